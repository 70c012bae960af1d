#pragma once

// A frame of more fragments in the picture than are drawn without being asked for.

#include <utility>

#include "session/content.h"
#include "session/session.h"
#include "ui/canvas/large_frame.h"

namespace rasterwalk {

/// Sixty walls one behind the other, the nearest last, each as large as the picture.
inline Scene many_walls() {
    Scene scene;
    scene.viewport = {1000, 1000};
    scene.camera = {};
    scene.camera.position = {0.0f, 0.0f, 0.0f};
    scene.camera.focal_length = 1000.0f;
    constexpr int walls = 60;
    for (int i = 0; i < walls; ++i) {
        const float z = 2.0f + 0.1f * static_cast<float>(walls - i), half = 0.5f * z;
        const auto corner = [&](float x, float y) {
            Vertex vertex;
            vertex.position = {x * half, y * half, z};
            vertex.normal = {0.0f, 0.0f, -1.0f};
            return vertex;
        };
        scene.mesh.add_triangle_of({corner(-1, -1), corner(1, -1), corner(-1, 1)});
        scene.mesh.add_triangle_of({corner(1, -1), corner(1, 1), corner(-1, 1)});
        scene.parts.push_back({"wall", 2 * i, 2});
    }
    static_assert(walls * 1000 * 1000 > many_fragments);
    return scene;
}

inline Session session_of(Scene scene) {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    set_scene(session, std::move(scene));
    session.a.settings.stage = Stage::fill;
    return session;
}

} // namespace rasterwalk
