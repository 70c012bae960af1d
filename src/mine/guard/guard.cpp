#include "mine/guard/guard.h"

#include "base/error.h"
#include "mine/guard/guard_system.h"

#ifndef RASTERWALK_HAS_GUARD

namespace rasterwalk {

GuardedRun run_guarded(const GuardedCommand&) {
    throw AccessError("this system cannot run a program under guard.");
}

} // namespace rasterwalk

#else

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/quoted.h"
#include "mine/guard/guard_landlock.h"
#include "mine/guard/guard_supervised.h"
#include "mine/guard/guard_watch.h"

namespace rasterwalk {

namespace {

using namespace std::chrono_literals;
using GuardClock = std::chrono::steady_clock;

/// How often the program is looked at.
constexpr auto look_interval = 20ms;

/// Watches a program until it ends.
class GuardWatch {
  public:
    GuardWatch(const GuardedCommand& command, Supervised& supervised, GuardedRun& run)
        : command_(command), supervised_(supervised), run_(run) {}

    void watch() {
        const GuardClock::time_point begin = GuardClock::now();
        GuardClock::time_point next_look = begin;
        std::optional<GuardReport> report;
        while (true) {
            std::array<pollfd, 2> wanted{
                pollfd{supervised_.reports(), POLLIN, 0},
                pollfd{is_output_open_ ? supervised_.output() : -1, POLLIN, 0}};
            const auto wait = std::chrono::ceil<std::chrono::milliseconds>(
                std::max(next_look - GuardClock::now(), GuardClock::duration::zero()));
            const int ready = ::poll(wanted.data(), wanted.size(), static_cast<int>(wait.count()));
            if (ready > 0 && wanted[1].revents != 0) read_output();
            if (ready > 0 && wanted[0].revents != 0) {
                report = read_message<GuardReport>(supervised_.reports());
                break;
            }
            if (GuardClock::now() < next_look) continue;
            next_look = GuardClock::now() + look_interval;
            look(GuardClock::now() - begin);
        }
        run_.time =
            std::chrono::duration_cast<std::chrono::milliseconds>(GuardClock::now() - begin);
        while (is_output_open_ && read_output()) {
        }
        finish(report);
    }

  private:
    /// Reads what has arrived, but not for ever.
    /// @return false: there is nothing more now
    bool read_output() {
        constexpr int most_reads = 32;
        for (int i = 0; i < most_reads; ++i) {
            const ssize_t count = ::read(supervised_.output(), block_.data(), block_.size());
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) {
                is_output_open_ = count < 0 && errno == EAGAIN;
                return false;
            }
            const auto size = static_cast<std::size_t>(count);
            const std::size_t kept = std::min(size, command_.limits.output - run_.output.size());
            run_.output.append(block_.data(), kept);
            if (kept < size) run_.is_output_cut = true;
            written_ += size;
        }
        return true;
    }

    void look(GuardClock::duration time) {
        const GuardLimits& limits = command_.limits;
        if (kill_reason_) return;
        if (command_.is_stopped && command_.is_stopped()) return kill(GuardedEnd::stopped);
        if (written_ > most_output) return kill(GuardedEnd::too_much_output);
        if (time >= limits.time + last_words) return kill(GuardedEnd::out_of_time);
        if (time >= limits.time && !is_warned_) {
            is_warned_ = true;
            supervised_.send(guard_warn);
        }
        const pid_t process = supervised_.process();
        const ProcessUse use = limits.may_start_programs ? use_of_group(process, limits.threads + 1)
                                                         : use_of_process(process);
        if (use.threads > limits.threads) return kill(GuardedEnd::too_many_threads);
        if (limits.resident > 0 && use.memory > limits.resident)
            return kill(GuardedEnd::out_of_memory);
    }

    void kill(GuardedEnd reason) {
        kill_reason_ = reason;
        supervised_.send(guard_kill);
    }

    /// Fills in how it ended.
    void finish(const std::optional<GuardReport>& report) {
        if (!report) {
            // Someone has killed the supervisor, with which the program dies.
            ::kill(-supervised_.process(), SIGKILL);
            run_.signal = SIGKILL;
        } else if (WIFSIGNALED(report->status)) {
            run_.signal = WTERMSIG(report->status);
        } else {
            run_.exit_code = WEXITSTATUS(report->status);
        }
        if (run_.signal == SIGKILL && kill_reason_) {
            run_.end = *kill_reason_;
        } else if (is_warned_ || has_used_processor(report)) {
            run_.end = GuardedEnd::out_of_time;
        } else if (run_.signal == SIGABRT && command_.limits.memory > 0 &&
                   run_.output.find("std::bad_alloc") != std::string::npos) {
            run_.end = GuardedEnd::out_of_memory; // it was given no more, and did not catch that
        } else if (run_.signal != 0) {
            run_.end = GuardedEnd::signalled;
        }
    }

    /// Did the system end it because it has used its time of the processor?
    bool has_used_processor(const std::optional<GuardReport>& report) const {
        if (run_.signal != SIGXCPU && run_.signal != SIGKILL) return false;
        const std::chrono::seconds limit(processor_seconds(command_.limits));
        // The system may have counted more than it reports: on a busy machine its ticks are rough.
        return report && std::chrono::microseconds(report->processor_time) >= limit * 3 / 4;
    }

    const GuardedCommand& command_;
    Supervised& supervised_;
    GuardedRun& run_;
    std::array<char, 1 << 16> block_{};
    std::size_t written_ = 0;
    bool is_output_open_ = true;
    bool is_warned_ = false;
    std::optional<GuardedEnd> kill_reason_;
};

} // namespace

GuardedRun run_guarded(const GuardedCommand& command) {
    if (command.words.empty() || command.words.front().empty() ||
        command.words.front().front() != '/')
        throw AccessError("a program to run needs an absolute path.");
    const std::string& program = command.words.front();
    const int version = command.limits.use_landlock ? landlock_version() : 0;
    if (::access(program.c_str(), X_OK) != 0)
        throw AccessError(
            fmt::format("cannot start {}: {}.", in_quotes(program), std::strerror(errno)));
    // A descriptor that cannot be sealed stays as it is.
    if (command.descriptor >= 0)
        ::fcntl(command.descriptor, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL);
    GuardedRun run;
    run.has_landlock = version > 0;
    Supervised supervised(command, version);
    GuardWatch(command, supervised, run).watch();
    return run;
}

} // namespace rasterwalk

#endif
