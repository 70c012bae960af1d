#pragma once

// The shadow pass: prepares what casts shadows, before the picture is drawn. For a map the scene is
// drawn six times by the pipeline itself, from the lamp, and only the depth is kept.

#include "pipeline/frame.h"

namespace rasterwalk {

/// Nearer to the lamp than this a map sees nothing, world units.
inline constexpr float shadow_near = 1e-3f;

/// How the lamp sees a face of its map: its rules are always the right ones, with pixels tested at
/// their centres, whatever rules the picture has.
/// @param lamp world
/// @param face 0 to shadow_face_count - 1
Settings shadow_face_settings(const glm::vec3& lamp, int face, int resolution);

/// Draws all faces.
ShadowMap draw_shadow_map(const Scene& scene, const glm::vec3& lamp, int resolution);

/// Gives a frame what casts its shadows, or nothing if its settings ask for none. Needs the frame's
/// scene, settings and stages. Whatever it already has is kept as far as it is the same.
void take_occluders(Frame& frame);

} // namespace rasterwalk
