#include "view/widget_names.h"

#include <algorithm>
#include <span>

#include "base/error.h"
#include "base/files.h"
#include "base/nearest_name.h"
#include "base/quoted.h"
#include "base/text_parts.h"
#include "picture/overlay.h"
#include "session/content.h"
#include "session/tabs.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

/// The settings of one kind.
template <typename Kind>
std::vector<std::string_view> settings_of_kind() {
    std::vector<std::string_view> names;
    for (const Setting& setting : setting_table()) {
        if (std::holds_alternative<Kind>(setting.kind)) names.push_back(setting.name);
    }
    return names;
}

/// What `{stage}` and the like can be; nothing for another word.
std::vector<std::string_view> words_for(std::string_view place) {
    std::vector<std::string_view> words;
    if (place == "{tab}") {
        words.assign(tab_names().begin(), tab_names().end());
    } else if (place == "{stage}") {
        for (const StageInfo& stage : stage_list())
            words.push_back(stage.name);
    } else if (place == "{setting}") {
        for (const Setting& setting : setting_table())
            words.push_back(setting.name);
    } else if (place == "{vector}") {
        words = settings_of_kind<VectorSetting>();
    } else if (place == "{size}") {
        words = settings_of_kind<SizeSetting>();
    } else if (place == "{box}") {
        words = settings_of_kind<BoxSetting>();
    } else if (place == "{overlay}") {
        for (const OverlayInfo& overlay : overlay_list())
            words.push_back(overlay.name);
    }
    return words;
}

/// `{stage}`, if the pattern continues with that.
std::string_view place_at_start(std::string_view pattern) {
    return pattern.starts_with("{") ? pattern.substr(0, pattern.find('}') + 1) : std::string_view();
}

bool matches(std::string_view name, std::string_view pattern) {
    const std::size_t special = std::min(pattern.find_first_of("#{*"), pattern.size());
    if (name.substr(0, special) != pattern.substr(0, special)) return false;
    if (special == pattern.size()) return name.size() == pattern.size();
    name.remove_prefix(special);
    pattern.remove_prefix(special);
    if (pattern[0] == '#') {
        const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
        return digits > 0 && matches(name.substr(digits), pattern.substr(1));
    }
    if (pattern[0] == '{') {
        const std::string_view place = place_at_start(pattern);
        const std::vector<std::string_view> words = words_for(place);
        return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
            return name.starts_with(word) &&
                   matches(name.substr(word.size()), pattern.substr(place.size()));
        });
    }
    for (std::size_t length = 1; length <= name.size(); ++length) {
        if (matches(name.substr(length), pattern.substr(1))) return true;
    }
    return false;
}

/// Throws UsageError with what is wrong with a pattern.
void check_pattern(const WidgetPattern& pattern) {
    const std::string_view name = pattern.name;
    for (std::size_t at = 0; (at = name.find_first_of("{}", at)) != name.npos; ++at) {
        const std::string_view place = place_at_start(name.substr(at));
        if (words_for(place).empty()) {
            throw UsageError(
                "a widget's name can contain {stage}, {tab}, {setting}, {vector}, {size}, {box} "
                "and {overlay}, not " +
                in_quotes(place.empty() ? name.substr(at) : place) + ".");
        }
        at += place.size() - 1;
    }
    if (pattern.is_for_lessons && name.find('*') != name.npos) {
        throw UsageError("a widget that lessons can point at must have a name of its own, not "
                         "'*'.");
    }
}

} // namespace

std::vector<WidgetPattern> parse_widget_patterns(std::string_view text, const std::string& path) {
    constexpr std::string_view not_for_lessons = "- ";
    std::vector<WidgetPattern> patterns;
    for (int line = 1; !text.empty(); ++line) {
        std::string_view name = take_part(text, '\n');
        if (name.ends_with('\r')) name.remove_suffix(1);
        if (name.empty() || name.starts_with('#')) continue;
        WidgetPattern pattern;
        pattern.is_for_lessons = !name.starts_with(not_for_lessons);
        if (!pattern.is_for_lessons) name.remove_prefix(not_for_lessons.size());
        pattern.name = name;
        try {
            check_pattern(pattern);
        } catch (const UsageError& fault) {
            throw InputError(path, line, fault.what());
        }
        patterns.push_back(std::move(pattern));
    }
    return patterns;
}

std::string widgets_file() {
    constexpr const char* name = "/widgets.txt";
    try {
        return own_lessons_folder() + name;
    } catch (const AccessError&) {
        return lessons_folder() + name; // a program without lessons next to it
    }
}

std::vector<WidgetPattern> read_widget_patterns() {
    const std::string path = widgets_file();
    return parse_widget_patterns(read_file(path), path);
}

bool is_named_by(const WidgetPattern& pattern, std::string_view name) {
    return matches(name, pattern.name);
}

void check_widget_name(std::string_view name) {
    const std::vector<WidgetPattern> patterns = read_widget_patterns();
    std::vector<std::string> names;
    for (const WidgetPattern& pattern : patterns) {
        if (!pattern.is_for_lessons) continue;
        if (is_named_by(pattern, name)) return;
        const std::size_t place = pattern.name.find('{');
        if (place == pattern.name.npos) {
            names.push_back(pattern.name);
            continue;
        }
        const std::string_view word_for =
            place_at_start(std::string_view(pattern.name).substr(place));
        for (const std::string_view word : words_for(word_for)) {
            names.push_back(pattern.name);
            names.back().replace(place, word_for.size(), word);
        }
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    throw UsageError("the window has no widget " + in_quotes(name) +
                     " that a lesson can point at." + did_you_mean(name, views));
}

} // namespace rasterwalk
