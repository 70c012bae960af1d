#pragma once

// Small pictures on cards side by side, each with a caption and a few words; a click chooses one.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "base/image.h"
#include "ui/widgets/picture_state.h"

namespace rasterwalk {

struct Ui;

/// The picture shown small: every pixel the mean of what it covers. For a very large one only some
/// of its columns and rows are read.
/// @param scale new pixels for each old one, above 0
Image small_picture(const Image& image, float scale);

/// The largest picture whose every pixel is read, pixels.
inline constexpr std::int64_t largest_read_through = 1'000'000;

/// Brings the texture of a small picture up to date. At rest there is nothing to do.
/// @param number of the image: changes whenever the image does
void show_small(Ui& ui, PictureTexture& texture, const Image& image, std::uint64_t number,
                float scale);

/// The ground of a card, and its name. Returns true if it is clicked.
/// @param can_be_chosen false: a click on it does nothing
bool small_card(Ui& ui, const std::string& name, std::string_view tooltip, ImVec2 low, ImVec2 high,
                bool can_be_chosen = true);
/// The border of the chosen card.
void frame_small_card(const Ui& ui, ImVec2 low, ImVec2 high);

/// A line over a small picture. Its ends are in picture pixels from the upper left corner.
struct SmallLine {
    ImVec2 from, to;
    ImU32 colour = 0;
};

/// A small picture, and the words about it.
struct SmallPicture {
    std::string name;  ///< of the widget
    std::string title; ///< above it, or next to it
    std::string words; ///< below it, or next to it
    std::string tooltip;
    const Image* image = nullptr; ///< all in a row have the same size
    std::uint64_t number = 0;     ///< of the image
    std::vector<SmallLine> lines;
    std::span<const SmallMark> marks; ///< seen if pixels are large enough
    bool is_chosen = false;
    bool can_be_chosen = false;
};

/// The pictures in a row, as wide as the page, with every word: lines are broken where they must
/// be. In a low page they are one below another, with their words next to them.
/// @param textures as many as pictures
/// @return the one that was clicked
std::optional<std::size_t> draw_small_pictures(Ui& ui, std::span<const SmallPicture> pictures,
                                               std::span<PictureTexture> textures);

} // namespace rasterwalk
