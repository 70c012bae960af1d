#pragma once

// The shadow pass: prepares what casts shadows, before the picture is drawn. For a map the scene is
// drawn six times by the pipeline itself, from the lamp, and only the depth is kept. In time these
// six passes come before the picture. To walk through one, its frame is made again: each is the
// same work with other settings.

#include <string>

#include "base/language.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// Nearer to the lamp than this a map sees nothing, world units.
inline constexpr float shadow_near = 1e-3f;

/// How the lamp sees a face of its map: its rules are always the right ones, with pixels tested at
/// their centres, whatever rules the picture has.
/// @param lamp world
/// @param face 0 to shadow_face_count - 1
Settings shadow_face_settings(const glm::vec3& lamp, int face, int resolution);

static_assert(shadow_face_count == early_pass_count);
constexpr int pass_of_face(int face) {
    return face - shadow_face_count;
}
constexpr int face_of_pass(int pass) {
    return pass + shadow_face_count;
}

/// The pass with which a picture with these settings begins: that of the map's first face, or the
/// picture itself.
int first_pass(const Settings& settings, SceneSpace space);

/// The pass of a cursor in the walk through a picture with these settings; 0 if there is no such
/// pass.
int pass_of(const Cursor& cursor, const Settings& settings, SceneSpace space);

/// What is drawn in a pass before the picture: "shadow map, face +x".
std::string pass_name(int pass, const Language& language = english());

/// The settings of the frame that is drawn in a pass, for a picture with these settings.
/// @param pass first_pass() to 0
Settings settings_of_pass(const Settings& settings, int pass);

/// Prepares the frame that is drawn in a pass.
/// @param settings of the picture
Frame prepare_pass(const Scene& scene, const Settings& settings, int pass);

/// Draws all faces.
ShadowMap draw_shadow_map(const Scene& scene, const glm::vec3& lamp, int resolution);

/// Gives a frame what casts its shadows, or nothing if its settings ask for none. Needs the frame's
/// scene, settings and stages. Whatever it already has is kept as far as it is the same.
void take_occluders(Frame& frame);

} // namespace rasterwalk
