#include "session/scene_file.h"

#include <array>
#include <string_view>

#include "base/files.h"
#include "scene/model_scene.h"
#include "scene/read_obj.h"
#include "scene/read_scene.h"
#include "settings/settings.h"

namespace rasterwalk {

Scene read_scene_file(const std::string& path, const ReadingWatch& watch) {
    if (is_model_file(path)) return scene_of_model(read_obj(path, {}, watch));
    std::array<std::string_view, stage_count> stages;
    for (std::size_t i = 0; i < stages.size(); ++i)
        stages[i] = stage_list()[i].name;
    if (path == "-") return parse_scene(read_input(path), standard_input_name, stages, watch);
    return read_scene(path, stages, watch);
}

} // namespace rasterwalk
