#include <cstdint>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "compare/picture_reasons.h"
#include "ui/actions/compare.h"
#include "ui/inspector/compare_parts.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

void draw_reasons(Ui& ui) {
    const Comparison& found = ui.results.comparison.whole();
    const Palette& p = palette(ui.options.theme);
    wrapped_text_in(p.dim, found.only_pictures, ui.fonts.small);
    register_widget(ui, "compare.only_pictures", "Why rows and moments are not compared.");
    register_text(ui, "compare.only_pictures", found.only_pictures);
    if (!ui.results.comparison.work.is_done()) return;
    if (ui.results.b->is_of_program()) {
        draw_program_parting(ui);
        return;
    }
    if (ImGui::BeginTable("compare.reasons", 2, ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("", 0, 2.0f);
        ImGui::TableSetupColumn("", 0, 1.0f);
        for (const PixelReasonWords& words : pixel_reason_list()) {
            const std::int64_t count = found.reasons.count(words.reason);
            if (count == 0) continue;
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            put_text(std::string(words.title));
            const std::string name = "compare.reason." + std::string(words.name);
            register_widget(ui, name, std::string(words.help));
            ImGui::TableNextColumn();
            right_aligned(grouped(count), p.text, ui.fonts.mono);
            register_text(ui, name, grouped(count));
        }
        ImGui::EndTable();
    }
    const std::optional<DifferentPixel>& first = found.reasons.first();
    if (!first) return;
    begin_card(ui);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
    if (button(ui, "compare.first_pixel",
               fmt::format("first: pixel ({}, {})", first->place.x, first->place.y), Look::link,
               "Click to pick it."))
        select_pixel(ui, first->place);
    ImGui::PopStyleVar();
    wrapped_text(first->text);
    register_text(ui, "compare.first_pixel", first->text);
    end_card(ui);
}

} // namespace rasterwalk
