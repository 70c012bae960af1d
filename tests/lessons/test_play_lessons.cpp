// Every lesson is played from its first step to its last, as a student could.

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>

#include "base/files.h"
#include "base/numbers.h"
#include "base/text_parts.h"
#include "facts/facts.h"
#include "lessons/lesson.h"
#include "lessons/lesson_advice.h"
#include "lessons/lesson_check.h"
#include "lessons/lesson_link.h"
#include "lessons/lesson_list.h"
#include "lessons/lesson_run.h"
#include "lessons/puzzle_judge.h"
#include "picture/view_image.h"
#include "session/content.h"
#include "support/effort.h"
#include "support/project_root.h"
#include "tests/support/catch.h"
#include "tests/support/hostile_lessons.h"
#include "tests/support/prediction_checks.h"
#include "text/markdown_text.h"
#include "view/view_table.h"

using namespace rasterwalk;

namespace {

std::vector<Lesson> all_lessons() {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(lessons_folder())) {
        if (is_lesson_file(entry.path().filename().string())) {
            paths.push_back(entry.path().string());
        }
    }
    std::sort(paths.begin(), paths.end());
    std::vector<Lesson> lessons;
    for (const std::string& path : paths)
        lessons.push_back(read_lesson(path));
    return lessons;
}

/// The session of a student who has opened a step.
struct Student {
    Session session = empty_session();
    Results results;

    std::vector<Fault> open(const Lesson& lesson, int step) {
        std::vector<Fault> faults = open_step(session, lesson, step);
        finish(session, results);
        return faults;
    }
    void follow(const std::string& target) {
        follow_lesson_link(session, results.a.frame, parse_lesson_link(target));
        finish(session, results);
    }
    bool has_done(const LessonTask& task) const { return is_done(task, Facts(session, results)); }
};

/// Checks that links of fields keep their promises, by the key of the field.
const std::map<std::string_view, void (*)(const LessonLink&, const Student&)> promises{
    {"set",
     [](const LessonLink& link, const Student& student) {
         // Nothing is left to set.
         Session again = student.session;
         follow_lesson_link(again, student.results.a.frame, link);
         CHECK(again.a.settings == student.session.a.settings);
     }},
    {"cursor",
     [](const LessonLink& link, const Student& student) {
         const Cursor& cursor = student.session.cursor;
         CHECK(student.results.a.cursor == cursor);
         CHECK((cursor == cursor_end) == (link.argument == "end"));
         CHECK_FALSE(student.session.selection.triangle);
         if (link.argument != "end") {
             CHECK(cursor.triangle == parse_cursor(link.argument)->triangle);
         }
     }},
    {"compare",
     [](const LessonLink& link, const Student& student) {
         CHECK(student.session.b.has_value() == (link.argument != "off"));
         CHECK((student.results.b != nullptr) == (link.argument != "off"));
     }},
    {"pixel",
     [](const LessonLink& link, const Student& student) {
         const std::optional<glm::ivec2>& pixel = student.session.selection.pixel;
         CHECK(pixel == parse_pixel(link.argument));
         CHECK(student.results.history.has_value() == pixel.has_value());
     }},
    {"triangle",
     [](const LessonLink& link, const Student& student) {
         CHECK(student.session.selection.triangle == parse_int(link.argument));
     }},
    {"row",
     [](const LessonLink& link, const Student& student) {
         CHECK(student.session.selection.row == parse_int(link.argument));
     }},
    {"vertex",
     [](const LessonLink& link, const Student& student) {
         CHECK(student.session.selection.vertex == parse_int(link.argument));
     }},
    {"tab", [](const LessonLink& link,
               const Student& student) { CHECK(student.session.tab == link.argument); }},
    {"view",
     [](const LessonLink& link, const Student& student) {
         CHECK(student.session.view == value_of_word<View>(link.argument));
     }},
    {"canvas",
     [](const LessonLink& link, const Student& student) {
         CHECK(student.session.canvas.shows == value_of_word<CanvasShows>(link.argument));
     }},
    {"overlays",
     [](const LessonLink& link, const Student& student) {
         CHECK(student.session.overlays.empty() == (link.argument == "none"));
     }},
};

/// Checks that a link keeps its promise.
void check_kept(const LessonLink& link, const Student& student) {
    if (link.kind == LessonLink::Kind::lesson) {
        CHECK(std::filesystem::exists(lessons_folder() + "/" + link.argument + ".md"));
    }
    if (link.field != nullptr) promises.at(link.field->key)(link, student);
}

} // namespace

TEST_CASE("Every lesson has no fault") {
    const Session session = empty_session();
    // Without sanitizers the program itself checks all of them.
    for (const Lesson& lesson : test::some_of(all_lessons(), 5)) {
        for (const Fault& fault : check_lesson(lesson, session)) {
            // A lesson may speak of one that is not written yet.
            if (fault.sentence.starts_with("there is no lesson '")) {
                WARN(fault_text(lesson, fault));
            } else {
                FAIL_CHECK(fault_text(lesson, fault));
            }
        }
    }
}

TEST_CASE("Each step of every lesson can be opened, and each link followed") {
    Student student;
    for (const Lesson& lesson : all_lessons()) {
        INFO(lesson.path);
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            const LessonStep& step = lesson.steps[i];
            INFO(step.heading);
            CHECK(student.open(lesson, static_cast<int>(i)).empty());
            CHECK(student.session.lesson == lesson.id);
            CHECK(student.session.step == static_cast<int>(i));
            const Frame& frame = student.results.a.frame;
            CHECK(in_pass(student.results.a.cursor, frame.pass) == student.session.cursor);
            if (step.state.cursor && *step.state.cursor != cursor_end) {
                CHECK(student.session.cursor.triangle == step.state.cursor->triangle);
            }
            for (const LinkPlace& link : test::some_of(step.links, 1)) {
                if (link.is_picture) continue;
                INFO(link.line << ": " << link.target);
                student.follow(link.target);
                check_kept(parse_lesson_link(link.target), student);
            }
        }
    }
}

TEST_CASE("Each task is unsolved before its recipe, and solved after it") {
    Student student;
    for (const Lesson& lesson : all_lessons()) {
        for (const LessonTask& task : lesson.tasks) {
            INFO(lesson.path << ":" << task.line << " " << task.id);
            student.open(lesson, task.step);
            CHECK_FALSE(student.has_done(task));
            for (const std::string& target : task.recipe)
                student.follow(target);
            CHECK(student.has_done(task));
        }
    }
}

TEST_CASE("Each prediction is computed, refuses a wrong answer and takes the right one") {
    const Session session = empty_session();
    std::vector<std::pair<Lesson, std::size_t>> places;
    for (const Lesson& lesson : all_lessons()) {
        for (std::size_t i = 0; i < lesson.predictions.size(); ++i)
            places.emplace_back(lesson, i);
    }
    for (const auto& [of_lesson, place] : test::some_of(places, 13)) {
        const Lesson& lesson = of_lesson;
        const LessonPrediction& prediction = lesson.predictions[place];
        INFO(lesson.path << ":" << prediction.line << " " << prediction.id);
        const auto judged = [&](GivenAnswer answer) {
            Judgement judgement = judge(lesson, prediction, answer, session);
            CHECK(judgement.fault.empty());
            CHECK(judgement.because.find('{') == std::string::npos);
            return judgement;
        };
        switch (prediction.kind) {
        case LessonPrediction::Kind::number: {
            const double right = judged({0.0}).number;
            CHECK(judged({right}).is_right);
            const double far = 2.0 * std::abs(right) + 1e6; // beyond any tolerance
            CHECK_FALSE(judged({right + far}).is_right);
            // What is shown would be accepted.
            CHECK(judged({*read_answer(answer_text(right))}).is_right);
            break;
        }
        case LessonPrediction::Kind::choice: {
            const int right = judged({0}).choice;
            for (int i = 0; i < static_cast<int>(prediction.choices.size()); ++i)
                CHECK(judged({i}).is_right == (i == right));
            break;
        }
        case LessonPrediction::Kind::pixel:
            CHECK(judged({*prediction.right_pixel}).is_right);
            CHECK_FALSE(judged({*prediction.wrong_pixel}).is_right);
            break;
        }
    }
}

TEST_CASE(
    "Each puzzle is solved by its own order, and by none with a distractor in a line's place") {
    int puzzles = 0;
    for (const Lesson& lesson : all_lessons()) {
        for (const LessonPuzzle& puzzle : lesson.puzzles) {
            ++puzzles;
            INFO(lesson.path << ":" << puzzle.line << " " << puzzle.id);
            const std::vector<PlacedPiece> right = right_order(puzzle);
            CHECK(judge_order(puzzle, right).is_right);
            const std::vector<PuzzleQuestion>& questions = find_exam(puzzle.exam)->questions;
            for (int piece = static_cast<int>(right.size()); piece < piece_count(puzzle); ++piece) {
                INFO(piece_text(puzzle, piece));
                bool is_wrong_by_answer = false;
                for (std::size_t place = 0; place < right.size(); ++place) {
                    std::vector<PlacedPiece> order = right;
                    order[place].piece = piece;
                    const PuzzleVerdict verdict = judge_order(puzzle, order);
                    CHECK_FALSE(verdict.is_right);
                    is_wrong_by_answer =
                        is_wrong_by_answer ||
                        std::any_of(questions.begin(), questions.end(),
                                    [&](const PuzzleQuestion& question) {
                                        return verdict.sentence.starts_with(question.words + ": ");
                                    });
                }
                CHECK(is_wrong_by_answer);
            }
        }
    }
    CHECK(puzzles >= 4);
}

TEST_CASE("The program's answer to each prediction is computed a second time without it") {
    std::set<std::string> all;
    for (const Lesson& lesson : all_lessons()) {
        for (const LessonPrediction& prediction : lesson.predictions)
            all.insert(lesson.id + "/" + prediction.id);
    }
    REQUIRE(all.size() >= 26);
    for (const std::string& name : all) {
        INFO(name << " has no PREDICTIONS_TEST");
        CHECK(test::checked_predictions().count(name) == 1);
    }
    for (const std::string& name : test::checked_predictions()) {
        INFO(name << " has a PREDICTIONS_TEST, but is no prediction of a lesson");
        CHECK(all.count(name) == 1);
    }
}

TEST_CASE("Each lesson holds at least two tasks and two predictions") {
    for (const Lesson& lesson : all_lessons()) {
        INFO(lesson.path);
        CHECK(lesson.tasks.size() >= 2);
        CHECK(lesson.predictions.size() >= 2);
        CHECK(lesson.minutes >= 10);
        CHECK(lesson.minutes <= 20);
    }
}

TEST_CASE("The words of a step are counted without its questions, controls and footnotes") {
    const Lesson lesson = parse_lesson(test::lesson_head() + R"(One two, 3 − *four*[^1].

## Not counted

Five [six seven](tab:rows) `eight`:

| nine | |
|---|---|
| 10 | eleven |

```cpp
int twelve = thirteen;
```

![Not counted.](figures/hidden-stretch.svg)

<!-- task
id = "not-counted"
done = "stage == rows"
recipe = ["set:stage=rows"]
-->
> **Task.** Not counted.

<!-- control
setting = "stage"
-->

> **Fourteen**
>
> - Fifteen.

[^1]: Not counted.
)",
                                       "40-words.md");
    CHECK(lesson.faults.empty());
    REQUIRE(lesson.steps.size() == 2);
    CHECK(count_words(lesson.steps[0]) == 4);
    CHECK(count_words(lesson.steps[1]) == 12); // `int` is one, too
}

TEST_CASE("No step of a lesson has more than 130 words") {
    for (const Lesson& lesson : all_lessons()) {
        for (const LessonStep& step : lesson.steps) {
            const int words = count_words(step);
            INFO(lesson.path << ":" << step.line << ", \"" << heading_text(step) << "\": " << words
                             << " words");
            CHECK(words <= most_step_words);
        }
    }
}

TEST_CASE("Each lesson has its picture in screenshots/ and its place in lessons/README.md, and "
          "none is left over") {
    const std::filesystem::path root(project_root());
    const std::string readme = read_file((root / "lessons/README.md").string());
    std::set<std::string> wanted, found;
    for (const Lesson& lesson : all_lessons()) {
        const std::string picture = std::string("lesson-").append(lesson.id).append(".png");
        wanted.insert(picture);
        INFO(lesson.id << ", " << lesson.title << ", " << lesson.minutes << " minutes");
        CHECK(readme.find("(../screenshots/" + picture + ")") != readme.npos);
        CHECK(readme.find("[" + lesson.title + "](" + lesson.id + ".md), " +
                          std::to_string(lesson.minutes) + " minutes") != readme.npos);
    }
    for (const auto& entry : std::filesystem::directory_iterator(root / "screenshots")) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("lesson-")) found.insert(name);
    }
    CHECK(found == wanted);
}
