#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "mine/checked_program.h"

namespace rasterwalk {

/// A student's program that is checked on its own thread. The destructor stops the check and waits
/// for that thread, which ends soon.
class ProgramCheck {
  public:
    /// Does the work. Throws Error.
    using Work = std::function<CheckedProgram(const CheckProgramOptions&)>;

    /// Starts. Throws std::system_error where there are no threads, as in a browser.
    /// @param options those that the thread needs to be stopped, and to say how far it is, are set
    ///                here
    ProgramCheck(Work work, CheckProgramOptions options);
    ~ProgramCheck();
    ProgramCheck(const ProgramCheck&) = delete;
    ProgramCheck& operator=(const ProgramCheck&) = delete;

    /// What is being done: "Compiling it". Empty before that.
    std::string doing() const;

    /// What is known so far; null: nothing yet. Another object each time that it is more.
    std::shared_ptr<const CheckedProgram> so_far() const;

    /// Has the thread ended, successfully or not?
    /// @param patience how long to wait for its end
    bool is_done(std::chrono::milliseconds patience = {}) const;

    /// Returns at once; is_done() says when the thread has stopped.
    void stop() { is_stopped_ = true; }

    /// The whole of what is known; waits until it is done. Throws what the check threw.
    std::shared_ptr<const CheckedProgram> take();

  private:
    void run(const Work& work, CheckProgramOptions options);

    mutable std::mutex mutex_; ///< of the next three
    std::string doing_;
    std::shared_ptr<const CheckedProgram> so_far_;
    bool is_done_ = false;
    mutable std::condition_variable end_;
    std::exception_ptr fault_; ///< belongs to the thread until it is done
    std::atomic<bool> is_stopped_ = false;
    std::thread thread_; ///< the last member: it starts when all others exist
};

/// Starts checking the program of a .cpp file or of a folder, as check_program() does. What it
/// throws, and what find_student_files() throws, take() throws.
std::unique_ptr<ProgramCheck> begin_program_check(const std::string& path,
                                                  const CheckProgramOptions& options = {});

} // namespace rasterwalk
