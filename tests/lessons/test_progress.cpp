#include "lessons/progress.h"

#include <filesystem>

#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "lessons/lesson_scores.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

namespace {

Progress some_progress() {
    Progress progress;
    progress.record_step("04-edges", 0);
    progress.record_step("04-edges", 3);
    progress.record_task("04-edges", "no-gap");
    progress.record_answer("04-edges", "how-many", {"12 \"samples\"\n\\ and π", false});
    progress.record_answer("05-row-table", "index", {"-1", true});
    progress.record_step("05-row-table", 1);
    return progress;
}

/// A lesson of three steps with a task and a prediction.
Lesson small_lesson(const std::string& id) {
    Lesson lesson;
    lesson.id = id;
    lesson.steps.resize(3);
    lesson.tasks.emplace_back().id = "task";
    lesson.predictions.emplace_back().id = "prediction";
    return lesson;
}

void finish(Progress& progress, const std::string& lesson) {
    for (const int step : {0, 1, 2})
        progress.record_step(lesson, step);
    progress.record_task(lesson, "task");
    progress.record_answer(lesson, "prediction", {"5", false});
}

std::string fault_of(const std::string& text) {
    try {
        parse_progress(text, "progress.toml");
        return "none";
    } catch (const InputError& fault) {
        return fault.what();
    }
}

} // namespace

TEST_CASE("Progress is the same after it was written and read") {
    const Progress progress = some_progress();
    CHECK(parse_progress(progress_text(progress), "progress.toml") == progress);
    CHECK(parse_progress(progress_text(Progress{}), "progress.toml") == Progress{});
    CHECK(parse_progress("", "progress.toml") == Progress{});

    const test::TemporaryFolder folder;
    const std::string path = folder.file("a/new/folder/progress.toml");
    CHECK(read_progress(path) == Progress{});
    CHECK(write_progress({}, progress, path) == progress);
    CHECK(read_progress(path) == progress);
    CHECK(write_progress(progress, {}, path) == Progress{});
    CHECK(read_progress(path) == Progress{});
}

TEST_CASE("Only the first answer counts, and the last step is remembered") {
    Progress progress = some_progress();
    progress.record_answer("05-row-table", "index", {"0", false});
    CHECK(progress.of("05-row-table").answers.at("index") == FirstAnswer{"-1", true});
    CHECK(progress.last_lesson == "05-row-table");
    CHECK(progress.of("04-edges").last_step == 3);
    CHECK(progress.was_step_shown("04-edges", 0));
    CHECK_FALSE(progress.was_step_shown("04-edges", 1));
    CHECK(progress.is_task_done("04-edges", "no-gap"));
    CHECK_FALSE(progress.is_task_done("05-row-table", "no-gap"));
    CHECK(progress.of("never opened") == LessonProgress{});
}

TEST_CASE("A wrong first answer counts once the program has shown its own") {
    const Lesson lesson = small_lesson("01-a");
    Progress progress;
    const std::string id = lesson.predictions.at(0).id;
    progress.record_answer("01-a", id, {"7", false, true});
    CHECK(progress.has_second_try("01-a", id));
    CHECK_FALSE(progress.is_revealed("01-a", id));
    CHECK(score_of(progress, lesson).done == 0);
    // It is kept, and taken up where it was left.
    const Progress kept = parse_progress(progress_text(progress), "p.toml");
    CHECK(kept == progress);
    CHECK(kept.has_second_try("01-a", id));
    const Progress before = progress;
    progress.end_second_try("01-a", id);
    CHECK(progress.is_revealed("01-a", id));
    CHECK(score_of(progress, lesson).answered == 1);
    CHECK(score_of(progress, lesson).right == 0);
    // Another window that still has the second try open learns that it is over.
    CHECK_FALSE(merged(before, progress, before).has_second_try("01-a", id));
    // But one opened again there stays open if this window has changed nothing.
    CHECK(merged(progress, progress, before).has_second_try("01-a", id));
    Progress theirs = before;
    theirs.record_step("02-b", 1);
    CHECK_FALSE(merged(before, progress, theirs).has_second_try("01-a", id));
    CHECK(progress_text(progress).find("second_try") == std::string::npos);
}

TEST_CASE("A lesson is done when all was seen, solved and answered, rightly or not") {
    const Lesson lesson = small_lesson("01-a");
    Progress progress;
    CHECK(score_of(progress, lesson).all == 2);
    CHECK(score_of(progress, lesson).done == 0);
    progress.record_task("01-a", "task");
    progress.record_task("01-a", "a task that the lesson had once");
    CHECK(score_of(progress, lesson).done == 1);
    finish(progress, "01-a");
    CHECK(score_of(progress, lesson).is_done);
    CHECK(score_of(progress, lesson).last_step == 2);
    // A step was added to the lesson, or steps were taken away.
    Lesson other = lesson;
    other.steps.resize(4);
    CHECK_FALSE(score_of(progress, other).is_done);
    other.steps.resize(2);
    CHECK(score_of(progress, other).last_step == 1);
}

TEST_CASE("The student goes on with the lesson that was left, or the first that is not done") {
    const std::vector<Lesson> lessons{small_lesson("01-a"), small_lesson("02-b"),
                                      small_lesson("03-c")};
    Progress progress;
    CHECK(lesson_to_open(progress, {}).empty());
    CHECK(lesson_to_open(progress, lessons) == "01-a");
    progress.record_step("02-b", 1);
    CHECK(lesson_to_open(progress, lessons) == "02-b");
    finish(progress, "02-b");
    CHECK(lesson_to_open(progress, lessons) == "01-a");
    finish(progress, "01-a");
    CHECK(lesson_to_open(progress, lessons) == "03-c");
    finish(progress, "03-c");
    CHECK(lesson_to_open(progress, lessons) == "01-a");
    progress.last_lesson = "99-gone";
    CHECK(lesson_to_open(progress, lessons) == "01-a");
}

TEST_CASE("Progress over all lessons is computed again only when it has changed") {
    const test::TemporaryFolder folder;
    for (const char* name : {"01-a.md", "02-b.md"})
        folder.write(name, "# A\n\nText.\n\n## B\n\nMore.\n");
    LessonList lessons;
    lessons.read_folder(folder.file(""));
    REQUIRE(lessons.all().size() == 2);
    Progress progress;
    LessonScores scores;
    const auto are_right = [&] {
        bool is_right = scores.to_open() == lesson_to_open(progress, lessons.all());
        for (std::size_t i = 0; i < lessons.all().size(); ++i) {
            const LessonScore score = score_of(progress, lessons.all()[i]);
            is_right = is_right && scores.of(i).is_done == score.is_done &&
                       scores.of(i).done == score.done && scores.of(i).all == score.all &&
                       scores.of(i).last_step == score.last_step;
        }
        return is_right;
    };
    scores.renew(progress, lessons);
    CHECK(are_right());
    const std::uint64_t first = scores.number();
    for (int frame = 0; frame < 10; ++frame)
        scores.renew(progress, lessons);
    CHECK(scores.number() == first);
    for (const int step : {0, 1}) {
        progress.record_step("01-a", step);
        scores.renew(progress, lessons);
        CHECK(are_right());
    }
    CHECK(scores.of(0).is_done);
    CHECK(scores.number() == first + 2);
    // Other progress, whatever it says; also what another window has kept.
    for (const Progress& other :
         {Progress{}, parse_progress(progress_text(some_progress()), "p.toml"), progress,
          merged({}, progress, some_progress())}) {
        progress = other;
        scores.renew(progress, lessons);
        CHECK(are_right());
    }
    // A lesson that was read again may have more steps.
    const std::uint64_t before = scores.number();
    lessons.read_folder(folder.file(""));
    scores.renew(progress, lessons);
    CHECK(scores.number() > before);
    CHECK(are_right());
}

TEST_CASE("A file of progress that is damaged is refused with its line") {
    CHECK(fault_of("last_lesson = 5") ==
          "progress.toml:1: 'last_lesson' of the progress must be text in quotes.");
    CHECK(fault_of("lesson = 'a'").find("progress.toml:1: the progress has no 'lesson'") == 0);
    CHECK(fault_of("\nlessons = 5") == "progress.toml:2: the lessons must be a table.");
    CHECK(fault_of("[lessons]\na = 5") == "progress.toml:2: a lesson must be a table.");
    for (const std::string step : {"-1", "65", "2.0", "1e70", "1, 'two'"})
        CHECK(fault_of("[lessons.a]\nsteps = [" + step + "]") ==
              "progress.toml:2: A step must be a whole number.");
    CHECK(fault_of("[lessons.a]\nlast_step = 9999999999").find("progress.toml:2: ") == 0);
    CHECK(fault_of("[lessons.a]\ntasks = [5]") == "progress.toml:2: The name of a task must "
                                                  "be text.");
    CHECK(fault_of("[lessons.a]\nanswers = [5]") ==
          "progress.toml:2: the answers must be a table.");
    CHECK(fault_of("[lessons.a.answers]\nb = 5") == "progress.toml:2: an answer must be a table.");
    CHECK(fault_of("[lessons.a.answers]\nb = { right = 'no' }") ==
          "progress.toml:2: 'right' must be true or false.");
    CHECK(fault_of("= = =").find("progress.toml:1: ") == 0);
    CHECK(fault_of(std::string(300, '[')).find("progress.toml:1: ") == 0);
    CHECK(fault_of("\xff\xfe").find("progress.toml:1: ") == 0);
}

TEST_CASE("A file of progress that is too large, or none, is refused") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("progress.toml", std::string(largest_progress + 1, '\n'));
    CHECK_THROWS_AS(read_progress(path), InputError);
    CHECK_THROWS_AS(read_progress(folder.file("")), AccessError);
    CHECK_THROWS_AS(write_progress({}, {}, "/proc/nowhere/progress.toml"), AccessError);
}

TEST_CASE("A file with a damaged byte is read or refused, and never crashes") {
    const std::string good = progress_text(some_progress());
    for (std::size_t i = 0; i < good.size(); ++i) {
        for (const char c : {'\0', '"', '[', '}', '\n', '\xff', '9'}) {
            std::string text = good;
            text[i] = c;
            try {
                parse_progress(text, "progress.toml");
            } catch (const InputError& fault) {
                REQUIRE(std::string(fault.what()).find("progress.toml:") == 0);
            }
        }
    }
}

TEST_CASE("What two windows do is kept, whichever writes last") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("progress.toml");
    const Progress start = write_progress({}, some_progress(), path);
    Progress a = start, b = start;
    a.record_step("06-filling", 1);
    a.record_answer("06-filling", "how-many", {"5", true});
    b.record_task("06-filling", "paint");
    b.record_answer("06-filling", "how-many", {"6", false});
    b.record_step("04-edges", 5);
    const Progress after_a = write_progress(start, a, path);
    CHECK(after_a == a);
    const Progress after_b = write_progress(start, b, path);
    CHECK(read_progress(path) == after_b);
    CHECK(after_b.was_step_shown("06-filling", 1));
    CHECK(after_b.is_task_done("06-filling", "paint"));
    CHECK(after_b.of("06-filling").answers.at("how-many") == FirstAnswer{"5", true});
    CHECK(after_b.of("04-edges").last_step == 5);
    CHECK(after_b.last_lesson == "04-edges");
    // What one forgets does not come back through the other, which still has it.
    write_progress(after_b, {}, path);
    Progress later = after_b;
    later.record_step("07-painters-order", 0);
    const Progress left = write_progress(after_b, later, path);
    CHECK(left.lessons.size() == 1);
    CHECK(left.was_step_shown("07-painters-order", 0));
}

TEST_CASE("Two processes that write at the same time lose none of each other's work") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("progress.toml");
    constexpr int count = 40;
    std::vector<pid_t> children;
    for (const char* lesson : {"01-a", "02-b"}) {
        const pid_t child = ::fork();
        if (child == 0) {
            Progress kept;
            for (int step = 0; step < count; ++step) {
                Progress mine = kept;
                mine.record_step(lesson, step);
                try {
                    kept = write_progress(kept, mine, path);
                } catch (const Error&) {
                    ::_exit(1);
                }
            }
            ::_exit(0);
        }
        children.push_back(child);
    }
    for (const pid_t child : children) {
        int status = -1;
        ::waitpid(child, &status, 0);
        CHECK(status == 0);
    }
    const Progress both = read_progress(path);
    CHECK(both.of("01-a").steps.size() == count);
    CHECK(both.of("02-b").steps.size() == count);
}

TEST_CASE("Where no folder can be made, the reason is that of the folder, not that it is missing") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("state/rasterwalk/progress.toml");
    std::filesystem::permissions(folder.file(""), std::filesystem::perms(0555));
    const pid_t child = ::fork();
    if (child == 0) {
        constexpr uid_t nobody = 65534; // root may write anywhere
        if (::getuid() == 0 && ::setuid(nobody) != 0) ::_exit(2);
        try {
            write_progress({}, some_progress(), path);
        } catch (const AccessError& fault) {
            ::_exit(fault.what() == "cannot write '" + path + "': Permission denied." ? 0 : 1);
        }
        ::_exit(3);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    std::filesystem::permissions(folder.file(""), std::filesystem::perms(0755));
    CHECK(status == 0);
}

TEST_CASE("Progress broken by someone in the meantime is left as it is") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("progress.toml", "lessons = 5\n");
    CHECK_THROWS_AS(write_progress({}, some_progress(), path), InputError);
    CHECK(test::bytes_of(path) == "lessons = 5\n");
}
