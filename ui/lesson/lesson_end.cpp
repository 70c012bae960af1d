#include "ui/lesson/lesson_end.h"

#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "lessons/progress.h"
#include "text/markdown_text.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The steps with something not answered or not done.
std::vector<int> open_steps(const Progress& progress, const Lesson& lesson) {
    std::set<int> steps;
    for (const LessonPrediction& prediction : lesson.predictions) {
        if (!progress.is_revealed(lesson.id, prediction.id)) steps.insert(prediction.step);
    }
    for (const LessonTask& task : lesson.tasks) {
        if (!progress.is_task_done(lesson.id, task.id)) steps.insert(task.step);
    }
    for (const LessonPuzzle& puzzle : lesson.puzzles) {
        if (!progress.is_task_done(lesson.id, puzzle.id)) steps.insert(puzzle.step);
    }
    return {steps.begin(), steps.end()};
}

/// "4 of 6 predictions right at the first try, 2 of 3 tasks done."
std::string done_so_far(const Ui& ui, const Lesson& lesson) {
    const LessonScore score = score_of(ui.lesson.progress, lesson);
    std::string text = tr(score.is_done ? "**Lesson done.**" : "**The end of the lesson.**");
    if (score.all == 0) return text;
    text += " ";
    const std::size_t predictions = lesson.predictions.size();
    if (predictions > 0) {
        text += predictions == 1
                    ? tr("{} of 1 prediction right on the first try", score.right)
                    : tr("{} of {} predictions right on the first try", score.right, predictions);
    }
    if (const int tasks = task_count(lesson); tasks > 0) {
        text += predictions == 0 ? "" : ", ";
        text += tasks == 1 ? tr("{} of 1 task done", score.solved)
                           : tr("{} of {} tasks done", score.solved, tasks);
    }
    text += ".";
    const std::vector<int> steps = open_steps(ui.lesson.progress, lesson);
    if (!steps.empty()) {
        const std::string list = fmt::format("{}", fmt::join(steps, ", "));
        text += " " + (steps.size() > 1 ? tr("Still open: steps {}.", list)
                                        : tr("Still open: step {}.", list));
    }
    return text;
}

/// A sentence on the track that ends with the lesson and the one that begins with the next; empty
/// if it goes on.
std::string end_of_track(Ui& ui, const Lesson& lesson, const Lesson& next) {
    const Course& course = ui.lesson.lessons.course();
    const Track* const ended = track_of(course, lesson.id);
    const Track* const begun = track_of(course, next.id);
    if (ended == nullptr || begun == nullptr || ended == begun) return {};
    return tr("*{}* ends here, and *{}* begins.", as_markdown(ended->title),
              as_markdown(begun->title)) +
           " ";
}

/// The next lesson, with a link; a lesson that is not written yet is skipped.
std::string next_lesson_link(Ui& ui, const Lesson& lesson) {
    const std::string id = lesson_after(ui, lesson.id);
    const Lesson* const next = id.empty() ? nullptr : ui.lesson.lessons.find(id);
    if (next == nullptr)
        return tr(
            "This is the last lesson. Next comes [your own program](show:tab.lab), with all of "
            "this in it.");
    std::string text = end_of_track(ui, lesson, *next);
    text += tr("Next: lesson {}, {}. {}", lesson_number(id), link_to_lesson(*next),
               as_markdown(next->about));
    return text;
}

} // namespace

bool is_last_step(const Ui& ui, const Lesson& lesson) {
    return ui.session.step + 1 == static_cast<int>(lesson.steps.size());
}

std::string end_of_lesson(Ui& ui, const Lesson& lesson) {
    std::string text = done_so_far(ui, lesson) + "\n\n" + next_lesson_link(ui, lesson);
    if (lesson.sources.empty()) return text;
    text += "\n";
    for (const std::string& source : lesson.sources)
        text += "\n- " + tr("Source: {}", source);
    return text;
}

void draw_lesson_end(Ui& ui, const Lesson& lesson, float width) {
    const float u = ui.options.text_scale;
    ImGui::Dummy({0.0f, 8.0f * u});
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + width, at.y + 1.0f},
                                              packed(palette(ui.options.theme).line));
    ImGui::Dummy({0.0f, 6.0f * u});
    std::shared_ptr<MarkdownPage>& page = ui.lesson.pages["end"];
    const std::string text = end_of_lesson(ui, lesson);
    const MarkdownEvents events =
        draw_markdown(ui, page, text, width, "lesson.end.link.", ui.session.lesson_folder);
    register_widget(ui, "lesson.end", {}, text);
    answer_links(ui, document_of(*page), events);
}

} // namespace rasterwalk
