#pragma once

#include "pipeline/frame.h"
#include "support/random.h"
#include "support/samples.h"

namespace rasterwalk::test {

/// The room seen by a camera somewhere in it that looks somewhere.
inline Frame room_frame(const Scene& room, Random& random, Clip clip) {
    Settings settings = default_settings(room);
    settings.clip = clip;
    settings.camera.position = {random.number(-0.9f, 0.9f), random.number(-0.9f, 0.9f),
                                random.number(-2.0f, 0.9f)};
    settings.camera.yaw = random.number(-3.0f, 3.0f);
    settings.camera.pitch = random.number(-0.8f, 0.8f);
    return prepare_frame(room, settings);
}

/// The room from the inside: the camera at z = -0.5, which cuts walls at the near plane.
inline Settings near_clipped_room(const Scene& room) {
    Settings settings = default_settings(room);
    settings.clip = Clip::near;
    settings.camera.position.z = -0.5f;
    return settings;
}

} // namespace rasterwalk::test
