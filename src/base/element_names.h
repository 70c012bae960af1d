#pragma once

// The names of the pieces of a frame. Each is counted from 0 and written as in a C++ program:
// "triangles[29]", "vertices[0]", "edge 1", "line[4]". Every text that names one takes the name
// from here, so that the screen, the messages and the student's own program count alike.

#include <string>
#include <string_view>

#include "base/language.h"

namespace rasterwalk {

/// How a name is written; '#' is where the number goes. Pieces that a program keeps in an array
/// have brackets.
inline constexpr std::string_view triangle_form = "triangles[#]";
inline constexpr std::string_view vertex_form = "vertices[#]";
inline constexpr std::string_view plane_form = "plane #";
inline constexpr std::string_view edge_form = "edge #";
inline constexpr std::string_view sample_form = "line[#]";    ///< of an edge: the array of the lab
inline constexpr std::string_view box_row_form = "box row #"; ///< of pixels that are tested
inline constexpr std::string_view box_pixel_form = "pixel #"; ///< of such a row, from its left end
inline constexpr std::string_view entry_form = "entry [#]";   ///< of leftPixels and rightPixels
inline constexpr std::string_view fragment_form = "fragments[#]"; ///< of a row, from its left end
inline constexpr std::string_view picture_row_form =
    "row #"; ///< of the picture, when it is resolved
inline constexpr std::string_view picture_column_form = "column #"; ///< of such a row

/// The name with its number in a language; a form without a '#' has none.
std::string element_name(std::string_view form, int index, const Language& language = english());

/// The same with the count: "line[4] of 11". Only names with brackets get it: "edge 1 of 3" would
/// read as if it counted from 1, so it is just "edge 1".
std::string element_name_of(std::string_view form, int index, int count,
                            const Language& language = english());

std::string triangle_name(int triangle);       ///< "triangles[29]"
std::string vertex_name(int vertex);           ///< "vertices[0]"
std::string edge_name(int edge);               ///< "edge 1"
std::string sample_name(int edge, int sample); ///< "edge 1, line[4]"

/// For tables and the canvas, where space is tight: "t29" and "v0", as in the text of a moment.
std::string short_triangle_name(int triangle);
std::string short_vertex_name(int vertex);

} // namespace rasterwalk
