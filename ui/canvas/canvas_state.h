#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "inspect/triangle_fates.h"
#include "scene/scene.h"
#include "settings/settings.h"
#include "ui/widgets/picture_state.h"

namespace rasterwalk {

class OutsideDrawing; // outside/outside_drawing.h

/// The part of the canvas that the row table takes from the picture, screen pixels.
struct RowTablePlace {
    float left = 0.0f, right = 0.0f;
    bool is_at_left = false; ///< at the left of the canvas; if not, at its right
};

/// What the triangles cover of the picture.
struct DrawnPart {
    std::uint64_t frame_number = 0; ///< of the frame that was looked through; see RunResults
    PicturePart part;
};

/// What the student wants done with a frame of very many fragments.
enum class LargeFrameChoice : std::uint8_t {
    none, ///< not said: it is not begun if too much of it is in the picture
    draw,
    stop,
};

/// That wish, and the frame it is about.
struct LargeFrame {
    LargeFrameChoice choice = LargeFrameChoice::none;
    std::shared_ptr<const Scene> scene;
    std::optional<Settings> a, b; ///< of the two runs
};

/// Hints that the student has hidden.
struct HiddenHints {
    std::weak_ptr<const Scene> scene;  ///< whose hints they were
    std::vector<std::string> in_short; ///< see VisibilityHint
};

/// What the canvas keeps from one frame to the next.
struct CanvasState {
    PictureTexture picture; ///< shows Results::picture
    PictureTexture overlay; ///< shows Results::overlay
    PicturePlace place;     ///< of the picture in this frame
    DrawnPart drawn;        ///< looked for again when the frame changes
    PictureTexture outside; ///< shows the drawing of the scene from outside
    std::shared_ptr<OutsideDrawing> outside_drawing; ///< none while it has not been shown for long
    double outside_shown = 0.0;                      ///< when it was shown last, ImGui's time
    bool shows_legend = true; ///< of the overlays; if not, only their swatches
    float depth_grip = 0.0f;  ///< from the held handle of the depth view to the pointer
    std::optional<glm::ivec2> hovered_pixel; ///< of the picture, under the pointer
    std::optional<int> hovered_row; ///< of the picture, under the pointer in the table next to it
    std::optional<RowTablePlace> row_table; ///< next to the picture in this frame; none: not shown
    FateFinder fates;                       ///< of the triangle shown
    float frame_top = 0.0f,
          frame_bottom = 0.0f; ///< of the picture's part of the canvas, screen pixels
    int dragged_vertex = -1;   ///< of the bench triangle; -1: none
    LargeFrame large_frame;
    HiddenHints hidden_hints;
};

/// What run B of each pair would look like, small.
struct OfferPictures {
    std::shared_ptr<const Scene> scene;   ///< the scene they show
    std::optional<Settings> settings;     ///< of run A, from which they follow
    int side = 0;                         ///< the size they were made for, screen pixels
    bool is_drawn = false;                ///< false: there are none, the scene is too large
    std::vector<PictureTexture> textures; ///< in the order of compare_pairs()
};

/// What only concerns the screen while two runs are compared.
struct CompareLook {
    PictureTexture picture;                 ///< shows run B
    PictureTexture difference;              ///< shows B minus A
    std::array<PictureTexture, 3> small;    ///< the small pictures of A, B and B minus A
    OfferPictures offers;                   ///< before anything is compared
    std::optional<PicturePlace> place_of_b; ///< of its picture, while both are large
    bool has_small = true;                  ///< there is, or would be, room for the small pictures
    float blink_seconds = 0.0f;             ///< since A's last turn began
    bool blink_is_held = false;
};

} // namespace rasterwalk
