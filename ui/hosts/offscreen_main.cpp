#include <cstdio>
#include <exception>
#include <iostream>
#include <map>
#include <new>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/error.h"
#include "base/image.h"
#include "base/language_files.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "cli/package_option.h"
#include "opening/view_options.h"
#include "session/content.h"
#include "ui/hosts/offscreen.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

/// The command line as written.
struct Arguments {
    std::string output;
    ViewOptions view;
    std::string window = "1600x1000";
    std::string theme = "dark";
    float text_scale = 1.0f;
    std::vector<std::string> clicks, hovers, picks, presses;
    OffscreenOptions options;
};

using ActionOptions =
    std::map<const CLI::Option*, std::pair<HandAction::Kind, std::vector<std::string>*>>;

ActionOptions describe(CLI::App& app, Arguments& a) {
    app.set_version_flag("--version", "rasterwalk-offscreen " + version_text());
    app.footer("--click, --hover, --pick and --press are done in the order given.\nExit codes: 0 "
               "done, 2 wrong usage, 3 bad input, 4 could not read or write.");
    app.add_option("FILE", a.view.file,
                   "Scene (.toml), model (.obj), lesson (.md) or saved view (.walk.toml) to open");
    app.add_option("-o,--output", a.output, "PNG file to write")->type_name("FILE")->required();
    add_view_options(app, a.view);
    add_look_options(app, a.view);
    const auto text = [&](const char* names, std::string& value, const char* help,
                          const char* type) {
        app.add_option(names, value, help)->type_name(type)->group("Window");
    };
    text("--window", a.window, "Size of the window, 320x240 to 8192x8192", "WIDTHxHEIGHT");
    app.add_option("--text-scale", a.text_scale, "Size of the text; 1 is 16 pixels")
        ->group("Window");
    text("--theme", a.theme, "dark or light", "NAME");
    text("--language", a.options.ui.language, "Language of the texts, such as sv", "CODE");
    text("--ladder-times", a.options.ladder_times,
         "Show the times in this file in the Speed tab, instead of times of this machine", "FILE");
    text("--code", a.options.code, "Check this program (.cpp, or its folder) first", "FILE");
    text("--report-widgets", a.options.report_path,
         "Write the names and positions of all widgets to this file; - for standard output",
         "FILE");

    add_package_option(app);
    ActionOptions actions;
    const auto action = [&](const char* name, std::vector<std::string>& values,
                            HandAction::Kind kind, const char* help, const char* type) {
        CLI::Option* const option = app.add_option(name, values, help);
        option->type_name(type)->allow_extra_args(false)->group("Window");
        actions[option] = {kind, &values};
    };
    action("--click", a.clicks, HandAction::Kind::click, "Click on a widget; repeatable", "NAME");
    action("--hover", a.hovers, HandAction::Kind::hover, "Point at a widget; repeatable", "NAME");
    action("--pick", a.picks, HandAction::Kind::pick, "Click on a pixel of the picture; repeatable",
           "X,Y");
    action("--press", a.presses, HandAction::Kind::press, "Press a key, such as Ctrl+Z; repeatable",
           "KEY");
    return actions;
}

/// The actions of all kinds in the order in which they were written.
std::vector<HandAction> in_order(const CLI::App& app, const ActionOptions& options) {
    std::map<const CLI::Option*, std::size_t> taken;
    std::vector<HandAction> actions;
    for (const CLI::Option* option : app.parse_order()) {
        const auto found = options.find(option);
        if (found == options.end()) continue;
        const auto& [kind, values] = found->second;
        actions.push_back({kind, values->at(taken[option]++)});
    }
    return actions;
}

void read_window(const std::string& text, OffscreenOptions& options) {
    char rest = 0;
    const bool is_size =
        std::sscanf(text.c_str(), "%5dx%5d%c", &options.width, &options.height, &rest) == 2;
    if (!is_size || options.width < smallest_offscreen_width ||
        options.height < smallest_offscreen_height || options.width > largest_offscreen_side ||
        options.height > largest_offscreen_side) {
        throw UsageError("--window must be a size from 320x240 to 8192x8192, not '" + text + "'.");
    }
}

void check_range(const char* name, float value, float smallest, float largest) {
    if (value >= smallest && value <= largest) return;
    const auto number = [](float of) { return significant(static_cast<double>(of), 6); };
    throw UsageError(fmt::format("{} must be a number from {} to {}, not {}.", name,
                                 number(smallest), number(largest), number(value)));
}

/// Makes options and session from the arguments. Throws Error.
Session understand(Arguments& a) {
    OffscreenOptions& options = a.options;
    read_window(a.window, options);
    check_range("--text-scale", a.text_scale, smallest_text_scale, largest_text_scale);
    options.ui.wished_text_scale = a.text_scale;
    if (a.theme != "dark" && a.theme != "light") {
        throw UsageError("--theme must be dark or light, not '" + a.theme + "'.");
    }
    options.ui.theme = a.theme == "light" ? Theme::light : Theme::dark;
    if (!options.ui.language.empty()) read_language(lessons_folder(), options.ui.language);
    // A tab requested by name comes in front of anything over the inspector.
    const auto tab = a.view.given.find("tab");
    if (tab != a.view.given.end()) options.tab = tab->second.back();
    return open_view(a.view);
}

/// Reads the arguments. Prints help or version if they ask for it, and then returns false.
bool parse(CLI::App& app, std::vector<std::string> words) {
    restore_arguments(app);
    std::reverse(words.begin(), words.end()); // the order that CLI11 needs
    try {
        app.parse(std::move(words));
        return true;
    } catch (const CLI::ParseError& fault) {
        if (fault.get_exit_code() == 0) {
            app.exit(fault);
            return false;
        }
        std::string sentence = fault.what();
        if (!sentence.ends_with('.')) sentence += '.';
        throw UsageError(sentence + " See rasterwalk-offscreen --help.");
    }
}

int run(int argc, const char* const* argv) {
    CLI::App app{"Draws the window of Rasterwalk as a picture, without a display.",
                 "rasterwalk-offscreen"};
    Arguments arguments;
    const ActionOptions actions = describe(app, arguments);
    if (parse(app, command_arguments(argc, argv))) {
        Session session = understand(arguments);
        arguments.options.actions = in_order(app, actions);
        write_png(draw_offscreen(std::move(session), arguments.options), arguments.output);
    }
    std::cout.flush();
    if (!std::cout) throw AccessError("the output could not be written.");
    return static_cast<int>(ExitCode::done);
}

} // namespace

} // namespace rasterwalk

int main(int argc, char** argv) {
    using rasterwalk::ExitCode;
    const auto complain = [](const char* sentence, ExitCode code) {
        std::cerr << "rasterwalk-offscreen: " << rasterwalk::visible_line(sentence) << '\n';
        return static_cast<int>(code);
    };
    try {
        return rasterwalk::run(argc, argv);
    } catch (const rasterwalk::Error& fault) {
        return complain(fault.what(), fault.code);
    } catch (const std::bad_alloc&) {
        return complain("there is not enough memory for this.", ExitCode::no_access);
    } catch (const std::exception& fault) {
        return complain(fault.what(), ExitCode::no_access);
    }
}
