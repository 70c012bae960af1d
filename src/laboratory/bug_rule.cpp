#include "laboratory/bug_rule.h"

#include <algorithm>

#include "settings/setting_table.h"

namespace rasterwalk {

bool changes_rule(const Bug& bug) {
    return std::any_of(bug.set.begin(), bug.set.end(), [](const auto& assignment) {
        return assignment.first != "stage" && !assignment.first.starts_with("camera.");
    });
}

void apply_bug_rule(const Bug& bug, Settings& settings) {
    for (const auto& [name, value] : bug.set) {
        const Setting* const setting = name == "stage" ? nullptr : find_setting(name);
        if (setting != nullptr) set_value(settings, *setting, value);
    }
}

bool is_made_by(const Bug& bug, const Settings& settings) {
    Settings made = settings;
    apply_bug_rule(bug, made);
    return made == settings;
}

} // namespace rasterwalk
