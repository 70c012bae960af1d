#pragma once

// How far the reading of a large file is, and how it is stopped on the way.

#include <cstdint>
#include <exception>
#include <functional>

namespace rasterwalk {

/// What a model is made of on the way, in the order in which it is done.
enum class ReadingPart : std::uint8_t {
    bytes,     ///< of its file are read
    triangles, ///< are made of its faces
};

/// How far a reading is.
struct ReadingState {
    ReadingPart part = ReadingPart::bytes;
    std::int64_t done = 0;
    std::int64_t all = 0; ///< bytes of the file, or triangles of all faces; 0: not known yet

    friend bool operator==(const ReadingState&, const ReadingState&) = default;
};

/// Called now and then with how far a reading is, some thousand times a second at most. False:
/// stop. May be empty.
using ReadingWatch = std::function<bool(const ReadingState&)>;

/// Thrown where a watch stops a reading. No fault of the file, and so no Error.
class ReadingStopped : public std::exception {
  public:
    const char* what() const noexcept override { return "reading was stopped."; }
};

/// Asks a watch once in so many steps, so that a step costs next to nothing.
class WatchedSteps {
  public:
    explicit WatchedSteps(const ReadingWatch& watch) : watch_(watch) {}

    /// One step more is done. Throws ReadingStopped.
    /// @param state makes the ReadingState; called only where the watch is asked
    template <class State>
    void step(State state) {
        if (++steps_ % steps_between == 0) ask(state());
    }

    /// One step more, of a file that is read on the way: how far the whole is stays.
    void step() {
        if (++steps_ % steps_between == 0) ask();
    }

    /// One step more, after which so much of the same part is done.
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
