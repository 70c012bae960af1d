// Draws the pictures of shots.txt, and one of each lesson, and compares them with the blessed ones,
// or blesses them.
//
//     picture_tests [--bless] [--list] [--shots=FILE] [--others=FOLDER] [--by=PROGRAM] [NAME...]
//
// NAME is a picture's file name without folder and ".png"; without names all are meant. FILE stands
// for shots.txt and the lessons. FOLDER holds the pictures that this version of Dear ImGui draws
// differently from the first version, which drew all others. PROGRAM takes the pictures in place of
// rasterwalk-offscreen. Exit codes: 0 all are as expected, 1 a picture differs, is missing or could
// not be taken, 2 wrong usage, 4 could not read or write. The last line names those that failed.

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>

#include "base/error.h"
#include "base/files.h"
#include "lessons/lesson.h"
#include "lessons/lesson_list.h"
#include "tests/support/compare_images.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

const fs::path root = RASTERWALK_ROOT;
const fs::path shots_path = root / "tests/pictures/shots.txt";

/// What takes the pictures, and where those that failed go, from the root.
std::string program = RASTERWALK_OFFSCREEN;
fs::path failed_folder = "tests/failed";

struct Shot {
    std::string name;
    std::string path; ///< of the blessed picture, from the root
    std::vector<std::string> arguments;
};

/// The folder, from the root, of pictures that are drawn differently here; empty if none are.
std::string others_folder = RASTERWALK_OTHERS;

/// The words of a line, up to a # that begins a word.
std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> words;
    bool is_quoted = false, is_open = false;
    for (const char c : line) {
        if (c == '"') {
            is_quoted = !is_quoted;
            if (!is_open) words.emplace_back();
            is_open = true;
        } else if (!is_quoted && std::isspace(static_cast<unsigned char>(c)) != 0) {
            is_open = false;
        } else {
            if (!is_open && c == '#') break;
            if (!is_open) words.emplace_back();
            is_open = true;
            words.back() += c;
        }
    }
    return words;
}

/// A picture of each lesson: the step that its head names.
std::vector<Shot> lesson_shots() {
    std::vector<std::string> paths;
    for (const auto& entry : fs::directory_iterator(root / "lessons")) {
        if (is_lesson_file(entry.path().filename().string()))
            paths.push_back(entry.path().string());
    }
    std::sort(paths.begin(), paths.end());
    std::vector<Shot> shots;
    for (const std::string& path : paths) {
        const Lesson lesson = read_lesson(path);
        if (!lesson.faults.empty()) throw InputError(fault_text(lesson, lesson.faults.front()));
        const std::string name = "lesson-" + lesson.id;
        shots.push_back({name,
                         "screenshots/" + name + ".png",
                         {"--lesson", lesson.id, "--step", std::to_string(lesson.picture)}});
    }
    return shots;
}

/// Adds the shots of a file to these.
void read_shots(const fs::path& path, std::vector<Shot>& shots) {
    std::string line;
    const std::string text = read_file(path.string()) + "\n";
    for (const char c : text) {
        if (c != '\n') {
            line += c;
            continue;
        }
        std::vector<std::string> words = words_of(line);
        line.clear();
        if (words.empty()) continue;
        Shot shot{fs::path(words[0]).stem().string(), words[0], {}};
        shot.arguments.assign(words.begin() + 1, words.end());
        const bool is_new = std::none_of(shots.begin(), shots.end(),
                                         [&](const Shot& s) { return s.name == shot.name; });
        if (!is_new) throw InputError(path.string() + ": '" + shot.name + "' is there twice.");
        shots.push_back(std::move(shot));
    }
}

/// Calls the program. Returns its exit code.
int take_picture(const Shot& shot, const fs::path& output) {
    std::vector<std::string> words{program, "-o", output.string()};
    words.insert(words.end(), shot.arguments.begin(), shot.arguments.end());
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    if (posix_spawn(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) {
        throw AccessError(words[0] + " cannot be started.");
    }
    int status = 0;
    if (waitpid(child, &status, 0) != child) throw AccessError(words[0] + " got lost.");
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

fs::path failed_path(const Shot& shot, const char* what) {
    return root / failed_folder / (shot.name + "." + what + ".png");
}

void remove_failed(const Shot& shot) {
    std::error_code ignored;
    for (const char* what : {"actual", "expected", "difference"})
        fs::remove(failed_path(shot, what), ignored);
}

/// The picture among those that are drawn differently, if there are any, from the root.
std::string other_path(const Shot& shot) {
    return others_folder.empty() ? shot.path : others_folder + "/" + shot.name + ".png";
}

bool is_there(const std::string& path) {
    std::error_code ignored;
    return fs::exists(root / path, ignored);
}

/// Is there a picture, and does this one differ from it by no more than the tolerance?
bool agrees(const Image& actual, const std::string& path) {
    return is_there(path) &&
           compare_images(actual, read_image((root / path).string()), interface_tolerance)
               .is_within_tolerance;
}

/// Puts the picture in place of the blessed one, or among those that are drawn differently.
/// Where it agrees nothing is written, so that another machine does not rewrite all of them.
void bless(const Shot& shot, const Image& actual) {
    const std::string other = other_path(shot);
    if (agrees(actual, shot.path)) {
        std::error_code ignored;
        if (other != shot.path) fs::remove(root / other, ignored);
        std::cout << "kept     " << shot.path << '\n';
        return;
    }
    if (agrees(actual, other)) {
        std::cout << "kept     " << other << '\n';
        return;
    }
    const std::string path = is_there(shot.path) ? other : shot.path;
    std::cout << (is_there(path) ? "changed  " : "new      ") << path << '\n';
    fs::create_directories((root / path).parent_path());
    write_png(actual, (root / path).string());
}

/// Returns true if the picture is as expected.
bool check(const Shot& shot, const Image& actual) {
    const std::string other = other_path(shot), path = is_there(other) ? other : shot.path;
    if (!is_there(path)) {
        std::cout << shot.name << ": there is no picture " << path << " yet. Look at "
                  << failed_folder.string() << '/' << shot.name
                  << ".actual.png and bless it with ./test --bless.\n";
        return false;
    }
    const Image expected = read_image((root / path).string());
    if (compare_images(actual, expected, interface_tolerance).is_within_tolerance) {
        remove_failed(shot);
        std::cout << shot.name << ": as expected.\n";
        return true;
    }
    write_png(expected, failed_path(shot, "expected").string());
    write_png(difference_image(actual, expected, interface_tolerance),
              failed_path(shot, "difference").string());
    std::cout << shot.name << " differs from " << path << ".\n"
              << describe_difference(actual, expected, interface_tolerance) << "  See "
              << failed_folder.string() << '/' << shot.name
              << ".{actual,expected,difference}.png; ./test --bless accepts the new picture.\n";
    return false;
}

/// Returns true if all went well.
bool process(const Shot& shot, bool is_blessing) {
    remove_failed(shot);
    fs::create_directories(root / failed_folder);
    const fs::path path = failed_path(shot, "actual");
    const int exit_code = take_picture(shot, path);
    if (exit_code != 0) {
        std::cout << shot.name << ": rasterwalk-offscreen ended with exit code " << exit_code
                  << ".\n";
        return false;
    }
    const Image actual = read_image(path.string());
    if (!is_blessing) return check(shot, actual);
    bless(shot, actual);
    remove_failed(shot);
    return true;
}

/// The same; a picture that cannot be read or written has failed too, and the others go on.
bool succeeds(const Shot& shot, bool is_blessing) {
    try {
        return process(shot, is_blessing);
    } catch (const Error& fault) {
        std::cout << shot.name << ": " << fault.what() << '\n';
        return false;
    }
}

int run(const std::vector<std::string>& words) {
    bool is_blessing = false, is_listing = false;
    constexpr std::string_view shots_option = "--shots=", others_option = "--others=",
                               program_option = "--by=";
    std::vector<Shot> shots;
    std::vector<std::string> names;
    for (const std::string& word : words) {
        if (word == "--bless") {
            is_blessing = true;
        } else if (word == "--list") {
            is_listing = true;
        } else if (word.starts_with(shots_option)) {
            read_shots(word.substr(shots_option.size()), shots);
        } else if (word.starts_with(others_option)) {
            others_folder = word.substr(others_option.size());
        } else if (word.starts_with(program_option)) {
            program = word.substr(program_option.size());
            failed_folder /= fs::path(program).filename();
        } else {
            names.push_back(word);
        }
    }
    if (shots.empty()) {
        shots = lesson_shots();
        read_shots(shots_path, shots);
    }
    for (const std::string& name : names) {
        if (std::none_of(shots.begin(), shots.end(),
                         [&](const Shot& shot) { return shot.name == name; })) {
            throw UsageError("there is no picture '" + name + "': see --list.");
        }
    }
    std::string failed;
    for (const Shot& shot : shots) {
        if (!names.empty() && std::find(names.begin(), names.end(), shot.name) == names.end()) {
            continue;
        }
        if (is_listing) {
            std::cout << shot.name << '\n';
        } else if (!succeeds(shot, is_blessing)) {
            failed += " " + shot.name;
        }
    }
    if (failed.empty()) return static_cast<int>(ExitCode::done);
    std::cout << "failed:" << failed << '\n';
    return static_cast<int>(ExitCode::difference);
}

} // namespace

} // namespace rasterwalk

int main(int argc, char** argv) {
    try {
        return rasterwalk::run({argv + 1, argv + argc});
    } catch (const rasterwalk::Error& fault) {
        std::cerr << "picture_tests: " << fault.what() << '\n';
        return static_cast<int>(fault.code);
    } catch (const std::exception& fault) {
        std::cerr << "picture_tests: " << fault.what() << '\n';
        return static_cast<int>(rasterwalk::ExitCode::no_access);
    }
}
