#pragma once

// The names of the window's widgets, for lessons that point at one. The core knows none of them:
// the file lessons/widgets.txt lists them, and a test of the interface holds it to the window.

#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A widget, or several of a kind, by name. `#` stands for a number, `{stage}`, `{tab}`,
/// `{setting}` and `{overlay}` for one of their names, `{vector}`, `{size}` and `{box}` for a
/// setting that is one, `*` for any text.
struct WidgetPattern {
    std::string name;
    bool is_for_lessons = true; ///< false: it comes and goes, so no lesson can point at it
};

/// The patterns of a file, a line each: those after "- " are not for lessons, and those after "#"
/// are comments. Throws InputError with file:line.
std::vector<WidgetPattern> parse_widget_patterns(std::string_view text, const std::string& path);

/// Those of widgets_file(). Throws AccessError, InputError.
std::vector<WidgetPattern> read_widget_patterns();

/// The file that lists them, in own_lessons_folder(), because lessons of one's own point at the
/// same window; where the program has none, in lessons_folder(). Throws AccessError.
std::string widgets_file();

/// Does the pattern stand for a widget of this name?
bool is_named_by(const WidgetPattern& pattern, std::string_view name);

/// Throws UsageError with a sentence, and the name that comes near, if no lesson can point at a
/// widget of this name; and as read_widget_patterns().
void check_widget_name(std::string_view name);

} // namespace rasterwalk
