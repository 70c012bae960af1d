#pragma once

// Where a number comes from.

#include <cstdint>
#include <string>

#include "pipeline/cursor.h"

namespace rasterwalk {

/// The kinds of places that a number can come from.
enum class SourceKind : std::uint8_t {
    given,   ///< a constant, or the scene itself
    setting, ///< a setting, by name
    vertex,  ///< a value of a vertex of a triangle
    row_end, ///< the left or right end of a row
    moment,  ///< a piece of work, by its cursor
    texel,   ///< a texel of the shadow map
    formula, ///< another formula of the same report, by id
};

/// The place that a number comes from.
struct Source {
    SourceKind kind = SourceKind::given;
    std::string name;      ///< of the setting, the formula or the vertex's value; for `given` words
    int triangle = -1;     ///< of a vertex or row end
    int vertex = -1;       ///< 0..2
    int row = -1;          ///< of the picture, or of a face of the shadow map
    int column = -1;       ///< of that face
    int face = -1;         ///< of the map
    bool is_right = false; ///< which end of the row
    Cursor moment;

    friend bool operator==(const Source&, const Source&) = default;
};

Source from_words(std::string words);
Source from_setting(std::string name);
Source from_vertex(int triangle, int vertex, std::string value_id);
Source from_row_end(int triangle, int row, bool is_right);
Source from_moment(const Cursor& moment);
Source from_texel(int face, int column, int row);
Source from_formula(std::string id);

/// The place in words, counted from 0: "left end of row 20", "setting light.power", "vertices[1] of
/// triangles[7]".
std::string source_text(const Source& source);

} // namespace rasterwalk
