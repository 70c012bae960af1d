#include "ui/lesson/stage_page.h"

#include <algorithm>
#include <string>

#include "facts/facts.h"
#include "session/glossary.h"
#include "ui/actions/actions.h"
#include "ui/actions/lesson_links.h"
#include "ui/lesson/page_footer.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

void draw_heading(Ui& ui, const StageInfo& info) {
    text_in(palette(ui.options.theme).dim,
            "Stage " + std::to_string(strip_place(info.step) + 1) + " of " +
                std::to_string(stage_count) + " · " + section_words(info.section),
            ui.fonts.small);
    ImGui::Dummy({0.0f, 2.0f * ui.options.text_scale});
}

/// The stage's own title and summary, for when its note cannot be read.
void draw_missing(Ui& ui, const StageInfo& info, const StageNote& note) {
    wrapped_text(info.title, ui.fonts.title);
    ImGui::Spacing();
    wrapped_text(info.summary);
    ImGui::Spacing();
    wrapped_text_in(palette(ui.options.theme).dim,
                    "The page about this stage is missing: " + note.fault);
}

void draw_text(Ui& ui, const StageInfo& info, float width) {
    LessonView& lesson = ui.lesson;
    const StageNote& note = lesson.notes.find(note_name(ui.session));
    draw_heading(ui, info);
    if (!note.fault.empty()) {
        draw_missing(ui, info, note);
    } else {
        std::shared_ptr<MarkdownPage>& page = lesson.pages["stage"];
        const MarkdownEvents events =
            draw_markdown(ui, page, shown_note(ui, note), width, "lesson.link.");
        answer_links(ui, document_of(*page), events);
    }
    ImGui::Dummy({0.0f, 10.0f * ui.options.text_scale});
}

} // namespace

std::string shown_note(const Ui& ui, const StageNote& note) {
    return note_about(note.text, Facts(ui.session, ui.results));
}

std::string stage_page_name(Ui& ui) {
    return ui.lesson.notes.find(note_name(ui.session)).path;
}

void draw_stage_text(Ui& ui, float width) {
    draw_text(ui, stage_info(ui.session.a.settings), width);
}

PageFooter pages_of_stages(const Ui& ui) {
    PageFooter footer;
    const StripStep here = step_of(ui.session.a.settings);
    footer.current = strip_place(here);
    for (const StageInfo& info : stage_list()) {
        footer.pages.push_back(
            {"lesson.bar." + std::string(info.name), std::string(info.title), info.step <= here});
    }
    return footer;
}

void turn_to_stage(Ui& ui, int wanted) {
    if (wanted < 0) return;
    const StageInfo& stage = stage_list()[static_cast<std::size_t>(wanted)];
    find_action("stage." + std::string(stage.name)).run(ui);
}

void draw_stage_footer(Ui& ui, float width) {
    const PageFooter pages = pages_of_stages(ui);
    const PageRequest request = draw_page_footer(ui, pages, width);
    turn_to_stage(ui, request.direction != 0 ? pages.current + request.direction : request.page);
}

} // namespace rasterwalk
