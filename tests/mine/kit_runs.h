#pragma once

// Compiles small programs against the kit and runs them with the memory that they are watched
// through. The guard is not used here: the tests wrote the programs themselves.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "mine/kit/recording.h"
#include "support/catch.h"
#include "support/project_root.h"
#include "support/temporary_folder.h"

namespace rasterwalk::test {

inline std::string kit_folder() {
    return project_root() + "/src/mine/kit";
}

/// What a command has written, and how it ended.
struct CommandResult {
    int status = -1; ///< of waitpid
    std::string output;
    bool is_well() const { return WIFEXITED(status) && WEXITSTATUS(status) == 0; }
};

/// In a new process: the descriptor becomes recording_descriptor of the program that it starts.
inline void give_descriptor(int descriptor) {
    const int given = rasterwalk_kit::recording_descriptor;
    if (descriptor == given) {
        fcntl(given, F_SETFD, 0);
    } else if (descriptor >= 0) {
        dup2(descriptor, given);
    } else {
        close(given);
    }
}

/// Runs a program, found by PATH, until it ends.
/// @param descriptor is given to it as recording_descriptor; -1: none
/// @param prepare called in the new process before the program starts; null: nothing is
inline CommandResult run_command(const std::vector<std::string>& words, int descriptor = -1,
                                 void (*prepare)() = nullptr) {
    int output[2] = {};
    REQUIRE(pipe2(output, O_CLOEXEC) == 0);
    std::vector<char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        // An endless program ends as well, and no file with its memory is left.
        const rlimit time = {20, 25};
        const rlimit none = {0, 0};
        setrlimit(RLIMIT_CPU, &time);
        setrlimit(RLIMIT_CORE, &none);
        dup2(output[1], STDOUT_FILENO);
        dup2(output[1], STDERR_FILENO);
        give_descriptor(descriptor);
        if (prepare != nullptr) prepare();
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    close(output[1]);
    CommandResult result;
    char bytes[4096];
    for (ssize_t count = 0; (count = read(output[0], bytes, sizeof(bytes))) > 0;) {
        result.output.append(bytes, static_cast<std::size_t>(count));
    }
    close(output[0]);
    waitpid(child, &result.status, 0);
    return result;
}

/// How a program is compiled.
struct KitOptions {
    std::string compiler = "g++";
    std::vector<std::string> flags = {};
    bool has_fast_start = true; ///< reads claims.h compiled beforehand
};

/// The words that every source is compiled with.
inline std::vector<std::string> compile_words(const KitOptions& options) {
    std::vector<std::string> words = {options.compiler,   "-std=gnu++20", "-O1", "-g1", "-w",
                                      "-I" + kit_folder()};
    words.insert(words.end(), options.flags.begin(), options.flags.end());
    return words;
}

/// What is compiled once for all programs of a test: claims.h and the runtime.
struct CompiledKit {
    TemporaryFolder folder;
    std::string claims = folder.file("claims.h");
    std::string runtime = folder.file("runtime.o");

    CompiledKit() {
        std::vector<std::string> words = compile_words({});
        words.insert(words.end(),
                     {"-x", "c++-header", kit_folder() + "/claims.h", "-o", claims + ".gch"});
        CommandResult result = run_command(words);
        INFO(result.output);
        REQUIRE(result.is_well());
        words = compile_words({});
        words.insert(words.end(), {"-c", kit_folder() + "/runtime.cpp", "-o", runtime});
        result = run_command(words);
        INFO(result.output);
        REQUIRE(result.is_well());
    }
};

inline const CompiledKit& compiled_kit() {
    static const CompiledKit kit;
    return kit;
}

/// A program that was compiled, and its folder.
struct KitProgram {
    std::shared_ptr<TemporaryFolder> folder = std::make_shared<TemporaryFolder>();
    std::string path() const { return folder->file("program"); }
};

/// A file of a program.
struct SourceFile {
    std::string name, text;
};

/// Compiles the .cpp files of these with the kit before the folder, as a student's program is.
inline KitProgram compile_with_kit(const std::vector<SourceFile>& files,
                                   const KitOptions& options = {}) {
    KitProgram program;
    const CompiledKit& kit = compiled_kit();
    std::vector<std::string> words = compile_words(options);
    words.push_back("-I" + program.folder->file(""));
    words.insert(words.end(),
                 {"-include", options.has_fast_start ? kit.claims : kit_folder() + "/claims.h"});
    // As Rasterwalk does, the sources are in another folder than the program's headers.
    const std::string copies = program.folder->file("copies");
    REQUIRE(mkdir(copies.c_str(), 0700) == 0);
    for (const SourceFile& file : files) {
        const bool is_header =
            file.name.size() > 2 && file.name.substr(file.name.size() - 2) == ".h";
        const std::string path =
            program.folder->write(is_header ? file.name : "copies/" + file.name, file.text);
        if (!is_header) words.push_back(path);
    }
    words.insert(words.end(), {kit.runtime, "-o", program.path()});
    const CommandResult result = run_command(words);
    INFO(result.output);
    REQUIRE(result.is_well());
    return program;
}

inline KitProgram compile_with_kit(const std::string& main, const KitOptions& options = {}) {
    return compile_with_kit(std::vector<SourceFile>{{"main.cpp", main}}, options);
}

/// What a program has done.
struct KitRun {
    CommandResult ended;
    std::shared_ptr<const rasterwalk_kit::Recorded> recorded;

    const rasterwalk_kit::Progress& progress() const { return recorded->progress; }
    const rasterwalk_kit::Put& put(std::size_t i) const { return recorded->puts[i]; }
    /// A pixel of the picture: red, green, blue.
    std::vector<float> pixel(int x, int y) const {
        const float* at = recorded->picture + 3 * (y * progress().width + x);
        return {at[0], at[1], at[2]};
    }
};

/// Runs it and returns what it has recorded.
/// @param key held from the second frame on, as SDL 2 numbers it
/// @param word an argument of its main(); empty: it has none
inline KitRun run_recorded(const KitProgram& program, std::uint32_t frames = 1, int key = 0,
                           void (*prepare)() = nullptr, const std::string& word = {}) {
    using rasterwalk_kit::Recorded;
    const int descriptor = memfd_create("recorded", MFD_CLOEXEC);
    REQUIRE(descriptor >= 0);
    REQUIRE(ftruncate(descriptor, sizeof(Recorded)) == 0);
    void* memory =
        mmap(nullptr, sizeof(Recorded), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    REQUIRE(memory != MAP_FAILED);
    auto* recorded = static_cast<Recorded*>(memory);
    recorded->task.magic = rasterwalk_kit::recording_magic;
    recorded->task.frames = frames;
    recorded->task.key = key;
    KitRun run;
    run.recorded = {recorded, [](const Recorded* mapped) {
                        munmap(const_cast<Recorded*>(mapped), sizeof(Recorded));
                    }};
    std::vector<std::string> words = {program.path()};
    if (!word.empty()) words.push_back(word);
    run.ended = run_command(words, descriptor, prepare);
    close(descriptor);
    return run;
}

/// A line of the program's source.
struct SourcePlace {
    std::string function, line; ///< "draw(int)", "main.cpp:12"
};

/// Where a place of the program comes from, and where the functions are called that the compiler
/// has put in line there. At least one.
inline std::vector<SourcePlace> source_places(const KitProgram& program, std::uint64_t place) {
    char number[32] = {};
    std::snprintf(number, sizeof(number), "0x%llx", static_cast<unsigned long long>(place));
    const CommandResult result =
        run_command({"addr2line", "-s", "-f", "-i", "-C", "-e", program.path(), number});
    std::vector<SourcePlace> places;
    std::istringstream lines(result.output);
    SourcePlace next;
    while (std::getline(lines, next.function) && std::getline(lines, next.line)) {
        next.line = next.line.substr(0, next.line.find(' '));
        places.push_back(next);
    }
    REQUIRE(!places.empty());
    return places;
}

} // namespace rasterwalk::test
