#include "session/content.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "base/error.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

bool holds_content(const fs::path& folder) {
    std::error_code ignored;
    return fs::is_regular_file(folder / "presets.toml", ignored);
}

} // namespace

std::string lessons_folder() {
    if (const char* named = std::getenv("RASTERWALK_LESSONS"); named != nullptr && *named != '\0') {
        if (holds_content(named)) return named;
        throw AccessError(std::string("RASTERWALK_LESSONS names '") + named +
                          "', and there is no presets.toml in it.");
    }
    std::error_code fault;
    const fs::path program = fs::read_symlink("/proc/self/exe", fault);
    // The program lies in the project's build folder, or a folder deeper, or is installed in bin/.
    constexpr int levels = 4;
    fs::path folder = program.parent_path();
    for (int level = 0; !fault && level < levels; ++level, folder = folder.parent_path()) {
        if (holds_content(folder / "lessons")) return (folder / "lessons").string();
        if (holds_content(folder / "share/rasterwalk/lessons")) {
            return (folder / "share/rasterwalk/lessons").string();
        }
    }
    if (holds_content(RASTERWALK_LESSONS)) return RASTERWALK_LESSONS;
    throw AccessError("the folder 'lessons' was not found; set RASTERWALK_LESSONS to its place.");
}

std::string version_text() {
    return RASTERWALK_VERSION;
}

} // namespace rasterwalk
