#include "opening/view_options.h"

#include <cctype>

#include <CLI/CLI.hpp>

namespace rasterwalk {

namespace {

const char* const view_group = "View";

void add_text(CLI::App& command, const char* name, std::string& value, const char* help,
              const char* type) {
    command.add_option(name, value, help)->type_name(type)->group(view_group);
}

void add_texts(CLI::App& command, const char* name, std::vector<std::string>& values,
               const char* help, const char* type) {
    command.add_option(name, values, help)
        ->type_name(type)
        ->allow_extra_args(false)
        ->group(view_group);
}

} // namespace

void add_view_options(CLI::App& command, ViewOptions& o) {
    add_text(command, "--scene", o.scene,
             "Scene file (.toml), or one of the program's own as scenes/fence.toml; the lab's room "
             "if not given",
             "FILE");
    add_text(command, "--lesson", o.lesson,
             "The picture of a lesson, 05-row-table or a file (.md); what else is said here wins",
             "ID");
    add_text(command, "--step", o.step, "Step of the lesson; 0, its opening, if not given", "N");
    add_text(command, "--stage", o.stage,
             "points, edges, rows, fill, depth, vertex_light or pixel_light", "NAME");
    add_text(command, "--bug", o.bug,
             "A mistake of the bug laboratory, such as B9, on its own scene unless --scene names "
             "another",
             "ID");
    add_texts(command, "--preset", o.presets, "Named set of settings; repeatable", "NAME");
    add_texts(command, "--set", o.assignments, "One setting: name=value; repeatable", "NAME=VALUE");
    add_text(command, "--to", o.to,
             "Draw up to this moment: t12, t12/v1, t12/e2/s14, t12/r37/c5 or end", "CURSOR");
    add_text(command, "--size", o.size,
             "Size of the picture; the focal length follows unless it is set too", "WIDTHxHEIGHT");
    add_texts(command, "--vertices", o.vertices,
              "Where the vertices of a scene in pixels lie, as 10,5/5,10/15,15; of triangle 3: "
              "3:10,5/5,10/15,15; repeatable",
              "[N:]X,Y/X,Y/X,Y");
}

void add_plane_options(CLI::App& command, ViewOptions& o) {
    add_text(command, "--view", o.view, "Plane: colour, depth, triangle or overdraw", "PLANE");
    add_text(command, "--depth-range", o.depth_range,
             "Range of 1/z that the depth view colours; all that is there if not given",
             "FAR,NEAR");
}

void add_look_options(CLI::App& command, ViewOptions& o) {
    add_plane_options(command, o);
    add_text(command, "--tab", o.tab,
             "Tab of the inspector: vertices, rows, fragment, microscope, history, graph, "
             "settings, compare or lab",
             "NAME");
    add_texts(command, "--overlay", o.overlays,
              "Laid over the picture: wireframe, owner, overdraw, drawn_twice, depth, uncovered, "
              "over_one or affine_error; repeatable; none for none",
              "NAME");
    add_text(command, "--pixel", o.pixel, "Pixel that is picked, or none", "X,Y");
    add_text(command, "--triangle", o.triangle, "Triangle that is selected, from 0, or none", "N");
    add_text(command, "--row", o.row, "Row of the picture that is selected, from 0, or none", "N");
    add_text(command, "--vertex", o.vertex, "Vertex that is selected, 0 to 2, or none", "N");
    add_text(command, "--zoom", o.zoom,
             "Screen pixels for each pixel of the picture, 0.25 to 64, or fit", "NUMBER");
    add_text(command, "--centre", o.centre, "Place in the middle of the zoomed picture", "X,Y");
    add_text(command, "--grid", o.grid, "Grid of pixels from 8x on: on or off", "WORD");
    add_texts(command, "--b", o.b,
              "A second run beside the first, which differs by this setting; repeatable; none for "
              "no second run",
              "NAME=VALUE");
    add_text(command, "--compare-view", o.compare_view,
             "How two runs are shown: side_by_side, wipe, blink or difference", "NAME");
    add_text(command, "--wipe", o.wipe, "Place of the divider between them, 0 to 1", "NUMBER");
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
