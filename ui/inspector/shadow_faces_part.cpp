#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/numbers.h"
#include "pipeline/shadow_pass.h"
#include "session/walk.h"
#include "ui/inspector/fragment_parts.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/small_pictures.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Design pixels: a face in a row of six, or else in two rows of three, and the mark of a texel.
constexpr float least_face = 58.0f, largest_face = 84.0f, face_gap = 6.0f, least_mark = 7.0f;

void make_pictures(ShadowFacesView& view, const std::shared_ptr<const ShadowMap>& map, int side) {
    if (view.map.lock() == map && view.side == side) return;
    view.map = map;
    view.side = side;
    view.pictures = shadow_face_pictures(*map, side);
    ++view.number;
}

/// The texels that were compared, on the face where they are.
void draw_texel_marks(const Ui& ui, const ShadowTerms& shadow, int resolution, ImVec2 low,
                      float side) {
    const float u = ui.options.text_scale, scale = side / static_cast<float>(resolution);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->PushClipRect({low.x - 4.0f * u, low.y - 4.0f * u},
                       {low.x + side + 4.0f * u, low.y + side + 4.0f * u}, true);
    for (int i = 0; i < shadow.texel_count; ++i) {
        const ShadowTexel& texel = shadow.texels[static_cast<std::size_t>(i)];
        const float half = 0.5f * std::max(scale, least_mark * u);
        const ImVec2 middle{low.x + scale * (static_cast<float>(texel.column) + 0.5f),
                            low.y + scale * (static_cast<float>(texel.row) + 0.5f)};
        const ImVec2 from{middle.x - half, middle.y - half}, to{middle.x + half, middle.y + half};
        // Dark around it, because the colours of depth are light and dark.
        list->AddRect(from, to, IM_COL32(0, 0, 0, 200), 0.0f, 0, 4.0f * u);
        // On a picture, so in the tone for the dark theme.
        list->AddRect(from, to,
                      packed(colour_of(texel.is_lit ? Meaning::pass : Meaning::fail, Theme::dark)),
                      0.0f, 0, 2.0f * u);
    }
    list->PopClipRect();
}

std::string face_help(const ShadowTerms& shadow, int face, const std::string& pass) {
    std::string help = fmt::format("What the lamp saw along {}: near is bright, and black is where "
                                   "it saw nothing.",
                                   shadow_face_names[static_cast<std::size_t>(face)]);
    if (face == shadow.face)
        help += shadow.texel_count > 1 ? "\nThe boxes are the texels that this pixel was compared "
                                         "with."
                                       : "\nThe box is the texel that this pixel was compared "
                                         "with.";
    return help + "\nClick to go to the end of its pass, " + pass + ".";
}

} // namespace

void draw_shadow_faces(Ui& ui, const ShadowTerms& shadow) {
    const Frame& frame = ui.results.a.frame;
    const std::shared_ptr<const ShadowMap>& map = frame.occluders.map;
    if (map == nullptr || map->resolution < 1) return;
    const float u = ui.options.text_scale, gap = face_gap * u,
                width = right_end() - ImGui::GetCursorScreenPos().x;
    const auto side_of = [&](int in_row) {
        return std::floor((width - static_cast<float>(in_row - 1) * gap) /
                          static_cast<float>(in_row));
    };
    const int in_row = side_of(shadow_face_count) >= least_face * u ? shadow_face_count : 3;
    const float side = std::clamp(side_of(in_row), 1.0f, largest_face * u);
    ShadowFacesView& view = ui.inspector.shadow_faces;
    make_pictures(view, map, static_cast<int>(side));
    ImGui::PushFont(ui.fonts.small);
    const float line = ImGui::GetTextLineHeight() + 3.0f * u;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    for (int face = 0; face < shadow_face_count; ++face) {
        const auto i = static_cast<std::size_t>(face);
        const int column = face % in_row, row = face / in_row;
        const ImVec2 at{start.x + static_cast<float>(column) * (side + gap),
                        start.y + static_cast<float>(row) * (side + line + gap)};
        const Image& image = view.pictures.faces[i];
        // Texels of a coarse map stay squares.
        show_small(ui, view.textures[i], image, view.number,
                   side / static_cast<float>(image.width));
        const std::string pass = fmt::format("p{}", pass_number(pass_of_face(face)));
        const bool is_clicked =
            small_card(ui, fmt::format("fragment.shadow.face.{}", face),
                       face_help(shadow, face, pass), at, {at.x + side, at.y + side + line});
        ImDrawList* const list = ImGui::GetWindowDrawList();
        const Palette& p = palette(ui.options.theme);
        list->AddText(
            {at.x + 2.0f * u, at.y}, packed(face == shadow.face ? p.text : p.dim),
            first_fitting({pass + " " + shadow_face_names[i], shadow_face_names[i]}, side).c_str());
        const ImVec2 low{at.x, at.y + line};
        list->AddImage(view.textures[i].id, low, {low.x + side, low.y + side});
        if (face == shadow.face) draw_texel_marks(ui, shadow, map->resolution, low, side);
        if (is_clicked) go_to(ui.session, in_pass(cursor_end, pass_of_face(face)));
    }
    const int row_count = shadow_face_count / in_row;
    const auto rows = static_cast<float>(row_count);
    ImGui::SetCursorScreenPos(start);
    ImGui::Dummy({width, rows * (side + line) + (rows - 1.0f) * gap});
    if (view.pictures.farthest > 0.0f) {
        text_in(palette(ui.options.theme).dim,
                first_fitting({fmt::format("z from the lamp: {} (bright) to {} (dark)",
                                           significant(view.pictures.nearest, 3),
                                           significant(view.pictures.farthest, 3)),
                               "near is bright"},
                              right_end() - ImGui::GetCursorScreenPos().x));
        register_widget(ui, "fragment.shadow.range",
                        "The nearest and the farthest thing that the lamp saw: how far along the "
                        "axis of its face.");
    }
    ImGui::PopFont();
}

} // namespace rasterwalk
