#include "engines/llvmpipe_peer.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

class LlvmpipePeer final : public TimedEngine {
  public:
    LlvmpipePeer(const std::string& program, const PeerTask& task,
                 const ChildProcess::Patience& patience)
        : size_(task.size), child_(command_of(program, task), patience) {}

    /// To be called once, first.
    std::string name_when_ready() { return rest_of_line("ready "); }

    Milliseconds time_pictures(int first, int count) override {
        child_.write_line(fmt::format("round {} {}", first, count));
        const std::string line = child_.read_line();
        Milliseconds times;
        std::string rest;
        std::istringstream words(line);
        words.imbue(std::locale::classic());
        if (!(words >> times.processor >> times.wall) || words >> rest) throw_no_answer(line);
        return times;
    }

    EnginePicture picture(int number) override {
        child_.write_line(fmt::format("picture {}", number));
        EnginePicture picture;
        picture.size = size_;
        const auto pixels =
            static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height);
        const std::string count = rest_of_line("bytes ");
        if (count != std::to_string(4 * pixels)) throw_no_answer("bytes " + count);
        const std::string bytes = child_.read_bytes(4 * pixels);
        for (std::size_t i = 0; i < pixels; ++i) {
            const auto byte = [&](std::size_t channel) {
                return std::uint32_t{static_cast<unsigned char>(bytes[4 * i + channel])};
            };
            picture.colour.push_back(byte(2) << 16 | byte(1) << 8 | byte(0));
        }
        return picture;
    }

  private:
    static std::vector<std::string> command_of(const std::string& program, const PeerTask& task) {
        std::vector<std::string> words = peer_arguments(task);
        words.insert(words.begin(), program);
        return words;
    }

    std::string rest_of_line(std::string_view begin) {
        std::string line = child_.read_line();
        if (!line.starts_with(begin)) throw_no_answer(line);
        return line.substr(begin.size());
    }

    [[noreturn]] static void throw_no_answer(const std::string& line) {
        throw AccessError("the llvmpipe program gave an unexpected answer: " + in_quotes(line) +
                          '.');
    }

    Viewport size_;
    ChildProcess child_;
};

} // namespace

std::vector<std::string> peer_arguments(const PeerTask& task) {
    return {std::string(word_of(task.workload)),
            fmt::format("{}x{}", task.size.width, task.size.height), std::to_string(task.threads)};
}

PeerTask parse_peer_arguments(const std::vector<std::string>& words) {
    if (words.size() != 3) throw UsageError("the arguments are WORKLOAD WIDTHxHEIGHT THREADS.");
    PeerTask task;
    const auto workload = value_of_word<Workload>(words[0]);
    if (!workload) throw UsageError("there is no workload " + in_quotes(words[0]) + '.');
    task.workload = *workload;
    Settings settings;
    set_value(settings, *find_setting("viewport.size"), words[1]);
    task.size = settings.viewport;
    const auto threads = parse_int(words[2]);
    if (!threads || *threads < 1 || *threads > most_threads)
        throw UsageError(fmt::format("the number of threads is 1 to {}, not {}.", most_threads,
                                     in_quotes(words[2])));
    task.threads = *threads;
    return task;
}

Peer start_llvmpipe(const std::string& program, const PeerTask& task,
                    const ChildProcess::Patience& patience) {
    auto engine = std::make_unique<LlvmpipePeer>(program, task, patience);
    std::string name = engine->name_when_ready();
    return {std::move(name), std::move(engine)};
}

std::string llvmpipe_program() {
    const char* const named = std::getenv("RASTERWALK_LLVMPIPE");
    if (named != nullptr && *named != '\0') return named;
    std::error_code fault;
    const std::filesystem::path folder =
        std::filesystem::read_symlink("/proc/self/exe", fault).parent_path();
    const std::filesystem::path installed =
        folder.parent_path() / "libexec/rasterwalk/rasterwalk-llvmpipe";
    if (std::filesystem::exists(installed, fault)) return installed.string();
    return (folder / "rasterwalk-llvmpipe").string();
}

} // namespace rasterwalk
