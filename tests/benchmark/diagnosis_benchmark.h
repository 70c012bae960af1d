#pragma once

#include <string>
#include <vector>

namespace rasterwalk {

/// Prints how much processor time it takes to diagnose the picture of each mistake in the lab's
/// room, 500 x 500 pixels, and whether the mistake is named first: `B3 1.4 s named`; finally the
/// longest of these times.
/// @param names ids of the mistakes; empty: all
void print_diagnosis_times(const std::vector<std::string>& names);

} // namespace rasterwalk
