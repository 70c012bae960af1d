#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "scene/reading.h"
#include "scene/scene.h"

namespace rasterwalk {

/// Larger models than this, bytes, are read beside the window: others take no longer than a frame.
inline constexpr std::uintmax_t largest_model_at_once = std::uintmax_t{256} << 10;

/// Is this a model so large that a window would stand still while it is read?
bool is_large_model(const std::string& path);

/// A scene file that is read on a thread of its own. It does not end before that thread does; a
/// reading that is stopped ends soon.
class SceneReading {
  public:
    /// Begins to read. Throws std::system_error where there can be no further thread.
    explicit SceneReading(const std::string& path);
    ~SceneReading() = default;
    SceneReading(const SceneReading&) = delete;
    SceneReading& operator=(const SceneReading&) = delete;

    const std::string& path() const { return path_; }

    ReadingState state() const;

    /// Has the thread come to its end, with a scene or without?
    bool is_done() const { return is_done_; }

    /// Returns at once; is_done() says when the thread has taken note of it.
    void stop() { thread_.request_stop(); }

    /// The scene; waits for it if it is not done. To be called once. Throws what the reading threw,
    /// and ReadingStopped after stop(), even if that came too late.
    Scene take();

  private:
    void read(const std::stop_token& stop);

    std::string path_;
    mutable std::mutex mutex_; ///< of state_
    ReadingState state_;
    std::optional<Scene> scene_; ///< both are the thread's until it is done
    std::exception_ptr fault_;
    std::atomic<bool> is_done_ = false;
    std::jthread thread_; ///< the last: it begins when all else is there
};

/// How far it is, from 0 to 1.
float share_of(const ReadingState& state);

/// "12.3 of 61.0 MB", "300000 of 1000000 triangles"; empty while nothing is known.
std::string reading_words(const ReadingState& state);

} // namespace rasterwalk
