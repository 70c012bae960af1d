#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/element_names.h"
#include "ui/inspector/clip_parts.h"
#include "ui/inspector/clip_table.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// A bit of an outcode: 1 is beyond the plane.
void draw_bit(const ClipPage& page, const std::string& text, bool is_set) {
    right_aligned(text,
                  is_set ? colour_of(Meaning::fail, page.ui.options.theme) : page.palette().dim);
}

void draw_code_row(const ClipPage& page, const std::string& title, Outcode code,
                   const std::string& help) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    text_in(page.palette().text, title);
    register_widget(page.ui, "clip.code." + title, help);
    ImGui::PushFont(page.ui.fonts.mono);
    for (std::size_t p = 0; p < page.history.codes.plane_count; ++p) {
        const bool is_set = (code >> p & 1u) != 0;
        ImGui::TableNextColumn();
        draw_bit(page, is_set ? "1" : "0", is_set);
    }
    ImGui::PopFont();
}

} // namespace

void draw_clip_corners(const ClipPage& page) {
    draw_clip_title(page, "The corners", "clip space, before dividing by w");
    if (!begin_clip_table(page, "corners", {1.4f, 1.1f, 1.1f, 0.6f, 0.9f})) return;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    for (std::size_t i = 0; i < clip_coordinates.size(); ++i)
        draw_column_title(page, std::string("clip.header.") + clip_coordinates[i],
                          clip_coordinates[i], clip_coordinate_help[i]);
    for (const CutCorner& corner : given_corners(page.history)) {
        draw_corner_name(page, corner, false);
        const bool is_behind = !(corner.vertex.position_clip.w > 0.0f);
        ImGui::PushFont(page.ui.fonts.mono);
        for (int i = 0; i < 4; ++i) {
            const std::string id = corner_formula_id(corner, i);
            ImGui::TableNextColumn();
            draw_selected_formula(
                page, "clip." + id, id, clip_number(corner.vertex.position_clip[i], i),
                i == 3 && is_behind ? colour_of(Meaning::fail, page.ui.options.theme)
                                    : page.palette().text,
                clip_coordinate_help[static_cast<std::size_t>(i)]);
        }
        ImGui::PopFont();
    }
    end_clip_table();
    if (page.frame.settings.transform != Transform::matrices) return;
    // The Vertices tab has the same space in a different scale.
    wrapped_text_in(
        page.palette().dim,
        "Here x and y are in pixels: they are W/2 and H/2 times those that Tp gives. So "
        "the left plane, x + w = 0 after Tp, is x + W/2 · w = 0.");
    register_widget(page.ui, "clip.scale",
                    "The division by w gives the same position: W/2 · (x / w) = (W/2 · x) / w.");
}

void draw_clip_codes(const ClipPage& page) {
    const TriangleCodes& codes = page.history.codes;
    if (codes.plane_count == 0) return;
    draw_clip_title(page, "Outcodes", "1: beyond the plane");
    std::vector<float> widths{1.5f};
    widths.resize(codes.plane_count + 1, 1.0f);
    if (!begin_clip_table(page, "codes", widths)) return;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    for (std::size_t p = 0; p < codes.plane_count; ++p) {
        const auto plane = static_cast<ClipPlane>(p);
        draw_column_title(page, "clip.header." + std::string(word_of(plane)),
                          std::string(word_of(plane)),
                          "1 for a corner beyond the " + plane_name(plane) + ".");
    }
    for (int v = 0; v < triangle_corners; ++v) {
        const CutCorner corner = given_corners(page.history)[static_cast<std::size_t>(v)];
        draw_corner_name(page, corner, false);
        ImGui::PushFont(page.ui.fonts.mono);
        for (std::size_t p = 0; p < codes.plane_count; ++p) {
            const bool is_set = (codes.of_corner[static_cast<std::size_t>(v)] >> p & 1u) != 0;
            const std::string id = fmt::format("code.{}.{}", p, v);
            ImGui::TableNextColumn();
            draw_selected_formula(page, "clip." + id, id, is_set ? "1" : "0",
                                  is_set ? colour_of(Meaning::fail, page.ui.options.theme)
                                         : page.palette().dim,
                                  fmt::format("{} is {} the {}.", vertex_name(v),
                                              is_set ? "beyond"
                                                     : "on the inner "
                                                       "side of",
                                              plane_name(static_cast<ClipPlane>(p))));
        }
        ImGui::PopFont();
    }
    draw_code_row(
        page, "AND", codes.common(),
        "The bits that all corners have. The whole triangle lies beyond such a plane and can be "
        "rejected at once. The absence of such a bit does not mean that any part is inside.");
    draw_code_row(page, "OR", codes.any(),
                  "The bits that any corner has. Only these planes can have work to do. If no bit "
                  "is set, the whole triangle lies inside and is accepted at once.");
    end_clip_table();
}

} // namespace rasterwalk
