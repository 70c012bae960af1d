#include "session/canvas_view.h"

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
                        "Shows the picture, and the scene from outside beside it."},
    };
    static_assert(is_indexed_by(list, &CanvasShowsInfo::shows));
    return list;
}

CanvasShows shown_on_canvas(const CanvasView& view, const Scene& scene) {
    return scene.space == SceneSpace::world ? view.shows : CanvasShows::picture;
}

std::string to_text(const glm::vec2& place) {
    return number_text(place.x) + "," + number_text(place.y);
}

} // namespace rasterwalk
