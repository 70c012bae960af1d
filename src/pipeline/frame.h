#pragma once

#include <functional>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "settings/choose_stages.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Puts other functions in slots of the table that the settings have chosen.
using ReplaceStages = std::function<void(Stages&)>;

/// A frame ready to be drawn: what is O(vertices) is worked out and kept; what is O(pixels) is left
/// to draw(). Refers to its scene, which must live as long.
struct Frame {
    const Scene* scene = nullptr;
    Settings settings;
    ReplaceStages replace;              ///< functions beside those of the settings, or null
    Stages stages;                      ///< the table by which it is drawn and inspected
    std::vector<ScreenVertex> vertices; ///< the corners of the polygons, one after another
    std::vector<Polygon> polygons;      ///< what has become of each triangle of the scene, in order

    int triangle_count() const { return static_cast<int>(polygons.size()); }
    Rejection rejection(int triangle) const {
        return polygons[static_cast<std::size_t>(triangle)].rejection;
    }
    bool is_drawn(int triangle) const { return rejection(triangle) == Rejection::none; }
    /// Are its corners no longer those that the scene gives the triangle?
    bool is_cut(int triangle) const { return polygons[static_cast<std::size_t>(triangle)].is_cut; }
    /// The corners of what is drawn of a triangle; of one that is not drawn, as far as known.
    std::span<const ScreenVertex> triangle_vertices(int triangle) const {
        const Polygon& polygon = polygons[static_cast<std::size_t>(triangle)];
        return {vertices.data() + polygon.first, static_cast<std::size_t>(polygon.count)};
    }
};

/// The table for a frame: what the settings choose, and what is put in its place.
Stages stages_for(const Settings& settings, const ReplaceStages& replace);

/// Takes each vertex of the scene's mesh through vertex shader and projection, once, and each
/// triangle through reject, clip and cull. A polygon with one vertex that is rejected is left out
/// whole, for the reason of the first such vertex.
Frame prepare_frame(const Scene& scene, const Settings& settings,
                    const ReplaceStages& replace = nullptr);

/// The same in place of another frame, whose memory is used again: with many triangles to ask for
/// new memory takes longer than all the rest.
void prepare_frame(const Scene& scene, const Settings& settings, const ReplaceStages& replace,
                   Frame& frame);

/// The corners of one triangle as they would be under other settings, with the functions that were
/// put in slots of the frame.
std::vector<ScreenVertex> polygon_under(const Frame& frame, int triangle, const Settings& settings);

/// The row table of a drawn triangle.
/// @param sink    is told of each edge sample, or null
/// @param carried the varyings that are wanted; where only places count, none
void compute_rows(const Frame& frame, int triangle, PolygonRows& rows, SampleSink* sink = nullptr,
                  VaryingSet carried = VaryingSet::all());

/// The pixels that the bounds test lets through: the picture, or a little less.
Rectangle drawn_area(const Frame& frame);

} // namespace rasterwalk
