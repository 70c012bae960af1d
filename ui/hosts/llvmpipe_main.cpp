// The program that `rasterwalk engines` asks for llvmpipe's times and pictures, and commands with
// engine=opengl for OpenGL's. Their protocols are described in engines/llvmpipe_peer.h and
// engines/opengl_peer.h.

#include <cstdint>
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/quoted.h"
#include "engines/kept_memory.h"
#include "engines/llvmpipe_peer.h"
#include "engines/opengl_peer.h"
#include "engines/opengl_task.h"
#include "engines/pinned_threads.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "ui/hosts/llvmpipe.h"
#include "ui/hosts/memory_context.h"
#include "ui/hosts/opengl_drawing.h"

namespace rasterwalk {

namespace {

/// Four bytes a pixel: blue, green, red, and one without meaning.
std::string bytes_of(const EnginePicture& picture) {
    std::string bytes;
    bytes.reserve(4 * picture.colour.size());
    for (const std::uint32_t colour : picture.colour)
        for (const int shift : {0, 8, 16, 24})
            bytes += static_cast<char>(colour >> shift & 0xffU);
    return bytes;
}

/// The answer to a line, with its line break. Throws UsageError.
std::string answer(const std::string& line, LlvmpipeDrawing& drawing) {
    std::istringstream words(line);
    std::string word;
    int number = 0, count = 0;
    words >> word >> number;
    if (word == "picture" && words) {
        const std::string bytes = bytes_of(drawing.picture(number));
        return fmt::format("bytes {}\n{}", bytes.size(), bytes);
    }
    if (word == "round" && words >> count && count > 0) {
        const Milliseconds time = drawing.time_pictures(number, count);
        return fmt::format("{} {}\n", time.processor, time.wall);
    }
    throw UsageError("expected 'round' or 'picture', not " + in_quotes(line) + '.');
}

/// The bytes of a task that a line announces. Throws UsageError if it announces none, InputError if
/// they are not all there.
std::string announced_bytes(const std::string& line) {
    constexpr std::size_t most_bytes = std::size_t{1} << 30;
    std::istringstream words(line);
    std::string word;
    std::size_t count = 0;
    if (!(words >> word >> count) || word != "draw" || count > most_bytes)
        throw UsageError("expected 'draw' and a number of bytes, not " + in_quotes(line) + '.');
    std::string bytes(count, '\0');
    if (!std::cin.read(bytes.data(), static_cast<std::streamsize>(count)))
        throw InputError("the input ended before the picture.");
    return bytes;
}

/// Draws whatever it is asked to draw with OpenGL.
void run_opengl() {
    const auto context = make_memory_context({1, 1}, 0);
    context->enter();
    OpenGlDrawing drawing;
    FastPicture picture;
    std::cout << "ready " << drawing.name() << std::endl;
    for (std::string line; std::getline(std::cin, line);) {
        const std::string bytes = announced_bytes(line);
        try {
            drawing.draw(opengl_task_from(bytes), picture);
            std::cout << fmt::format("planes {} {}\n", picture.size.width, picture.size.height)
                      << bytes_of_planes(picture);
        } catch (const Error& fault) {
            std::cout << "fault " << visible_line(fault.what()) << '\n';
        }
        std::cout << std::flush;
    }
}

void run(const std::vector<std::string>& words) {
    if (words == std::vector<std::string>{opengl_peer_word}) return run_opengl();
    keep_freed_memory();
    const PeerTask task = parse_peer_arguments(words);
    const Scene room = read_scene(lessons_folder() + '/' + std::string(usual_scene));
    PinnedThreads pinned;
    LlvmpipeDrawing drawing(task, workload_scene(task.workload, room));
    drawing.picture(0);
    // Mesa has other threads too, which wait; with one thread ours does the drawing.
    pinned.pin(task.threads == 1 ? "" : "llvmpipe-");
    std::cout << "ready " << drawing.name() << std::endl;
    for (std::string line; std::getline(std::cin, line);)
        std::cout << answer(line, drawing) << std::flush;
}

} // namespace

} // namespace rasterwalk

int main(int argc, char** argv) {
    using rasterwalk::ExitCode;
    const auto complain = [](const char* sentence, ExitCode code) {
        std::cerr << "rasterwalk-llvmpipe: " << rasterwalk::visible_line(sentence) << '\n';
        return static_cast<int>(code);
    };
    try {
        rasterwalk::run({argv + 1, argv + argc});
        return static_cast<int>(ExitCode::done);
    } catch (const rasterwalk::Error& fault) {
        return complain(fault.what(), fault.code);
    } catch (const std::bad_alloc&) {
        return complain("there is not enough memory for this.", ExitCode::no_access);
    } catch (const std::exception& fault) {
        return complain(fault.what(), ExitCode::no_access);
    }
}
