#pragma once

// Scenes and settings that several tests draw.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "settings/settings.h"
#include "support/random.h"

namespace rasterwalk::test {

/// The lab's room, from its file.
Scene lab_room();

/// A vertex in pixel space, with a normal toward the eye.
Vertex pixel_vertex(float column, float row, float z);

/// A scene in pixel space, with each triangle a part with its own colour.
Scene pixel_scene(const std::vector<std::array<glm::vec3, 3>>& triangles, Viewport viewport);

/// A few triangles on a tiny picture: overlapping, partly and wholly outside it, without area, of
/// one pixel, with samples outside their row tables, and one that is left out.
Scene small_scene();

/// A random triangle around a picture of this size; sometimes without area.
std::array<glm::vec3, 3> random_triangle(Random& random, Viewport viewport);

/// One choice of the settings that change which pixels are covered, or how.
struct Variant {
    std::string name;
    std::function<void(Settings&)> apply;
};

/// The handout's rules; each other word of each choice setting alone; and several changed at
/// once.
const std::vector<Variant>& rule_variants();

/// A camera pose from which all of the room can be drawn.
struct Pose {
    std::string name;
    Camera camera;
    Viewport viewport;
};
const std::vector<Pose>& room_poses();

} // namespace rasterwalk::test
