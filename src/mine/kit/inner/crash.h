#pragma once

// Writes down how the program dies. Part of runtime.cpp.

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include <execinfo.h>
#include <link.h>
#include <ucontext.h>

#include "../recording.h"

namespace rasterwalk_kit {
namespace crash {

inline constexpr int signals[] = {SIGSEGV, SIGBUS,  SIGFPE, SIGILL,
                                  SIGABRT, SIGXCPU, SIGSYS, SIGTERM};
inline constexpr std::size_t signal_count = sizeof(signals) / sizeof(signals[0]);
inline constexpr int refused_by_filter = 1; ///< si_code of a trap of seccomp
inline constexpr int most_unwound = 96;

/// All that a handler may touch.
struct Watch {
    Progress* progress = nullptr;
    std::uintptr_t base = 0, end = 0; ///< where the program's file is in memory
    struct sigaction before[signal_count] = {};
    void (*save_picture)() = nullptr; ///< takes what a death would lose
};
inline Watch watch;

/// Where in the code the signal came; 0: not known on this machine.
inline std::uintptr_t place_of(void* context) {
    const auto* where = static_cast<const ucontext_t*>(context);
#if defined(__x86_64__)
    return static_cast<std::uintptr_t>(where->uc_mcontext.gregs[REG_RIP]);
#elif defined(__aarch64__)
    return static_cast<std::uintptr_t>(where->uc_mcontext.pc);
#else
    (void)where;
    return 0;
#endif
}

/// Where the function returns to that was called last, if it has not done anything yet; 0: not
/// known on this machine.
inline std::uintptr_t caller_of(void* context) {
    const auto* where = static_cast<const ucontext_t*>(context);
#if defined(__x86_64__)
    return *reinterpret_cast<const std::uintptr_t*>(where->uc_mcontext.gregs[REG_RSP]);
#elif defined(__aarch64__)
    return static_cast<std::uintptr_t>(where->uc_mcontext.regs[30]);
#else
    (void)where;
    return 0;
#endif
}

inline bool is_in_program(std::uintptr_t place) {
    return place >= watch.base && place < watch.end;
}

/// Adds the place of a call, if the program made it. A call returns to the instruction after it,
/// which may belong to another line.
inline void add_call(std::uintptr_t returns_to, std::uint64_t* places, std::uint32_t& count) {
    if (is_in_program(returns_to - 1)) places[count++] = returns_to - 1 - watch.base;
}

/// The places in the program's file that led to where the signal came, the innermost first; how
/// many. Places in libraries are left out.
inline std::uint32_t unwind(void* context, std::uint64_t* places, std::uint32_t most) {
    const std::uintptr_t from = place_of(context);
    void* frames[most_unwound] = {};
    const int depth = backtrace(frames, most_unwound);
    // The first frames are those of the handler.
    int next = 0;
    while (next < depth && reinterpret_cast<std::uintptr_t>(frames[next]) != from)
        ++next;
    std::uint32_t count = 0;
    if (is_in_program(from)) places[count++] = from - watch.base;
    // Where there is no code, as after a call of a null pointer, unwinding has no beginning.
    if (next + 1 >= depth && count == 0) add_call(caller_of(context), places, count);
    for (++next; next < depth && count < most; ++next) {
        add_call(reinterpret_cast<std::uintptr_t>(frames[next]), places, count);
    }
    return count;
}

#if defined(__x86_64__) || defined(__aarch64__)
/// A call that the guard refused: it is written down, and fails as any call may fail.
inline void refuse(const siginfo_t* info, ucontext_t* context) {
    std::uint64_t place = 0;
    unwind(context, &place, 1);
    const auto call = static_cast<std::uint32_t>(info->si_syscall);
    for (Refused& entry : watch.progress->refused) {
        const bool is_free = entry.count == 0;
        if (!is_free && (entry.call != call || entry.place != place)) continue;
        entry.call = call;
        entry.place = place;
        ++entry.count;
        break;
    }
#if defined(__x86_64__)
    context->uc_mcontext.gregs[REG_RAX] = -EPERM;
#else
    context->uc_mcontext.regs[0] = static_cast<std::uint64_t>(-EPERM);
#endif
}
#endif

inline void handle(int signal, siginfo_t* info, void* context) {
    const int kept_errno = errno;
#if defined(__x86_64__) || defined(__aarch64__)
    if (signal == SIGSYS && info->si_code == refused_by_filter) {
        refuse(info, static_cast<ucontext_t*>(context));
        errno = kept_errno;
        return;
    }
#endif
    // What was there before comes back first, so that a fault in here ends the program.
    for (std::size_t i = 0; i < signal_count; ++i) {
        if (signals[i] == signal) sigaction(signal, &watch.before[i], nullptr);
    }
    const bool is_fault =
        signal == SIGSEGV || signal == SIGBUS || signal == SIGFPE || signal == SIGILL;
    Progress& progress = *watch.progress;
    progress.signal = signal;
    progress.signal_code = info->si_code;
    progress.address = is_fault ? reinterpret_cast<std::uintptr_t>(info->si_addr) : 0;
    progress.depth = unwind(context, progress.stack, most_frames_deep);
    if (watch.save_picture != nullptr) watch.save_picture();
    errno = kept_errno;
    // A faulting instruction is repeated and faults again; other signals must be sent again.
    if (!is_fault || info->si_code <= 0) raise(signal);
}

inline int find_program(dl_phdr_info* info, std::size_t, void*) {
    watch.base = info->dlpi_addr;
    for (int i = 0; i < info->dlpi_phnum; ++i) {
        const auto& part = info->dlpi_phdr[i];
        const std::uintptr_t end = info->dlpi_addr + part.p_vaddr + part.p_memsz;
        if (part.p_type == PT_LOAD && end > watch.end) watch.end = end;
    }
    return 1; // the program comes first, its libraries are not needed
}

/// From now on a death is written down.
inline void begin(Progress& progress, void (*save_picture)()) {
    watch.progress = &progress;
    watch.save_picture = save_picture;
    dl_iterate_phdr(find_program, nullptr);
    // The first call loads a library, which a handler must not do.
    void* first[1];
    backtrace(first, 1);

    // When the stack is full the handler needs another one. Sanitizers have one already.
    constexpr std::size_t stack_size = 1 << 17;
    alignas(16) static unsigned char stack[stack_size];
    stack_t present = {};
    sigaltstack(nullptr, &present);
    if ((present.ss_flags & SS_DISABLE) != 0 || present.ss_size < stack_size / 4) {
        stack_t own = {};
        own.ss_sp = stack;
        own.ss_size = stack_size;
        sigaltstack(&own, nullptr);
    }
    struct sigaction action = {};
    action.sa_sigaction = handle;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    for (const int signal : signals)
        sigaddset(&action.sa_mask, signal);
    for (std::size_t i = 0; i < signal_count; ++i) {
        sigaction(signals[i], &action, &watch.before[i]);
    }
}

} // namespace crash
} // namespace rasterwalk_kit
