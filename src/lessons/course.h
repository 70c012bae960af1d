#pragma once

// The order of the lessons, in tracks, and which lesson builds on which: lessons/course.toml.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A lesson's place in a course.
struct CourseLesson {
    std::string id;
    std::vector<std::string> needs; ///< ids of the earlier lessons that it builds on directly
    int line = 0;                   ///< of the course's file
};

/// Lessons that are taken one after the other.
struct Track {
    std::string title;
    std::string about; ///< one sentence: what it teaches
    std::string needs; ///< what its students bring along
    std::vector<CourseLesson> lessons;
};

/// When the answer to a prediction is shown: whenever a student asks for it, or only after two
/// tries of their own.
enum class AnswerRule : std::uint8_t { on_request, after_tries };

struct Course {
    std::vector<Track> tracks;
    AnswerRule answers = AnswerRule::on_request;
};

/// A lesson's place in a course.
struct CoursePlace {
    std::size_t track = 0;  ///< index in Course::tracks
    std::size_t lesson = 0; ///< index in Track::lessons
    std::size_t order = 0;  ///< how many lessons of the course come before it
};

/// Reads a course. Every lesson is named once, and what it needs is named before it. Throws
/// InputError with file:line.
Course parse_course(std::string_view text, const std::string& path);

/// Reads the course of a folder of lessons; one without tracks if the folder has no course.toml.
/// Throws AccessError, or InputError with file:line.
Course read_course(const std::string& folder);

/// The file of read_course().
std::string course_file(const std::string& folder);

/// The place of a lesson. A lesson that the course does not name comes after all others: its track
/// and its order are the numbers of tracks and of lessons.
CoursePlace place_in(const Course& course, std::string_view id);

/// The track of a lesson; null if the course does not name it.
const Track* track_of(const Course& course, std::string_view id);

/// What a lesson builds on directly; empty if the course does not name it.
std::vector<std::string> needs_of(const Course& course, std::string_view id);

/// Throws InputError with file:line if the folder of a course has no file for one of its lessons.
void check_course_files(const Course& course, const std::string& folder);

inline constexpr std::size_t most_tracks = 6;
inline constexpr std::size_t most_lessons = 100; ///< of a course, or of a folder
inline constexpr std::size_t most_needs = 12;    ///< of a lesson

} // namespace rasterwalk
