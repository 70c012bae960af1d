#include "opening/view_options.h"

#include <cctype>

#include <CLI/CLI.hpp>

#include "view/view_table.h"

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

/// Does it begin like a negative number?
bool begins_negative(std::string_view argument) {
    return argument.size() > 1 && argument[0] == '-' &&
           std::isdigit(static_cast<unsigned char>(argument[1])) != 0;
}

/// The option of a field of the view.
void add_field(CLI::App& command, ViewOptions& o, const ViewField& field) {
    const ViewOption& option = field.option;
    const auto take = [&o, &field](const std::vector<std::string>& words) {
        // An empty word counts as no option.
        if (!field.option.is_repeatable && words.back().empty()) return;
        o.given[std::string(field.key)] = words;
    };
    CLI::Option* const made = command.add_option_function<std::vector<std::string>>(
        option_name(field), take, std::string(option.help));
    made->type_name(std::string(option.type))->group(view_group);
    if (!option.is_repeatable) made->expected(1);
    made->allow_extra_args(false); // what follows the word does not belong to the option
}

void add_part(CLI::App& command, ViewOptions& o, ViewPart part) {
    for (const ViewField& field : view_table()) {
        if (field.part == part && field.parse) add_field(command, o, field);
    }
}

} // namespace

void add_view_options(CLI::App& command, ViewOptions& o) {
    add_text(command, "--scene", o.scene,
             "Scene (.toml) or model (.obj), or one of the program's own, like scenes/fence.toml; "
             "if not given, the lab's room",
             "FILE");
    add_text(command, "--texture", o.texture,
             "Image for every part of the model that has none of its own", "FILE");
    add_text(command, "--lesson", o.lesson,
             "The picture of a lesson, like 05-row-table or a file (.md); other options override "
             "it",
             "ID");
    add_text(command, "--step", o.step, "Step of the lesson; if not given, 0, its opening", "N");
    add_text(command, "--stage", o.stage,
             "points, edges, rows, fill, depth, vertex_light or pixel_light", "NAME");
    add_text(command, "--bug", o.bug,
             "A mistake from the bug laboratory, such as B9, on its own scene unless --scene names "
             "another",
             "ID");
    add_texts(command, "--preset", o.presets, "Named set of settings; repeatable", "NAME");
    add_texts(command, "--set", o.assignments, "One setting: name=value; repeatable", "NAME=VALUE");
    add_field(command, o, view_field("cursor"));
    add_text(command, "--size", o.size,
             "Size of the picture; the focal length follows unless it is set too", "WIDTHxHEIGHT");
    add_field(command, o, view_field("vertices"));
}

void add_plane_options(CLI::App& command, ViewOptions& o) {
    add_part(command, o, ViewPart::plane);
}

void add_look_options(CLI::App& command, ViewOptions& o) {
    for (const ViewPart part : {ViewPart::plane, ViewPart::panel, ViewPart::selection,
                                ViewPart::canvas, ViewPart::runs}) {
        add_part(command, o, part);
    }
}

std::vector<std::string> command_arguments(int argc, const char* const* argv) {
    std::vector<std::string> arguments;
    for (int i = 1; i < argc; ++i) {
        std::string argument = argv[i];
        // The blank keeps CLI11 from seeing an option.
        if (begins_negative(argument)) argument.insert(0, " ");
        arguments.push_back(std::move(argument));
    }
    return arguments;
}

void restore_arguments(CLI::App& app) {
    const auto without_blank = [](const std::string& argument) {
        const bool has_blank = argument.starts_with(' ') && begins_negative(argument.substr(1));
        return has_blank ? argument.substr(1) : argument;
    };
    for (CLI::Option* const option : app.get_options()) {
        if (option->get_items_expected_max() > 0) option->transform(without_blank);
    }
    for (CLI::App* const command : app.get_subcommands({}))
        restore_arguments(*command);
}

} // namespace rasterwalk
