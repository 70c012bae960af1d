#pragma once

// The race of two threads for one depth buffer: see two_threads_one_buffer.cpp.

#include <cstdint>
#include <functional>
#include <vector>

#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Sheets one behind the other that fill the picture, the nearest drawn last: whatever the two
/// threads draw at the same time lies in the same pixels.
Scene race_scene();

/// Light at each pixel, in the size of the scene.
Settings race_settings(const Scene& scene);

/// Draws the scene several times with two threads that share one depth buffer, and counts the
/// pixels of each picture that differ from what one thread draws by itself. None where a program
/// has no threads (ladder_threads()), as nothing races there. ladder_refuses() must not name the
/// scene.
/// @param is_stopped asked before each run; null: never
/// @return one count for each run that took place
std::vector<std::int64_t> race_pictures(const Scene& scene, const Settings& settings, int runs,
                                        const std::function<bool()>& is_stopped = {});

} // namespace rasterwalk
