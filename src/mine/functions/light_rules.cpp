#include "mine/functions/light_rules.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <glm/common.hpp>

#include "settings/choose_stages.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

/// A change of the lab's formula. One of `bug` and `cause` is empty.
struct LightChange {
    int part;                     ///< of the formula: two changes of a part exclude each other
    std::string_view name, value; ///< of the setting; empty: `gap`
    LightGap gap;
    std::string_view bug, cause;
};

constexpr LightChange changes[] = {
    {0, "light.direction", "from_light", LightGap::none, "B20a", {}},
    {0, "light.direction", "not_normalized", LightGap::none, "B20b", {}},
    {0, "light.direction", "with_w", LightGap::none, "B76", {}},
    {1, "light.falloff", "no_4pi", LightGap::none, "B20c", {}},
    {1, "light.falloff", "cubed", LightGap::none, "B20d", {}},
    {1, "light.falloff", "pi_of_atan", LightGap::none, "B77a", {}},
    {1, "light.falloff", "pi_three", LightGap::none, "B77b", {}},
    {1,
     "light.falloff",
     "linear",
     LightGap::none,
     {},
     "The power is divided by r, and not by 4 pi r^2."},
    {1, "light.falloff", "none", LightGap::none, {}, "The power is not divided by 4 pi r^2."},
    {2, "light.sum", "reflectance_plus", LightGap::none, "B21", {}},
    {2, "light.sum", "reflectance_twice", LightGap::none, "B78", {}},
    {3,
     {},
     {},
     LightGap::no_max,
     {},
     "The cosine is not limited by max(..., 0), so a lamp behind a surface takes light away."},
    {3, {}, {}, LightGap::no_indirect, {}, "The indirect light is missing."},
    {3, {}, {}, LightGap::no_direct, {}, "The direct light is missing."},
    {3,
     {},
     {},
     LightGap::no_colour,
     {},
     "The light is not multiplied by the colour of the surface."},
    {3, {}, {}, LightGap::gamma, "B80", {}},
};

LightRule rule_with(std::initializer_list<const LightChange*> made) {
    LightRule rule;
    Settings settings;
    for (const LightChange* const change : made) {
        if (change->name.empty()) {
            rule.gap = change->gap;
        } else {
            rule.settings.emplace_back(change->name, change->value);
            set_value(settings, *find_setting(change->name), change->value);
        }
        if (!change->bug.empty()) rule.bugs.emplace_back(change->bug);
        if (!change->cause.empty()) rule.causes.emplace_back(change->cause);
        ++rule.mistakes;
    }
    rule.stages = choose_stages(settings);
    return rule;
}

std::vector<LightRule> make_light_rules() {
    std::vector<LightRule> rules;
    rules.push_back(rule_with({}));
    for (const LightChange& change : changes)
        rules.push_back(rule_with({&change}));
    for (const LightChange& first : changes) {
        for (const LightChange& second : changes) {
            if (first.part < second.part) rules.push_back(rule_with({&first, &second}));
        }
    }
    return rules;
}

} // namespace

const std::vector<LightRule>& light_rules() {
    static const std::vector<LightRule> rules = make_light_rules();
    return rules;
}

LitColour lit_colour(const LightRule& rule, const glm::vec3& position, const glm::vec3& normal,
                     const glm::vec3& reflectance, const Light& light) {
    const auto reflected = [&](const glm::vec3& n, const Light& lamp) {
        const glm::vec3 colour = rule.gap == LightGap::no_colour ? glm::vec3(1.0f) : reflectance;
        return glm::dvec3(rule.stages.reflected_light(position, n, colour, lamp).reflected);
    };
    Light used = light;
    if (rule.gap == LightGap::no_indirect) used.indirect = glm::vec3(0.0f);
    if (rule.gap == LightGap::no_direct) used.power = glm::vec3(0.0f);
    Light unlit = used;
    unlit.power = glm::vec3(0.0f);
    const glm::dvec3 without = reflected(normal, unlit);
    LitColour lit;
    lit.colour = reflected(normal, used);
    // max(c, 0) - max(-c, 0) is c.
    if (rule.gap == LightGap::no_max) lit.colour += without - reflected(-normal, used);
    lit.tolerance = 1e-3 * glm::abs(lit.colour - without) + 0x1p-16 * glm::abs(lit.colour) + 1e-6;
    if (rule.gap == LightGap::gamma) {
        for (int i = 0; i < 3; ++i)
            lit.colour[i] = std::pow(std::max(lit.colour[i], 0.0), 1.0 / 2.2);
    }
    return lit;
}

bool is_same_colour(const glm::dvec3& theirs, const LitColour& ours) {
    for (int i = 0; i < 3; ++i) {
        const double cut = std::min(ours.colour[i], 1.0);
        // Written so that NaN is another colour.
        const bool same = std::abs(theirs[i] - ours.colour[i]) <= ours.tolerance[i] ||
                          std::abs(theirs[i] - cut) <= ours.tolerance[i];
        if (!same) return false;
    }
    return true;
}

} // namespace rasterwalk
