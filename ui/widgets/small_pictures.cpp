#include "ui/widgets/small_pictures.h"

#include <algorithm>
#include <cmath>

#include "picture/resample.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/whole_lines.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Design pixels.
constexpr float card_gap = 8.0f, card_inset = 6.0f, largest_shown_side = 150.0f, least_side = 48.0f;
constexpr float card_rounding = 4.0f;

/// Of the page, for a row of cards.
constexpr float share_of_page = 0.5f;

/// In smaller pixels a sign is not seen, design pixels.
constexpr float least_marked_pixel = 5.0f;

/// The image without most of its columns and rows, if it is so large that looking at all of them
/// would take too long; and by how much it is smaller.
struct Thinned {
    Image image;
    int step = 1;
};
Thinned thinned(const Image& image) {
    Thinned thin;
    const auto pixels_at = [&](int step) {
        return static_cast<std::int64_t>(image.width / step) * (image.height / step);
    };
    while (pixels_at(thin.step) > largest_looked_through)
        ++thin.step;
    if (thin.step == 1) return thin;
    thin.image.width = std::max(image.width / thin.step, 1);
    thin.image.height = std::max(image.height / thin.step, 1);
    thin.image.rgba.reserve(4 * static_cast<std::size_t>(thin.image.width) *
                            static_cast<std::size_t>(thin.image.height));
    for (int row = 0; row < thin.image.height; ++row) {
        for (int column = 0; column < thin.image.width; ++column) {
            // The middle of the square that it stands for.
            const auto at = [&](int place, int side) {
                return static_cast<std::size_t>(
                    std::min(place * thin.step + thin.step / 2, side - 1));
            };
            const std::size_t from =
                4 * (at(row, image.height) * static_cast<std::size_t>(image.width) +
                     at(column, image.width));
            for (std::size_t c = 0; c < 4; ++c)
                thin.image.rgba.push_back(image.rgba[from + c]);
        }
    }
    return thin;
}

/// The words of a card, broken into lines.
struct CardWords {
    std::string title, words;
};

float lines_in(const std::string& text) {
    return static_cast<float>(1 + std::count(text.begin(), text.end(), '\n'));
}

/// Line by line in the present font, from a height downward.
void draw_card_lines(Ui& ui, ImVec2 at, const std::string& text, const ImVec4& colour) {
    const float line = ImGui::GetTextLineHeight();
    for (std::size_t from = 0; from < text.size(); at.y += line) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        ImGui::GetWindowDrawList()->AddText(at, packed(colour),
                                            text.substr(from, end - from).c_str());
        keep_whole(ui, at.y, at.y + line);
        from = end + 1;
    }
}

void draw_mark(const Ui& ui, const SmallMark& mark, ImVec2 low, float scale) {
    const Palette& p = palette(ui.options.theme);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImVec2 at{low.x + static_cast<float>(mark.column) * scale,
                    low.y + static_cast<float>(mark.row) * scale};
    const ImVec2 end{at.x + scale, at.y + scale};
    const float rim = std::max(std::round(0.2f * scale), 1.0f);
    switch (mark.sign) {
    case SmallSign::dot:
        list->AddCircleFilled({0.5f * (at.x + end.x), 0.5f * (at.y + end.y)}, 0.25f * scale,
                              IM_COL32(0, 0, 0, 255));
        break;
    case SmallSign::hollow:
        list->AddRectFilled({at.x + rim, at.y + rim}, {end.x - rim, end.y - rim}, packed(p.canvas));
        break;
    case SmallSign::stroke:
        list->AddLine({at.x, end.y}, {end.x, at.y}, IM_COL32(0, 0, 0, 255), 1.0f);
        break;
    }
}

void draw_over_picture(const Ui& ui, const SmallPicture& picture, const PictureTexture& texture,
                       ImVec2 low) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImVec2 high{low.x + texture.size.x, low.y + texture.size.y};
    list->AddImage(texture.id, low, high);
    list->PushClipRect(low, high, true);
    if (texture.scale >= least_marked_pixel * ui.options.text_scale) {
        for (const SmallMark& mark : picture.marks)
            draw_mark(ui, mark, low, texture.scale);
    }
    const auto place = [&](ImVec2 at) {
        return ImVec2(low.x + at.x * texture.scale, low.y + at.y * texture.scale);
    };
    for (const SmallLine& line : picture.lines)
        list->AddLine(place(line.from), place(line.to), line.colour, 1.5f * ui.options.text_scale);
    list->PopClipRect();
}

} // namespace

Image small_picture(const Image& image, float scale) {
    const Thinned thin = thinned(image);
    if (thin.step == 1) return resampled(image, scale);
    return resampled(thin.image, scale * static_cast<float>(thin.step));
}

void show_small(Ui& ui, PictureTexture& texture, const Image& image, std::uint64_t number,
                float scale) {
    if (texture.number == number && texture.scale == scale) return;
    const Image small = small_picture(image, scale);
    texture.id = ui.host.textures->upload(texture.id, small);
    texture.number = number;
    texture.scale = scale;
    texture.size = {static_cast<float>(small.width), static_cast<float>(small.height)};
}

bool small_card(Ui& ui, const std::string& name, std::string_view tooltip, ImVec2 low, ImVec2 high,
                bool can_be_taken) {
    const Palette& p = palette(ui.options.theme);
    const ImVec2 size{high.x - low.x, high.y - low.y};
    ImGui::SetCursorScreenPos(low);
    bool is_clicked = false;
    if (can_be_taken)
        is_clicked = ImGui::InvisibleButton(name.c_str(), size);
    else
        ImGui::Dummy(size);
    const bool is_lit = can_be_taken && ImGui::IsItemHovered();
    name_widget(ui, name, tooltip);
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, packed(is_lit ? p.button_hovered : p.card),
                                              card_rounding * ui.options.text_scale);
    return is_clicked;
}

void frame_small_card(const Ui& ui, ImVec2 low, ImVec2 high) {
    ImGui::GetWindowDrawList()->AddRect(low, high, packed(palette(ui.options.theme).link),
                                        card_rounding * ui.options.text_scale);
}

std::optional<std::size_t> draw_small_pictures(Ui& ui, std::span<const SmallPicture> pictures,
                                               std::span<PictureTexture> textures) {
    if (pictures.empty()) return std::nullopt;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale, inset = std::round(card_inset * u);
    const float gap = std::round(card_gap * u), count = static_cast<float>(pictures.size());
    const float width =
        std::floor((ImGui::GetContentRegionAvail().x - (count - 1.0f) * gap) / count);
    const float room = width - 2.0f * inset;
    if (room < 1.0f) return std::nullopt;
    ImGui::PushFont(ui.fonts.small);
    const float line = ImGui::GetTextLineHeight();
    float title_lines = 1.0f, word_lines = 1.0f;
    std::vector<CardWords> words;
    for (const SmallPicture& picture : pictures) {
        words.push_back(
            {broken_into_lines(picture.title, room), broken_into_lines(picture.words, room)});
        title_lines = std::max(title_lines, lines_in(words.back().title));
        word_lines = std::max(word_lines, lines_in(words.back().words));
    }
    const float around = (title_lines + word_lines) * line + 4.0f * inset;
    const float side =
        std::clamp(share_of_page * page_room(ui) - around, least_side * u, largest_shown_side * u);
    const Image& first = *pictures.front().image;
    const float fitting =
        std::min(room / static_cast<float>(first.width), side / static_cast<float>(first.height));
    // Pixels stay equally large.
    const float scale = fitting >= 1.0f ? std::floor(fitting) : fitting;
    const float shown_height = std::ceil(scale * static_cast<float>(first.height));
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = around + shown_height;
    std::optional<std::size_t> clicked;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const SmallPicture& picture = pictures[i];
        const ImVec2 low{start.x + static_cast<float>(i) * (width + gap), start.y};
        const ImVec2 high{low.x + width, low.y + height};
        if (small_card(ui, picture.name, picture.tooltip, low, high, picture.can_be_taken))
            clicked = i;
        note_text(ui, picture.name, picture.title + ": " + picture.words);
        show_small(ui, textures[i], *picture.image, picture.number, scale);
        draw_card_lines(ui, {low.x + inset, low.y + inset}, words[i].title, p.text);
        const float top = low.y + 2.0f * inset + title_lines * line;
        draw_over_picture(ui, picture, textures[i],
                          {std::round(low.x + 0.5f * (width - textures[i].size.x)), top});
        draw_card_lines(ui, {low.x + inset, top + shown_height + inset}, words[i].words, p.dim);
        if (picture.is_chosen) frame_small_card(ui, low, high);
    }
    ImGui::PopFont();
    ImGui::SetCursorScreenPos(start);
    ImGui::Dummy({count * width + (count - 1.0f) * gap, height});
    keep_item_whole(ui);
    return clicked;
}

} // namespace rasterwalk
