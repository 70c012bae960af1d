#pragma once

// What each way to remove hidden surfaces costs, and what it gets wrong.

#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/frame.h"
#include "pipeline/frame_drawing.h"
#include "pipeline/tally.h"
#include "settings/choices.h"

namespace rasterwalk {

/// What was compared, cut and remembered to find what hides what.
struct HiddenCounts {
    /// Depth buffer: fragments, or their samples, with what their pixels hold. Painter: two
    /// triangles' depths. BSP: the camera with a plane. Warnock: a triangle with a square, and two
    /// triangles in one.
    std::int64_t comparisons = 0;
    int splits = 0;  ///< BSP: triangles and pieces that a plane has cut in two
    int squares = 0; ///< Warnock: of the picture, those that are divided too
    /// Bytes needed besides scene and picture: the buffer; a depth and a number for each triangle;
    /// the tree; or the rows of all triangles.
    std::int64_t memory = 0;

    friend bool operator==(const HiddenCounts&, const HiddenCounts&) = default;
};

/// @param tally of the frame, as far as it is drawn
HiddenCounts hidden_counts(const Frame& frame, const DrawTally& tally);

/// One of the ways, with a scene and its camera.
struct HiddenWay {
    Hidden way = Hidden::depth_buffer;
    bool is_possible = true; ///< false: the scene is too large for it
    int triangles = 0;       ///< that are drawn: those of the scene, or pieces
    HiddenCounts counts;     ///< of the whole picture
    /// Pixels that show a triangle of the scene, or nothing, which the depth buffer shows neither
    /// there nor at any pixel next to it: outlines may be a pixel apart.
    std::int64_t wrong = 0;

    friend bool operator==(const HiddenWay&, const HiddenWay&) = default;
};

/// What the counts depend on, of these settings: a picture without light, and the lab's depth
/// buffer. `hidden` is depth_buffer.
Settings counted_settings(const Settings& settings);

/// Draws a scene in several ways, without light, and counts. The rules of the ways are those of the
/// settings, except for the depth buffer's: it is the lab's.
class HiddenWaysWork {
  public:
    HiddenWaysWork() = default;
    HiddenWaysWork(const HiddenWaysWork&) = delete; // its parts refer to each other
    HiddenWaysWork& operator=(const HiddenWaysWork&) = delete;

    /// Begins with the depth buffer, which the others are compared with. A BSP tree of the same
    /// mesh is kept from the last time.
    /// @param scene must outlive the work
    /// @param only  the one way to be counted besides it; none: all of them
    void begin(const Scene& scene, const Settings& settings, std::optional<Hidden> only = {});

    /// Goes on as far as the limit allows.
    void advance(const WorkLimit& limit = {});
    bool is_done() const { return ways_.size() == wanted_.size(); }

    /// In the order of Hidden; all that are wanted once is_done().
    const std::vector<HiddenWay>& ways() const { return ways_; }

  private:
    std::vector<int> shown() const;
    std::int64_t count_wrong() const;
    void count();

    const Scene* scene_ = nullptr;
    Settings settings_;
    std::vector<Hidden> wanted_;
    FrameDrawing drawing_;
    bool is_begun_ = false;      ///< the next way
    std::vector<int> by_buffer_; ///< what each pixel shows with the depth buffer, see shown()
    std::vector<HiddenWay> ways_;
};

/// All at once, see HiddenWaysWork::begin().
std::vector<HiddenWay> hidden_ways(const Scene& scene, const Settings& settings,
                                   std::optional<Hidden> only = {});

} // namespace rasterwalk
