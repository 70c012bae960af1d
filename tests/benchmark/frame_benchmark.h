#pragma once

#include <string>
#include <vector>

namespace rasterwalk {

/// Prints how long the frames of the interface take while the camera turns, one turn a frame, and
/// until everything has come to rest: update, building of the interface and textures, without GL.
/// For each case what the update takes of a turn, the median and the longest frame of the turn, the
/// longest after it, and how long it takes from the last turn until the picture is complete again,
/// and until everything is. Each is printed in milliseconds of the clock and, after a slash, of the
/// processor, which is what counts on a machine with other work.
/// @param names of the cases, as `made-comparing`; empty: all
/// Throws UsageError for a name that is no case.
void print_frame_times(const std::vector<std::string>& names);

} // namespace rasterwalk
