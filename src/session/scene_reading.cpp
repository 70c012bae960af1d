#include "session/scene_reading.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.h"
#include "scene/read_obj.h"
#include "session/scene_file.h"

namespace rasterwalk {

bool is_large_model(const std::string& path) {
    std::error_code fault;
    const std::uintmax_t size = std::filesystem::file_size(path, fault);
    return !fault && size > largest_model_at_once && is_model_file(path);
}

SceneReading::SceneReading(const std::string& path)
    : path_(path), thread_([this](const std::stop_token& stop) { read(stop); }) {}

void SceneReading::read(const std::stop_token& stop) {
    try {
        scene_ = read_scene_file(path_, [&](const ReadingState& state) {
            const std::lock_guard lock(mutex_);
            state_ = state;
            return !stop.stop_requested();
        });
    } catch (...) {
        fault_ = std::current_exception();
    }
    is_done_ = true;
}

ReadingState SceneReading::state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

Scene SceneReading::take() {
    const bool is_stopped = thread_.get_stop_token().stop_requested();
    if (thread_.joinable()) thread_.join();
    if (is_stopped) throw ReadingStopped();
    if (fault_) std::rethrow_exception(fault_);
    return std::move(scene_).value();
}

float share_of(const ReadingState& state) {
    if (state.all <= 0) return 0.0f;
    return static_cast<float>(static_cast<double>(state.done) / static_cast<double>(state.all));
}

std::string reading_words(const ReadingState& state) {
    if (state.all <= 0) return {};
    if (state.part == ReadingPart::triangles)
        return fmt::format("{} of {} triangles", state.done, state.all);
    constexpr double megabyte = 1e6;
    return fmt::format("{} of {} MB", decimals(static_cast<double>(state.done) / megabyte, 1),
                       decimals(static_cast<double>(state.all) / megabyte, 1));
}

} // namespace rasterwalk
