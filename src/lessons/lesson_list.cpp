#include "lessons/lesson_list.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"
#include "base/language_files.h"
#include "session/content.h"

namespace rasterwalk {

bool is_lesson_file(std::string_view name) {
    const auto is_digit = [&](std::size_t i) {
        return std::isdigit(static_cast<unsigned char>(name[i])) != 0;
    };
    return name.size() > 6 && is_digit(0) && is_digit(1) && name[2] == '-' && name.ends_with(".md");
}

int lesson_number(std::string_view id) {
    int number = 0;
    for (const char c : id.substr(0, 2)) {
        if (std::isdigit(static_cast<unsigned char>(c)) == 0) return 0;
        number = 10 * number + (c - '0');
    }
    return number;
}

namespace {

/// A lesson that can no longer be read keeps its earlier text, and says why.
void take_up(Lesson& lesson, Lesson&& newer) {
    if (is_readable(newer) || !is_readable(lesson)) {
        lesson = std::move(newer);
    } else {
        lesson.faults = std::move(newer.faults);
    }
}

} // namespace

std::vector<LessonList::LessonFile> LessonList::files_in_folder() const {
    namespace fs = std::filesystem;
    std::vector<LessonFile> files;
    std::error_code fault;
    for (fs::directory_iterator entry(folder_, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        const std::string name = entry->path().filename().string();
        if (!is_lesson_file(name)) continue;
        std::string path = entry->path().string();
        if (!language_.empty()) {
            const std::string translated = translated_lesson(folder_, language_, name);
            std::error_code ignored;
            if (fs::is_regular_file(translated, ignored)) path = translated;
        }
        files.push_back({path, file_state(path)});
    }
    const auto id_of = [](const LessonFile& file) { return fs::path(file.path).stem().string(); };
    std::sort(files.begin(), files.end(),
              [&](const LessonFile& a, const LessonFile& b) { return id_of(a) < id_of(b); });
    if (files.size() > most_lessons) files.resize(most_lessons);
    const auto order_of = [&](const LessonFile& file) {
        return place_in(course_, id_of(file)).order;
    };
    std::stable_sort(files.begin(), files.end(), [&](const LessonFile& a, const LessonFile& b) {
        return order_of(a) < order_of(b);
    });
    return files;
}

void LessonList::refresh_course() {
    const FileState state = file_state(course_file(folder_));
    if (is_read_ && state == course_state_) return;
    course_state_ = state;
    course_fault_.clear();
    try {
        course_ = read_course(folder_);
    } catch (const Error& fault) {
        course_fault_ = fault.what();
    }
    ++number_;
}

void LessonList::refresh() {
    refresh_course();
    std::vector<LessonFile> files = files_in_folder();
    if (is_read_ && files == files_) return;
    std::vector<Lesson> lessons;
    for (const LessonFile& file : files) {
        const auto known = std::find_if(files_.begin(), files_.end(), [&](const LessonFile& other) {
            return other.path == file.path;
        });
        if (!is_read_ || known == files_.end()) {
            lessons.push_back(read_lesson(file.path));
            continue;
        }
        Lesson& lesson = lessons_[static_cast<std::size_t>(known - files_.begin())];
        if (*known != file) take_up(lesson, read_lesson(file.path));
        lessons.push_back(std::move(lesson));
    }
    files_ = std::move(files);
    lessons_ = std::move(lessons);
    is_read_ = true;
    ++number_;
}

void LessonList::read_folder(const std::string& folder) {
    folder_ = folder;
    is_read_ = false;
    files_.clear();
    lessons_.clear();
    course_ = {};
    refresh();
}

void LessonList::set_language(const std::string& code) {
    language_ = code;
    if (is_read_) refresh();
}

const std::vector<Lesson>& LessonList::all() {
    if (!is_read_) {
        try {
            read_folder(lessons_folder());
        } catch (const Error&) {
            is_read_ = true; // no folder, no lessons; code that needs them reports that
        }
    }
    return lessons_;
}

const Course& LessonList::course() {
    all();
    return course_;
}

const Lesson* LessonList::find(std::string_view id) {
    const std::vector<Lesson>& lessons = all();
    const auto found = std::find_if(lessons.begin(), lessons.end(),
                                    [&](const Lesson& lesson) { return lesson.id == id; });
    if (found == lessons.end()) return nullptr;
    const auto index = static_cast<std::size_t>(found - lessons.begin());
    const FileState now = file_state(files_[index].path);
    if (now != files_[index].state) {
        files_[index].state = now;
        // A file that was removed, or is just being written, leaves its lesson open.
        if (now.size > 0) {
            take_up(lessons_[index], read_lesson(files_[index].path));
            ++number_;
        }
    }
    return &lessons_[index];
}

bool LessonList::is_edited(std::string_view id) const {
    for (std::size_t i = 0; i < lessons_.size(); ++i) {
        if (lessons_[i].id == id) return file_state(files_[i].path) != files_[i].state;
    }
    return false;
}

TrackSize size_of_track(const Course& course, std::size_t track,
                        const std::vector<Lesson>& lessons) {
    TrackSize size;
    for (const Lesson& lesson : lessons) {
        if (place_in(course, lesson.id).track != track) continue;
        ++size.lessons;
        size.minutes += lesson.minutes;
    }
    return size;
}

std::string hours_text(int minutes) {
    if (minutes < 60) return fmt::format("{} min", minutes);
    return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

int missing_number(const std::vector<Lesson>& lessons, std::size_t index) {
    const int number = lesson_number(lessons[index].id);
    const auto is_there = [&](int other) {
        return std::any_of(lessons.begin(), lessons.end(),
                           [&](const Lesson& lesson) { return lesson_number(lesson.id) == other; });
    };
    return number > 2 && !is_there(number - 1) && is_there(number - 2) ? number - 1 : 0;
}

} // namespace rasterwalk
