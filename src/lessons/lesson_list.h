#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/file_state.h"
#include "lessons/lesson.h"

namespace rasterwalk {

/// The lessons of a folder, in the order of their names. A file that changes is read again; if
/// nothing of it can be shown any more, what was read before stays, with the new faults.
class LessonList {
  public:
    /// All lessons: those of lessons_folder(), unless read_folder() named another. Valid until the
    /// next call of refresh() or read_folder().
    const std::vector<Lesson>& all();

    /// The lesson of this id, read again if its file has changed; null if there is none. Valid
    /// until the next call.
    const Lesson* find(std::string_view id);

    /// Has the file of this lesson changed since it was read?
    bool is_edited(std::string_view id) const;

    /// Grows whenever a lesson is read: what was found in them may be out of date then.
    std::uint64_t number() const { return number_; }

    /// Looks whether files were changed, added or taken away, and reads those again.
    void refresh();

    /// Reads the lessons of this folder from now on. Never throws: a folder that cannot be read has
    /// none.
    void read_folder(const std::string& folder);

    /// The folder whose lessons these are; empty before any was read.
    const std::string& folder() const { return folder_; }

  private:
    struct LessonFile {
        std::string path;
        FileState state;

        friend bool operator==(const LessonFile&, const LessonFile&) = default;
    };
    std::vector<LessonFile> files_in_folder() const;

    bool is_read_ = false;
    std::uint64_t number_ = 0;
    std::string folder_;
    std::vector<LessonFile> files_; ///< of the same index as lessons_
    std::vector<Lesson> lessons_;
};

/// Is this the name of a lesson's file: two digits, a hyphen, a name, `.md`?
bool is_lesson_file(std::string_view name);

/// The number with which a lesson's id begins; 0 if it begins with none.
int lesson_number(std::string_view id);

/// The number that is missing between the lesson of this index and its predecessor: that of a
/// lesson that is to come. 0 if none is, or more than one.
int number_to_come(const std::vector<Lesson>& lessons, std::size_t index);

/// The most lessons of a folder that are read.
inline constexpr std::size_t most_lessons = 100;

} // namespace rasterwalk
