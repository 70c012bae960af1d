// Sends itself the signal of a call that the guard refuses. Under the kit's handler the call that
// sends it fails with EPERM, is written down, and the program goes on. Exit codes: 0 so it is, 1
// not; without the handler the signal ends the program.

#include <csignal>
#include <cstdio>
#include <cstring>

#include <sys/syscall.h>
#include <unistd.h>

#include "mine/kit/inner/crash.h"

int main() {
    using namespace rasterwalk_kit;
    constexpr int call = 41;
    static Progress progress;
    crash::begin(progress, nullptr);
    siginfo_t info;
    std::memset(&info, 0, sizeof info);
    info.si_signo = SIGSYS;
    info.si_code = crash::refused_by_filter;
    info.si_syscall = call;
    const long result = ::syscall(SYS_rt_sigqueueinfo, ::getpid(), SIGSYS, &info);
    const bool is_refused = result == -1 && errno == EPERM;
    const bool is_noted = progress.refused[0].count == 1 && progress.refused[0].call == call;
    if (is_refused && is_noted) return 0;
    std::printf("refused: %d, written down: %d\n", is_refused, is_noted);
    return 1;
}
