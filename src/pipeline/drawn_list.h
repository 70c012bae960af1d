#pragma once

// The list of triangles that is drawn, where they are not drawn in the scene's order: its triangles
// sorted, or cut and sorted. The order removes hidden surfaces, or saves a depth buffer work. It is
// a scene of its own, so that everything that draws, walks or examines a frame does so as ever: its
// triangle t is the t-th to be drawn, and Scene::sources says which of the scene's it is.
// tests/pipeline/test_drawn_list.cpp shows that with a depth buffer and draw_order=scene there is
// no list.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "scene/scene.h"
#include "settings/settings.h"
#include "stages/bsp.h"
#include "stages/stage_table.h"

namespace rasterwalk {

/// A mesh and its tree, which is the same for every camera.
struct DividedMesh {
    Mesh given;
    BspTree tree;                        ///< empty if the mesh is too large for one
    Mesh pieces;                         ///< of the tree, as triangles in its order
    std::vector<TriangleSource> sources; ///< of the pieces
};

/// The list of a frame.
struct DrawnList {
    Hidden made_by = Hidden::painter;           ///< depth_buffer: by draw_order
    Scene scene;                                ///< in the order in which it is drawn
    std::shared_ptr<const DividedMesh> divided; ///< of bsp
    std::vector<float> depths;    ///< if sorted: what each drawn triangle was sorted by
    std::vector<int> nodes;       ///< of bsp: each drawn triangle's node in the tree
    std::int64_t comparisons = 0; ///< of two depths, or of the camera with a plane
};

/// Makes the list of a scene for a camera.
/// @param divided the last tree, kept if it is of the same mesh; gets the one that is made, even if
///                that is empty; may hold null
/// @return null if the scene's order is asked for, or the scene is in pixels or too large to be
///         sorted or divided: it is then drawn in its own order
std::shared_ptr<const DrawnList> make_drawn_list(const Scene& scene, const Settings& settings,
                                                 const Stages& stages,
                                                 std::shared_ptr<const DividedMesh>& divided);

/// z of camera space of a triangle's corners, by the function that moves and turns the world.
/// @param rotation camera_rotation() of the rules' camera
CornerDepths corner_depths(const Scene& scene, int triangle, const VertexRules& rules,
                           const glm::mat3& rotation, const Stages& stages);

/// The first drawn triangle that is a triangle of the scene, or a piece of it; none: no part of it
/// is drawn.
std::optional<int> first_drawn(const Scene& drawn, int scene_triangle);

} // namespace rasterwalk
