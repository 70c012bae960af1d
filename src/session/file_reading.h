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

/// What a file holds: a scene or model, or a lesson or saved view with all that it sets.
using Opened = std::variant<Scene, Session>;

/// A file that is read on a thread of its own. It does not end before that thread does; a reading
/// that is stopped ends soon.
class FileReading {
  public:
    using Read = std::function<Opened(const ReadingWatch&)>;

    /// Begins to read. Where there are no threads, as in a browser, all is read on return.
    /// @param path of what is read, to name it
    /// @param read runs on the thread
    FileReading(const std::string& path, const Read& read);
    ~FileReading();
    FileReading(const FileReading&) = delete;
    FileReading& operator=(const FileReading&) = delete;

    const std::string& path() const { return path_; }

    ReadingState state() const;

    /// Has the thread come to its end, with or without what it was to read?
    /// @param patience how long to wait for that
    bool is_done(std::chrono::milliseconds patience = {}) const;

    /// Returns at once; is_done() says when the thread has taken note of it.
    void stop() { is_stopped_ = true; }

    /// What was read; waits for it if it is not done. To be called once. Throws what the reading
    /// threw, and ReadingStopped after stop(), even if that came too late.
    Opened take();

  private:
    void run(const Read& read);

    std::string path_;
    mutable std::mutex mutex_; ///< of state_ and is_done_
    mutable std::condition_variable end_;
    ReadingState state_;
    bool is_done_ = false;
    std::optional<Opened> opened_; ///< both are the thread's until it is done
    std::exception_ptr fault_;
    std::atomic<bool> is_stopped_ = false;
    std::thread thread_; ///< the last: it begins when all else is there
};

/// How far it is, from 0 to 1.
float share_of(const ReadingState& state);

/// "12.3 of 61.0 MB", "300000 of 1000000 triangles"; empty while nothing is known.
std::string reading_words(const ReadingState& state);

} // namespace rasterwalk
