#pragma once

#include "session/session.h"
#include "tests/support/project_root.h"

namespace rasterwalk {

/// The room with a lamp that can be seen, at stage pixel_light.
/// @param side of the picture, pixels; small where it is drawn many times
inline Session lit_room(int side = 500) {
    Session session = open_session(project_root() + "/lessons/scenes/lab-room.toml");
    Settings& settings = session.a.settings;
    set_step(settings, StripStep::pixel_light);
    settings.light.power = glm::vec3(14.0f);
    settings.viewport = {side, side};
    settings.camera.focal_length = static_cast<float>(side);
    return session;
}

} // namespace rasterwalk
