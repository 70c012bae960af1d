#include "engines/stopwatch.h"

#include <ctime>

namespace rasterwalk {

namespace {

double read_clock(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

} // namespace

Milliseconds milliseconds_now() {
    return {read_clock(CLOCK_PROCESS_CPUTIME_ID), read_clock(CLOCK_MONOTONIC)};
}

Milliseconds milliseconds_since(const Milliseconds& begin) {
    const Milliseconds end = milliseconds_now();
    return {end.processor - begin.processor, end.wall - begin.wall};
}

} // namespace rasterwalk
