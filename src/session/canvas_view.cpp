#include "session/canvas_view.h"

#include <fmt/format.h>

#include "base/numbers.h"

namespace rasterwalk {

const std::array<CanvasShowsInfo, canvas_shows_count>& canvas_shows_list() {
    static constexpr std::array list{
        CanvasShowsInfo{CanvasShows::picture, "Picture", "The picture",
                        "Shows what the camera sees: the picture that is being drawn."},
        CanvasShowsInfo{CanvasShows::outside, "Outside", "The scene from outside",
                        "Shows the scene from outside, with the camera, its picture and the rays "
                        "that make it."},
        CanvasShowsInfo{CanvasShows::both, "Both", "Picture and outside",
                        "Shows the picture, with the scene from outside next to it."},
    };
    static_assert(is_indexed_by(list, &CanvasShowsInfo::shows));
    return list;
}

const std::array<CellNumbersInfo, cell_numbers_count>& cell_numbers_list() {
    static constexpr std::array list{
        CellNumbersInfo{CellNumbers::none, "no numbers", "The cells show only their colour.", ""},
        CellNumbersInfo{CellNumbers::ends, "ends of rows",
                        "The columns of each row's left and right end for the triangle shown: "
                        "leftPixels[i].x and rightPixels[i].x.",
                        "column of an end of the row"},
        CellNumbersInfo{CellNumbers::depth, "{0}",
                        "What the depth buffer holds for the pixel; {1} is nearer.",
                        "{0} in the depth buffer"},
        CellNumbersInfo{CellNumbers::owner, "triangle",
                        "The triangle that the pixel shows: t7 is triangles[7].",
                        "visible triangle"},
        CellNumbersInfo{CellNumbers::overdraw, "overdraw",
                        "How many fragments fell on the pixel, drawn or not.",
                        "fragments on the pixel"},
        CellNumbersInfo{CellNumbers::edge_values, "edge functions",
                        "The three edge functions of the triangle shown at the pixel's centre; "
                        "if the pixel is outside, only those that keep it out.",
                        "edge functions; filled 0: inside, framed 0: outside"},
        CellNumbersInfo{
            CellNumbers::weights, "weights",
            "The weights of the corners of the triangle shown at the pixel's centre; if the "
            "pixel is outside, only those below 0.",
            "weights of the corners v0, v1, v2"},
    };
    static_assert(is_indexed_by(list, &CellNumbersInfo::numbers));
    return list;
}

CellNumbersWords cell_numbers_words(CellNumbers numbers, const DepthWords& depth) {
    const CellNumbersInfo& info = cell_numbers_list()[static_cast<std::size_t>(numbers)];
    const auto said = [&](std::string_view text) {
        return fmt::format(fmt::runtime(text), depth.name, depth.nearer);
    };
    return {said(info.title), said(info.help), said(info.key)};
}

CanvasShows shown_on_canvas(const CanvasView& view, const Scene& scene) {
    return scene.space == SceneSpace::world ? view.shows : CanvasShows::picture;
}

std::string to_text(const glm::vec2& place) {
    return number_text(place.x) + "," + number_text(place.y);
}

} // namespace rasterwalk
