#pragma once

#include <cstdint>
#include <functional>
#include <variant>

#include <glm/vec3.hpp>

#include "base/enum_words.h"
#include "pipeline/cursor.h"
#include "stages/clip.h"
#include "stages/cull.h"
#include "stages/edge_functions.h"
#include "stages/fragment.h"
#include "stages/polygon_rows.h"
#include "stages/project.h"
#include "stages/sample_list.h"

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

/// One vertex of the scene before clipping, at the moment it is projected. One behind the camera
/// has no pixel.
struct VertexEvent {
    Cursor cursor;
    ProjectedVertex vertex;
    Varyings varyings; ///< as q, however the pixel carries them
};

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
    // Of a pixel with several samples. Depth, stored, before and after are then those of the first
    // sample that passed; if none did, of the first that is covered.
    SampleMask covered = 0; ///< the samples that the triangle covers; never 0 then
    SampleMask passed = 0;  ///< those of them to which it is written
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

/// One pixel with several samples, at the moment it is resolved. Not among the events of other
/// sources: recordings have none.
struct ResolveEvent {
    Cursor cursor;
    int column = 0, row = 0;
    SampleColours samples{}; ///< not clamped
    glm::vec3 colour{0.0f};  ///< that the pixel gets

    friend bool operator==(const ResolveEvent&, const ResolveEvent&) = default;
};

/// What draw() and other sources of events tell, see EventSource.
using Event =
    std::variant<VertexEvent, ClipEvent, CullEvent, SampleEvent, TestEvent, FragmentEvent>;

inline const Cursor& cursor_of(const Event& event) {
    return std::visit([](const auto& of_kind) -> const Cursor& { return of_kind.cursor; }, event);
}

/// Receives what draw() does. Watching never changes what is drawn. A kind without a function saves
/// draw() the work of reporting it.
struct Observer {
    std::function<void(const VertexEvent&)> vertex = nullptr;
    std::function<void(const ClipEvent&)> clip_step = nullptr;
    std::function<void(const CullEvent&)> cull = nullptr;
    std::function<void(const SampleEvent&)> edge_sample = nullptr;
    std::function<void(const TestEvent&)> pixel_test = nullptr;
    std::function<void(const FragmentEvent&)> fragment = nullptr;
    std::function<void(const ResolveEvent&)> resolve = nullptr;
};

/// Calls a function with events of every kind in Event.
template <class Hear>
Observer observe_all(const Hear& hear) {
    return {hear, hear, hear, hear, hear, hear, nullptr};
}

} // namespace rasterwalk
