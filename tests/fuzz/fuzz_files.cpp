// Reads changed files of every format, as support/changed_files.h makes them, and prints each whose
// outcome is wrong. The script `fuzz` builds and calls it.

#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "ledger.h"
#include "support/changed_files.h"

namespace {

using namespace rasterwalk::test;

/// Files to read, which end with their number or with the computing time.
struct Task {
    std::string folder; ///< where findings are kept
    std::uint32_t files = 0, start = 0;
    double seconds = 1e9;
};

/// Memory that the reading process shares with its parent.
struct Progress {
    std::uint32_t file, read, findings;
};

/// Files of one start value are different from those of the next.
std::uint32_t number_of(const Task& task, std::uint32_t file) {
    return task.start * 0x9e3779b9u + file;
}

/// Computing time so far of this process, or of those that it started and that have ended.
double seconds_of(int who) {
    rusage usage{};
    ::getrusage(who, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
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

bool goes_on(const Task& task, const Progress& progress, double seconds) {
    return progress.file < task.files && progress.findings < most_findings &&
           seconds < task.seconds;
}

/// @param before seconds that other processes have already computed
[[noreturn]] void read_files(const Task& task, const ChangedFormat& format,
                             const TemporaryFolder& folder, Progress& progress, double before) {
    for (; goes_on(task, progress, before + seconds_of(RUSAGE_SELF)); ++progress.file) {
        set_timer();
        const std::string bytes = changed_file(format, number_of(task, progress.file));
        const FileOutcome outcome = outcome_of(format, bytes, folder);
        if (!outcome.problem.empty())
            report(task, format, progress, outcome.problem);
        else
            progress.read += outcome.is_read ? 1 : 0;
    }
    ::_exit(0);
}

/// Reads the files of a format in a separate process; if that ends, another one goes on with the
/// next file.
LedgerLine fuzz(const Task& task, const ChangedFormat& format, Progress& progress) {
    const TemporaryFolder folder;
    lay_out(folder);
    progress = {};
    const double begin = seconds_of(RUSAGE_CHILDREN);
    double seconds = 0.0;
    while (goes_on(task, progress, seconds)) {
        const pid_t child = ::fork();
        if (child == 0) read_files(task, format, folder, progress, seconds);
        if (child < 0) {
            fmt::print(stderr, "rasterwalk-fuzz: no process could be started.\n");
            std::exit(2);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        seconds = seconds_of(RUSAGE_CHILDREN) - begin;
        if (status == 0) break;
        const bool is_late = WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF;
        report(task, format, progress, is_late ? "it takes too long." : "it ends the program.");
        ++progress.file;
    }
    return {format.name, task.start, progress.file, progress.read, progress.findings, seconds};
}

/// Reads as many files of each format. Returns the number of findings.
std::uint32_t fuzz_files(const Task& task, const std::vector<ChangedFormat>& formats,
                         Progress& progress) {
    std::uint32_t findings = 0;
    for (const ChangedFormat& format : formats) {
        const LedgerLine line = fuzz(task, format, progress);
        fmt::print("{}: {} files from start value {}, {} read, {} findings\n", line.format,
                   line.files, line.start, line.read, line.findings);
        std::fflush(stdout);
        findings += line.findings;
    }
    return findings;
}

/// Reads files until the ledger has as many seconds for each format, a minute of each in turn.
/// Returns the number of findings in the ledger; nothing if that cannot be written.
std::optional<std::uint32_t> fuzz_seconds(Task task, const std::vector<ChangedFormat>& formats,
                                          Progress& progress) {
    constexpr double longest_part = 60.0;
    constexpr double rounding = 0.5; // the times in the ledger are rounded
    const std::string path = task.folder + "/ledger";
    const double seconds = task.seconds - rounding;
    std::vector<ChangedFormat> left = formats;
    while (!left.empty()) {
        for (const ChangedFormat& format : left) {
            const LedgerLine sum = sum_of(read_ledger(path), format.name);
            task.start = sum.start;
            if (sum.seconds >= seconds) continue;
            task.seconds = std::min(longest_part, seconds + rounding - sum.seconds);
            if (!append(path, fuzz(task, format, progress))) return std::nullopt;
        }
        const std::vector<LedgerLine> ledger = read_ledger(path);
        std::erase_if(left, [&](const ChangedFormat& format) {
            const LedgerLine sum = sum_of(ledger, format.name);
            return sum.seconds >= seconds || sum.findings >= most_findings;
        });
    }
    std::uint32_t findings = 0;
    for (const ChangedFormat& format : formats) {
        const LedgerLine sum = sum_of(read_ledger(path), format.name);
        fmt::print("{:12}{:10} files,{:10} read,{:10} refused,{:4} findings,{:8.0f} s\n",
                   sum.format, sum.files, sum.read, sum.files - sum.read - sum.findings,
                   sum.findings, sum.seconds);
        findings += sum.findings;
    }
    return findings;
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
    const bool is_timed = words.size() == 4 && words[1] == "--seconds";
    const auto count = words.size() == 4 ? parse_count(words[is_timed ? 2 : 1]) : std::nullopt;
    const auto start = words.size() == 4 ? parse_count(words[2]) : std::nullopt;
    std::vector<ChangedFormat> formats = changed_formats();
    if (words.size() == 4 && words[3] != "all")
        std::erase_if(formats,
                      [&](const ChangedFormat& format) { return format.name != words[3]; });
    if (!count || !start || formats.empty()) {
        fmt::print(stderr, "rasterwalk-fuzz FOLDER FILES START FORMAT|all, or FOLDER --seconds "
                           "SECONDS FORMAT|all: formats are");
        for (const ChangedFormat& format : changed_formats())
            fmt::print(stderr, " {}", format.name);
        fmt::print(stderr, ".\n");
        return 2;
    }
    if (*count < formats.size() && !is_timed) {
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
    if (!is_timed) {
        const Task task{words[0], *count / static_cast<std::uint32_t>(formats.size()), *start};
        return fuzz_files(task, formats, progress) > 0 ? 1 : 0;
    }
    const Task task{words[0], UINT32_MAX, 0, static_cast<double>(*count)};
    const auto findings = fuzz_seconds(task, formats, progress);
    if (!findings) {
        fmt::print(stderr, "rasterwalk-fuzz: {}/ledger cannot be written.\n", words[0]);
        return 2;
    }
    return *findings > 0 ? 1 : 0;
}
