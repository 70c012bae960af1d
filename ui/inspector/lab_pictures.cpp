#include <algorithm>
#include <cmath>
#include <string>

#include "laboratory/image_variant.h"
#include "picture/resample.h"
#include "ui/inspector/lab_parts.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Design pixels: sizes of a column and of a picture, and the space between them.
constexpr float least_column = 88.0f, least_shown = 56.0f, largest_shown = 216.0f;
constexpr float pair_gap = 12.0f, pair_border = 4.0f;

/// The height at which a picture is large enough to leave room for the words below it too; and at
/// which it is large enough to be seen whole; design pixels.
constexpr float good_side = 100.0f, fair_side = 68.0f;

/// How both pictures, which have the same size, are shown.
struct PairLayout {
    float column; ///< width for a picture and its caption, screen pixels
    float scale;  ///< screen pixels per picture pixel
    bool is_stacked;
};

/// How high a picture may be, screen pixels: both are seen whole, together with the words below
/// them if they stay large enough. If they would get too small, they are scrolled to.
float picture_room(const Ui& ui) {
    const float u = ui.options.text_scale, page = page_room();
    const float below = page - ImGui::GetCursorPosY() - pair_border * u;
    const float words = 4.0f * ui.fonts.small->FontSize;
    if (below - words >= good_side * u) return below - words;
    return below >= fair_side * u ? below : page - words;
}

PairLayout pair_layout(const Ui& ui, const Image& image, float width) {
    const float u = ui.options.text_scale;
    PairLayout layout{};
    layout.column = std::floor(0.5f * (width - pair_gap * u));
    layout.is_stacked = layout.column < least_column * u;
    if (layout.is_stacked) layout.column = width;
    const float high = std::clamp(picture_room(ui), least_shown * u, largest_shown * u);
    const float wide = std::min(layout.column, largest_shown * u);
    const float scale =
        std::min(wide / static_cast<float>(image.width), high / static_cast<float>(image.height));
    // All pixels are the same size.
    layout.scale = scale >= 1.0f ? std::floor(scale) : scale;
    return layout;
}

void draw_captioned(Ui& ui, LabPictures& pictures, const std::string& owner, bool is_own,
                    const PairLayout& layout, const PictureCaption& caption) {
    const Palette& p = palette(ui.options.theme);
    PictureTexture& texture = pictures.small[is_own ? 0 : 1];
    if (texture.number != pictures.number || texture.scale != layout.scale) {
        const Image small =
            is_own ? resampled(pictures.own, layout.scale)
                   : with_differences_marked(pictures.right, pictures.own, layout.scale);
        texture.id = ui.host.textures->upload(texture.id, small);
        texture.number = pictures.number;
        texture.scale = layout.scale;
        texture.size = {static_cast<float>(small.width), static_cast<float>(small.height)};
    }
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high{low.x + texture.size.x, low.y + texture.size.y};
    ImGui::BeginGroup();
    ImGui::Dummy(texture.size);
    const std::string name = owner + (is_own ? ".picture.own" : ".picture.beside");
    register_widget(ui, name,
                    is_own ? "The picture of your program."
                           : "What a correct program draws, in grey; orange where yours differs.",
                    caption.title + (caption.words.empty() ? "" : ": " + caption.words));
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddImage(texture.id, low, high);
    list->AddRect(low, high, packed(p.line));
    ImGui::PushFont(ui.fonts.small);
    text_in(p.text, broken_into_lines(caption.title, layout.column));
    clip_to_lines();
    if (!caption.words.empty()) {
        text_in(p.dim, broken_into_lines(caption.words, layout.column));
        clip_to_lines();
    }
    ImGui::PopFont();
    ImGui::EndGroup();
}

} // namespace

void draw_lab_pictures(Ui& ui, LabPictures& pictures, const std::string& owner,
                       const PictureCaption& beside) {
    const Image& image = pictures.own;
    const float width = ImGui::CalcItemWidth();
    ImGui::Spacing();
    const PairLayout layout = pair_layout(ui, image, width);
    const float left = ImGui::GetCursorScreenPos().x;
    draw_captioned(ui, pictures, owner, true, layout, {"Your picture", ""});
    if (!layout.is_stacked) {
        ImGui::SameLine();
        const float next = left + layout.column + std::round(pair_gap * ui.options.text_scale);
        ImGui::SetCursorScreenPos({next, ImGui::GetCursorScreenPos().y});
    }
    draw_captioned(ui, pictures, owner, false, layout, beside);
    ImGui::Spacing();
}

} // namespace rasterwalk
