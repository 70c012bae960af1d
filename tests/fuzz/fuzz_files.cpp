// Reads changed files of every format, as support/changed_files.h makes them, and prints each whose
// outcome is wrong. The script `fuzz` builds and calls it.

#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/changed_files.h"

namespace {

using namespace rasterwalk::test;

/// The requested run, and where findings are kept.
struct Task {
    std::string folder;
    std::uint32_t files = 0, start = 0;
    std::string format; ///< empty: all
};

/// Memory that the reading process shares with its parent.
struct Progress {
    std::uint32_t file, read, findings;
};

/// Files of one start value are different from those of the next.
std::uint32_t number_of(const Task& task, std::uint32_t file) {
    return task.start * 0x9e3779b9u + file;
}

/// Ends, by SIGPROF, a process that is busy for longer than a file may take.
void set_timer() {
    constexpr long longest = static_cast<long>(2 * most_seconds);
    const itimerval timer{{0, 0}, {longest, 0}};
    ::setitimer(ITIMER_PROF, &timer, nullptr);
}

void report(const Task& task, const ChangedFormat& format, Progress& progress,
            const std::string& problem) {
    ++progress.findings;
    const std::string path =
        fmt::format("{}/{}-{}-{}", task.folder, format.name, task.start, progress.file);
    std::ofstream(path, std::ios::binary) << changed_file(format, number_of(task, progress.file));
    fmt::print("{}: file {} of start value {}: {}\n    It is kept as {}.\n", format.name,
               progress.file, task.start, problem, path);
    std::fflush(stdout);
}

constexpr std::uint32_t most_findings = 20;

bool goes_on(const Task& task, const Progress& progress) {
    return progress.file < task.files && progress.findings < most_findings;
}

[[noreturn]] void read_files(const Task& task, const ChangedFormat& format,
                             const TemporaryFolder& folder, Progress& progress) {
    for (; goes_on(task, progress); ++progress.file) {
        set_timer();
        const std::string bytes = changed_file(format, number_of(task, progress.file));
        const FileOutcome outcome = outcome_of(format, bytes, folder);
        progress.read += outcome.is_read ? 1 : 0;
        if (!outcome.problem.empty()) report(task, format, progress, outcome.problem);
    }
    ::_exit(0);
}

/// Reads all files of a format in a separate process; if that ends, another one goes on with the
/// next file.
void fuzz(const Task& task, const ChangedFormat& format, Progress& progress) {
    const TemporaryFolder folder;
    lay_out(folder);
    progress = {};
    while (goes_on(task, progress)) {
        const pid_t child = ::fork();
        if (child == 0) read_files(task, format, folder, progress);
        int status = 0;
        ::waitpid(child, &status, 0);
        if (status == 0) break;
        const bool is_late = WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF;
        report(task, format, progress, is_late ? "it takes too long." : "it ends the program.");
        ++progress.file;
    }
    fmt::print("{}: {} files from start value {}, {} read, {} findings\n", format.name,
               progress.file, task.start, progress.read, progress.findings);
    std::fflush(stdout);
}

std::optional<std::uint32_t> parse_count(std::string_view word) {
    std::uint32_t number = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (fault != std::errc{} || end != word.data() + word.size()) return std::nullopt;
    return number;
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const auto count = words.size() == 4 ? parse_count(words[1]) : std::nullopt;
    const auto start = words.size() == 4 ? parse_count(words[2]) : std::nullopt;
    std::vector<ChangedFormat> formats = changed_formats();
    if (words.size() == 4 && words[3] != "all")
        std::erase_if(formats,
                      [&](const ChangedFormat& format) { return format.name != words[3]; });
    if (!count || !start || formats.empty()) {
        fmt::print(stderr, "rasterwalk-fuzz FOLDER FILES START FORMAT|all: formats are");
        for (const ChangedFormat& format : changed_formats())
            fmt::print(stderr, " {}", format.name);
        fmt::print(stderr, ".\n");
        return 2;
    }
    if (*count < formats.size()) {
        fmt::print(stderr,
                   "rasterwalk-fuzz: {} files are too few for {} formats: give at least one to "
                   "each.\n",
                   *count, formats.size());
        return 2;
    }
    void* const shared = ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE,
                                MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) return 2;
    auto& progress = *static_cast<Progress*>(shared);
    const Task task{words[0], *count / static_cast<std::uint32_t>(formats.size()), *start,
                    words[3]};
    std::uint32_t findings = 0;
    for (const ChangedFormat& format : formats) {
        fuzz(task, format, progress);
        findings += progress.findings;
    }
    return findings > 0 ? 1 : 0;
}
