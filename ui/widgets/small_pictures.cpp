#include "ui/widgets/small_pictures.h"

#include <algorithm>
#include <cmath>

#include "picture/resample.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Design pixels.
constexpr float picture_gap = 8.0f, card_inset = 6.0f, largest_shown_side = 150.0f,
                least_side = 48.0f;
constexpr float card_rounding = 4.0f;

/// The share of the page that a row of cards may take.
constexpr float share_of_page = 0.5f;

/// The share of a card for its picture, if the words are next to it.
constexpr float share_of_card = 0.4f;

/// In smaller pixels a sign cannot be seen, design pixels.
constexpr float least_marked_pixel = 5.0f;

/// The image without most of its columns and rows, if it is so large that reading all of them would
/// take too long; and by how much it is smaller.
struct Thinned {
    Image image;
    int step = 1;
};
Thinned thinned(const Image& image) {
    Thinned thin;
    const auto pixels_at = [&](int step) {
        return static_cast<std::int64_t>(image.width / step) * (image.height / step);
    };
    while (pixels_at(thin.step) > largest_read_through)
        ++thin.step;
    if (thin.step == 1) return thin;
    thin.image.width = std::max(image.width / thin.step, 1);
    thin.image.height = std::max(image.height / thin.step, 1);
    thin.image.rgba.reserve(4 * static_cast<std::size_t>(thin.image.width) *
                            static_cast<std::size_t>(thin.image.height));
    for (int row = 0; row < thin.image.height; ++row) {
        for (int column = 0; column < thin.image.width; ++column) {
            // The middle of the square that it represents.
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

/// Line by line in the current font, from a height downward.
void draw_card_lines(ImVec2 at, const std::string& text, const ImVec4& colour) {
    const float line = ImGui::GetTextLineHeight();
    for (std::size_t from = 0; from < text.size(); at.y += line) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        ImGui::GetWindowDrawList()->AddText(at, packed(colour),
                                            text.substr(from, end - from).c_str());
        clip_range_to_lines(at.y, at.y + line);
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

/// The words of all cards, broken into lines, and how many lines the longest have.
struct AllWords {
    std::vector<CardWords> of;
    float title_lines = 1.0f, word_lines = 1.0f;

    float lines() const { return title_lines + word_lines; }
};
AllWords break_words(std::span<const SmallPicture> pictures, float room) {
    AllWords all;
    for (const SmallPicture& picture : pictures) {
        all.of.push_back(
            {broken_into_lines(picture.title, room), broken_into_lines(picture.words, room)});
        all.title_lines = std::max(all.title_lines, lines_in(all.of.back().title));
        all.word_lines = std::max(all.word_lines, lines_in(all.of.back().words));
    }
    return all;
}

/// How much larger than their own size the pictures are shown. All their pixels are the same size.
float scale_into(const Image& image, ImVec2 room) {
    const float fitting = std::min(room.x / static_cast<float>(image.width),
                                   room.y / static_cast<float>(image.height));
    return fitting >= 1.0f ? std::floor(fitting) : fitting;
}

/// Where a card and its content lie, screen pixels.
struct CardPlace {
    ImVec2 low, high;
    ImVec2 picture; ///< the middle of its upper edge
    ImVec2 title, words;
};

/// True if the card is clicked.
bool draw_picture_card(Ui& ui, const SmallPicture& picture, const CardWords& words,
                       PictureTexture& texture, float scale, const CardPlace& at) {
    const Palette& p = palette(ui.options.theme);
    const bool is_clicked =
        small_card(ui, picture.name, picture.tooltip, at.low, at.high, picture.can_be_chosen);
    register_text(ui, picture.name, picture.title + ": " + picture.words);
    show_small(ui, texture, *picture.image, picture.number, scale);
    draw_card_lines(at.title, words.title, p.text);
    draw_over_picture(ui, picture, texture,
                      {std::round(at.picture.x - 0.5f * texture.size.x), at.picture.y});
    draw_card_lines(at.words, words.words, p.dim);
    if (picture.is_chosen) frame_small_card(ui, at.low, at.high);
    return is_clicked;
}

/// The words are next to the pictures, and the cards one below another: each is seen whole.
std::optional<std::size_t> draw_in_column(Ui& ui, std::span<const SmallPicture> pictures,
                                          std::span<PictureTexture> textures) {
    const float u = ui.options.text_scale, inset = std::round(card_inset * u);
    const float gap = std::round(picture_gap * u), line = ImGui::GetTextLineHeight();
    const float width = ImGui::GetContentRegionAvail().x;
    const float picture_width = std::round(share_of_card * width);
    const AllWords words =
        break_words(pictures, std::max(width - picture_width - 3.0f * inset, 1.0f));
    const Image& first = *pictures.front().image;
    const float side = std::max(std::min(least_side * u, share_of_page * page_room()), line);
    const float scale = scale_into(first, {picture_width, side});
    const float shown_height = std::ceil(scale * static_cast<float>(first.height));
    const float height = std::max(shown_height, words.lines() * line) + 2.0f * inset;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    std::optional<std::size_t> clicked;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const ImVec2 low{start.x, start.y + static_cast<float>(i) * (height + gap)};
        const float beside = low.x + 2.0f * inset + picture_width;
        const float top = std::round(low.y + 0.5f * (height - words.lines() * line));
        const CardPlace place{low,
                              {low.x + width, low.y + height},
                              {low.x + inset + 0.5f * picture_width,
                               std::round(low.y + 0.5f * (height - shown_height))},
                              {beside, top},
                              {beside, top + words.title_lines * line}};
        if (draw_picture_card(ui, pictures[i], words.of[i], textures[i], scale, place)) clicked = i;
        clip_range_to_lines(low.y, low.y + height);
    }
    ImGui::SetCursorScreenPos(start);
    const float count = static_cast<float>(pictures.size());
    ImGui::Dummy({width, count * height + (count - 1.0f) * gap});
    return clicked;
}

std::optional<std::size_t> draw_in_row(Ui& ui, std::span<const SmallPicture> pictures,
                                       std::span<PictureTexture> textures, float width,
                                       const AllWords& words) {
    const float u = ui.options.text_scale, inset = std::round(card_inset * u);
    const float gap = std::round(picture_gap * u), line = ImGui::GetTextLineHeight();
    const float around = words.lines() * line + 4.0f * inset;
    const float side =
        std::clamp(share_of_page * page_room() - around, least_side * u, largest_shown_side * u);
    const Image& first = *pictures.front().image;
    const float scale = scale_into(first, {width - 2.0f * inset, side});
    const float shown_height = std::ceil(scale * static_cast<float>(first.height));
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float height = around + shown_height;
    std::optional<std::size_t> clicked;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const ImVec2 low{start.x + static_cast<float>(i) * (width + gap), start.y};
        const float top = low.y + 2.0f * inset + words.title_lines * line;
        const CardPlace place{low,
                              {low.x + width, low.y + height},
                              {low.x + 0.5f * width, top},
                              {low.x + inset, low.y + inset},
                              {low.x + inset, top + shown_height + inset}};
        if (draw_picture_card(ui, pictures[i], words.of[i], textures[i], scale, place)) clicked = i;
    }
    ImGui::SetCursorScreenPos(start);
    const float count = static_cast<float>(pictures.size());
    ImGui::Dummy({count * width + (count - 1.0f) * gap, height});
    clip_to_lines();
    return clicked;
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
                bool can_be_chosen) {
    const Palette& p = palette(ui.options.theme);
    const ImVec2 size{high.x - low.x, high.y - low.y};
    ImGui::SetCursorScreenPos(low);
    bool is_clicked = false;
    if (can_be_chosen)
        is_clicked = ImGui::InvisibleButton(name.c_str(), size);
    else
        ImGui::Dummy(size);
    const bool is_lit = can_be_chosen && ImGui::IsItemHovered();
    register_widget(ui, name, tooltip);
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
    const float u = ui.options.text_scale, inset = std::round(card_inset * u);
    const float gap = std::round(picture_gap * u), count = static_cast<float>(pictures.size());
    const float width =
        std::floor((ImGui::GetContentRegionAvail().x - (count - 1.0f) * gap) / count);
    if (width - 2.0f * inset < 1.0f) return std::nullopt;
    ImGui::PushFont(ui.fonts.small);
    const AllWords words = break_words(pictures, width - 2.0f * inset);
    const float least = words.lines() * ImGui::GetTextLineHeight() + 4.0f * inset + least_side * u;
    // A row of cards that takes most of the page would hardly ever be seen whole.
    const auto clicked = least > share_of_page * page_room()
                             ? draw_in_column(ui, pictures, textures)
                             : draw_in_row(ui, pictures, textures, width, words);
    ImGui::PopFont();
    return clicked;
}

} // namespace rasterwalk
