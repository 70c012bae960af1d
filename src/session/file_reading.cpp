#include "session/file_reading.h"

#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.h"

namespace rasterwalk {

FileReading::FileReading(const std::string& path, const Read& read) : path_(path) {
    try {
        thread_ = std::thread([this, read] { run(read); });
    } catch (const std::system_error&) {
        run(read);
    }
}

FileReading::~FileReading() {
    stop();
    if (thread_.joinable()) thread_.join();
}

void FileReading::run(const Read& read) {
    try {
        opened_ = read([&](const ReadingState& state) {
            const std::lock_guard lock(mutex_);
            state_ = state;
            return !is_stopped_;
        });
    } catch (...) {
        fault_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    is_done_ = true;
    end_.notify_all();
}

ReadingState FileReading::state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

bool FileReading::is_done(std::chrono::milliseconds patience) const {
    std::unique_lock lock(mutex_);
    return end_.wait_for(lock, patience, [&] { return is_done_; });
}

Opened FileReading::take() {
    const bool is_stopped = is_stopped_;
    if (thread_.joinable()) thread_.join();
    if (is_stopped) throw ReadingStopped();
    if (fault_) std::rethrow_exception(fault_);
    return std::move(opened_).value();
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
