#pragma once

// The building blocks of the Clip tab's tables.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ui/inspector/clip_parts.h"

namespace rasterwalk {

inline constexpr std::array<const char*, 4> clip_coordinates{"x", "y", "z", "w"};
inline constexpr std::array<const char*, 4> clip_coordinate_help{
    "x of clip space, x' = f x of the lab: pixels from the middle of the picture, times w. Divided "
    "by w it is on the screen. The matrix Tp gives it in units of W/2.",
    "y of clip space, y' = f y of the lab: pixels from the middle of the picture, times w; points "
    "down. The matrix Tp gives it in units of H/2.",
    "z of clip space, from which the depth is made; it is divided by w too.",
    "What x, y and z are divided by: how far in front of the camera. 0 or less is behind it."};

/// A coordinate in clip space as its column shows it.
std::string clip_number(float value, int coordinate);

/// A number of a table; the student can ask where it came from.
void draw_selected_formula(const ClipPage& page, const std::string& name, const std::string& id,
                           const std::string& text, const ImVec4& colour, const std::string& help);

/// The title of a table, and a small remark next to it, or below if there is no room.
void draw_clip_title(const ClipPage& page, const std::string& title, const std::string& remark);

/// A title over a column, at its right edge.
void draw_column_title(const ClipPage& page, const std::string& name, const std::string& title,
                       const std::string& help);

/// @param widths of the columns in relation to each other; the first is for names
bool begin_clip_table(const ClipPage& page, const std::string& name,
                      const std::vector<float>& widths);
void end_clip_table();

/// The tooltip of a corner: what made it.
std::string corner_help(const CutCorner& corner);

/// The name of a corner in its own column.
void draw_corner_name(const ClipPage& page, const CutCorner& corner, bool is_dim);

} // namespace rasterwalk
