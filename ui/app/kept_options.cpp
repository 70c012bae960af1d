#include "ui/app/kept_options.h"

#include <filesystem>
#include <sstream>

#include "base/error.h"
#include "base/files.h"
#include "base/toml_input.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

constexpr std::size_t largest_options = std::size_t{1} << 16; ///< bytes

void give_up(Ui& ui, const Error& fault) {
    ui.options_path.clear();
    ui.session.notice =
        std::string("The look of the window will not be kept: ").append(fault.what());
}

} // namespace

std::string options_text(const UiOptions& options) {
    toml::table table{{"theme", options.theme == Theme::dark ? "dark" : "light"},
                      {"text_scale", options.wished_text_scale},
                      {"lesson_width", options.lesson_width},
                      {"inspector_width", options.inspector_width}};
    if (options.score.is_kept) {
        table.insert("quiz_points", options.score.points);
        table.insert("quiz_rounds", options.score.rounds);
    }
    std::ostringstream out;
    out << table << '\n';
    return out.str();
}

UiOptions parse_options(std::string_view text, const std::string& path, UiOptions options) {
    const toml::table root = parse_toml(text, path);
    const TomlInput input(root, path, "the look of the window");
    input.allow_only(
        {"theme", "text_scale", "lesson_width", "inspector_width", "quiz_points", "quiz_rounds"});
    if (input.find("theme") != nullptr) {
        const std::string theme = input.text("theme");
        if (theme != "dark" && theme != "light") {
            input.fail(*input.find("theme"), "'theme' is \"dark\" or \"light\".");
        }
        options.theme = theme == "dark" ? Theme::dark : Theme::light;
    }
    input.read("text_scale", options.wished_text_scale, smallest_text_scale, largest_text_scale);
    input.read("lesson_width", options.lesson_width, 0.0f, 0.9f);
    input.read("inspector_width", options.inspector_width, 0.0f, 0.9f);
    options.score.is_kept = input.find("quiz_rounds") != nullptr;
    input.read("quiz_points", options.score.points, 0, largest_score);
    input.read("quiz_rounds", options.score.rounds, 0, largest_score);
    return options;
}

void keep_options(Ui& ui, const std::string& path) {
    ui.options_path = path;
    try {
        if (path.empty()) throw AccessError("there is no home folder.");
        std::error_code fault;
        if (std::filesystem::exists(path, fault) || fault) {
            ui.options = parse_options(read_file(path, largest_options), path, ui.options);
            ui.style_is_stale = true;
        }
        ui.kept_options = options_text(ui.options);
    } catch (const Error& error) {
        give_up(ui, error);
    }
}

void save_options(Ui& ui) {
    if (ui.options_path.empty()) return;
    std::string text = options_text(ui.options);
    if (text == ui.kept_options) return;
    try {
        std::error_code fault; // the writing itself will tell
        std::filesystem::create_directories(std::filesystem::path(ui.options_path).parent_path(),
                                            fault);
        write_file(ui.options_path, text);
        ui.kept_options = std::move(text);
    } catch (const Error& error) {
        give_up(ui, error);
    }
}

} // namespace rasterwalk
