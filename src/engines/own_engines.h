#pragma once

#include <memory>

#include "engines/fast/fast_engine.h"
#include "engines/timed_engine.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

// The engines of this program. The scene must outlive the engine.

/// The stages that users walk through, without an observer: vertices, cleared planes, all
/// triangles. One thread.
std::unique_ptr<TimedEngine> steps_engine(const Scene& scene, const Settings& settings);

/// The loop of the lab as a student writes it. One thread.
std::unique_ptr<TimedEngine> student_engine(const Scene& scene, const Settings& settings);

/// The fast engine. It does not record which triangle a pixel belongs to; the peer does not either.
std::unique_ptr<TimedEngine> fast_engine(const Scene& scene, const Settings& settings,
                                         SimdLevel level, int threads);

} // namespace rasterwalk
