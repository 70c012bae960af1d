#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "base/enum_words.h"
#include "outside/outside_view.h"
#include "scene/scene.h"
#include "settings/depth_words.h"

namespace rasterwalk {

/// What the canvas shows.
enum class CanvasShows : std::uint8_t {
    picture, ///< what the camera sees
    outside, ///< the scene, the camera and the picture, from outside
    both,    ///< side by side
};

inline constexpr int canvas_shows_count = static_cast<int>(enum_words<CanvasShows>.size());

/// Its words in the interface.
struct CanvasShowsInfo {
    CanvasShows shows;
    std::string_view title;                 ///< on the switch
    std::string_view menu_title;            ///< in the menu
    std::string_view help;                  ///< one sentence
    std::string_view name = word_of(shows); ///< for tests and lessons
};

/// All of them, in the order of their switches; indexed by CanvasShows.
const std::array<CanvasShowsInfo, canvas_shows_count>& canvas_shows_list();

/// The number in every cell of the picture, if the zoom leaves room for it.
enum class CellNumbers : std::uint8_t {
    none,
    ends,        ///< the column of a row's left and right end, of the triangle shown
    depth,       ///< what the depth buffer holds
    owner,       ///< the triangle that the pixel shows
    overdraw,    ///< how many fragments fell on it
    edge_values, ///< values of the edge functions of the triangle shown
    weights,     ///< of its corners
};

inline constexpr int cell_numbers_count = static_cast<int>(enum_words<CellNumbers>.size());

/// Do they belong to edge-function tests? Then a cell holds three of them.
constexpr bool is_of_tests(CellNumbers numbers) {
    return numbers == CellNumbers::edge_values || numbers == CellNumbers::weights;
}

/// Their words in the interface.
struct CellNumbersInfo {
    CellNumbers numbers;
    std::string_view title; ///< where they are chosen; {0}: the depth's name, {1}: which is nearer
    std::string_view help;  ///< one sentence; with the same fields
    std::string_view key;   ///< explains a number, next to the cells; with the same fields
    std::string_view name = word_of(numbers); ///< for tests and lessons
};

/// The words for the numbers in a frame.
struct CellNumbersWords {
    std::string title, help, key;
};
/// @param depth what the frame's depth buffer holds
CellNumbersWords cell_numbers_words(CellNumbers numbers, const DepthWords& depth);

/// All of them, in the order they are offered; indexed by CellNumbers.
const std::array<CellNumbersInfo, cell_numbers_count>& cell_numbers_list();

/// How the canvas shows the scene.
struct CanvasView {
    CanvasShows shows = CanvasShows::picture; ///< if there is a camera; see shown_on_canvas()
    OutsideView outside;
    float zoom = 0.0f;            ///< screen pixels per picture pixel; 0: fit
    glm::vec2 centre{0.0f, 0.0f}; ///< picture pixel in the middle of the canvas, when zoom is set
    bool grid = true;             ///< pixel grid, from 8x up
    bool row_table = true;        ///< next to the rows it describes, from 24x up
    bool fates = true;            ///< pass and fail in the cells, from 24x up
    CellNumbers numbers = CellNumbers::none; ///< in the cells
    std::optional<int> field_edge; ///< of the overlay edge_field; none: the one at work, or edge 0

    friend bool operator==(const CanvasView&, const CanvasView&) = default;
};

/// What the canvas shows of this scene: without a camera there is no outside.
CanvasShows shown_on_canvas(const CanvasView& view, const Scene& scene);

/// A point in the picture, picture pixels: "250.5,131", which parse_place() reads back.
std::string to_text(const glm::vec2& place);

/// From this zoom up, single pixels are worth a grid and their own marks.
inline constexpr float grid_zoom = 8.0f;

/// From this zoom up, a cell has room for its own marks, and the row table is next to the rows.
inline constexpr float cell_zoom = 24.0f;

inline constexpr float smallest_zoom = 0.25f; ///< screen pixels per picture pixel
inline constexpr float largest_zoom = 64.0f;
inline constexpr float farthest_centre = 1e6f; ///< picture pixels, either sign

} // namespace rasterwalk
