#include "lessons/progress.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "base/files.h"
#include "base/toml_input.h"

namespace rasterwalk {

namespace {

LessonProgress parse_lesson_progress(const TomlInput& input) {
    LessonProgress lesson;
    input.allow_only({"last_step", "steps", "tasks", "answers"});
    input.read("last_step", lesson.last_step, 0, most_lesson_steps);
    if (input.find("steps") != nullptr) {
        for (const toml::node& node : input.list("steps")) {
            const auto step = node.value_exact<std::int64_t>();
            if (!step || *step < 0 || *step > most_lesson_steps)
                input.fail(node, "A step must be a whole number.");
            lesson.steps.insert(static_cast<int>(*step));
        }
    }
    if (input.find("tasks") != nullptr) {
        for (const toml::node& node : input.list("tasks")) {
            const auto id = node.value<std::string>();
            if (!id) input.fail(node, "The name of a task must be text.");
            lesson.tasks.insert(*id);
        }
    }
    const toml::node* const answers = input.find("answers");
    if (answers == nullptr) return lesson;
    const TomlInput table = input.table(*answers, "the answers");
    for (const auto& [id, node] : table.nodes()) {
        const TomlInput answer = table.table(node, "an answer");
        answer.allow_only({"said", "right", "second_try", "second"});
        const auto truth = [&](const char* key) {
            const toml::node* const found = answer.find(key);
            if (found == nullptr) return false;
            const std::optional<bool> value = found->value<bool>();
            if (!value) answer.fail(*found, std::string("'") + key + "' must be true or false.");
            return *value;
        };
        lesson.answers[std::string(id.str())] = {answer.text_or_empty("said"), truth("right"),
                                                 truth("second_try"),
                                                 answer.text_or_empty("second")};
    }
    return lesson;
}

const std::string& key_of(const std::string& id) {
    return id;
}
int key_of(int step) {
    return step;
}
template <class Value>
const std::string& key_of(const std::pair<const std::string, Value>& answer) {
    return answer.first;
}

TestAnswers parse_test_answers(const TomlInput& input, std::string_view key) {
    TestAnswers answers;
    const toml::node* const found = input.find(key);
    if (found == nullptr) return answers;
    const TomlInput table = input.table(*found, "the answers of the test");
    for (const auto& [id, node] : table.nodes()) {
        const auto said = node.value<std::string>();
        if (!said) table.fail(node, "An answer of the test must be text.");
        answers[std::string(id.str())] = *said;
    }
    return answers;
}

toml::table table_of(const TestAnswers& answers) {
    toml::table table;
    for (const auto& [id, said] : answers)
        table.insert(id, said);
    return table;
}

/// Removes what is gone in `after` compared with `before`, and adds what is new.
template <class Container>
void merge_changes(const Container& before, const Container& after, Container& theirs) {
    for (const auto& one : before) {
        if (after.count(key_of(one)) == 0) theirs.erase(key_of(one));
    }
    for (const auto& one : after) {
        if (before.count(key_of(one)) == 0) theirs.insert(one);
    }
}

/// An answer that was changed replaces the one that is there.
void merge_test(const TestAnswers& before, const TestAnswers& after, TestAnswers& theirs) {
    merge_changes(before, after, theirs);
    for (const auto& [id, said] : after) {
        const auto was = before.find(id);
        if (was == before.end() || was->second != said) theirs[id] = said;
    }
}

LessonProgress merged(const LessonProgress& before, const LessonProgress& after,
                      LessonProgress theirs) {
    merge_changes(before.steps, after.steps, theirs.steps);
    merge_changes(before.tasks, after.tasks, theirs.tasks);
    merge_changes(before.answers, after.answers, theirs.answers);
    for (auto& [id, answer] : theirs.answers) {
        const auto was = before.answers.find(id), own = after.answers.find(id);
        const bool is_shown = own != after.answers.end() && !own->second.has_second_try;
        const bool was_shown = was != before.answers.end() && !was->second.has_second_try;
        if (!is_shown || was_shown || !answer.has_second_try) continue;
        answer.has_second_try = false;
        answer.second = own->second.second;
    }
    if (after.last_step != before.last_step) theirs.last_step = after.last_step;
    return theirs;
}

} // namespace

const LessonProgress& Progress::of(const std::string& lesson) const {
    static const LessonProgress none;
    const auto found = lessons.find(lesson);
    return found == lessons.end() ? none : found->second;
}

bool Progress::was_step_shown(const std::string& lesson, int step) const {
    return of(lesson).steps.count(step) > 0;
}

bool Progress::is_task_done(const std::string& lesson, const std::string& task) const {
    return of(lesson).tasks.count(task) > 0;
}

void Progress::record_step(const std::string& lesson, int step) {
    last_lesson = lesson;
    lessons[lesson].last_step = step;
    lessons[lesson].steps.insert(step);
    touch();
}

void Progress::record_task(const std::string& lesson, const std::string& task) {
    lessons[lesson].tasks.insert(task);
    touch();
}

void Progress::record_answer(const std::string& lesson, const std::string& prediction,
                             const FirstAnswer& answer) {
    lessons[lesson].answers.try_emplace(prediction, answer);
    touch();
}

bool Progress::has_second_try(const std::string& lesson, const std::string& prediction) const {
    const auto& answers = of(lesson).answers;
    const auto found = answers.find(prediction);
    return found != answers.end() && found->second.has_second_try;
}

void Progress::end_second_try(const std::string& lesson, const std::string& prediction,
                              const std::string& said) {
    if (!has_second_try(lesson, prediction)) return;
    FirstAnswer& answer = lessons[lesson].answers[prediction];
    answer.has_second_try = false;
    answer.second = said;
    touch();
}

bool Progress::is_revealed(const std::string& lesson, const std::string& prediction) const {
    return of(lesson).answers.count(prediction) > 0 && !has_second_try(lesson, prediction);
}

void Progress::touch() {
    static std::uint64_t last = 0;
    number_ = ++last;
}

LessonScore score_of(const Progress& progress, const Lesson& lesson) {
    const LessonProgress& own = progress.of(lesson.id);
    LessonScore score;
    score.all = task_count(lesson) + static_cast<int>(lesson.predictions.size());
    for (const LessonTask& task : lesson.tasks)
        score.solved += own.tasks.count(task.id) > 0 ? 1 : 0;
    for (const LessonPuzzle& puzzle : lesson.puzzles)
        score.solved += own.tasks.count(puzzle.id) > 0 ? 1 : 0;
    for (const LessonPrediction& prediction : lesson.predictions) {
        if (!progress.is_revealed(lesson.id, prediction.id)) continue;
        ++score.answered;
        score.right += own.answers.at(prediction.id).is_right ? 1 : 0;
    }
    score.done = score.solved + score.answered;
    const int last = static_cast<int>(lesson.steps.size()) - 1;
    score.last_step = std::clamp(own.last_step, 0, std::max(last, 0));
    bool all_seen = true;
    for (int step = 0; step <= last; ++step)
        all_seen = all_seen && own.steps.count(step) > 0;
    score.is_done = all_seen && score.done == score.all;
    return score;
}

std::string lesson_to_open(const Progress& progress, const std::vector<Lesson>& lessons) {
    if (lessons.empty()) return {};
    for (const Lesson& lesson : lessons) {
        if (lesson.id == progress.last_lesson && !score_of(progress, lesson).is_done) {
            return lesson.id;
        }
    }
    for (const Lesson& lesson : lessons) {
        if (!score_of(progress, lesson).is_done) return lesson.id;
    }
    return lessons.front().id;
}

std::string progress_text(const Progress& progress) {
    toml::table lessons;
    for (const auto& [id, own] : progress.lessons) {
        toml::array steps, tasks;
        for (const int step : own.steps)
            steps.push_back(step);
        for (const std::string& task : own.tasks)
            tasks.push_back(task);
        toml::table answers;
        for (const auto& [prediction, answer] : own.answers) {
            toml::table one{{"said", answer.said}, {"right", answer.is_right}};
            if (answer.has_second_try) one.insert("second_try", true);
            if (!answer.second.empty()) one.insert("second", answer.second);
            answers.insert(prediction, std::move(one));
        }
        lessons.insert(id, toml::table{{"last_step", own.last_step},
                                       {"steps", std::move(steps)},
                                       {"tasks", std::move(tasks)},
                                       {"answers", std::move(answers)}});
    }
    std::ostringstream out;
    toml::table all{{"last_lesson", progress.last_lesson}, {"lessons", std::move(lessons)}};
    if (!progress.test_before.empty()) all.insert("test_before", table_of(progress.test_before));
    if (!progress.test_after.empty()) all.insert("test_after", table_of(progress.test_after));
    out << all << '\n';
    return out.str();
}

Progress parse_progress(std::string_view text, const std::string& path) {
    const toml::table root = parse_toml(text, path);
    const TomlInput input(root, path, "the progress");
    input.allow_only({"last_lesson", "lessons", "test_before", "test_after"});
    Progress progress;
    progress.last_lesson = input.text_or_empty("last_lesson");
    progress.test_before = parse_test_answers(input, "test_before");
    progress.test_after = parse_test_answers(input, "test_after");
    if (!progress.test_before.empty() || !progress.test_after.empty()) progress.touch();
    const toml::node* const lessons = input.find("lessons");
    if (lessons == nullptr) return progress;
    const TomlInput table = input.table(*lessons, "the lessons");
    for (const auto& [id, node] : table.nodes()) {
        progress.lessons[std::string(id.str())] =
            parse_lesson_progress(table.table(node, "a lesson"));
    }
    progress.touch();
    return progress;
}

Progress read_progress(const std::string& path) {
    std::error_code fault;
    if (!std::filesystem::exists(path, fault) && !fault) return {};
    return parse_progress(read_file(path, largest_progress), path);
}

Progress merged(const Progress& before, const Progress& after, const Progress& theirs) {
    if (theirs == before) return after;
    Progress result = theirs;
    result.touch();
    merge_test(before.test_before, after.test_before, result.test_before);
    merge_test(before.test_after, after.test_after, result.test_after);
    if (after.last_lesson != before.last_lesson) result.last_lesson = after.last_lesson;
    std::set<std::string> ids;
    for (const Progress* const one : {&before, &after, &theirs}) {
        for (const auto& [id, lesson] : one->lessons)
            ids.insert(id);
    }
    for (const std::string& id : ids) {
        LessonProgress lesson = merged(before.of(id), after.of(id), theirs.of(id));
        if (lesson == LessonProgress{}) {
            result.lessons.erase(id);
        } else {
            result.lessons[id] = std::move(lesson);
        }
    }
    return result;
}

Progress write_progress(const Progress& before, const Progress& after, const std::string& path) {
    make_folder_of(path);
    const FileLock lock(path);
    Progress kept = merged(before, after, read_progress(path));
    write_file(path, progress_text(kept));
    return kept;
}

std::string state_folder() {
    const char* const state = std::getenv("XDG_STATE_HOME");
    if (state != nullptr && *state == '/') return std::string(state).append("/rasterwalk");
    const char* const home = std::getenv("HOME");
    if (home == nullptr || *home == '\0') return {};
    return std::string(home).append("/.local/state/rasterwalk");
}

} // namespace rasterwalk
