#include "mine/compile/compiler_run.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.h"
#include "base/text_parts.h"
#include "mine/compile/project_folder.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string() : value;
}

/// The folder of a compiler that is not the system's: its libraries are near it.
std::string compiler_home(const std::string& path) {
    std::error_code fault;
    const fs::path home = fs::canonical(path, fault).parent_path().parent_path();
    if (fault || is_below(home.string(), "/usr")) return {};
    // Never all of the disk, or of what a person has.
    if (home == home.root_path() || home == fs::path(variable("HOME"))) return {};
    return home.string();
}

bool is_program(const fs::path& path) {
    std::error_code fault;
    return fs::is_regular_file(path, fault) && ::access(path.c_str(), X_OK) == 0;
}

/// ccache writes into a folder of its own, which the guard refuses; the compiler comes later on the
/// path.
bool is_wrapper(const fs::path& path) {
    std::error_code fault;
    const std::string name = fs::canonical(path, fault).filename().string();
    return name == "ccache" || name == "distcc" || name == "icecc";
}

/// The program's path; empty: there is none of this name.
std::string find_program(const std::string& name) {
    if (name.find('/') != std::string::npos) {
        const std::string path = fs::absolute(name).lexically_normal().string();
        return is_program(path) ? path : std::string();
    }
    std::string places = variable("PATH");
    if (places.empty()) places = "/usr/local/bin:/usr/bin:/bin";
    for (const std::string_view place : split(places, ':')) {
        if (!place.starts_with('/')) continue;
        const fs::path path = fs::path(place) / name;
        if (is_program(path) && !is_wrapper(path)) return path.string();
    }
    return {};
}

/// The first number with dots in "Debian clang version 14.0.6".
std::string version_number(std::string_view text) {
    for (std::string_view rest = text; !rest.empty();) {
        const std::string_view word = take_part(rest, ' ');
        const bool is_number = !word.empty() && word.front() >= '0' && word.front() <= '9';
        if (is_number && word.find('.') != std::string_view::npos) {
            return std::string(word.substr(0, word.find_first_not_of("0123456789.")));
        }
    }
    return {};
}

std::string ask_compiler(const std::string& path, const std::string& option) {
    CompilerFolders folders;
    folders.work = cache_folder();
    const GuardedRun run = run_compiler(path, {option}, folders, {});
    if (!is_done(run)) return {};
    const std::vector<std::string_view> lines = split_lines(run.output);
    return lines.empty() ? std::string() : std::string(lines.front());
}

} // namespace

GuardedRun run_compiler(const std::string& path, const std::vector<std::string>& arguments,
                        const CompilerFolders& folders, const std::function<bool()>& is_stopped) {
    GuardedCommand command;
    command.words = {path};
    command.words.insert(command.words.end(), arguments.begin(), arguments.end());
    const std::string own_folder = fs::path(path).parent_path().string();
    command.environment = {"LC_ALL=C", "PATH=" + own_folder + ":/usr/local/bin:/usr/bin:/bin",
                           "TMPDIR=" + folders.work};
    command.folder = folders.work;
    command.readable = folders.readable;
    const std::string home = compiler_home(path);
    if (!home.empty()) command.readable.push_back(home);
    command.writable = {folders.work};
    command.limits.time = longest_compilation;
    command.limits.memory = 0; // its children are watched together
    command.limits.resident = most_compiler_memory;
    command.limits.file_size = std::size_t{512} << 20;
    command.limits.open_files = 256;
    command.limits.may_start_programs = true;
    command.is_stopped = is_stopped;
    return run_guarded(command);
}

bool is_done(const GuardedRun& run) {
    return run.end == GuardedEnd::exited && run.exit_code == 0;
}

void make_folder(const std::string& path) {
    std::error_code fault;
    if (fs::is_directory(path, fault)) return;
    const fs::path above = fs::path(path).parent_path();
    if (above != path && !fs::is_directory(above, fault)) make_folder(above.string());
    fs::create_directory(path, fault);
    if (fault) throw AccessError(fmt::format("cannot make '{}': {}.", path, fault.message()));
    fs::permissions(path, fs::perms::owner_all, fault);
}

void keep_newest(const std::string& folder, std::size_t count) {
    struct Kept {
        fs::file_time_type written;
        fs::path path;
    };
    std::vector<Kept> files;
    std::error_code fault;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        std::error_code ignored;
        files.push_back({entry->last_write_time(ignored), entry->path()});
    }
    std::sort(files.begin(), files.end(),
              [](const Kept& a, const Kept& b) { return a.written > b.written; });
    for (std::size_t i = count; i < files.size(); ++i)
        fs::remove(files[i].path, fault);
}

void mark_used(const std::string& path) {
    std::error_code fault;
    fs::last_write_time(path, fs::file_time_type::clock::now(), fault);
}

void forget_unused(const std::string& folder) {
    constexpr std::chrono::hours longest_unused{30 * 24};
    const auto now = fs::file_time_type::clock::now();
    std::vector<fs::path> unused;
    std::error_code fault;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        std::error_code unknown;
        const auto used = entry->last_write_time(unknown);
        if (!unknown && now - used > longest_unused) unused.push_back(entry->path());
    }
    for (const fs::path& path : unused)
        fs::remove_all(path, fault);
}

std::string unfinished_name(const std::string& path) {
    static std::atomic<unsigned> number{0};
    return fmt::format("{}.{}-{}.part", path, ::getpid(), ++number);
}

void finish_file(const std::string& unfinished, const std::string& path) {
    std::error_code fault;
    fs::rename(unfinished, path, fault);
    if (fault) throw AccessError(fmt::format("cannot write '{}': {}.", path, fault.message()));
}

std::string cache_folder() {
    std::string folder = variable("RASTERWALK_CACHE");
    if (folder.empty() && !variable("XDG_CACHE_HOME").empty()) {
        folder = variable("XDG_CACHE_HOME") + "/rasterwalk";
    }
    if (folder.empty() && !variable("HOME").empty()) {
        folder = variable("HOME") + "/.cache/rasterwalk";
    }
    if (folder.empty()) {
        throw AccessError("There is no folder for compiled programs: set RASTERWALK_CACHE to one.");
    }
    const std::string absolute = fs::absolute(folder).lexically_normal().string();
    make_folder(absolute);
    return absolute;
}

Compiler find_compiler(const std::string& wanted) {
    std::vector<std::string> names{wanted};
    if (wanted.empty()) names = {"g++", "clang++"};
    for (const std::string& name : names) {
        Compiler compiler;
        compiler.path = find_program(name);
        if (compiler.path.empty()) continue;
        const std::string said = ask_compiler(compiler.path, "--version");
        compiler.is_clang = said.find("clang") != std::string::npos;
        std::string number = version_number(said);
        if (!compiler.is_clang) {
            // Other programs have a version as well.
            number = version_number(ask_compiler(compiler.path, "-dumpfullversion"));
        }
        if (number.empty()) {
            throw AccessError(fmt::format("'{}' is no C++ compiler that is known here.", name));
        }
        compiler.version = fmt::format("{} {}", compiler.is_clang ? "clang++" : "g++", number);
        return compiler;
    }
    if (!wanted.empty()) throw AccessError(fmt::format("There is no compiler '{}'.", wanted));
    throw AccessError("There is no C++ compiler: install g++ (on Debian and Ubuntu: apt install "
                      "g++).");
}

} // namespace rasterwalk
