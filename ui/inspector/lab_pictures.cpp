#include <algorithm>
#include <cmath>
#include <string>

#include "laboratory/image_variant.h"
#include "picture/resample.h"
#include "ui/inspector/lab_parts.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Design pixels: of a column, of a picture, and between them.
constexpr float least_column = 88.0f, least_shown = 56.0f, largest_shown = 216.0f;
constexpr float pair_gap = 12.0f;

/// How both pictures, which have the same size, are shown.
struct PairLayout {
    float column; ///< width for a picture and its caption, screen pixels
    float scale;  ///< screen pixels a picture pixel
    bool is_stacked;
};

PairLayout pair_layout(const Ui& ui, const Image& image, float width, float page_height) {
    const float u = ui.options.text_scale;
    PairLayout layout{};
    layout.column = std::floor(0.5f * (width - pair_gap * u));
    layout.is_stacked = layout.column < least_column * u;
    if (layout.is_stacked) layout.column = width;
    // A picture and the first line of its caption are seen together.
    const float line = 2.0f * ui.fonts.small->FontSize;
    const float high = std::clamp(page_height - line, least_shown * u, largest_shown * u);
    const float wide = std::min(layout.column, largest_shown * u);
    const float scale =
        std::min(wide / static_cast<float>(image.width), high / static_cast<float>(image.height));
    // Pixels stay equally large.
    layout.scale = scale >= 1.0f ? std::floor(scale) : scale;
    return layout;
}

/// What is shown as the second picture: without a likely mistake, where it is not as the first.
Image small_one(const LabPictures& pictures, bool is_own, float scale) {
    if (is_own) return resampled(pictures.own, scale);
    if (!pictures.is_reference || pictures.own == pictures.beside)
        return resampled(pictures.beside, scale);
    return with_differences_marked(pictures.beside, pictures.own, scale);
}

void draw_captioned(Ui& ui, bool is_own, const PairLayout& layout, const PictureCaption& caption) {
    const Palette& p = palette(ui.options.theme);
    LabPictures& pictures = ui.lab.pictures;
    PictureTexture& texture = pictures.small[is_own ? 0 : 1];
    if (texture.number != pictures.number || texture.scale != layout.scale) {
        const Image small = small_one(pictures, is_own, layout.scale);
        texture.id = ui.host.textures->upload(texture.id, small);
        texture.number = pictures.number;
        texture.scale = layout.scale;
        texture.size = {static_cast<float>(small.width), static_cast<float>(small.height)};
    }
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high{low.x + texture.size.x, low.y + texture.size.y};
    ImGui::BeginGroup();
    ImGui::Dummy(texture.size);
    const std::string name = is_own ? "lab.picture.own" : "lab.picture.beside";
    name_widget(ui, name,
                is_own ? "The picture that you chose."
                       : "What the program draws for comparison. “show”, in the list below, shows "
                         "it large.");
    note_text(ui, name, caption.title + (caption.words.empty() ? "" : ": " + caption.words));
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddImage(texture.id, low, high);
    list->AddRect(low, high, packed(p.line));
    ImGui::PushFont(ui.fonts.small);
    text_in(p.text, broken_into_lines(caption.title, layout.column));
    if (!caption.words.empty()) text_in(p.dim, broken_into_lines(caption.words, layout.column));
    ImGui::PopFont();
    ImGui::EndGroup();
}

} // namespace

void draw_lab_pictures(Ui& ui, const PictureCaption& beside) {
    const Image& image = ui.lab.pictures.own;
    const float width = ImGui::CalcItemWidth();
    const PairLayout layout = pair_layout(ui, image, width, ImGui::GetWindowHeight());
    ImGui::Spacing();
    const float left = ImGui::GetCursorScreenPos().x;
    draw_captioned(ui, true, layout, {"Your picture", ""});
    if (!layout.is_stacked) {
        ImGui::SameLine();
        const float next = left + layout.column + std::round(pair_gap * ui.options.text_scale);
        ImGui::SetCursorScreenPos({next, ImGui::GetCursorScreenPos().y});
    }
    draw_captioned(ui, false, layout, beside);
    ImGui::Spacing();
}

} // namespace rasterwalk
