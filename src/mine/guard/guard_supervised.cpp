#include "mine/guard/guard_supervised.h"

#ifdef RASTERWALK_HAS_GUARD

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/random.h>
#include <sys/wait.h>

#include "base/error.h"
#include "base/quoted.h"
#include "mine/guard/guard_filter.h"
#include "mine/guard/guard_landlock.h"
#include "mine/guard/guard_watch.h"

namespace rasterwalk {

namespace {

struct PipeEnds {
    OwnDescriptor read, write;
};

[[noreturn]] void throw_not_started(const std::string& program, int error) {
    throw AccessError(
        fmt::format("cannot start {}: {}.", in_quotes(program), std::strerror(error)));
}

PipeEnds make_pipe(const std::string& program) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw_not_started(program, errno);
    return {OwnDescriptor(ends[0]), OwnDescriptor(ends[1])};
}

/// The path of a program, somewhere in memory where it cannot be guessed: the filter lets the text
/// at this address alone be executed. There is no use in looking for it either: in one try in 10^13
/// the program would find it, and would still be guarded.
class HiddenPath {
  public:
    explicit HiddenPath(const std::string& path) {
        std::array<std::uint64_t, 2> random{};
        if (::getrandom(random.data(), sizeof random, 0) != sizeof random)
            throw_not_started(path, errno);
        constexpr std::uint64_t addresses = std::uint64_t{1} << 46U, page = 4096;
        size_ = page + path.size() + 1;
        void* const wish = reinterpret_cast<void*>(random[0] % addresses / page * page);
        block_ = ::mmap(wish, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (block_ == MAP_FAILED) throw_not_started(path, errno);
        text_ = static_cast<char*>(block_) + random[1] % page;
        std::memcpy(text_, path.c_str(), path.size() + 1);
    }
    HiddenPath(const HiddenPath&) = delete;
    HiddenPath& operator=(const HiddenPath&) = delete;
    ~HiddenPath() { ::munmap(block_, size_); }

    const char* text() const { return text_; }

  private:
    std::size_t size_ = 0;
    void* block_ = nullptr;
    char* text_ = nullptr;
};

std::vector<char*> pointers_to(const std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    pointers.reserve(texts.size() + 1);
    for (const std::string& text : texts)
        pointers.push_back(const_cast<char*>(text.c_str())); // only read
    pointers.push_back(nullptr);
    return pointers;
}

/// This limit, or the one that this program has itself if that is lower.
ResourceLimit resource_limit(int resource, rlim_t soft, rlim_t hard) {
    rlimit own{};
    ::getrlimit(static_cast<__rlimit_resource_t>(resource), &own);
    return {resource, {std::min(soft, own.rlim_max), std::min(hard, own.rlim_max)}};
}

ResourceLimit resource_limit(int resource, rlim_t most) {
    return resource_limit(resource, most, most);
}

ResourceLimits resource_limits(const GuardLimits& limits) {
    constexpr rlim_t largest_stack = rlim_t{64} << 20U, locked = rlim_t{64} << 10U;
    const rlim_t seconds = processor_seconds(limits);
    rlimit stack{};
    ::getrlimit(RLIMIT_STACK, &stack);
    // The system counts all that the user runs. This one is for a program that starts others faster
    // than they can be counted, with room for what the user starts meanwhile.
    constexpr int spare = 64;
    const rlim_t processes =
        limits.may_start_programs
            ? static_cast<rlim_t>(use_of_this_user().threads + limits.threads + spare)
            : RLIM_INFINITY;
    return {
        resource_limit(RLIMIT_CPU, seconds, seconds + 1),
        resource_limit(RLIMIT_AS, limits.memory > 0 ? limits.memory : RLIM_INFINITY),
        resource_limit(RLIMIT_FSIZE, limits.file_size),
        resource_limit(RLIMIT_NOFILE, static_cast<rlim_t>(limits.open_files)),
        resource_limit(RLIMIT_CORE, 0),
        resource_limit(RLIMIT_STACK, std::min(stack.rlim_cur, largest_stack), largest_stack),
        resource_limit(RLIMIT_MEMLOCK, locked),
        resource_limit(RLIMIT_NPROC, processes),
    };
}

/// No signal reaches this thread while it lives: a fork of it must not run this program's handlers.
class BlockedSignals {
  public:
    BlockedSignals() {
        sigset_t all;
        sigfillset(&all);
        ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    BlockedSignals(const BlockedSignals&) = delete;
    BlockedSignals& operator=(const BlockedSignals&) = delete;
    ~BlockedSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  private:
    sigset_t before_{};
};

/// Why it could not be started, for people.
std::string start_fault_text(const StartFault& fault, const GuardedCommand& command) {
    const char* const cause = std::strerror(fault.error);
    const std::string program = in_quotes(command.words.front());
    switch (fault.step) {
    case StartStep::fork:
    case StartStep::program:
        break;
    case StartStep::folder:
        return fmt::format("cannot start {} in {}: {}.", program, in_quotes(command.folder), cause);
    case StartStep::limits:
        return fmt::format("cannot set limits for {}: {}.", program, cause);
    case StartStep::file_rules:
        return fmt::format("this system cannot guard files: {}.", cause);
    case StartStep::filter:
        return fmt::format("this system cannot run a program under guard: {}.", cause);
    }
    return fmt::format("cannot start {}: {}.", program, cause);
}

} // namespace

/// The time of the processor, in whole seconds, at which the system sends SIGXCPU.
rlim_t processor_seconds(const GuardLimits& limits) {
    const auto seconds = std::chrono::ceil<std::chrono::seconds>(limits.time).count();
    return static_cast<rlim_t>(std::max<std::int64_t>(seconds, 1));
}

Supervised::Supervised(const GuardedCommand& command, int landlock_version) {
    const std::string& program = command.words.front();
    const OwnDescriptor rules(landlock_version > 0 ? make_file_rules(command, landlock_version)
                                                   : -1);
    const HiddenPath path(program);
    SystemCallFilter filter =
        make_filter({command.limits.may_start_programs, landlock_version, path.text()});
    const std::vector<char*> words = pointers_to(command.words);
    const std::vector<char*> environment = pointers_to(command.environment);
    const OwnDescriptor null(::open("/dev/null", O_RDONLY | O_CLOEXEC));
    if (null.number() < 0) throw_not_started(program, errno);
    PipeEnds output = make_pipe(program), commands = make_pipe(program),
             reports = make_pipe(program), faults = make_pipe(program);
    ::fcntl(output.read.number(), F_SETFL, O_NONBLOCK);
    GuardedStart start;
    start.path = path.text();
    start.words = words.data();
    start.environment = environment.data();
    start.folder = command.folder.c_str();
    start.limits = resource_limits(command.limits);
    start.filter = &filter;
    start.null = null.number();
    start.output = output.write.number();
    start.given = command.descriptor;
    start.rules = rules.number();
    start.commands = commands.read.number();
    start.reports = reports.write.number();
    start.faults = faults.write.number();
    {
        const BlockedSignals blocked;
        supervisor_ = ::fork();
        if (supervisor_ == 0) supervise(start);
    }
    if (supervisor_ < 0) throw_not_started(program, errno);
    output_ = std::move(output.read);
    commands_ = std::move(commands.write);
    reports_ = std::move(reports.read);
    output.write.close();
    commands.read.close();
    reports.write.close();
    faults.write.close();
    const std::optional<StartFault> fault = read_message<StartFault>(faults.read.number());
    const std::optional<GuardReport> report =
        fault ? std::nullopt : read_message<GuardReport>(reports_.number());
    if (report) {
        process_ = report->process;
        return;
    }
    end();
    throw AccessError(
        start_fault_text(fault.value_or(StartFault{StartStep::fork, ECHILD}), command));
}

Supervised::~Supervised() {
    end();
}

void Supervised::send(GuardCommand command) {
    // If the supervisor has ended, the pipe is broken, and SIGPIPE would end this program.
    const BlockedSignals blocked;
    if (::write(commands_.number(), &command, 1) >= 0 || errno != EPIPE) return;
    sigset_t broken;
    sigemptyset(&broken);
    sigaddset(&broken, SIGPIPE);
    const timespec at_once{};
    ::sigtimedwait(&broken, nullptr, &at_once);
}

void Supervised::end() {
    commands_.close();
    while (::waitpid(supervisor_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

} // namespace rasterwalk

#endif
