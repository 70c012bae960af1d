#include "engines/opengl_peer.h"

#include <chrono>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/quoted.h"
#include "engines/opengl_task.h"

namespace rasterwalk {

namespace {

/// The longest wait for any byte of an answer: the largest scene, on a slow machine.
constexpr std::chrono::minutes longest_drawing{2};

std::size_t pixels_of(const Viewport& size) {
    return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

} // namespace

std::string bytes_of_planes(const FastPicture& picture) {
    std::string bytes;
    const auto append = [&](const auto& plane) {
        for (int row = 0; row < picture.size.height; ++row)
            bytes.append(reinterpret_cast<const char*>(plane.data() + picture.at(0, row)),
                         4 * static_cast<std::size_t>(picture.size.width));
    };
    bytes.reserve(12 * pixels_of(picture.size));
    append(picture.colour);
    append(picture.inv_z);
    append(picture.owner);
    return bytes;
}

void set_planes(const std::string& bytes, FastPicture& picture) {
    const std::size_t pixels = pixels_of(picture.size);
    if (bytes.size() != 12 * pixels) throw AccessError("the planes of a picture are incomplete.");
    picture.stride = static_cast<std::size_t>(picture.size.width);
    std::size_t from = 0;
    const auto take = [&](auto& plane) {
        plane.resize(pixels);
        std::memcpy(plane.data(), bytes.data() + from, 4 * pixels);
        from += 4 * pixels;
    };
    take(picture.colour);
    take(picture.inv_z);
    take(picture.owner);
}

PeerOpenGl::PeerOpenGl(std::string program) : program_(std::move(program)) {
    std::error_code ignored;
    exists_ = std::filesystem::exists(program_, ignored);
}

std::string PeerOpenGl::refusal() const {
    return exists_ ? "" : "OpenGL needs the program " + in_quotes(program_) + ", which is missing";
}

void PeerOpenGl::start() const {
    if (child_ != nullptr) return;
    auto child = std::make_unique<ChildProcess>(
        std::vector<std::string>{program_, opengl_peer_word},
        ChildProcess::Patience{.longest = longest_drawing, .is_stopped = nullptr});
    constexpr std::string_view ready = "ready ";
    const std::string line = child->read_line();
    if (!line.starts_with(ready))
        throw AccessError("OpenGL's program gave an unexpected answer: " + in_quotes(line) + '.');
    name_ = line.substr(ready.size());
    child_ = std::move(child);
}

std::string PeerOpenGl::name() const {
    start();
    return name_;
}

void PeerOpenGl::draw(const Scene& scene, const Settings& settings, FastPicture& picture) {
    start();
    // If anything fails on the way, the rest of an answer is lost: the next picture starts afresh.
    std::unique_ptr<ChildProcess> child = std::move(child_);
    const std::string bytes = bytes_of(opengl_task(scene, settings));
    child->write_line(fmt::format("draw {}", bytes.size()));
    child->write_bytes(bytes);
    const std::string line = child->read_line();
    picture.size = settings.viewport;
    if (line == fmt::format("planes {} {}", picture.size.width, picture.size.height)) {
        set_planes(child->read_bytes(12 * pixels_of(picture.size)), picture);
        child_ = std::move(child);
        return;
    }
    constexpr std::string_view fault = "fault ";
    if (line.starts_with(fault)) throw AccessError(line.substr(fault.size()));
    throw AccessError("OpenGL's program gave an unexpected answer: " + in_quotes(line) + '.');
}

} // namespace rasterwalk
