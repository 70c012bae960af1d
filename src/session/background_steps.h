#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace rasterwalk {

/// Who makes the steps of work in the background.
enum class StepMaker : std::uint8_t {
    thread,  ///< of its own; where there are none, as in a browser, the caller
    advance, ///< the caller, one with each call of advance()
};

/// Work in small steps that nothing waits for. The destructor waits for the step being made.
class BackgroundSteps {
  public:
    /// Starts the work.
    /// @param step does a part of the work and returns whether more is left; runs on the thread
    explicit BackgroundSteps(std::function<bool()> step, StepMaker maker = StepMaker::thread);
    ~BackgroundSteps();
    BackgroundSteps(const BackgroundSteps&) = delete;
    BackgroundSteps& operator=(const BackgroundSteps&) = delete;

    /// Is a thread at work? If not, advance() is.
    bool has_thread() const { return thread_.joinable(); }

    /// Without a thread, makes the next step; otherwise does nothing.
    void advance();

    /// Returns at once; is_done() says when no more steps are made.
    void stop() { is_stopped_ = true; }

    /// Has the last step been made: all is done, the work was stopped, or it failed?
    bool is_done() const { return is_done_; }

    /// What ended the work early, a sentence; empty: nothing has.
    std::string fault() const;

  private:
    /// Makes a step; false: it was the last.
    bool make_step();

    std::function<bool()> step_;
    mutable std::mutex mutex_; ///< of fault_
    std::string fault_;
    std::atomic<bool> is_stopped_ = false, is_done_ = false;
    std::thread thread_; ///< the last member: it starts when all others exist
};

} // namespace rasterwalk
