#pragma once

// The progress of reading a large file, and how to stop it.

#include <cstdint>
#include <exception>
#include <functional>

namespace rasterwalk {

/// The phases of reading a model, in order.
enum class ReadingPart : std::uint8_t {
    bytes,     ///< of its file are read
    triangles, ///< are made from its faces
};

/// How far the reading has got.
struct ReadingState {
    ReadingPart part = ReadingPart::bytes;
    std::int64_t done = 0;
    std::int64_t all = 0; ///< bytes of the file, or triangles of all faces; 0: not known yet

    friend bool operator==(const ReadingState&, const ReadingState&) = default;
};

/// Called now and then with the progress, at most about a thousand times a second. False: stop. May
/// be empty.
using ReadingWatch = std::function<bool(const ReadingState&)>;

/// Thrown when a watch stops the reading. Not a fault of the file, so not an Error.
class ReadingStopped : public std::exception {
  public:
    const char* what() const noexcept override { return "reading was stopped."; }
};

/// Asks a watch only once in a while, so that a step costs next to nothing.
class WatchedSteps {
  public:
    explicit WatchedSteps(const ReadingWatch& watch) : watch_(watch) {}

    /// Counts one more step. Throws ReadingStopped.
    /// @param state makes the ReadingState; called only where the watch is asked
    template <class State>
    void step(State state) {
        if (++steps_ % steps_between == 0) ask(state());
    }

    /// Counts one more step of a file that is read in between: the reported progress stays.
    void step() {
        if (++steps_ % steps_between == 0) ask();
    }

    /// Counts one more step, after which so much of the same phase is done.
    void step_to(std::int64_t done) {
        state_.done = done;
        step();
    }

    /// Asks now. Throws ReadingStopped.
    void ask(const ReadingState& state) {
        state_ = state;
        ask();
    }
    void ask() const {
        if (watch_ && !watch_(state_)) throw ReadingStopped();
    }

    static constexpr int steps_between = 1024;

  private:
    const ReadingWatch& watch_;
    ReadingState state_; ///< the last one reported
    unsigned steps_ = 0;
};

} // namespace rasterwalk
