#include <algorithm>
#include <cctype>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "ui/actions/keys.h"
#include "ui/sheets/sheets.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

bool has_word(const Term& term, const std::string& search) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    };
    const auto found_in = [&](const std::string& text) {
        return std::search(text.begin(), text.end(), search.begin(), search.end(), same) !=
               text.end();
    };
    return found_in(term.word) || found_in(term.sentence);
}

void draw_term(Ui& ui, const Term& term) {
    const Palette& p = palette(ui.options.theme);
    ImGui::PushFont(ui.fonts.bold);
    ImGui::TextUnformatted(term.word.c_str());
    ImGui::PopFont();
    name_widget(ui, "glossary.term." + term.word, "Lab: " + term.section);
    wrapped_text(term.sentence);
    ImGui::PushFont(ui.fonts.small);
    text_in(p.dim, "lab: " + term.section);
    ImGui::PopFont();
    ImGui::Spacing();
}

} // namespace

void draw_glossary_sheet(Ui& ui, ImVec2 window) {
    if (!ui.sheets.shows_glossary) return;
    const float u = ui.options.text_scale;
    ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(
        {std::min(520.0f * u, window.x - 20.0f), std::min(640.0f * u, window.y - 20.0f)});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.options.theme).card);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6.0f * u);
    ImGui::Begin("glossary", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
    ImGui::PushFont(ui.fonts.title);
    ImGui::TextUnformatted("Glossary");
    ImGui::PopFont();
    ImGui::SameLine(0.0f, 24.0f * u);
    if (button(ui, "glossary.close", "Close", Look::plain, "Closes the glossary. Keys: F2, Esc")) {
        ui.sheets.shows_glossary = false;
    }
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::InputTextWithHint("##search", "search the glossary", &ui.sheets.glossary_search);
    const bool is_left = ImGui::IsItemDeactivated();
    name_widget(ui, "glossary.search", "Shows only the terms that have this word.");
    // The field had the keyboard, and with it the key.
    if (is_left && ImGui::IsKeyPressed(key::escape, false)) ui.sheets.shows_glossary = false;
    ImGui::BeginChild("terms");
    bool any = false;
    for (const Term& term : ui.session.glossary) {
        if (!has_word(term, ui.sheets.glossary_search)) continue;
        any = true;
        draw_term(ui, term);
    }
    if (!any) text_in(palette(ui.options.theme).dim, "No term has that word.");
    ImGui::EndChild();
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
}

} // namespace rasterwalk
