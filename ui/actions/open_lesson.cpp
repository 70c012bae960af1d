#include "ui/actions/open_lesson.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <imgui.h>

#include "base/error.h"
#include "session/content.h"
#include "ui/actions/kept_file.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// Discards what belongs to the step that was shown.
void forget_step(LessonView& view) {
    view.pages.clear();
    view.open_hints.clear();
    view.task_words.clear();
    for (auto& [id, prediction] : view.predictions)
        prediction.is_in_picture = false;
    view.meant.clear();
    view.pointed_at.clear();
    view.of_step.clear();
    view.is_pinned = false;
    view.strip.cards.clear();
    view.strip.card = 0;
    view.strip.place = {};
    view.strip.read_to.reset();
    view.place_to_show.reset();
    view.open_below.reset();
    view.wants_end = false;
}

/// Points at the widget that a step or an answer names, if it does.
void point_as_named(Ui& ui, const std::optional<std::string>& widget) {
    if (!widget) return;
    point_at_widget_of_step(ui, *widget);
    // The formula of a number in the table of vertices is shown.
    constexpr std::string_view vertices = "vertices.";
    if (widget->starts_with(vertices))
        ui.inspector.chosen.vertex_number = widget->substr(vertices.size());
}

/// Notes that the current step was reached, and points at what it names.
void enter_step(Ui& ui, const Lesson& lesson) {
    ui.lesson.progress.record_step(lesson.id, ui.session.step);
    point_as_named(ui, lesson.steps[static_cast<std::size_t>(ui.session.step)].state.point_at);
}

} // namespace

void take_up_lesson(Ui& ui) {
    Session& session = ui.session;
    LessonView& view = ui.lesson;
    view.predictions.clear();
    view.puzzles.clear();
    if (session.lesson.empty()) {
        forget_step(view);
        return;
    }
    const std::string& folder = session.lesson_folder;
    if (!folder.empty()) {
        if (view.lessons.folder() != folder) view.lessons.read_folder(folder);
    } else if (const std::string own = lessons_folder(); view.lessons.folder() != own) {
        view.lessons.read_folder(own);
    }
    const Lesson* const lesson = view.lessons.find(session.lesson);
    if (lesson == nullptr) {
        session.notice = "There is no lesson '" + session.lesson.substr(0, 60) + "'.";
        session.lesson.clear();
        session.step = 0;
        return;
    }
    session.step = std::clamp(session.step, 0, static_cast<int>(lesson->steps.size()) - 1);
    forget_step(view);
    enter_step(ui, *lesson);
}

void open_lesson(Ui& ui, std::string_view id, int step) {
    LessonView& view = ui.lesson;
    const Lesson* const lesson = view.lessons.find(id);
    if (lesson == nullptr) {
        ui.session.notice = "There is no lesson '" + std::string(id.substr(0, 60)) + "'.";
        return;
    }
    if (!is_readable(*lesson)) {
        ui.session.notice = fault_text(*lesson, lesson->faults.front());
        return;
    }
    const bool is_another = ui.session.lesson != lesson->id;
    if (is_another) {
        view.predictions.clear();
        view.puzzles.clear();
    }
    // Choosing a lesson, or a place in one, means wanting to see it.
    if (is_another || ui.session.page == SidePage::list) view.drawer_is_open = false;
    forget_step(view);
    const std::vector<Fault> faults = rasterwalk::open_step(ui.session, *lesson, step);
    ui.session.notice = faults.empty() ? "" : fault_text(*lesson, faults.front());
    enter_step(ui, *lesson);
}

void close_lesson(Ui& ui) {
    Session& session = ui.session;
    if (session.lesson.empty()) return;
    session.lesson.clear();
    session.lesson_folder.clear();
    session.step = 0;
    session.page = SidePage::lesson;
    guide_to_tab(session, {});
    take_up_lesson(ui);
}

void open_lesson_to_go_on(Ui& ui) {
    const std::string id = lesson_to_open(ui.lesson.progress, ui.lesson.lessons.all());
    if (!id.empty()) open_lesson(ui, id, ui.lesson.progress.of(id).last_step);
}

void open_neighbour_step(Ui& ui, int distance) {
    const Lesson* const lesson = open_lesson_of(ui);
    if (lesson == nullptr) {
        ui.session.notice = "No lesson is open. Press L to list them.";
        return;
    }
    const int step = ui.session.step + distance;
    if (step < 0 || step >= static_cast<int>(lesson->steps.size())) return;
    open_lesson(ui, std::string(lesson->id), step);
}

namespace {

/// In a lecture: the question shown, if it has not been answered; null if there is none.
const LessonPrediction* open_question(Ui& ui, const Lesson& lesson) {
    const LessonStrip& strip = ui.lesson.strip;
    const auto card = static_cast<std::size_t>(strip.card);
    if (!ui.options.is_lecture || ui.lesson.drawer_is_open || card >= strip.cards.size() ||
        ui.lesson.lessons.course().answers == AnswerRule::after_tries)
        return nullptr;
    const LessonStep& step = lesson.steps[static_cast<std::size_t>(ui.session.step)];
    const auto number = static_cast<std::size_t>(strip.cards[card].part);
    if (number >= step.parts.size() || step.parts[number].kind != LessonPart::Kind::prediction)
        return nullptr;
    const LessonPrediction& prediction =
        lesson.predictions[static_cast<std::size_t>(step.parts[number].index)];
    return is_revealed(ui, lesson, prediction) ? nullptr : &prediction;
}

} // namespace

bool turn_card(Ui& ui, int distance) {
    LessonView& view = ui.lesson;
    if (ui.session.page == SidePage::stage || is_list_shown(ui)) return false;
    if (!view.is_strip) {
        const Lesson* const lesson = distance > 0 ? open_lesson_of(ui) : nullptr;
        const int last = lesson != nullptr ? static_cast<int>(lesson->steps.size()) - 1 : -1;
        if (ui.session.step == last && view.has_more_below) {
            view.pages_to_scroll = 1.0f; // to the end of the lesson
            return true;
        }
        if (distance < 0 || !view.open_below) return false;
        view.place_to_show = LessonPlace{*view.open_below};
        return true;
    }
    // First what is scrolled away.
    if (distance > 0 ? view.has_more_below : view.has_more_above) {
        view.pages_to_scroll = static_cast<float>(distance);
        return true;
    }
    if (view.drawer_is_open) return false;
    const Lesson* const lesson = open_lesson_of(ui);
    if (distance > 0 && lesson != nullptr) {
        // The lecturer has asked the audience, and has no other key.
        if (const LessonPrediction* const question = open_question(ui, *lesson)) {
            reveal_answer(ui, *lesson, *question);
            return true;
        }
    }
    const int card = view.strip.card + distance;
    if (card < 0 || card >= static_cast<int>(view.strip.cards.size())) return false;
    view.strip.card = card;
    return true;
}

void read_on(Ui& ui) {
    if (!turn_card(ui, 1)) open_neighbour_step(ui, 1);
}

void read_back(Ui& ui) {
    if (turn_card(ui, -1)) return;
    const int step = ui.session.step;
    open_neighbour_step(ui, -1);
    if (ui.session.step != step) ui.lesson.wants_end = ui.lesson.is_strip;
}

bool lesson_was_edited(const Ui& ui) {
    return !ui.session.lesson.empty() && ui.lesson.lessons.is_edited(ui.session.lesson);
}

const Lesson* open_lesson_of(Ui& ui) {
    return ui.session.lesson.empty() ? nullptr : ui.lesson.lessons.find(ui.session.lesson);
}

void tick_off_tasks(Ui& ui) {
    const Lesson* const lesson = open_lesson_of(ui);
    if (lesson == nullptr) return;
    LessonView& view = ui.lesson;
    const Facts facts(ui.session, ui.results, &view.facts);
    for (const LessonTask& task : lesson->tasks) {
        if (task.step != ui.session.step) continue;
        TaskWords& words = view.task_words[task.id];
        const std::string before = words.text;
        if (view.progress.is_task_done(lesson->id, task.id)) {
            // The numbers of a reason are from the moment in which it was solved.
            if (!words.is_reason)
                words = {needs_numbers(task.because) ? "" : reason_of(task, facts), true};
        } else if (is_done(task, facts)) {
            view.progress.record_task(lesson->id, task.id);
            view.strip.is_recut = true;
            words = {reason_of(task, facts), true};
        } else {
            words = {not_yet(task, facts), false};
        }
        if (words.text == before || words.text.empty()) continue;
        view.fresh = "lesson.task." + task.id + ".words";
        view.frames_to_fresh = 2;
    }
}

namespace {

/// Shows in the session what the step shows after the answer.
void show_reveal(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction) {
    ui.lesson.predictions[prediction.id].is_in_picture = true;
    if (!prediction.then) return;
    Session& session = ui.session;
    const ViewState& step = lesson.steps[static_cast<std::size_t>(session.step)].state;
    // The answer's own state may lead to a tab; the step's own tab leaves the student's alone.
    const bool keeps_tab = session.tab_guide.is_own && prediction.then->tab == step.tab;
    const bool shows_all = session.tab_guide.shows_all;
    const std::string own_tab(tab_below(session));
    const std::vector<Fault> faults = show_state(session, *prediction.then, lesson.folder);
    if (keeps_tab) keep_own_tab(session, own_tab);
    session.tab_guide.shows_all = shows_all;
    if (!faults.empty()) session.notice = fault_text(lesson, faults.front());
    point_as_named(ui, prediction.then->point_at);
}

} // namespace

void answer_prediction(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction,
                       const GivenAnswer& answer, std::string said) {
    PredictionView& view = ui.lesson.predictions[prediction.id];
    Progress& progress = ui.lesson.progress;
    view.judged = judge(lesson, prediction, answer, ui.session);
    view.is_fresh = true;
    view.because = nullptr;
    view.typed.clear();
    ui.lesson.strip.is_recut = true;
    const bool is_first = progress.of(lesson.id).answers.count(prediction.id) == 0;
    const bool may_try_again = is_first && !view.judged->is_right && view.judged->fault.empty();
    progress.record_answer(lesson.id, prediction.id, {said, view.judged->is_right, may_try_again});
    view.said = std::move(said);
    if (may_try_again) return;
    progress.end_second_try(lesson.id, prediction.id, view.said);
    show_reveal(ui, lesson, prediction);
}

namespace {

/// The answer used when none was given: it is never right.
GivenAnswer no_answer(const LessonPrediction& prediction) {
    if (prediction.kind == LessonPrediction::Kind::number) return {std::nan("")};
    if (prediction.kind == LessonPrediction::Kind::choice) return {-1};
    return {prediction.wrong_pixel.value_or(glm::ivec2(0, 0))};
}

} // namespace

bool is_revealed(const Ui& ui, const Lesson& lesson, const LessonPrediction& prediction) {
    const auto view = ui.lesson.predictions.find(prediction.id);
    return view != ui.lesson.predictions.end() && view->second.judged &&
           !ui.lesson.progress.has_second_try(lesson.id, prediction.id);
}

void reveal_answer(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction) {
    PredictionView& view = ui.lesson.predictions[prediction.id];
    if (!view.judged) view.judged = judge(lesson, prediction, no_answer(prediction), ui.session);
    view.is_fresh = true;
    view.because = nullptr;
    ui.lesson.strip.is_recut = true;
    ui.lesson.progress.end_second_try(lesson.id, prediction.id);
    show_reveal(ui, lesson, prediction);
}

void ask_again(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction) {
    PredictionView& view = ui.lesson.predictions[prediction.id];
    view.judged.reset();
    view.typed.clear();
    view.takes_keys = true;
    ui.lesson.strip.is_recut = true;
    if (!prediction.then) return;
    const std::vector<Fault> faults = rasterwalk::open_step(ui.session, lesson, ui.session.step);
    if (!faults.empty()) ui.session.notice = fault_text(lesson, faults.front());
}

bool take_up_answer(Ui& ui, const Lesson& lesson, const LessonPrediction& prediction) {
    PredictionView& view = ui.lesson.predictions[prediction.id];
    if (view.is_taken_up || view.judged) return true;
    view.is_taken_up = true;
    const auto& answers = ui.lesson.progress.of(lesson.id).answers;
    const auto kept = answers.find(prediction.id);
    if (kept == answers.end()) return true;
    const std::string& second = kept->second.second;
    const std::string said = second.empty() ? kept->second.said : second;
    const std::optional<GivenAnswer> answer = answer_in_words(prediction, said);
    if (!answer) return true;
    if (ui.lesson.frame_of_answer == ImGui::GetFrameCount()) {
        ui.lesson.frame_of_waiting = ImGui::GetFrameCount();
        view.is_taken_up = false;
        return false;
    }
    ui.lesson.frame_of_answer = ImGui::GetFrameCount();
    view.judged = judge(lesson, prediction, *answer, ui.session);
    view.said = said;
    ui.lesson.strip.is_recut = true;
    // The lesson may have changed since: there is nothing to try again.
    if (view.judged->is_right || !view.judged->fault.empty())
        ui.lesson.progress.end_second_try(lesson.id, prediction.id);
    return true;
}

bool is_answer_waiting(const Ui& ui) {
    return ui.lesson.frame_of_waiting == ImGui::GetFrameCount();
}

std::string lesson_after(Ui& ui, std::string_view id) {
    const std::vector<Lesson>& lessons = ui.lesson.lessons.all();
    for (std::size_t i = 0; i + 1 < lessons.size(); ++i) {
        if (lessons[i].id != id) continue;
        const auto next = std::find_if(lessons.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                       lessons.end(), is_readable);
        return next == lessons.end() ? std::string() : next->id;
    }
    return {};
}

void reset_progress(Ui& ui) {
    LessonView& view = ui.lesson;
    view.progress = {};
    view.predictions.clear();
    view.puzzles.clear();
    view.task_words.clear();
    view.strip.is_recut = true;
    try {
        // What another window has kept in the meantime must be discarded too.
        if (!view.progress_file.path.empty())
            view.kept_progress = read_progress(view.progress_file.path);
    } catch (const Error&) {
        // A fault will show when it is written.
    }
}

void keep_progress(Ui& ui, const std::string& path) {
    LessonView& view = ui.lesson;
    take_up_kept(ui, view.progress_file, path, "Progress", [&] {
        view.progress = read_progress(path);
        view.kept_progress = view.progress;
    });
}

void save_progress(Ui& ui) {
    LessonView& view = ui.lesson;
    if (view.progress == view.kept_progress) return;
    write_kept(ui, view.progress_file, "Progress", [&] {
        view.progress = write_progress(view.kept_progress, view.progress, view.progress_file.path);
        view.kept_progress = view.progress;
    });
}

} // namespace rasterwalk
