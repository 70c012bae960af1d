#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "base/enum_words.h"
#include "pipeline/cursor.h"
#include "stages/clip.h"
#include "stages/cull.h"
#include "stages/edge_functions.h"
#include "stages/fragment.h"
#include "stages/polygon_rows.h"
#include "stages/project.h"

namespace rasterwalk {

/// What became of a fragment.
enum class Fate : std::uint8_t {
    written,      ///< now the pixel's colour
    depth_failed, ///< something nearer was there
    back_facing,  ///< its normal points away from the camera, and such fragments are culled
    cut_out,      ///< its texture is more clear than opaque there: it is let through
};

/// Points and row ends that are put on the screen are reported as fragments.
inline Fragment mark_of(const ScreenVertex& v) {
    return {v.column, v.row, v.depth, v.inv_w, v.z, v.varyings};
}
inline Fragment mark_of(const RowEnd& end, int row) {
    return {end.column, row, end.depth, end.inv_w, end.z, end.varyings};
}

/// One fragment, at the moment it is drawn. Points, edge samples and row ends that are put on the
/// screen are fragments too.
struct FragmentEvent {
    Cursor cursor; ///< its piece of work
    Fragment fragment;
    Fate fate = Fate::written;
    float depth = 0.0f;  ///< its value for the depth buffer
    float stored = 0.0f; ///< the depth buffer's previous value
    glm::vec3 before{0.0f};
    glm::vec3 after{0.0f};
    float alpha = 1.0f; ///< how opaque it is, see FragmentAlpha
};

/// Did a fragment get as far as the depth test?
constexpr bool is_depth_tested(Fate fate) {
    return fate == Fate::written || fate == Fate::depth_failed;
}

/// One sample of an edge, at the moment it is entered in the row table.
struct SampleEvent {
    Cursor cursor;
    EdgeSample sample;
};

/// One pixel of the box, at the moment it is tested for coverage.
struct TestEvent {
    Cursor cursor;
    PixelTest test;
};

/// One edge at one plane, at the moment it is clipped.
struct ClipEvent {
    Cursor cursor;
    ClipStep step;
};

/// One triangle, at the moment it is tested for facing away.
struct CullEvent {
    Cursor cursor;
    CullTest test;
};

/// Receives what draw() does. Watching never changes what is drawn.
class Observer {
  public:
    virtual ~Observer() = default;
    /// A vertex of the scene, before clipping; one behind the camera has no pixel.
    virtual void vertex(const Cursor&, const ProjectedVertex&) {}
    virtual void clip_step(const ClipEvent&) {}
    virtual void cull(const CullEvent&) {}
    virtual void edge_sample(const SampleEvent&) {}
    virtual void pixel_test(const TestEvent&) {}
    virtual void fragment(const FragmentEvent&) {}
    /// False saves draw() the work of reporting edge samples.
    virtual bool wants_edge_samples() const { return false; }
    /// False saves draw() the work of reporting tested pixels.
    virtual bool wants_pixel_tests() const { return false; }
    /// False saves draw() the work of reporting clipping and culling.
    virtual bool wants_clipping() const { return false; }
};

} // namespace rasterwalk
