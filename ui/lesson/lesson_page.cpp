#include "ui/lesson/lesson_page.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "session/glossary.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/lesson/lesson_box.h"
#include "ui/lesson/lesson_controls.h"
#include "ui/lesson/lesson_end.h"
#include "ui/lesson/lesson_predictions.h"
#include "ui/lesson/lesson_puzzles.h"
#include "ui/lesson/lesson_tasks.h"
#include "ui/lesson/page_footer.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

const LessonStep& shown_step(const Ui& ui, const Lesson& lesson) {
    const int last = static_cast<int>(lesson.steps.size()) - 1;
    return lesson.steps[static_cast<std::size_t>(std::clamp(ui.session.step, 0, last))];
}

std::string place_in_lesson(const Ui& ui, const Lesson& lesson) {
    const int last = static_cast<int>(lesson.steps.size()) - 1;
    return ui.session.step == 0 ? tr("lesson {}", lesson_number(lesson.id))
                                : tr("step {} of {}", ui.session.step, last);
}

namespace {

/// "Lesson 4 · 15 minutes · lab: Interpolation" over the opening, "Lesson 4 · step 2 of 8" later.
void draw_heading(Ui& ui, const Lesson& lesson) {
    const int last = static_cast<int>(lesson.steps.size()) - 1;
    const int number = lesson_number(lesson.id);
    const std::string text = ui.session.step == 0
                                 ? tr("Lesson {} · {} minutes · {}", number, lesson.minutes,
                                      section_words(lesson.section, current_language()))
                                 : tr("Lesson {} · step {} of {}", number, ui.session.step, last);
    wrapped_text_in(palette(ui.options.theme).dim, text, ui.fonts.small);
    ImGui::Dummy({0.0f, 2.0f * ui.options.text_scale});
}

/// Where a part of the step is in its whole text.
struct PartArea {
    int part = 0;
    float top = 0.0f, bottom = 0.0f; ///< screen pixels
};

/// A line of text is left above what is scrolled to.
float line_above(const Ui& ui) {
    return 1.4f * ui.fonts.text->FontSize;
}

/// How far the text is scrolled when this place is at the top.
float scroll_at(const Ui& ui, const PartArea& area, float share) {
    if (area.part == 0 && share == 0.0f) return 0.0f; // the heading above it
    const float top = area.top + share * (area.bottom - area.top);
    const float above = share > 0.0f ? line_above(ui) : 0.0f;
    return std::floor(top - above - ImGui::GetWindowPos().y + ImGui::GetScrollY());
}

/// Is there anything left to do or to answer in this part?
bool is_open(const Ui& ui, const Lesson& lesson, const LessonPart& part) {
    const auto index = static_cast<std::size_t>(part.index);
    switch (part.kind) {
    case LessonPart::Kind::text:
    case LessonPart::Kind::control:
        return false;
    case LessonPart::Kind::task:
        return !ui.lesson.progress.is_task_done(lesson.id, lesson.tasks[index].id);
    case LessonPart::Kind::puzzle:
        return !ui.lesson.progress.is_task_done(lesson.id, lesson.puzzles[index].id);
    case LessonPart::Kind::prediction: {
        const LessonPrediction& prediction = lesson.predictions[index];
        const auto view = ui.lesson.predictions.find(prediction.id);
        // Not there if a link has led elsewhere.
        return view != ui.lesson.predictions.end() && view->second.is_taken_up &&
               !is_revealed(ui, lesson, prediction);
    }
    }
    return false;
}

/// Is the part last drawn still out of sight? A part that the window cannot hold is in sight when
/// it is at the top.
bool is_below(const Ui& ui, const PartArea& area) {
    const float furthest = std::min(scroll_at(ui, area, 0.0f), ImGui::GetScrollMaxY());
    return is_cut_off() && ImGui::GetScrollY() < furthest - 1.0f;
}

/// Notes for the strip how far the student has scrolled the whole text.
void record_visit(Ui& ui, const std::vector<PartArea>& areas) {
    LessonView& view = ui.lesson;
    const float scroll = ImGui::GetScrollY(), last = ImGui::GetScrollMaxY();
    const bool is_led = view.place_to_show || view.frames_to_scroll > 0;
    const std::optional<float> before = view.known_scroll;
    view.known_scroll = is_led ? std::nullopt : std::optional(scroll);
    if (is_led || !before || *before == scroll) return;
    view.wants_end = false;
    const float top = ImGui::GetWindowPos().y + line_above(ui);
    for (const PartArea& area : areas) {
        if (area.part > 0 && area.top > top) break;
        const float share = (top - area.top) / std::max(area.bottom - area.top, 1.0f);
        view.strip.read_to = {area.part, std::clamp(share, 0.0f, 1.0f)};
    }
    if (scroll >= last && !areas.empty()) view.strip.read_to = {areas.back().part, 1.0f};
}

} // namespace

void draw_lesson_faults(Ui& ui, const Lesson& lesson) {
    if (lesson.faults.empty()) return;
    const Fault& first = lesson.faults.front();
    std::string text = fault_text(lesson, first);
    if (lesson.faults.size() > 1) {
        text.append(" And ").append(std::to_string(lesson.faults.size() - 1)).append(" more.");
    }
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(Meaning::fail, ui.options.theme));
    wrapped_text(text);
    register_widget(ui, "lesson.faults", tr("rasterwalk check lists all of them."));
    ImGui::PopStyleColor();
    ImGui::Spacing();
}

void draw_step_text(Ui& ui, const Lesson& lesson, float width) {
    const LessonStep& step = shown_step(ui, lesson);
    // The drawer, which has few lines, says it above its text.
    if (!is_drawer_open(ui)) draw_heading(ui, lesson);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    draw_lesson_faults(ui, lesson);
    ImGui::PopTextWrapPos();
    const float gap = 0.6f * ui.fonts.text->FontSize;
    std::shared_ptr<MarkdownPage>& heading = ui.lesson.pages["heading"];
    draw_markdown(ui, heading, "# " + step.heading, width, "lesson.heading.link.");
    std::vector<PartArea> areas;
    ui.lesson.open_below.reset();
    for (std::size_t i = 0; i < step.parts.size(); ++i) {
        const LessonPart& part = step.parts[i];
        ImGui::Dummy({0.0f, i == 0 ? 0.4f * gap : gap});
        const float top = ImGui::GetCursorScreenPos().y;
        switch (part.kind) {
        case LessonPart::Kind::text: {
            const std::string name = "lesson.part" + std::to_string(i);
            draw_marked(ui, name, ui.lesson.pages[name], with_footnotes(lesson, part.text), width);
            break;
        }
        case LessonPart::Kind::task:
            draw_task(ui, lesson, lesson.tasks[static_cast<std::size_t>(part.index)], width);
            break;
        case LessonPart::Kind::prediction:
            draw_prediction(ui, lesson, lesson.predictions[static_cast<std::size_t>(part.index)],
                            width);
            break;
        case LessonPart::Kind::puzzle:
            draw_puzzle(ui, lesson, lesson.puzzles[static_cast<std::size_t>(part.index)], width);
            break;
        case LessonPart::Kind::control:
            draw_lesson_control(ui, lesson.controls[static_cast<std::size_t>(part.index)], width);
            break;
        }
        const PartArea area{static_cast<int>(i), top, ImGui::GetCursorScreenPos().y};
        areas.push_back(area);
        if (ui.lesson.open_below || !is_open(ui, lesson, part) || !is_below(ui, area)) continue;
        ui.lesson.open_below = area.part;
    }
    if (is_last_step(ui, lesson)) {
        const float top = ImGui::GetCursorScreenPos().y;
        draw_lesson_end(ui, lesson, width);
        areas.push_back({static_cast<int>(step.parts.size()), top, ImGui::GetCursorScreenPos().y});
    }
    // Drawing may have led to another step, which asks for a different place.
    std::optional<LessonPlace>& place = ui.lesson.place_to_show;
    const bool is_here = place && static_cast<std::size_t>(place->part) < areas.size();
    if (is_here) {
        const PartArea& area = areas[static_cast<std::size_t>(place->part)];
        ImGui::SetScrollY(scroll_at(ui, area, place->share));
    }
    record_visit(ui, areas);
    if (ui.lesson.frames_to_scroll == 0) place.reset();
    ImGui::Dummy({0.0f, 10.0f * ui.options.text_scale});
}

PageFooter pages_of_lesson(Ui& ui, const Lesson& lesson) {
    PageFooter footer;
    footer.current = ui.session.step;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        footer.pages.push_back({"lesson.step." + std::to_string(i), lesson.steps[i].heading,
                                ui.lesson.progress.was_step_shown(lesson.id, static_cast<int>(i))});
    }
    if (!lesson_after(ui, lesson.id).empty()) footer.beyond = tr("next lesson");
    return footer;
}

void turn_to_step(Ui& ui, const Lesson& lesson, int wanted) {
    if (wanted < 0) return;
    if (wanted < static_cast<int>(lesson.steps.size())) {
        open_lesson(ui, lesson.id, wanted);
    } else {
        open_lesson(ui, lesson_after(ui, lesson.id), 0);
    }
}

void turn_in_lesson(Ui& ui, const Lesson& lesson, int direction) {
    if (direction < 0) {
        read_back(ui);
    } else if (!turn_card(ui, direction)) {
        turn_to_step(ui, lesson, ui.session.step + 1);
    }
}

namespace {

PageFooter::Open open_below(const Ui& ui, const LessonStep& step) {
    if (!ui.lesson.open_below) return PageFooter::Open::nothing;
    const auto part = static_cast<std::size_t>(*ui.lesson.open_below);
    if (part >= step.parts.size()) return PageFooter::Open::nothing; // a link has led elsewhere
    const bool is_question = step.parts[part].kind == LessonPart::Kind::prediction;
    return is_question ? PageFooter::Open::question : PageFooter::Open::task;
}

} // namespace

void draw_step_footer(Ui& ui, const Lesson& lesson, float width) {
    PageFooter pages = pages_of_lesson(ui, lesson);
    pages.open_below = open_below(ui, shown_step(ui, lesson));
    const PageRequest request = draw_page_footer(ui, pages, width);
    if (request.direction != 0) {
        turn_in_lesson(ui, lesson, request.direction);
    } else {
        turn_to_step(ui, lesson, request.page);
    }
}

} // namespace rasterwalk
