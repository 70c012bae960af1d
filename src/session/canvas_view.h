#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "base/enum_words.h"
#include "outside/outside_view.h"
#include "scene/scene.h"

namespace rasterwalk {

/// What the canvas shows.
enum class CanvasShows : std::uint8_t {
    picture, ///< what the camera sees
    outside, ///< the scene, the camera and the picture, from outside
    both,    ///< side by side
};
template <>
inline constexpr auto enum_words<CanvasShows> = word_list("picture", "outside", "both");
static_assert(words_match<CanvasShows>);

inline constexpr int canvas_shows_count = static_cast<int>(enum_words<CanvasShows>.size());

/// What the interface says of it.
struct CanvasShowsInfo {
    CanvasShows shows;
    std::string_view title;                 ///< on the switch
    std::string_view menu_title;            ///< in the menu
    std::string_view help;                  ///< one sentence
    std::string_view name = word_of(shows); ///< for tests and lessons
};

/// All of them, in the order of their switches; indexed by CanvasShows.
const std::array<CanvasShowsInfo, canvas_shows_count>& canvas_shows_list();

/// How the canvas shows the scene.
struct CanvasView {
    CanvasShows shows = CanvasShows::picture; ///< where there is a camera; see shown_on_canvas()
    OutsideView outside;
    float zoom = 0.0f;            ///< screen pixels a picture pixel; 0: fit
    glm::vec2 centre{0.0f, 0.0f}; ///< picture pixel in the middle of the canvas, when zoom is set
    bool grid = true;             ///< pixel grid from 8x on

    friend bool operator==(const CanvasView&, const CanvasView&) = default;
};

/// What the canvas shows of this scene: without a camera there is no outside.
CanvasShows shown_on_canvas(const CanvasView& view, const Scene& scene);

/// A place in the picture, picture pixels: "250.5,131", such that parse_place() reads it back.
std::string to_text(const glm::vec2& place);

inline constexpr float smallest_zoom = 0.25f; ///< screen pixels a picture pixel
inline constexpr float largest_zoom = 64.0f;
inline constexpr float farthest_centre = 1e6f; ///< picture pixels, either sign

} // namespace rasterwalk
