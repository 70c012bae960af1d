#include "cli/manual_page.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/text_parts.h"
#include "cli/shown_options.h"
#include "session/content.h"

namespace rasterwalk {

namespace {

/// Text as groff reads it: nothing in it is a command, and what is written as "-" stays one.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char letter : text) {
        if (letter == '\\')
            result += "\\e";
        else if (letter == '-')
            result += "\\-";
        else
            result += letter;
    }
    if (result.starts_with('.') || result.starts_with('\'')) result.insert(0, "\\&");
    return result;
}

std::string in_capitals(std::string text) {
    for (char& letter : text)
        if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
    return text;
}

std::string sentence(const std::string& text) {
    return escaped(text.ends_with('.') ? text : text + '.');
}

std::string heading_of(const ShownOption& option) {
    std::string names;
    for (const std::string& name : option.names)
        names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", escaped(name));
    if (option.names.empty()) return fmt::format("\\fI{}\\fR", escaped(option.value));
    return option.value.empty() ? names
                                : fmt::format("{} \\fI{}\\fR", names, escaped(option.value));
}

std::string entry(const ShownOption& option) {
    return fmt::format(".TP\n{}\n{}\n", heading_of(option), sentence(option.about));
}

/// The lines as they are.
std::string footer_of(const CLI::App& app) {
    const std::string footer = app.get_footer();
    if (footer.empty()) return {};
    std::string lines = ".PP\n.nf\n";
    for (const std::string_view line : split_lines(footer))
        lines += escaped(line) + '\n';
    return lines + ".fi\n";
}

std::string positionals_of(const std::vector<ShownOption>& options) {
    std::string words;
    for (const ShownOption& option : options)
        if (option.names.empty())
            words += option.is_required ? ' ' + option.value : " [" + option.value + ']';
    return words;
}

std::string part_on(const CLI::App& command, const std::vector<ShownOption>& explained) {
    std::string text, shared;
    const std::vector<ShownOption> options = shown_options(command);
    for (const ShownOption& option : options) {
        if (std::find(explained.begin(), explained.end(), option) == explained.end())
            text += entry(option);
        else if (!option.names.empty())
            shared += fmt::format("{}\\fB{}\\fR", shared.empty() ? "" : ", ",
                                  escaped(option.names.back()));
    }
    if (!shared.empty()) text += ".PP\nAs above: " + shared + ".\n";
    return fmt::format(".SS {} [OPTION]...{}\n{}\n{}{}", command.get_name(),
                       escaped(positionals_of(options)), sentence(command.get_description()), text,
                       footer_of(command));
}

/// What the help of the program with the commands has no place for.
constexpr std::string_view surroundings = R"(.SH ENVIRONMENT
.TP
\fBRASTERWALK_LESSONS\fR
A folder of lessons, scenes and models in place of those that were installed.
.TP
\fBRASTERWALK_PAGE\fR
The address of the course's page; links to a view that are copied begin with it.
.SH FILES
.TP
\fIshare/rasterwalk/lessons\fR
The lessons, below the folder that the program was installed in. README.md, TEACHING.md,
CHECKING\-HAND\-INS.md and ON\-THE\-WEB.md are in it.
.TP
\fI~/.local/state/rasterwalk\fR
The progress in the lessons and the look of the window.
.TP
\fI~/.cache/rasterwalk\fR
Compiled headers for programs that were checked. It may be deleted.
)";

} // namespace

std::string manual_page(const CLI::App& app) {
    const std::string name = escaped(app.get_name());
    const std::string about = app.get_description();
    const std::vector<ShownOption> options = shown_options(app);
    const auto commands = app.get_subcommands({});
    std::string page =
        fmt::format(".TH {} 1 \"\" \"Rasterwalk {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n"
                    ".SH SYNOPSIS\n\\fB{}\\fR [OPTION]...{}\n",
                    in_capitals(name), version_text(), name,
                    escaped(about.substr(0, about.find_last_not_of('.') + 1)), name,
                    escaped(positionals_of(options)));
    if (!commands.empty()) page += fmt::format(".br\n\\fB{}\\fR COMMAND [OPTION]...\n", name);
    std::string group;
    for (const ShownOption& option : options) {
        if (option.group != group) page += fmt::format(".SH {}\n", in_capitals(option.group));
        group = option.group;
        page += entry(option);
    }
    if (!commands.empty()) page += ".SH COMMANDS\n";
    for (const CLI::App* command : commands)
        page += part_on(*command, options);
    if (!commands.empty()) page += surroundings;
    return page + ".SH NOTES\n" + footer_of(app);
}

} // namespace rasterwalk
