#include "lessons/course.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "base/enum_words.h"
#include "base/error.h"
#include "base/files.h"
#include "base/quoted.h"
#include "base/toml_block.h"
#include "base/toml_input.h"

namespace rasterwalk {

namespace {

/// A text of a list.
std::string listed_id(const TomlInput& input, const toml::node& node) {
    const toml::value<std::string>* const text = node.as_string();
    if (text == nullptr) input.fail(node, "this must be the id of a lesson, in quotes.");
    return text->get();
}

/// @param known ids of the lessons before it
CourseLesson course_lesson(const TomlInput& input, const std::vector<std::string>& known) {
    input.allow_only({"id", "needs"});
    CourseLesson lesson;
    lesson.id = input.text("id");
    lesson.line = line_of(input.nodes());
    const auto is_known = [&](const std::string& id) {
        return std::find(known.begin(), known.end(), id) != known.end();
    };
    if (is_known(lesson.id)) {
        input.fail(fmt::format("the lesson {} is named twice.", in_quotes(lesson.id)));
    }
    if (input.find("needs") == nullptr) return lesson;
    const toml::array& needs = input.list("needs");
    if (needs.size() > most_needs) {
        input.fail(needs, fmt::format("a lesson may need at most {} others.", most_needs));
    }
    for (const toml::node& node : needs) {
        std::string id = listed_id(input, node);
        if (!is_known(id)) {
            input.fail(node, fmt::format("{} needs {}, which does not come before it.",
                                         in_quotes(lesson.id), in_quotes(id)));
        }
        lesson.needs.push_back(std::move(id));
    }
    return lesson;
}

constexpr std::size_t most_track_letters = 500; ///< of a text: what fits into the list

/// @param known ids of the lessons before it; receives its own
Track course_track(const TomlInput& input, std::vector<std::string>& known) {
    input.allow_only({"title", "about", "needs", "lessons"});
    Track track{input.text("title"), input.text("about"), input.text("needs"), {}};
    if (std::max({track.title.size(), track.about.size(), track.needs.size()}) > most_track_letters)
        input.fail(
            fmt::format("The texts of a track may have at most {} letters.", most_track_letters));
    for (const toml::node& node : input.list("lessons")) {
        if (known.size() >= most_lessons)
            input.fail(node, fmt::format("a course may have at most {} lessons.", most_lessons));
        track.lessons.push_back(course_lesson(input.table(node, "a lesson"), known));
        known.push_back(track.lessons.back().id);
    }
    return track;
}

} // namespace

Course parse_course(std::string_view text, const std::string& path) {
    const toml::table root = parse_toml(text, path);
    const TomlInput input(root, path, "the course");
    input.allow_only({"answers", "track"});
    Course course;
    if (const toml::node* const answers = input.find("answers")) {
        const std::string word = input.text("answers");
        const auto value = value_of_word<AnswerRule>(word);
        if (!value) input.fail(*answers, "'answers' must be on_request or after_tries.");
        course.answers = *value;
    }
    std::vector<std::string> known;
    for (const toml::node& node : input.list("track")) {
        if (course.tracks.size() >= most_tracks)
            input.fail(node, fmt::format("a course may have at most {} tracks.", most_tracks));
        const std::string what = fmt::format("track {}", course.tracks.size() + 1);
        course.tracks.push_back(course_track(input.table(node, what), known));
    }
    return course;
}

std::string course_file(const std::string& folder) {
    return folder + "/course.toml";
}

Course read_course(const std::string& folder) {
    const std::string path = course_file(folder);
    std::error_code fault;
    if (!std::filesystem::exists(path, fault)) return {};
    return parse_course(read_file(path), path);
}

CoursePlace place_in(const Course& course, std::string_view id) {
    CoursePlace place;
    for (const Track& track : course.tracks) {
        place.lesson = 0;
        for (const CourseLesson& lesson : track.lessons) {
            if (lesson.id == id) return place;
            ++place.lesson;
            ++place.order;
        }
        ++place.track;
    }
    return place;
}

const Track* track_of(const Course& course, std::string_view id) {
    const std::size_t track = place_in(course, id).track;
    return track < course.tracks.size() ? &course.tracks[track] : nullptr;
}

std::vector<std::string> needs_of(const Course& course, std::string_view id) {
    const CoursePlace place = place_in(course, id);
    if (place.track == course.tracks.size()) return {};
    return course.tracks[place.track].lessons[place.lesson].needs;
}

void check_course_files(const Course& course, const std::string& folder) {
    for (const Track& track : course.tracks) {
        for (const CourseLesson& lesson : track.lessons) {
            std::error_code fault;
            if (std::filesystem::is_regular_file(folder + "/" + lesson.id + ".md", fault)) continue;
            throw InputError(course_file(folder), lesson.line,
                             fmt::format("there is no lesson {}.", in_quotes(lesson.id)));
        }
    }
}

} // namespace rasterwalk
