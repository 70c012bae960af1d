#include "mine/guard/guard_watch.h"

#ifdef RASTERWALK_HAS_GUARD

#include <climits>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>

#include <dirent.h>
#include <sys/stat.h>
#include <unistd.h>

namespace rasterwalk {

namespace {

/// Of all processes together that are wanted, until there are enough threads.
template <class IsWanted>
ProcessUse use_of_processes(int enough, IsWanted is_wanted) {
    ProcessUse sum;
    const auto close = [](DIR* folder) { ::closedir(folder); };
    const std::unique_ptr<DIR, decltype(close)> folder(::opendir("/proc"), close);
    if (folder == nullptr) return sum;
    while (sum.threads < enough) {
        const dirent* const entry = ::readdir(folder.get());
        if (entry == nullptr) break;
        const auto process = static_cast<pid_t>(std::strtol(entry->d_name, nullptr, 10));
        if (process <= 0 || !is_wanted(process)) continue;
        const ProcessUse use = use_of_process(process);
        sum.memory += use.memory;
        sum.threads += use.threads;
    }
    return sum;
}

} // namespace

ProcessUse use_of_process(pid_t process) {
    ProcessUse use;
    std::ifstream file("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(':');
        if (colon == std::string::npos) continue;
        const std::string_view name(line.data(), colon);
        const bool is_memory = name == "VmRSS" || name == "VmSwap";
        if (!is_memory && name != "Threads") continue;
        const long value = std::strtol(line.c_str() + colon + 1, nullptr, 10);
        if (is_memory) {
            use.memory += static_cast<std::size_t>(value) * 1024;
        } else {
            use.threads = static_cast<int>(value);
        }
    }
    return use;
}

ProcessUse use_of_group(pid_t group, int enough) {
    return use_of_processes(enough, [=](pid_t process) { return ::getpgid(process) == group; });
}

ProcessUse use_of_this_user() {
    return use_of_processes(INT_MAX, [](pid_t process) {
        struct stat state {};
        return ::stat(("/proc/" + std::to_string(process)).c_str(), &state) == 0 &&
               state.st_uid == ::getuid();
    });
}

} // namespace rasterwalk

#endif
