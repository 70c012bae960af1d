#include "session/content.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>

#include "base/error.h"
#include "base/quoted.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

bool holds_content(const fs::path& folder) {
    std::error_code ignored;
    return fs::is_regular_file(folder / "presets.toml", ignored);
}

/// The file in a folder, if it exists and the path does not lead out of the folder, not even
/// through a symbolic link.
std::optional<std::string> find_within(const fs::path& folder, const fs::path& relative) {
    std::error_code fault;
    const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, fault);
    if (fault) return std::nullopt;
    const fs::path file = fs::canonical(root / relative, fault);
    if (fault || !fs::is_regular_file(file, fault)) return std::nullopt;
    const auto [end, ignored] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
    if (end != root.end()) return std::nullopt;
    return (folder / relative).lexically_normal().string();
}

} // namespace

std::string lessons_folder() {
    if (const char* named = std::getenv("RASTERWALK_LESSONS"); named != nullptr && *named != '\0') {
        if (holds_content(named)) return named;
        throw AccessError(std::string("RASTERWALK_LESSONS names '") + named +
                          "', but there is no presets.toml in it.");
    }
    return own_lessons_folder();
}

std::string own_lessons_folder() {
    std::error_code fault;
    const fs::path program = fs::read_symlink("/proc/self/exe", fault);
    // The program is in a build folder, which has a link to the lessons, or deeper in it, or is
    // installed in bin/. A browser has its files at the root.
    constexpr int levels = 4;
    fs::path folder = fault ? fs::path("/") : program.parent_path();
    for (int level = 0; level < levels; ++level, folder = folder.parent_path()) {
        for (const char* place : {"lessons", "share/rasterwalk/lessons"}) {
            if (holds_content(folder / place)) return fs::canonical(folder / place).string();
        }
    }
    throw AccessError("the folder 'lessons' was not found; set RASTERWALK_LESSONS to its path.");
}

std::string find_lesson_file(const std::string& folder, std::string_view relative) {
    const fs::path path(relative);
    const bool leads_out =
        std::any_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
    if (path.empty() || path.is_absolute() || leads_out) {
        throw UsageError(in_quotes(relative) + " leads out of the lessons folder.");
    }
    if (const auto found = find_within(folder, path)) return *found;
    if (const auto found = find_within(lessons_folder(), path)) return *found;
    throw UsageError("there is no file " + in_quotes(relative) + " in the lessons folder.");
}

std::optional<std::string> name_in_lessons_folder(const std::string& path) {
    std::error_code fault;
    const fs::path folder = fs::weakly_canonical(lessons_folder(), fault);
    const fs::path name = fs::weakly_canonical(path, fault).lexically_relative(folder);
    if (fault || name.empty() || *name.begin() == "..") return std::nullopt;
    return name.generic_string();
}

std::string version_text() {
    return RASTERWALK_VERSION;
}

} // namespace rasterwalk
