#include "ui/app/kept_options.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "base/files.h"
#include "base/language_files.h"
#include "base/toml_input.h"
#include "ui/actions/kept_file.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

constexpr std::size_t largest_options = std::size_t{1} << 16; ///< bytes

/// Points and rounds add up; a score that was reset, or not kept before, counts alone.
QuizScore merged(const QuizScore& before, const QuizScore& after, const QuizScore& theirs) {
    if (after == before) return theirs;
    const bool adds_up = after.is_kept && before.is_kept && theirs.is_kept &&
                         after.points >= before.points && after.rounds >= before.rounds;
    if (!adds_up) return after;
    return {.rounds = std::min(theirs.rounds + after.rounds - before.rounds, largest_score),
            .points = std::min(theirs.points + after.points - before.points, largest_score),
            .is_kept = true};
}

/// The options in the file, with what changed in this window between `before` and `after`.
UiOptions merged(const UiOptions& before, const UiOptions& after, UiOptions theirs) {
    const auto take = [&](auto member) {
        if (after.*member != before.*member) theirs.*member = after.*member;
    };
    take(&UiOptions::theme);
    take(&UiOptions::wished_text_scale);
    take(&UiOptions::lesson_width);
    take(&UiOptions::inspector_width);
    take(&UiOptions::start_choice);
    take(&UiOptions::language);
    take(&UiOptions::program);
    theirs.score = merged(before.score, after.score, theirs.score);
    return theirs;
}

/// The options in a file; what is missing, or all if there is no file, comes from `options`.
UiOptions read_options(const std::string& path, const UiOptions& options) {
    std::error_code fault;
    if (!std::filesystem::exists(path, fault) && !fault) return options;
    return parse_options(read_file(path, largest_options), path, options);
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
    if (options.start_choice) table.insert("way", word_of(*options.start_choice));
    if (!options.language.empty()) table.insert("language", options.language);
    if (!options.program.empty()) table.insert("program", options.program);
    std::ostringstream out;
    out << table << '\n';
    return out.str();
}

UiOptions parse_options(std::string_view text, const std::string& path, UiOptions options) {
    const toml::table root = parse_toml(text, path);
    const TomlInput input(root, path, "the look of the window");
    input.allow_only({"theme", "text_scale", "lesson_width", "inspector_width", "quiz_points",
                      "quiz_rounds", "way", "language", "program"});
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
    if (input.find("way") != nullptr) {
        options.start_choice = value_of_word<StartChoice>(input.text("way"));
        if (!options.start_choice) {
            input.fail(*input.find("way"), "'way' is \"lessons\", \"stages\" or \"picture\".");
        }
    }
    if (input.find("language") != nullptr) {
        options.language = input.text("language");
        if (!is_language_code(options.language))
            input.fail(*input.find("language"), "'language' is a code such as \"sv\".");
    }
    if (input.find("program") != nullptr) options.program = input.text("program");
    options.score.is_kept = input.find("quiz_rounds") != nullptr;
    input.read("quiz_points", options.score.points, 0, largest_score);
    input.read("quiz_rounds", options.score.rounds, 0, largest_score);
    return options;
}

void keep_options(Ui& ui, const std::string& path) {
    take_up_kept(ui, ui.options_file, path, "The look of the window", [&] {
        ui.options = read_options(path, ui.options);
        ui.style_is_stale = true;
        ui.kept_options = ui.options;
    });
}

void save_options(Ui& ui) {
    if (options_text(ui.options) == options_text(ui.kept_options)) return;
    write_kept(ui, ui.options_file, "The look of the window", [&] {
        const std::string& path = ui.options_file.path;
        make_folder_of(path);
        const FileLock lock(path);
        const UiOptions kept =
            merged(ui.kept_options, ui.options, read_options(path, ui.kept_options));
        write_file(path, options_text(kept));
        ui.options.score = kept.score;
        ui.kept_options = ui.options;
    });
}

} // namespace rasterwalk
