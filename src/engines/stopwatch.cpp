#include "engines/stopwatch.h"

#include <ctime>

namespace rasterwalk {

namespace {

/// A clock that the system does not have is replaced by elapsed time: in a browser there is no
/// processor time.
double read_clock(clockid_t clock) {
    timespec time{};
    if (clock_gettime(clock, &time) != 0) clock_gettime(CLOCK_MONOTONIC, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

} // namespace

Milliseconds milliseconds_now() {
    return {read_clock(CLOCK_PROCESS_CPUTIME_ID), read_clock(CLOCK_MONOTONIC),
            read_clock(CLOCK_THREAD_CPUTIME_ID)};
}

Milliseconds milliseconds_since(const Milliseconds& begin) {
    const Milliseconds end = milliseconds_now();
    return {end.processor - begin.processor, end.wall - begin.wall, end.thread - begin.thread};
}

} // namespace rasterwalk
