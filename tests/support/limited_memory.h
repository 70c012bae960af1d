#pragma once

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <string>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/catch.h"

namespace rasterwalk::test {

inline constexpr std::size_t megabyte = std::size_t{1} << 20;

/// The result of an action run in its own process, which may take only this much more
/// memory, bytes. With the address sanitizer there is no limit.
template <class Action>
std::string output_within([[maybe_unused]] std::size_t memory, Action action) {
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    const pid_t child = ::fork();
    if (child == 0) {
#if !defined(__SANITIZE_ADDRESS__)
        long pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const rlim_t most = static_cast<rlim_t>(pages) * 4096 + memory;
        const rlimit limit{most, most};
        ::setrlimit(RLIMIT_AS, &limit);
#endif
        const std::string said = action();
        if (::write(ends[1], said.data(), said.size()) < 0) ::_exit(1);
        ::_exit(0);
    }
    ::close(ends[1]);
    std::string said;
    char block[4096];
    for (ssize_t count = 0; (count = ::read(ends[0], block, sizeof block)) > 0;)
        said.append(block, static_cast<std::size_t>(count));
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    REQUIRE(status == 0);
    return said;
}

} // namespace rasterwalk::test
