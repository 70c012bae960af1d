#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "compare/compare.h"
#include "engines/engine_picture.h"
#include "engines/program_drawing.h"
#include "inspect/hidden_ways.h"
#include "inspect/pixel_history.h"
#include "inspect/visibility_hints.h"
#include "picture/overlay.h"
#include "picture/view_image.h"
#include "pipeline/stepping.h"
#include "session/depth_view.h"
#include "session/preview.h"
#include "session/run_results.h"
#include "session/session.h"

namespace rasterwalk {

/// How far the difference of the pictures at the cursor has been computed.
struct DifferenceProgress {
    std::uint64_t of_a = 0, of_b = 0; ///< numbers of the pictures that are compared; 0: none are
    std::optional<View> view;         ///< whose difference it is
    PixelCount pixels;
    int value_rows = 0; ///< rows whose values are computed
    int image_rows = 0; ///< rows of the picture that have their colour
    float limit = 1.0f; ///< of the scale for these colours
    bool is_done = false;
};

/// How run B differs from run A.
struct ComparisonResults {
    Image difference;                    ///< B minus A in the view shown, at the cursor
    std::uint64_t difference_number = 0; ///< changes whenever `difference` does
    float difference_limit = 1.0f;       ///< its scale goes from minus this to plus this, in linear
                                         ///< colour, 1/z or fragments; see difference_colour()
    std::vector<float> difference_values; ///< B minus A of each pixel: the number under the pointer
    PixelDifference pixels;               ///< at the cursor
    DifferenceProgress progress;          ///< of these; until it is done, all or some of them
                                          ///< belong to the previous pictures
    ComparisonWork work;                  ///< compares the whole frames, in parts if needed
    std::optional<Divergence> here;       ///< if the runs differ in the next piece of work
    Framebuffer scratch;                  ///< room for examining that piece of work

    /// The comparison of the whole frames, so far.
    const Comparison& whole() const { return work.found(); }
};

/// The pictures that the overlays' background is made from, by number.
struct GroundSource {
    std::uint64_t picture = 0, overlay = 0;

    friend bool operator==(const GroundSource&, const GroundSource&) = default;
};

/// What the geometry that overlays draw was found for.
struct GeometrySource {
    std::uint64_t frame = 0;         ///< its number
    std::optional<int> triangle;     ///< none: nothing is found
    std::optional<int> edge;         ///< whose field it is; none: it is not shown
    std::optional<glm::ivec2> pixel; ///< whose weights they are; none: they are not shown

    friend bool operator==(const GeometrySource&, const GeometrySource&) = default;
};

/// What the student's program that is run B puts on the picked pixel.
struct ProgramWrites {
    std::shared_ptr<const ProgramDrawing> program; ///< null: B is none, or no pixel is picked
    glm::ivec2 pixel{0};
    std::vector<ProgramWrite> puts; ///< in order
};

/// Hints about the whole picture of A, and about settings that would show more. Those about the
/// previous picture stay until those about this one are known.
struct PictureHints {
    std::vector<VisibilityHint> found;
    std::shared_ptr<const Scene> scene;      ///< of the picture; null: none are wanted
    bool are_due = false;                    ///< `found` is about an earlier picture
    std::optional<VisibilityHintsWork> work; ///< looks for them once all else is done
};

/// The ways to remove hidden surfaces, counted for the scene and camera of A while their tab is
/// open. Those of the previous camera stay until these are known.
struct HiddenTable {
    std::vector<HiddenWay> ways;
    std::shared_ptr<const Scene> scene; ///< counted, or being counted; null: none
    Settings settings;                  ///< the same, see counted_settings()
    std::optional<HiddenWaysWork> work; ///< counts once all else is done, and keeps its tree
};

/// Everything that the panels show, derived from the session. Written only by update(); must not be
/// copied or moved, because its parts refer to each other.
struct Results {
    Results() = default;
    Results(const Results&) = delete;
    Results& operator=(const Results&) = delete;

    RunResults a;
    std::unique_ptr<RunResults> b; ///< null without a run B, or if it cannot be compared with A
    std::unique_ptr<RunResults> next_b; ///< replaces it as soon as its first frame is prepared
    ComparisonResults comparison;       ///< of both; meaningless while there is no B
    std::string no_comparison;  ///< why they cannot be compared; empty if they can, or there is
                                ///< no run B
    OverlayPicture overlay;     ///< what is laid over the picture of A
    GeometrySource geometry_of; ///< that field and weights in `overlay` were found for
    std::uint64_t overlay_number = 0; ///< grows whenever `overlay` changes
    Image ground; ///< what is below `overlay` instead of the picture of A; no pixels: that picture
    std::uint64_t ground_number = 0;         ///< changes whenever `ground` does
    GroundSource ground_of;                  ///< that it was made from
    bool overlay_is_old = false;             ///< it is empty until the picture of A is drawn
    std::optional<DepthView> depth;          ///< of A, while the depth view is shown
    std::optional<OverdrawCounts> overdraw;  ///< of A, while the overdraw view is shown
    std::optional<PixelHistory> history;     ///< of the picked pixel, over the whole frame of A
    ProgramWrites program_writes;            ///< what the student's program puts on that pixel
    std::optional<HistoryWork> history_work; ///< computes it once the picture is drawn; none:
                                             ///< nothing to do
    PictureHints hints;
    HiddenTable hidden;
    FrameLength length; ///< of the frame of A
    HandWatch hand;     ///< says when previews are wanted
    FastRun preview_engine{{.keeps_planes = false}};
    std::uint64_t numbers = 0; ///< the last number given to a frame or a picture
};

/// Brings the results up to date; does nothing if they already are what the session asks for. Work
/// beyond the limit is done in parts, one per call, as long as is_working(); work that the limit
/// does not allow yet is held. While a frame of many triangles is prepared, all results are
/// still those of the previous frame. While the hand moves, the steps wait if they need more than
/// one update, and previews are shown unless the fast engine refuses; when it rests, the steps
/// begin, and the previews stay until the steps' pictures are complete. Returns true if the picture
/// of A changed.
bool update(const Session& session, Results& results, const WorkLimit& limit = frame_limit);

/// The same, with all the work done in one call.
bool finish(const Session& session, Results& results);

/// Did the last update() leave work to do?
bool is_working(const Results& results);

} // namespace rasterwalk
