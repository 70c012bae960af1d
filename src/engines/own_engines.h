#pragma once

#include <memory>

#include "engines/fast/fast_engine.h"
#include "engines/timed_engine.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

// The engines of this program. The scene must live as long as the engine.

/// The stages that can be walked through, without an observer: vertices, cleared planes, all
/// triangles. One thread.
std::unique_ptr<TimedEngine> steps_engine(const Scene& scene, const Settings& settings);

/// The loop of the lab as a student writes it. One thread.
std::unique_ptr<TimedEngine> student_engine(const Scene& scene, const Settings& settings);

/// The fast engine. Which triangle a pixel belongs to is not written down: the peer does not,
/// either.
std::unique_ptr<TimedEngine> fast_engine(const Scene& scene, const Settings& settings,
                                         SimdLevel level, int threads);

} // namespace rasterwalk
