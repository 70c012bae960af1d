#pragma once

#include <algorithm>
#include <array>
#include <climits>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/cursor.h"
#include "pipeline/drawn_list.h"
#include "pipeline/warnock_squares.h"
#include "scene/scene.h"
#include "settings/choose_stages.h"
#include "settings/depth_words.h"
#include "settings/settings.h"
#include "stages/polygon_corners.h"

namespace rasterwalk {

/// Puts other functions in slots of the table that the settings have chosen.
using ReplaceStages = std::function<void(Stages&)>;

/// A scene, and its tessellated form.
struct TessellatedScene {
    Scene given;
    int parts = 1; ///< of each edge
    Scene made;
};

/// A frame ready to be drawn: O(vertices) work is done and kept; O(pixels) work is left to draw().
/// Refers to its scene, which must outlive it.
struct Frame {
    const Scene* scene = nullptr;    ///< the one drawn: `in_order`, or the drawn list made of it
    const Scene* in_order = nullptr; ///< the given one, or its tessellation, in the scene's order
    const Scene* given = nullptr;    ///< the one the frame was made for
    int pass = 0; ///< in which it is drawn, see Cursor::pass; its own moments have pass 0
    std::shared_ptr<const TessellatedScene> tessellated; ///< owns the tessellation; null: none
    std::shared_ptr<const DrawnList> list;               ///< owns the drawn list; null: none
    std::shared_ptr<const DividedMesh> divided;          ///< the last tree, for the next list
    Settings settings;
    ReplaceStages replace;                  ///< functions in addition to those of the settings, or
                                            ///< null
    Stages stages;                          ///< the table used to draw and inspect it
    std::vector<ClipVertex> shaded;         ///< the vertices of the mesh in clip space
    std::vector<ProjectedVertex> projected; ///< the same, projected
    std::vector<TriangleIndices> triangles; ///< of the mesh: the vertices at their corners
    std::vector<ScreenVertex> vertices;     ///< corners of cut triangles, one after another
    bool blends = false;                    ///< something is half transparent, and drawn that way
    Occluders occluders;                    ///< what casts shadows; empty if nothing does
    bool bends = false;                     ///< normal maps bend normals somewhere
    bool shifts = false;                    ///< height maps shift textures somewhere
    std::vector<Polygon> polygons;          ///< what reject, clip and cull left of each triangle
                                            ///< of `scene`, in order
    std::shared_ptr<const WarnockSquares> squares; ///< the moments, if the picture is divided into
                                                   ///< squares; null: it is not

    int triangle_count() const { return static_cast<int>(polygons.size()); }
    /// How many triangles are drawn for each one of the given scene.
    int triangles_of_each() const {
        return tessellated == nullptr ? 1 : tessellated->parts * tessellated->parts;
    }
    Rejection rejection(int triangle) const {
        return polygons[static_cast<std::size_t>(triangle)].rejection;
    }
    /// Do pixels have several samples, and are they resolved once all triangles are drawn?
    bool has_samples() const { return rasterwalk::has_samples(stages); }
    bool is_drawn(int triangle) const { return rejection(triangle) == Rejection::none; }
    /// Are its corners no longer those of the scene's triangle?
    bool is_cut(int triangle) const { return polygons[static_cast<std::size_t>(triangle)].is_cut; }
    /// Did the triangle get as far as culling, and is anything in that slot?
    bool is_cull_tested(int triangle) const {
        const Rejection why = rejection(triangle);
        return stages.cull != cull_nothing &&
               (why == Rejection::none || why == Rejection::back_facing);
    }
    /// Has clipping left a polygon with different corners, or nothing?
    bool has_clip_events(int triangle) const {
        return is_cut(triangle) || rejection(triangle) == Rejection::clipped_away;
    }
    /// Does the triangle have moments? Of those not drawn, only the ones removed by clip or cull:
    /// the reason is one of their moments. Where squares are the moments, none has any.
    bool has_moments(int triangle) const {
        if (squares != nullptr) return false;
        const Rejection why = rejection(triangle);
        return why == Rejection::none || why == Rejection::clipped_away ||
               why == Rejection::back_facing;
    }
    /// One of the three vertices of a triangle of the scene, before it is clipped.
    const ProjectedVertex& given_vertex(int triangle, int corner) const {
        return projected[vertex_index(triangle, corner)];
    }
    const ClipVertex& given_clip_vertex(int triangle, int corner) const {
        return shaded[vertex_index(triangle, corner)];
    }
    /// All three in clip space.
    std::array<ClipVertex, triangle_corners> given_clip_vertices(int triangle) const {
        return {given_clip_vertex(triangle, 0), given_clip_vertex(triangle, 1),
                given_clip_vertex(triangle, 2)};
    }
    /// The number in the mesh of a corner, 0, 1 or 2, of a triangle of the scene.
    std::size_t vertex_index(int triangle, int corner) const {
        return static_cast<std::size_t>(
            triangles[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(corner)]);
    }
    /// The corners of the drawn part of a triangle; if it is not drawn, as far as known.
    PolygonCorners triangle_vertices(int triangle) const {
        const auto t = static_cast<std::size_t>(triangle);
        const Polygon& polygon = polygons[t];
        if (!polygon.is_cut) return {projected, triangles[t]};
        return std::span{vertices.data() + polygon.first, static_cast<std::size_t>(polygon.count)};
    }
};

/// The text of a moment of the frame, with the pass that it is drawn in.
std::string moment_text(const Frame& frame, const Cursor& cursor);

/// What comes after the last triangle with moments, see next_with_moments().
inline constexpr int no_triangle = INT_MAX;

/// The first triangle with moments from this one on; then resolve_triangle, in place of one, if the
/// frame's pixels are resolved; then no_triangle.
int next_with_moments(const Frame& frame, int triangle);

/// The last one before this triangle, or before resolve_triangle or no_triangle; -1: there is none.
int last_with_moments(const Frame& frame, int triangle);

/// How many units time is divided into, all equally long: the triangles, drawn or not, and one more
/// if pixels are resolved; or the squares.
int time_units(const Frame& frame);

/// The unit of a triangle, or of resolve_triangle; and back.
inline int unit_of(const Frame& frame, int triangle) {
    return std::min(triangle, frame.triangle_count());
}
inline int triangle_of_unit(const Frame& frame, int unit) {
    return unit < frame.triangle_count() ? unit : resolve_triangle;
}

/// Does a unit have moments? Not of squares.
bool has_moments_in_unit(const Frame& frame, int unit);

/// The triangle that a piece of work is about: of a square, the one that is drawn in it, if any.
std::optional<int> triangle_at(const Frame& frame, const Cursor& cursor);

/// What casts shadows in the frame; null: nothing does.
inline const Occluders* occluders_of(const Frame& frame) {
    return frame.occluders.triangles == nullptr ? nullptr : &frame.occluders;
}

/// The rules for vertices and pixels, with what casts shadows. They refer to the frame.
VertexRules vertex_rules(const Frame& frame);
PixelRules pixel_rules(const Frame& frame);

/// What the depth buffer of the frame holds.
inline ClipDepth depth_kind(const Frame& frame) {
    return clip_depth_rule(frame.settings, frame.scene->space);
}
inline const DepthWords& depth_words(const Frame& frame) {
    return depth_words(depth_kind(frame));
}

/// What values are divided by on their way: "1/z", or "1/w" if w is not z.
inline std::string_view weight_name(const Frame& frame) {
    return vertex_rules(frame.settings, frame.scene->space).projection.mix > 0.0f ? "1/w" : "1/z";
}

/// Does the frame show a texture anywhere?
inline bool is_textured(const Frame& frame) {
    return !frame.scene->textures.empty() && frame.settings.texture == TextureUse::on &&
           has_fragments(frame.settings.stage);
}

/// What the alpha of textures does in the frame: if nothing is blended, no texture is.
inline TextureAlpha texture_alpha_rule(const Frame& frame) {
    const TextureAlpha chosen = frame.settings.texture_alpha;
    return chosen == TextureAlpha::blend && !frame.blends ? TextureAlpha::off : chosen;
}

/// The varyings that edges and rows carry in the frame.
VaryingSet carried_varyings(const Frame& frame);

/// The table for a frame: what the settings choose for such a scene, with the slots that `replace`
/// changes.
Stages stages_for(const Settings& settings, const Scene& scene, const ReplaceStages& replace);

/// Tessellates the scene, takes each vertex of the mesh once through vertex shader and projection,
/// and each triangle through reject, clip and cull. A polygon with a rejected vertex is left out
/// altogether, for the reason of the first such vertex.
Frame prepare_frame(const Scene& scene, const Settings& settings,
                    const ReplaceStages& replace = nullptr);

/// The same, replacing another frame, whose memory is reused: with many triangles, allocating new
/// memory takes longer than all the rest.
void prepare_frame(const Scene& scene, const Settings& settings, const ReplaceStages& replace,
                   Frame& frame);

/// The corners of one triangle as they would be under other settings, with the functions that were
/// put in the frame's slots.
std::vector<ScreenVertex> polygon_under(const Frame& frame, int triangle, const Settings& settings);

/// The triangle of one frame that corresponds to this one of another frame of the same scene: the
/// same, or the first of its parts or pieces that is drawn, or the one it is part of.
int triangle_in(const Frame& frame, const Frame& other, int triangle_of_other);

/// Do both frames of a scene draw the same triangles, with the same numbers?
bool have_same_triangles(const Frame& a, const Frame& b);

/// Do they draw them one after another, too, so that their moments correspond? Those of pixels with
/// several samples are not compared.
bool have_same_moments(const Frame& a, const Frame& b);

/// Clips a triangle again, by the function that clipped it.
/// @param sink    receives each edge at each plane; for a triangle that no plane has cut, nothing
void replay_clipping(const Frame& frame, int triangle, ClipSink& sink);

/// Culls a triangle again, by the function that culled it.
/// @return what the function looked at
CullTest cull_test(const Frame& frame, int triangle);

/// The row table of a drawn triangle.
/// @param sink    receives each edge sample; or null
/// @param carried the varyings that are wanted; if only positions count, none
void compute_rows(const Frame& frame, int triangle, PolygonRows& rows, SampleSink* sink = nullptr,
                  VaryingSet carried = VaryingSet::all());

/// The pixels that are walked and pass the bounds test: the picture, or a little less.
Rectangle drawn_area(const Frame& frame);

} // namespace rasterwalk
