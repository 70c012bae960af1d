#pragma once

#include <cstddef>
#include <functional>

namespace rasterwalk {

/// Does a piece of work for each index below `count`: two at a time, by a second thread, where the
/// machine has more than one processor. Throws what the work throws.
void do_two_at_a_time(std::size_t count, const std::function<void(std::size_t)>& work);

/// Is asked by two threads as `is_stopped` is, which is asked by one at a time; null if it is null.
std::function<bool()> asked_one_at_a_time(const std::function<bool()>& is_stopped);

} // namespace rasterwalk
