#pragma once

// Starts a guarded program with its supervisor, and ends both.

#include "mine/guard/guard_system.h"

#ifdef RASTERWALK_HAS_GUARD

#include <utility>

#include <sys/resource.h>
#include <sys/types.h>
#include <unistd.h>

#include "mine/guard/guard.h"
#include "mine/guard/guard_process.h"

namespace rasterwalk {

/// A descriptor that is closed when it is no longer needed.
class OwnDescriptor {
  public:
    explicit OwnDescriptor(int number = -1) : number_(number) {}
    OwnDescriptor(OwnDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    OwnDescriptor& operator=(OwnDescriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~OwnDescriptor() { close(); }

    int number() const { return number_; }
    void close() {
        if (number_ >= 0) ::close(number_);
        number_ = -1;
    }

  private:
    int number_;
};

/// A program and its supervisor. When it goes out of scope, both have ended.
class Supervised {
  public:
    /// Starts them. Throws AccessError.
    /// @param landlock_version 0: files are not guarded
    Supervised(const GuardedCommand& command, int landlock_version);
    Supervised(const Supervised&) = delete;
    Supervised& operator=(const Supervised&) = delete;
    ~Supervised();

    pid_t process() const { return process_; }        ///< of the program; its group as well
    int output() const { return output_.number(); }   ///< of the program; does not block
    int reports() const { return reports_.number(); } ///< of the supervisor: GuardReport

    /// Sends the supervisor a command. If it has just ended, nothing happens.
    void send(GuardCommand command);

  private:
    void end();

    pid_t supervisor_ = -1;
    pid_t process_ = -1;
    OwnDescriptor output_, commands_, reports_;
};

/// The time of the processor, in whole seconds, at which the system sends SIGXCPU.
rlim_t processor_seconds(const GuardLimits& limits);

} // namespace rasterwalk

#endif
