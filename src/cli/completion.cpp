#include "cli/completion.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/shown_options.h"

namespace rasterwalk {

namespace {

bool names_file(const ShownOption& option) {
    return option.value == "FILE" || option.value == "FOLDER" || option.value == "PATH";
}

/// The text with each of these letters after a backslash.
std::string with_backslashes(std::string_view text, std::string_view letters) {
    std::string result;
    for (const char letter : text) {
        if (letters.find(letter) != std::string_view::npos) result += '\\';
        result += letter;
    }
    return result;
}

/// The names of the options that `are_wanted`, between blanks.
template <typename Wanted>
std::string names_of(const CLI::App& app, Wanted are_wanted) {
    std::string names = " ";
    for (const ShownOption& option : shown_options(app))
        for (const std::string& name : option.names)
            if (are_wanted(option)) names += name + ' ';
    return names;
}

std::string command_names(const CLI::App& app, std::string_view separator) {
    std::string names;
    for (const CLI::App* command : app.get_subcommands({})) {
        if (!names.empty()) names += separator;
        names += command->get_name();
    }
    return names;
}

/// A branch of `case $command in` for the program without a command, and for each command.
template <typename Branch>
std::string branches(const CLI::App& app, Branch branch) {
    std::string text = fmt::format("    '')\n{}        ;;\n", branch(app));
    for (const CLI::App* command : app.get_subcommands({}))
        text += fmt::format("    {})\n{}        ;;\n", command->get_name(), branch(*command));
    return text;
}

std::string function_name(const CLI::App& app) {
    std::string name = '_' + app.get_name();
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

/// Names a file among the others of the program or command, as zsh's _arguments wants it.
std::string zsh_option(const ShownOption& option) {
    const std::string about = with_backslashes(option.about, "\\[]:");
    const std::string value = option.value.empty()
                                  ? ""
                                  : fmt::format(":{}:{}", with_backslashes(option.value, "\\:"),
                                                names_file(option) ? "_files" : " ");
    std::string specs;
    for (const std::string& name : option.names) {
        std::string spec = fmt::format("*{}[{}]{}", name, about, value);
        for (std::size_t at = 0; (at = spec.find('\'', at)) != std::string::npos; at += 4)
            spec.replace(at, 1, "'\\''");
        specs += fmt::format(" \\\n            '{}'", spec);
    }
    return specs;
}

} // namespace

std::string bash_completion(const CLI::App& app) {
    const auto branch = [](const CLI::App& part) {
        return fmt::format("        options='{}'\n        values='{}'\n",
                           names_of(part, [](const ShownOption&) { return true; }),
                           names_of(part, [](const ShownOption& o) {
                               return !o.value.empty() && !names_file(o);
                           }));
    };
    const std::string has_value =
        names_of(app, [](const ShownOption& option) { return !option.value.empty(); });
    const std::string names = command_names(app, " ");
    return fmt::format(
        R"(# Completion for bash, made of the options of {0}.
{1}() {{
    local word=$2 before=$3 command= options values i
    for ((i = 1; i < COMP_CWORD; ++i)); do
        [[ '{2}' == *" ${{COMP_WORDS[i - 1]}} "* ]] && continue
        [[ ' {3} ' == *" ${{COMP_WORDS[i]}} "* ]] && command=${{COMP_WORDS[i]}} && break
    done
    case $command in
{4}    esac
    COMPREPLY=()
    if [[ $values == *" $before "* ]]; then
        compopt +o default
    elif [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$word"))
    elif [[ -z $command && $options != *" $before "* ]]; then
        COMPREPLY=($(compgen -W '{3}' -- "$word"))
    fi
}}
# Files, if nothing else fits.
complete -o default -F {1} {0})",
        app.get_name(), function_name(app), has_value, names, branches(app, branch));
}

std::string zsh_completion(const CLI::App& app) {
    const std::string names = command_names(app, " ");
    const auto branch = [&](const CLI::App& part) {
        std::string text = "        _arguments";
        for (const ShownOption& option : shown_options(part))
            text += zsh_option(option);
        const bool with_commands = &part == &app && !names.empty();
        return text +
               (with_commands ? fmt::format(" \\\n            '1: :_alternative "
                                            "\"commands:command:({})\" \"files:file:_files\"'",
                                            names)
                              : std::string(" \\\n            '*:file:_files'")) +
               '\n';
    };
    return fmt::format(R"(#compdef {0}
# Completion for zsh, made of the options of {0}.
local command= word
for word in ${{words[2,CURRENT-1]}}; do
    [[ " {1} " == *" $word "* ]] && command=$word && break
done
case $command in
{2}esac)",
                       app.get_name(), names, branches(app, branch));
}

std::string fish_completion(const CLI::App& app) {
    std::string text =
        fmt::format("# Completion for fish, made of the options of {}.\n", app.get_name());
    const auto quoted = [](std::string_view part) {
        return '\'' + with_backslashes(part, "\\'") + '\'';
    };
    const auto add = [&](const CLI::App& part, const std::string& when) {
        for (const ShownOption& option : shown_options(part)) {
            if (option.names.empty()) continue;
            text += fmt::format("complete -c {}{}", app.get_name(), when);
            for (const std::string& name : option.names)
                text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            if (!option.value.empty()) text += names_file(option) ? " -r -F" : " -x";
            text += fmt::format(" -d {}\n", quoted(option.about));
        }
    };
    const auto commands = app.get_subcommands({});
    const std::string no_command = commands.empty() ? "" : " -n __fish_use_subcommand";
    add(app, no_command);
    for (const CLI::App* command : commands) {
        text += fmt::format("complete -c {}{} -a {} -d {}\n", app.get_name(), no_command,
                            command->get_name(), quoted(command->get_description()));
        add(*command, fmt::format(" -n '__fish_seen_subcommand_from {}'", command->get_name()));
    }
    return text;
}

} // namespace rasterwalk
