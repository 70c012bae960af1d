#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>

#include "scene/reading.h"
#include "scene/scene.h"
#include "session/session.h"

namespace rasterwalk {

/// What a file holds: a scene or model, or a lesson or saved view with all its settings.
using Opened = std::variant<Scene, Session>;

/// A file that is read on its own thread. The destructor waits for that thread; a reading that is
/// stopped ends soon.
class FileReading {
  public:
    using Read = std::function<Opened(const ReadingWatch&)>;

    /// Starts reading. Without threads, as in a browser, all is read on return.
    /// @param path of the file, as its name
    /// @param read runs on the thread
    FileReading(const std::string& path, const Read& read);
    ~FileReading();
    FileReading(const FileReading&) = delete;
    FileReading& operator=(const FileReading&) = delete;

    const std::string& path() const { return path_; }

    ReadingState state() const;

    /// Has the thread ended, successfully or not?
    /// @param patience how long to wait for its end
    bool is_done(std::chrono::milliseconds patience = {}) const;

    /// Returns at once; is_done() says when the thread has stopped.
    void stop() { is_stopped_ = true; }

    /// What was read; waits until it is done. Call it once. Throws what the reading threw, and
    /// ReadingStopped after stop(), even if that came too late.
    Opened take();

  private:
    void run(const Read& read);

    std::string path_;
    mutable std::mutex mutex_; ///< of state_ and is_done_
    mutable std::condition_variable end_;
    ReadingState state_;
    bool is_done_ = false;
    std::optional<Opened> opened_; ///< belongs to the thread until it is done, like the next
    std::exception_ptr fault_;
    std::atomic<bool> is_stopped_ = false;
    std::thread thread_; ///< the last member: it starts when all others exist
};

/// How far the reading is, from 0 to 1.
float share_of(const ReadingState& state);

/// "12.3 of 61.0 MB", "300000 of 1000000 triangles"; empty while nothing is known.
std::string reading_words(const ReadingState& state);

} // namespace rasterwalk
