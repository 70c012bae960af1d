#pragma once

namespace rasterwalk {

struct Scene;

/// Prints how long it takes to go to a moment of the scene's frame: at random, step by step, by
/// scrubbing; and the memory that replay's copies take.
void print_replay_times(const Scene& scene);

} // namespace rasterwalk
