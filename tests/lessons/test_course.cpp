// The tracks of the course and the order of its lessons: as a file is read, and as the lessons that
// come with the program have them.

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/files.h"
#include "lessons/course.h"
#include "lessons/lesson_list.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/hostile_lessons.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

namespace {

const std::string track_head = "[[track]]\ntitle = \"T\"\nabout = \"A.\"\nneeds = \"N.\"\n";

/// What is wrong with a track that has these lines after its texts, which end with line 4.
std::string fault_of_course(const std::string& lines) {
    try {
        parse_course(track_head + lines, "course.toml");
    } catch (const InputError& fault) {
        return fault.what();
    }
    return "none";
}

std::vector<std::string> ids_of(LessonList& list) {
    std::vector<std::string> ids;
    for (const Lesson& lesson : list.all())
        ids.push_back(lesson.id);
    return ids;
}

std::vector<Lesson> own_lessons() {
    LessonList list;
    list.read_folder(lessons_folder());
    return list.all();
}

bool holds_link_to(const std::string& text, const std::string& id) {
    return text.find("(" + id + ".md)") != text.npos;
}

} // namespace

TEST_CASE("A course is read as it is written") {
    const Course course = parse_course(
        track_head +
            "lessons = [\n  { id = \"01-a\" },\n  { id = \"03-c\", needs = [\"01-a\"] },\n]\n" +
            "[[track]]\ntitle = \"U\"\nabout = \"B.\"\nneeds = \"M.\"\n"
            "lessons = [{ id = \"02-b\", needs = [\"03-c\", \"01-a\"] }]\n",
        "course.toml");
    REQUIRE(course.tracks.size() == 2);
    CHECK(course.tracks[1].title == "U");
    CHECK(course.tracks[1].about == "B.");
    CHECK(course.tracks[1].needs == "M.");
    CHECK(course.tracks[0].lessons[1].line == 7);
    CHECK(needs_of(course, "02-b") == std::vector<std::string>{"03-c", "01-a"});
    CHECK(needs_of(course, "01-a").empty());
    CHECK(needs_of(course, "09-z").empty());
    const CoursePlace place = place_in(course, "02-b");
    CHECK(place.track == 1);
    CHECK(place.lesson == 0);
    CHECK(place.order == 2);
    CHECK(track_of(course, "03-c") == &course.tracks[0]);
    CHECK(track_of(course, "09-z") == nullptr);
    CHECK(place_in(course, "09-z").track == 2);
    CHECK(place_in(course, "09-z").order == 3);
}

TEST_CASE("What is wrong with a course is said with its line") {
    CHECK(fault_of_course("lessons = [{ id = \"01-a\" }]\n") == "none");
    CHECK(fault_of_course("lessons = [\n{ id = \"01-a\" },\n{ id = \"01-a\" }]\n") ==
          "course.toml:7: the lesson '01-a' is named twice.");
    CHECK(fault_of_course(
              "lessons = [\n{ id = \"01-a\", needs = [\"02-b\"] },\n{ id = \"02-b\" }]\n") ==
          "course.toml:6: '01-a' needs '02-b', which does not come before it.");
    CHECK(fault_of_course("lessons = [{ id = \"01-a\", needs = [\"01-a\"] }]\n") ==
          "course.toml:5: '01-a' needs '01-a', which does not come before it.");
    CHECK(fault_of_course("lessons = [{ id = \"01-a\", needs = [1] }]\n") ==
          "course.toml:5: this must be the id of a lesson, in quotes.");
    for (const char* const lines :
         {"", "lessons = [1]\n", "lessons = [{ needs = [] }]\n", "lessons = [{ id = \"\" }]\n",
          "lessons = []\ntime = 5\n", "lessons = [{ id = \"01-a\", after = \"x\" }]\n",
          "lessons = \"01-a\"\n", "lessons = []\n[[tracks]]\n"}) {
        INFO(lines);
        CHECK(fault_of_course(lines).find("course.toml:") == 0);
    }
}

TEST_CASE("A course has so many tracks and lessons at most, which is said with its line") {
    std::string tracks;
    for (std::size_t i = 0; i < most_tracks; ++i)
        tracks += track_head + "lessons = []\n";
    CHECK(parse_course(tracks, "c").tracks.size() == most_tracks);
    CHECK_THROWS_WITH(parse_course(tracks + track_head + "lessons = []\n", "c"),
                      "c:31: a course may have at most 6 tracks.");
    std::string lessons = "lessons = [\n";
    for (std::size_t i = 0; i < most_lessons; ++i)
        lessons += "{ id = \"" + std::to_string(i) + "\" },\n";
    CHECK(fault_of_course(lessons + "]\n") == "none");
    CHECK(fault_of_course(lessons + "{ id = \"x\" }]\n") ==
          "course.toml:106: a course may have at most 100 lessons.");
}

TEST_CASE("A course says when answers are shown") {
    const std::string track = track_head + "lessons = []\n";
    CHECK(parse_course(track, "c").answers == AnswerRule::on_request);
    CHECK(parse_course("answers = \"on_request\"\n" + track, "c").answers ==
          AnswerRule::on_request);
    CHECK(parse_course("answers = \"after_tries\"\n" + track, "c").answers ==
          AnswerRule::after_tries);
    CHECK_THROWS_WITH(parse_course("answers = \"never\"\n" + track, "c"),
                      "c:1: 'answers' must be on_request or after_tries.");
    CHECK(read_course(lessons_folder()).answers == AnswerRule::on_request);
}

TEST_CASE("Lessons come in the order of the course, and others after them") {
    const test::TemporaryFolder folder;
    for (const char* const id : {"01-a", "02-b", "03-c", "05-e", "04-d"})
        folder.write(std::string(id) + ".md", test::lesson_head() + "Words.\n");
    LessonList list;
    list.read_folder(folder.file(""));
    CHECK(ids_of(list) == std::vector<std::string>{"01-a", "02-b", "03-c", "04-d", "05-e"});
    CHECK(list.course().tracks.empty());
    CHECK(list.course_fault().empty());

    const std::vector<std::string> ordered{"03-c", "05-e", "01-a", "02-b", "04-d"};
    const auto number = list.number();
    folder.write("course.toml",
                 track_head +
                     "lessons = [{ id = \"03-c\" }, { id = \"09-gone\" }, { id = \"05-e\" }]\n" +
                     track_head + "lessons = [{ id = \"01-a\" }]\n");
    list.refresh();
    CHECK(ids_of(list) == ordered);
    CHECK(list.number() > number);
    CHECK(list.find("05-e")->id == "05-e");
    CHECK_FALSE(list.is_edited("05-e"));

    SECTION("a course that can no longer be read leaves the order, and says why") {
        folder.write("course.toml", "track = 5\n");
        list.refresh();
        CHECK(ids_of(list) == ordered);
        CHECK(list.course_fault().find("course.toml:1: ") != std::string::npos);
    }
    SECTION("without its course a folder has the order of the names again") {
        std::filesystem::remove(folder.file("course.toml"));
        list.refresh();
        CHECK(ids_of(list) == std::vector<std::string>{"01-a", "02-b", "03-c", "04-d", "05-e"});
    }
}

TEST_CASE("A lesson to come is missed in any order, but not one that comes elsewhere") {
    const auto lessons_of = [](const std::vector<std::string>& ids) {
        std::vector<Lesson> lessons;
        for (const std::string& id : ids) {
            lessons.emplace_back();
            lessons.back().id = id;
        }
        return lessons;
    };
    const std::vector<Lesson> moved = lessons_of({"01-a", "03-c", "04-d", "02-b", "05-e"});
    for (std::size_t i = 0; i < moved.size(); ++i)
        CHECK(missing_number(moved, i) == 0);
    const std::vector<Lesson> missed = lessons_of({"01-a", "03-c", "06-f"});
    CHECK(missing_number(missed, 0) == 0);
    CHECK(missing_number(missed, 1) == 2);
    CHECK(missing_number(missed, 2) == 0); // two are missing
}

TEST_CASE("The size of a track counts its lessons and their minutes") {
    const Course course =
        parse_course(track_head + "lessons = [{ id = \"01-a\" }, { id = \"02-b\" }]\n", "c");
    std::vector<Lesson> lessons(3);
    lessons[0].id = "01-a";
    lessons[0].minutes = 45;
    lessons[1].id = "02-b";
    lessons[1].minutes = 20;
    lessons[2].id = "03-c";
    lessons[2].minutes = 7;
    CHECK(size_of_track(course, 0, lessons).lessons == 2);
    CHECK(size_of_track(course, 0, lessons).minutes == 65);
    CHECK(size_of_track(course, 1, lessons).minutes == 7);
    CHECK(hours_text(45) == "45 min");
    CHECK(hours_text(65) == "1 h 5 min");
    CHECK(hours_text(120) == "2 h 0 min");
}

TEST_CASE("A course whose lesson has no file is found out, with its line") {
    const test::TemporaryFolder folder;
    folder.write("01-a.md", "x");
    const std::string path = folder.write(
        "course.toml", track_head + "lessons = [{ id = \"01-a\" },\n{ id = \"02-b\" }]\n");
    const Course course = parse_course(read_file(path), path);
    try {
        check_course_files(course, folder.file(""));
        FAIL_CHECK("nothing was found");
    } catch (const InputError& fault) {
        CHECK(std::string(fault.what()).find("course.toml:6: there is no lesson '02-b'.") !=
              std::string::npos);
    }
    folder.write("02-b.md", "x");
    CHECK_NOTHROW(check_course_files(course, folder.file("")));
}

TEST_CASE("The course names every lesson, and the camera moves after the edges") {
    const Course course = read_course(lessons_folder());
    CHECK(course.tracks.size() == 3);
    CHECK_NOTHROW(check_course_files(course, lessons_folder()));
    const std::vector<Lesson> lessons = own_lessons();
    std::map<std::string, std::size_t> order;
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        INFO(lessons[i].id);
        CHECK(track_of(course, lessons[i].id) != nullptr);
        order[lessons[i].id] = i;
    }
    CHECK(order.at("02-moving-the-camera") == order.at("04-edges") + 1);
    CHECK(order.at("05-row-table") == order.at("02-moving-the-camera") + 1);
    // All others are in the order of their numbers.
    std::string before;
    for (const Lesson& lesson : lessons) {
        if (lesson.id == "02-moving-the-camera") continue;
        CHECK(before < lesson.id);
        before = lesson.id;
    }
}

TEST_CASE("Each lesson ends with a link to the one that comes next") {
    const std::vector<Lesson> lessons = own_lessons();
    for (std::size_t i = 0; i + 1 < lessons.size(); ++i) {
        INFO(lessons[i].id << ", " << lessons[i + 1].id);
        const std::string text = read_file(lessons[i].path);
        const std::size_t last_step = text.rfind("\n## ");
        REQUIRE(last_step != text.npos);
        CHECK(holds_link_to(text.substr(last_step), lessons[i + 1].id));
    }
}

TEST_CASE("lessons/README.md has the tracks, their lessons in order, and what each builds on") {
    const std::string text = read_file(lessons_folder() + "/README.md");
    const Course course = read_course(lessons_folder());
    const std::vector<Lesson> lessons = own_lessons();
    std::size_t at = text.find("\n## The lessons\n");
    REQUIRE(at != text.npos);
    const auto find_next = [&](const std::string& words) {
        INFO(words);
        const std::size_t found = text.find(words, at);
        REQUIRE(found != text.npos);
        at = found + words.size();
    };
    for (std::size_t track = 0; track < course.tracks.size(); ++track) {
        const TrackSize size = size_of_track(course, track, lessons);
        find_next("\n### " + course.tracks[track].title + "\n");
        // The text may break its lines anywhere.
        std::string head = text.substr(at, text.find("\n| | | |", at) - at);
        std::replace(head.begin(), head.end(), '\n', ' ');
        CHECK(head.find(course.tracks[track].about) != head.npos);
        CHECK(head.find(std::to_string(size.lessons) + " lessons, " + hours_text(size.minutes) +
                        ".") != head.npos);
        for (const CourseLesson& one : course.tracks[track].lessons) {
            const auto lesson = std::find_if(lessons.begin(), lessons.end(),
                                             [&](const Lesson& l) { return l.id == one.id; });
            REQUIRE(lesson != lessons.end());
            std::string words = "**" + std::to_string(lesson_number(one.id)) + "** [" +
                                lesson->title + "](" + one.id + ".md), " +
                                std::to_string(lesson->minutes) + " minutes";
            for (std::size_t i = 0; i < one.needs.size(); ++i) {
                words += (i == 0 ? ", after [" : " and [") +
                         std::to_string(lesson_number(one.needs[i])) + "](" + one.needs[i] + ".md)";
            }
            find_next(words + " |");
        }
    }
}
