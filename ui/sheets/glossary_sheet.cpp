#include <string>

#include <imgui.h>

#include "base/letter_case.h"
#include "session/glossary.h"
#include "ui/sheets/reading_sheet.h"
#include "ui/sheets/sheets.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

const SheetLook glossary_look{.sheet = Sheet::glossary,
                              .window = "glossary",
                              .widgets = "glossary",
                              .title = "Glossary",
                              .close_help = "Closes the glossary. Keys: F2, Esc",
                              .size = {520.0f, 640.0f}};

bool has_word(const Term& term, const std::string& search) {
    return contains_in_any_case(term.word, search) || contains_in_any_case(term.sentence, search);
}

void draw_term(Ui& ui, const Term& term) {
    const Palette& p = palette(ui.options.theme);
    ImGui::PushFont(ui.fonts.bold);
    put_text(term.word);
    // Together with the first line of the meaning.
    keep_beginning(ImGui::GetItemRectMin().y,
                   ImGui::GetCursorScreenPos().y + ImGui::GetTextLineHeight());
    ImGui::PopFont();
    register_widget(ui, "glossary.term." + term.word, section_words(term.section));
    wrapped_text(term.sentence);
    text_in(p.dim, section_words(term.section), ui.fonts.small);
    ImGui::Spacing();
}

} // namespace

void draw_glossary_sheet(Ui& ui, ImVec2 window) {
    if (!ui.sheets.is_open(Sheet::glossary)) return;
    begin_sheet(ui, glossary_look, window);
    draw_sheet_search(ui, glossary_look, "search the glossary",
                      "Shows only the entries that contain this word.");
    const std::string& search = ui.sheets.search_of(Sheet::glossary);
    ImGui::BeginChild("terms");
    begin_line_clip();
    bool any = false;
    for (const Term& term : ui.session.glossary) {
        if (!has_word(term, search)) continue;
        any = true;
        draw_term(ui, term);
    }
    if (!any) text_in(palette(ui.options.theme).dim, "No entry contains that word.");
    end_line_clip();
    ImGui::EndChild();
    end_sheet();
}

} // namespace rasterwalk
