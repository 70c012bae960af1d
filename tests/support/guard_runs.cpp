#include "tests/support/guard_runs.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

namespace rasterwalk::test {

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

int open_descriptors() {
    return static_cast<int>(std::distance(fs::directory_iterator("/proc/self/fd"), {}));
}

std::string found_in_path(const std::string& name) {
    std::istringstream path(std::getenv("PATH"));
    for (std::string folder; std::getline(path, folder, ':');)
        if (::access((folder + "/" + name).c_str(), X_OK) == 0) return folder + "/" + name;
    return {};
}

struct HostileProgram {
    HostileProgram() {
        const std::vector<std::string> found = compilers();
        if (found.empty()) throw std::runtime_error("this test needs a C++ compiler");
        const std::string command =
            fmt::format("{} -std=c++20 -O0 -pthread '{}/tests/mine/hostile/hostile.cpp' -o '{}'",
                        found.front(), project_root(), place.file("hostile"));
        if (std::system(command.c_str()) != 0)
            throw std::runtime_error("the hostile program does not compile");
        ::chmod(folder.c_str(), 0755);
    }

    TemporaryFolder place;
    std::string folder = fs::path(place.file("")).parent_path();
};

} // namespace

const std::string& hostile_folder() {
    static const HostileProgram program;
    return program.folder;
}

GuardedCommand hostile_command(const std::vector<std::string>& deed) {
    GuardedCommand command;
    command.folder = hostile_folder();
    command.words = {command.folder + "/hostile"};
    command.words.insert(command.words.end(), deed.begin(), deed.end());
    command.limits.time = 60s; // never needed, however busy the computer is
    return command;
}

GuardedCommand endless_command(const std::vector<std::string>& deed) {
    GuardedCommand command = hostile_command(deed);
    command.limits.time = 200ms;
    return command;
}

GuardSeen seen_run(const GuardWay& way, GuardedCommand command,
                   std::chrono::milliseconds stop_after) {
    command.limits.use_landlock = way.use_landlock;
    const auto begin = std::chrono::steady_clock::now();
    if (stop_after > 0ms)
        command.is_stopped = [=] { return std::chrono::steady_clock::now() - begin > stop_after; };
    std::istringstream said(as_user(way.user, [&] {
        const int before = open_descriptors();
        const GuardedRun run = run_guarded(command);
        const int children = ::waitpid(-1, nullptr, WNOHANG) < 0 ? 0 : 1;
        return fmt::format("{} {} {} {} {} {} {} {}\n{}", static_cast<int>(run.end), run.exit_code,
                           run.signal, run.is_output_cut, run.time.count(), run.has_landlock,
                           children, open_descriptors() - before, run.output);
    }));
    GuardSeen seen;
    int end = 0;
    std::int64_t time = 0;
    said >> end >> seen.run.exit_code >> seen.run.signal;
    std::string is_cut, has_landlock;
    said >> is_cut >> time >> has_landlock >> seen.children >> seen.descriptors;
    said.get();
    seen.run.end = static_cast<GuardedEnd>(end);
    seen.run.is_output_cut = is_cut == "true";
    seen.run.has_landlock = has_landlock == "true";
    seen.run.time = std::chrono::milliseconds(time);
    seen.run.output.assign(std::istreambuf_iterator<char>(said), {});
    return seen;
}

std::string unguarded_output(const std::vector<std::string>& deed) {
    std::string line = "'" + hostile_folder() + "/hostile'";
    for (const std::string& word : deed)
        line += " '" + word + "'";
    return as_ordinary_user([&] {
        std::string output;
        FILE* const pipe = ::popen(line.c_str(), "r");
        if (pipe == nullptr) return output;
        std::array<char, 4096> block{};
        for (std::size_t count = 0; (count = std::fread(block.data(), 1, block.size(), pipe)) > 0;)
            output.append(block.data(), count);
        ::pclose(pipe);
        return output;
    });
}

std::size_t count_processes(const std::string& text) {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        if (entry.path().filename().string().find_first_not_of("0123456789") != std::string::npos)
            continue;
        // A process may end while it is read; a stream's own functions then just stop.
        std::ifstream file(entry.path() / "cmdline", std::ios::binary);
        std::string words;
        std::getline(file, words);
        if (words.find(text) != std::string::npos) ++count;
    }
    return count;
}

bool wait_for_processes(const std::string& text, std::size_t least, std::size_t most) {
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < 30s) {
        const std::size_t count = count_processes(text);
        if (count >= least && count <= most) return true;
        std::this_thread::sleep_for(5ms);
    }
    return false;
}

std::vector<std::string> compilers() {
    std::vector<std::string> paths{found_in_path("g++"), found_in_path("clang++")};
    paths.erase(std::remove(paths.begin(), paths.end(), ""), paths.end());
    return paths;
}

} // namespace rasterwalk::test
