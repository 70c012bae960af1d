#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "lessons/course.h"
#include "lessons/lesson.h"

namespace rasterwalk {

/// The lessons of a folder, in the order of its course; without one, in the order of their names. A
/// file that changes is read again; if nothing of it can be shown any more, the earlier text stays,
/// with the new faults. The same is true of the course.
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

    /// Grows whenever a lesson is read, because earlier findings may then be out of date.
    std::uint64_t number() const { return number_; }

    /// Checks whether files were changed, added or removed, and reads those again.
    void refresh();

    /// From now on, reads the lessons of this folder. Never throws: a folder that cannot be read
    /// has none.
    void read_folder(const std::string& folder);

    /// From now on, a lesson that is translated into this language is read from there.
    /// @param code empty: English
    void set_language(const std::string& code);

    /// The course that orders the lessons; without tracks if the folder has none.
    const Course& course();

    /// Why the course cannot be read: "lessons/course.toml:12: sentence"; empty if it can.
    const std::string& course_fault() const { return course_fault_; }

    /// The folder whose lessons these are; empty before any was read.
    const std::string& folder() const { return folder_; }

  private:
    struct LessonFile {
        std::string path;
        FileState state;

        friend bool operator==(const LessonFile&, const LessonFile&) = default;
    };
    std::vector<LessonFile> files_in_folder() const;
    void refresh_course();

    bool is_read_ = false;
    std::uint64_t number_ = 0;
    std::string folder_;
    std::string language_;          ///< its code; empty: English
    std::vector<LessonFile> files_; ///< with the same index as lessons_
    std::vector<Lesson> lessons_;
    Course course_;
    FileState course_state_;
    std::string course_fault_;
};

/// How much a track holds.
struct TrackSize {
    int lessons = 0;
    int minutes = 0; ///< of all of them together
};

/// @param track index in Course::tracks
/// @param lessons as they were read; a lesson that is not among them does not count
TrackSize size_of_track(const Course& course, std::size_t track,
                        const std::vector<Lesson>& lessons);

/// A duration as text: "45 min", "2 h 59 min".
std::string hours_text(int minutes);

/// Is this the name of a lesson's file: two digits, a hyphen, a name, `.md`?
bool is_lesson_file(std::string_view name);

/// The number that a lesson's id begins with; 0 if there is none.
int lesson_number(std::string_view id);

/// The number missing just before that of the lesson with this index, for a lesson yet to come. 0
/// if none is missing, or more than one.
int missing_number(const std::vector<Lesson>& lessons, std::size_t index);

} // namespace rasterwalk
