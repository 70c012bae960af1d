#include "support/project_scenes.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include "session/content.h"
#include "session/scene_file.h"

namespace rasterwalk::test {

namespace {

void add_scenes(const std::string& folder, const char* extension, std::vector<Scene>& scenes) {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(lessons_folder() + folder)) {
        if (entry.path().extension() == extension) paths.push_back(entry.path().string());
    }
    std::sort(paths.begin(), paths.end());
    for (const std::string& path : paths)
        scenes.push_back(read_scene_file(path));
}

} // namespace

std::vector<Scene> project_scenes() {
    std::vector<Scene> scenes;
    add_scenes("/scenes", ".toml", scenes);
    return scenes;
}

std::vector<Scene> project_scenes_and_models() {
    std::vector<Scene> scenes = project_scenes();
    add_scenes("/models", ".obj", scenes);
    return scenes;
}

} // namespace rasterwalk::test
