#include "engines/pinned_threads.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#ifdef __linux__
#include <sched.h>
#endif

#include "base/numbers.h"

namespace rasterwalk {

#ifdef __linux__

namespace {

namespace fs = std::filesystem;

/// The threads of this process whose names begin with `name`, the oldest first.
std::vector<int> threads_named(std::string_view name) {
    std::vector<int> threads;
    std::error_code fault;
    for (fs::directory_iterator entry("/proc/self/task", fault), end; !fault && entry != end;
         entry.increment(fault)) {
        std::string own_name;
        std::getline(std::ifstream(entry->path() / "comm"), own_name);
        const auto thread = parse_int(entry->path().filename().string());
        if (thread && own_name.starts_with(name)) threads.push_back(*thread);
    }
    std::sort(threads.begin(), threads.end());
    return threads;
}

/// A thread that has ended meanwhile needs no processor: errors do not matter.
void hold(int thread, const std::vector<int>& processors) {
    cpu_set_t set;
    CPU_ZERO(&set);
    for (const int processor : processors)
        CPU_SET(static_cast<std::size_t>(processor), &set);
    sched_setaffinity(thread, sizeof set, &set);
}

} // namespace

PinnedThreads::PinnedThreads() {
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) != 0) return;
    for (int processor = 0; processor < CPU_SETSIZE; ++processor) {
        if (CPU_ISSET(static_cast<std::size_t>(processor), &set)) processors_.push_back(processor);
    }
}

PinnedThreads::~PinnedThreads() {
    if (processors_.empty()) return;
    for (const int thread : threads_named(""))
        hold(thread, processors_);
}

void PinnedThreads::pin(std::string_view name) {
    if (processors_.empty()) return;
    std::size_t next = 0;
    for (const int thread : threads_named(name))
        hold(thread, {processors_[next++ % processors_.size()]});
}

#else

PinnedThreads::PinnedThreads() = default;
PinnedThreads::~PinnedThreads() = default;
void PinnedThreads::pin(std::string_view) {}

#endif

} // namespace rasterwalk
