#pragma once

#include <memory>
#include <string>
#include <vector>

#include "session/scene_reading.h"

namespace rasterwalk {

/// A large scene file that is read beside the window.
struct BesideReading {
    std::unique_ptr<SceneReading> now;  ///< null: nothing is read
    std::shared_ptr<const Scene> shown; ///< when it began
    std::string lesson;                 ///< that was open then
    /// What was stopped, until its thread has taken note of it: the window waits for nobody.
    std::vector<std::unique_ptr<SceneReading>> stopped;
};

} // namespace rasterwalk
