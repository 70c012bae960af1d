#include "mine/guard/guard_process.h"

#ifdef RASTERWALK_HAS_GUARD

#include <cerrno>
#include <csignal>
#include <cstddef>

#include <fcntl.h>
#include <linux/capability.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "mine/guard/guard_landlock.h"

namespace rasterwalk {

namespace {

/// Where the supervisor puts its descriptors. The program gets the first four of them.
enum Place : int {
    place_input,
    place_output,
    place_error,
    place_given,
    place_rules,
    place_commands,
    place_reports,
    place_faults,
    place_count,
};

constexpr unsigned call_close_range = 436;

/// Writes all of a small message, which a pipe takes at once.
template <class Message>
void send_message(int descriptor, const Message& message) noexcept {
    while (::write(descriptor, &message, sizeof message) < 0 && errno == EINTR) {
    }
}

[[noreturn]] void fail(StartStep step) noexcept {
    send_message(place_faults, StartFault{step, errno});
    ::_exit(127);
}

void close_from(int first) noexcept {
    if (::syscall(call_close_range, first, ~0U, 0) == 0) return;
    rlimit files{};
    constexpr rlim_t most = 1U << 20U;
    const rlim_t end =
        ::getrlimit(RLIMIT_NOFILE, &files) == 0 && files.rlim_max < most ? files.rlim_max : most;
    for (int descriptor = first; static_cast<rlim_t>(descriptor) < end; ++descriptor)
        ::close(descriptor);
}

/// Moves the descriptors to their places and closes all others, of every part of this program.
void place_descriptors(const GuardedStart& start) noexcept {
    std::array<int, place_count> sources{start.null,  start.output,   start.output,  start.given,
                                         start.rules, start.commands, start.reports, start.faults};
    // Out of the way first: one may lie where another belongs.
    for (int& source : sources)
        if (source >= 0) source = ::fcntl(source, F_DUPFD_CLOEXEC, place_count);
    for (int place = 0; place < place_count; ++place) {
        const int source = sources[static_cast<std::size_t>(place)];
        if (source < 0) {
            ::close(place);
        } else if (place <= place_given) {
            ::dup2(source, place);
        } else {
            ::dup3(source, place, O_CLOEXEC);
        }
    }
    close_from(place_count);
}

/// Signals do what they do in a new program.
void reset_signals() noexcept {
    for (int signal = 1; signal < NSIG; ++signal)
        ::signal(signal, SIG_DFL);
}

/// If the system runs out of memory, the program is killed first.
void go_first() noexcept {
    const int file = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
    if (file < 0) return;
    [[maybe_unused]] const ssize_t count = ::write(file, "1000", 4);
    ::close(file);
}

/// Root without its powers is an ordinary user, to whom root's files belong.
void drop_capabilities() noexcept {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    const std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> none{};
    ::syscall(SYS_capset, &header, none.data());
}

/// Becomes the program.
[[noreturn]] void start_program(const GuardedStart& start, pid_t supervisor) noexcept {
    // A group of its own, and a session: the system shares its time among sessions, so that the
    // supervisor has some left, however many processes the program starts.
    ::setsid();
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != supervisor) ::_exit(127);
    reset_signals();
    ::umask(077);
    go_first();
    if (::chdir(start.folder) != 0) fail(StartStep::folder);
    for (const ResourceLimit& limit : start.limits)
        if (::setrlimit(static_cast<__rlimit_resource_t>(limit.resource), &limit.limit) != 0)
            fail(StartStep::limits);
    drop_capabilities();
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) fail(StartStep::filter);
    if (start.rules >= 0) {
        errno = follow_file_rules(place_rules);
        if (errno != 0) fail(StartStep::file_rules);
    }
    errno = install_filter(*start.filter);
    if (errno != 0) fail(StartStep::filter);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    ::execve(start.path, start.words, start.environment);
    fail(StartStep::program);
}

/// Has it ended? It stays a zombie, so that its number and its group's are not given to others.
bool has_ended(pid_t process) noexcept {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == process;
}

/// Kills the program and its group at once: a process that is being killed cannot start another,
/// and none can leave the group. The program's number must not be free yet.
void kill_all(pid_t program) noexcept {
    ::kill(-program, SIGKILL);
    ::kill(program, SIGKILL); // it may not have made its group yet
}

/// Obeys commands until the program has ended.
void wait_for_end(pid_t program, int signals) noexcept {
    std::array<pollfd, 2> wanted{pollfd{signals, POLLIN, 0}, pollfd{place_commands, POLLIN, 0}};
    while (!has_ended(program)) {
        if (::poll(wanted.data(), wanted.size(), -1) < 0) continue;
        if (wanted[0].revents != 0) {
            signalfd_siginfo ignored{};
            [[maybe_unused]] const ssize_t count = ::read(signals, &ignored, sizeof ignored);
        }
        if (wanted[1].revents == 0) continue;
        char command = guard_kill;
        if (::read(place_commands, &command, 1) < 0 && errno == EINTR) continue;
        if (command == guard_warn) {
            ::kill(program, SIGXCPU);
            ::kill(program, SIGCONT); // in case it has stopped itself
        } else {
            kill_all(program);
            wanted[1].fd = -1;
        }
    }
}

} // namespace

void supervise(const GuardedStart& start) noexcept {
    // Without a terminal: Ctrl+C is not for the supervisor, and no terminal takes what the program
    // types.
    ::setsid();
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    ::signal(SIGCHLD, SIG_DFL); // ignored, it would let children vanish without a report
    place_descriptors(start);
    sigset_t ended;
    ::sigemptyset(&ended);
    ::sigaddset(&ended, SIGCHLD);
    const int made = ::signalfd(-1, &ended, SFD_CLOEXEC | SFD_NONBLOCK);
    // Its number may be a place at which nothing was put, and which is closed below.
    const int signals = ::fcntl(made, F_DUPFD_CLOEXEC, place_count);
    ::close(made);
    const pid_t self = ::getpid();
    const pid_t program = signals < 0 ? -1 : ::fork();
    if (program < 0) fail(StartStep::fork);
    if (program == 0) start_program(start, self);
    for (const int place :
         {place_input, place_output, place_error, place_given, place_rules, place_faults})
        ::close(place);
    GuardReport report;
    report.process = program;
    send_message(place_reports, report);
    wait_for_end(program, signals);
    kill_all(program);
    while (true) {
        int status = 0;
        rusage use{};
        const pid_t ended_process = ::wait4(-1, &status, 0, &use);
        if (ended_process < 0 && errno != EINTR) break;
        if (ended_process != program) continue;
        report.status = status;
        report.processor_time =
            (use.ru_utime.tv_sec + use.ru_stime.tv_sec) * std::int64_t{1000000} +
            use.ru_utime.tv_usec + use.ru_stime.tv_usec;
    }
    report.has_ended = 1;
    send_message(place_reports, report);
    ::_exit(0);
}

} // namespace rasterwalk

#endif
