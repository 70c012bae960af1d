#pragma once

#include <string>
#include <vector>

namespace rasterwalk {

/// The camera benchmark's command line.
struct CameraBenchmark {
    int steps = 7;                  ///< measured steps of each figure; the smallest counts
    std::vector<std::string> names; ///< of the figures to take; empty: all
    std::string against;            ///< file with the figures of another version; empty: none
};

/// Prints what a step of the camera and a frame of the window cost, a line for each figure:
/// `made-step 401.2 ms`. The cost is the time of the processor, so that other programs hardly
/// count. With `against` each line ends with the ratio to the figure in that file.
/// Throws UsageError for a name that is no figure, and AccessError if the file cannot be read.
void print_camera_times(const CameraBenchmark& options);

} // namespace rasterwalk
