#pragma once

// Figures of lessons: drawings in a small part of SVG, some of whose parts follow settings and the
// cursor, or can be dragged. The format is described in lessons/README.md.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "facts/expression.h"
#include "settings/control_range.h"

namespace rasterwalk {

/// The colour of a part of a figure: what it means.
enum class FigureColour : std::uint8_t {
    ink,    ///< of text
    quiet,  ///< of what matters less
    edge_1, ///< and the others: of the same meanings in the window
    edge_2,
    edge_3,
    left,
    right,
    current,
    pass,
    fail,
};

/// How a part looks: its classes.
struct FigureLook {
    FigureColour colour = FigureColour::ink;
    bool is_filled = false; ///< and has no line around it
    bool is_soft = false;   ///< filled with a faint tint of its colour
    bool is_bare = false;   ///< no line around it
    bool is_thin = false, is_thick = false, is_dashed = false;
    bool has_arrow = false;                                    ///< at the end of the line
    bool is_bold = false, is_italic = false, is_small = false; // text

    friend bool operator==(const FigureLook&, const FigureLook&) = default;
};

/// A number of the file. While its expression has a value, that takes its place.
struct FigureNumber {
    float value = 0.0f;
    int follows = -1; ///< index in Figure::expressions; -1: it stays
};

/// A part of the drawing that is moved or hidden as a whole.
struct FigureGroup {
    int outer = -1;    ///< the group that it is in; -1: none
    FigureNumber x, y; ///< added to every place in it
    int shown_if = -1; ///< index in Figure::conditions; -1: always
};

/// A stretch of a line of text in one style.
struct FigureSpan {
    std::string text; ///< UTF-8
    FigureLook look;
    bool is_lowered = false; ///< an index: smaller, and lower
    int follows = -1;        ///< index in Figure::expressions: its number takes the text's place
    int digits = 0;          ///< of that number, after the point
};

/// A shape. `numbers` holds, by its kind: x1 y1 x2 y2 · x y of each corner · x y width height ·
/// cx cy r · the places of the path's commands · x y.
struct FigureShape {
    enum class Kind : std::uint8_t { line, polyline, polygon, rect, circle, path, text };
    enum class Anchor : std::uint8_t { start, middle, end };

    Kind kind = Kind::line;
    FigureLook look;
    int group = 0; ///< index in Figure::groups
    std::vector<FigureNumber> numbers;
    std::string commands; ///< of a path: M, L, Q, C and Z
    Anchor anchor = Anchor::start;
    std::vector<FigureSpan> spans; ///< of a text
    int shown_if = -1;             ///< as in FigureGroup
    int line = 0;                  ///< of the file, from 1
};

/// A circle that can be dragged: it sets a setting, on which its own place depends.
struct FigureHandle {
    std::string setting; ///< as in conditions: `camera.position.z`
    const Setting* set = nullptr;
    ControlRange range;
    int shape = 0; ///< index in Figure::shapes
};

/// An expression with its place in the file.
struct FigureExpression {
    Expression expression;
    std::optional<float> as_written; ///< the number in whose place it stands; none: other text
    double slack = 1.0;              ///< how far from that its value may be, for a browser
    int line = 0;                    ///< of the file, from 1
};

/// A condition with its place in the file.
struct FigureCondition {
    Expression expression;
    bool is_hidden = false; ///< as written, for a browser
    int line = 0;           ///< of the file, from 1
};

/// A figure as read. Places are in its own unit, about one pixel of text of the usual size, from
/// its upper left corner, y down.
struct Figure {
    glm::vec2 size{0.0f};            ///< 1 .. largest_figure_side
    std::vector<FigureGroup> groups; ///< an outer one comes before those in it; 0: the whole figure
    std::vector<FigureShape> shapes; ///< later ones are drawn over earlier ones
    std::vector<FigureHandle> handles;
    std::vector<FigureExpression> expressions;
    std::vector<FigureCondition> conditions;
    std::string style; ///< for a browser, see figure_style()
};

/// Reads a figure. Throws InputError with the line of what is not understood.
/// @param path is only used in messages
Figure read_figure(std::string_view text, const std::string& path);

/// A word of a class attribute and what it means for a browser.
struct FigureClass {
    std::string_view name;
    std::string_view light, dark; ///< of a colour: #rrggbb; otherwise empty
    FigureColour colour = FigureColour::ink;
    bool FigureLook::*flag = nullptr; ///< of anything else; null for a colour
    bool is_inherited = false;        ///< a group passes it on to its parts
};
const std::vector<FigureClass>& figure_classes();

/// The text of the <style> element that every figure of a lesson has: with it a browser shows the
/// same colours as the window.
std::string figure_style();

/// Are two styles the same, but for blanks?
bool is_same_style(std::string_view a, std::string_view b);

inline constexpr float largest_figure_side = 2000.0f;
inline constexpr float largest_figure_number = 1e5f;
inline constexpr std::size_t most_figure_shapes = 400;
/// Of places, of groups (two each), expressions and conditions.
inline constexpr std::size_t most_figure_numbers = 4'000;
inline constexpr std::size_t most_figure_handles = 8;
inline constexpr int most_handle_stops = 1'000;

} // namespace rasterwalk
