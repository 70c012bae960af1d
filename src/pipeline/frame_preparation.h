#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/frame.h"
#include "pipeline/work.h"

namespace rasterwalk {

/// The vertices and polygons of a frame on their way: each vertex of the mesh is shaded and
/// projected once, then each triangle goes through reject, clip and cull. Done in as many parts as
/// one likes it comes to the same. Mesh and frame must live as long.
class FramePreparation {
  public:
    /// Empties the frame of vertices and polygons. Its stages must have been chosen.
    FramePreparation(const Mesh& mesh, const VertexRules& rules, Frame& frame);

    /// Goes on as far as the limit allows. What is more than `most` is begun all the same: nothing
    /// can be shown of a frame that is not prepared.
    void advance(const WorkLimit& limit = {});

    /// Until then the frame is of no use to anyone.
    bool is_done() const;

    /// How much work the whole preparation is.
    double work() const;

  private:
    void shade_vertices(std::size_t count);
    void make_polygons(std::size_t count);
    Polygon make(int triangle);
    void clip(int triangle, Polygon& polygon);
    static void count(const ProjectedVertex& corner, Polygon& polygon);

    const Mesh* mesh_;
    Frame* frame_;
    ViewVolume volume_;
    SightRays rays_;
    glm::mat3 rotation_;
    bool asks_corners_;               ///< for them alone the corners are gathered
    std::vector<ClipVertex> corners_; ///< of the polygon on its way
};

/// Takes the scene, or what tessellation makes of it, into a frame in place of what is there, whose
/// memory is used again, and begins its preparation.
FramePreparation begin_frame(const Scene& scene, const Settings& settings,
                             const ReplaceStages& replace, Frame& frame);

} // namespace rasterwalk
