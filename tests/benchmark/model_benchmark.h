#pragma once

#include <string>
#include <vector>

namespace rasterwalk {

/// The model benchmark's command line.
struct ModelBenchmark {
    std::vector<std::string> names; ///< of the models to take; empty: all
    std::string against;            ///< file with the figures of another version; empty: none
};

/// Prints what the room and models of 200,000 and of 1,000,000 triangles cost, a line for each
/// figure: `200000-seek 31.2 ms`. `open` is all of the reading; the others are the longest frame of
/// the window until it comes to rest: after the scene is opened, after a step, a seek, a pick, and
/// while the camera keeps turning. The cost is the time of the processor.
/// Throws UsageError for a name that is not a model, and AccessError if the file cannot be read.
void print_model_times(const ModelBenchmark& options);

} // namespace rasterwalk
