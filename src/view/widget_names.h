#pragma once

// The names of the window's widgets, for lessons that point at one. The core knows none of them:
// lessons/widgets.txt lists them, and a test of the interface compares it with the window.

#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A widget, or several of a kind, by name. `#` stands for a number, `{stage}`, `{tab}`,
/// `{setting}` and `{overlay}` for one of their names, `{vector}`, `{size}` and `{box}` for a
/// setting of that kind, `*` for any text.
struct WidgetPattern {
    std::string name;
    bool is_for_lessons = true; ///< false: it comes and goes, so no lesson can point at it
};

/// The patterns of a file, one per line: lines that begin with "- " are not for lessons, and those
/// that begin with "#" are comments. Throws InputError with file:line.
std::vector<WidgetPattern> parse_widget_patterns(std::string_view text, const std::string& path);

/// The patterns of widgets_file(). Throws AccessError, InputError.
std::vector<WidgetPattern> read_widget_patterns();

/// The file that lists them, in own_lessons_folder(), because a teacher's own lessons point at the
/// same window; if the program has none, in lessons_folder(). Throws AccessError.
std::string widgets_file();

/// Does the pattern stand for a widget with this name?
bool is_named_by(const WidgetPattern& pattern, std::string_view name);

/// Throws UsageError with a sentence, and the nearest name, if no lesson can point at a widget of
/// this name; also what read_widget_patterns() throws.
void check_widget_name(std::string_view name);

} // namespace rasterwalk
