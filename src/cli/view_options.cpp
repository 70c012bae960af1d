#include "cli/view_options.h"

#include <cctype>
#include <optional>

#include <CLI/CLI.hpp>

#include "scene/error.h"
#include "session/bug.h"
#include "session/content.h"
#include "session/moments.h"
#include "session/setting_table.h"

namespace rasterwalk {

namespace {

/// Gives the picture another size and the same field of view.
void set_size(Settings& settings, SceneSpace space, const std::string& size) {
    const float old_height = static_cast<float>(settings.viewport.height);
    set_value(settings, *find_setting("viewport.size"), size);
    if (space == SceneSpace::pixels) return;
    const float focal_length =
        settings.camera.focal_length * (static_cast<float>(settings.viewport.height) / old_height);
    set_value(settings, *find_setting("camera.focal_length"), number_text(focal_length));
}

} // namespace

void add_view_options(CLI::App& command, ViewOptions& options) {
    const char* const group = "View";
    command.add_option("--scene", options.scene, "Scene file (.toml); the lab's room if not given")
        ->type_name("FILE")
        ->group(group);
    command
        .add_option("--stage", options.stage,
                    "points, edges, rows, fill, depth, vertex_light or pixel_light")
        ->type_name("NAME")
        ->group(group);
    command
        .add_option("--bug", options.bug,
                    "A mistake of the bug laboratory, such as B9, on its own scene unless --scene "
                    "names another")
        ->type_name("ID")
        ->group(group);
    command.add_option("--preset", options.presets, "Named set of settings; repeatable")
        ->type_name("NAME")
        ->allow_extra_args(false)
        ->group(group);
    command.add_option("--set", options.assignments, "One setting: name=value; repeatable")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false)
        ->group(group);
    command
        .add_option("--to", options.to,
                    "Draw up to this moment: t12, t12/v1, t12/e2/s14, t12/r37/c5 or end")
        ->type_name("CURSOR")
        ->group(group);
    command
        .add_option("--size", options.size,
                    "Size of the picture; the focal length follows unless it is set too")
        ->type_name("WIDTHxHEIGHT")
        ->group(group);
}

Session open_view(const ViewOptions& options) {
    std::string scene = options.scene;
    std::optional<Bug> bug;
    if (!options.bug.empty()) bug = find_bug(read_bugs(), options.bug);
    if (scene.empty()) {
        scene = lessons_folder() + "/" + (bug ? bug->scene : std::string("scenes/lab-room.toml"));
    }
    Session session = open_session(scene);
    Settings& settings = session.settings;
    if (!options.size.empty()) set_size(settings, session.scene->space, options.size);
    if (bug) apply_bug(*bug, session);
    for (const std::string& name : options.presets) {
        apply_preset(find_preset(session.presets, name), settings);
    }
    if (!options.stage.empty()) set_value(settings, *find_setting("stage"), options.stage);
    for (const std::string& assignment : options.assignments)
        set_from_text(settings, assignment);
    if (!options.to.empty()) {
        session.cursor = moment_of(prepare_frame(*session.scene, settings), options.to);
    }
    return session;
}

std::vector<std::string> command_arguments(int argc, const char* const* argv) {
    std::vector<std::string> arguments;
    for (int i = 1; i < argc; ++i) {
        std::string argument = argv[i];
        const bool is_negative = argument.size() > 1 && argument[0] == '-' &&
                                 std::isdigit(static_cast<unsigned char>(argument[1])) != 0;
        // A blank in front keeps CLI11 from seeing an option; numbers are read without it.
        if (is_negative) argument.insert(0, " ");
        arguments.push_back(std::move(argument));
    }
    return arguments;
}

} // namespace rasterwalk
