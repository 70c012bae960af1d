#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "pipeline/frame.h"
#include "pipeline/squares_preparation.h"
#include "pipeline/work.h"

namespace rasterwalk {

/// The vertices and polygons of a frame on their way: each vertex of the mesh is shaded and
/// projected once, then each triangle goes through reject, clip and cull; last, if the settings ask
/// for it, the picture is divided into squares. The result does not depend on how many parts this
/// is done in. Mesh and frame must outlive it.
class FramePreparation {
  public:
    /// Removes the frame's vertices and polygons. Its stages must have been chosen.
    FramePreparation(const Mesh& mesh, const VertexRules& rules, Frame& frame);

    /// Goes on as far as the limit allows. Work above `most` is begun all the same: a frame that is
    /// not prepared cannot be shown.
    void advance(const WorkLimit& limit = {});

    /// Until then the frame must not be used.
    bool is_done() const;

    /// How much work the whole preparation is.
    double work() const;

  private:
    void shade_vertices(std::size_t count);
    void make_polygons(std::size_t count);
    void make_squares(double work);
    Polygon make(int triangle);
    void clip(int triangle, Polygon& polygon);
    static void count(const ProjectedVertex& corner, Polygon& polygon);

    const Mesh* mesh_;
    Frame* frame_;
    ViewVolume volume_;
    SightRays rays_;
    glm::mat3 rotation_;
    bool asks_corners_;                         ///< only then are the corners gathered
    std::vector<ClipVertex> corners_;           ///< of the current polygon
    bool needs_squares_;                        ///< the frame has none yet, and is to have them
    std::optional<SquaresPreparation> squares_; ///< once the polygons are made
};

/// Puts the scene, or its tessellation, into a frame, reusing its memory, and begins its
/// preparation.
FramePreparation begin_frame(const Scene& scene, const Settings& settings,
                             const ReplaceStages& replace, Frame& frame);

} // namespace rasterwalk
