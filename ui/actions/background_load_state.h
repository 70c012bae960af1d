#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "session/file_reading.h"

namespace rasterwalk {

/// A file that is read in the background.
struct BackgroundLoad {
    /// How long a frame may wait for a file; what takes longer is read while the window goes on. 0:
    /// no frame waits.
    std::chrono::milliseconds patience{100};
    std::unique_ptr<FileReading> now;   ///< null: nothing is read
    std::shared_ptr<const Scene> shown; ///< when the reading began
    std::string lesson;                 ///< open at that time
    /// What was stopped, until its thread has noticed: the window does not wait.
    std::vector<std::unique_ptr<FileReading>> stopped;
};

} // namespace rasterwalk
