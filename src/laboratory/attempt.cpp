#include "laboratory/attempt.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "laboratory/bug_rule.h"
#include "laboratory/equal_rules.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

void add_bugs(const std::vector<Bug>& bugs, std::vector<Change>& changes) {
    for (const Bug& bug : bugs) {
        Change change{.id = bug.id, .name = bug.name, .set = {}, .bug = &bug};
        for (const auto& assignment : bug.set) {
            if (assignment.first != "stage") change.set.push_back(assignment);
        }
        if (changes_rule(bug)) changes.push_back(std::move(change));
    }
}

/// Every word of every choice, except for the stage and its shading.
void add_choices(const Scene& scene, std::vector<Change>& changes) {
    for (const Setting& setting : setting_table()) {
        const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
        if (choice == nullptr || setting.name == "stage" || setting.ties.part_of == "stage")
            continue;
        if (setting.ties.is_of_engine || is_of_equal_rules(setting.name) ||
            !is_of_use(setting, scene))
            continue;
        for (const std::string_view word : choice->words) {
            if (is_word_of_whole(setting, word)) continue;
            const std::string id = fmt::format("{}={}", setting.name, word);
            changes.push_back({.id = id,
                               .name = "Drawn by " + id,
                               .set = {{std::string(setting.name), std::string(word)}}});
        }
    }
}

void add_turns_and_moves(std::vector<Change>& changes) {
    for (const OrientationInfo& info : orientation_list()) {
        if (info.orientation == Orientation::upright) continue;
        changes.push_back(
            {.id = info.id, .name = info.name, .set = {}, .orientation = info.orientation});
    }
    constexpr std::array<const char*, 3> across{"left", "", "right"}, along{"up", "", "down"};
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            if (dx == 0 && dy == 0) continue;
            const std::string where_x = across[static_cast<std::size_t>(dx + 1)];
            const std::string where_y = along[static_cast<std::size_t>(dy + 1)];
            const std::string both = where_x.empty() || where_y.empty() ? "" : " and one pixel ";
            changes.push_back(
                {.id = "shifted",
                 .name = fmt::format("Shifted one pixel {}{}{}", where_x, both, where_y),
                 .set = {},
                 .right = dx,
                 .down = dy});
        }
    }
}

} // namespace

std::vector<Change> known_changes(const std::vector<Bug>& bugs, const Scene& scene) {
    std::vector<Change> changes;
    add_bugs(bugs, changes);
    add_choices(scene, changes);
    add_turns_and_moves(changes);
    return changes;
}

PictureRecipe recipe_of(const Attempt& attempt) {
    PictureRecipe recipe{attempt.right};
    for (const Change* change : attempt.changes) {
        for (const auto& [name, value] : change->set)
            set_value(recipe.settings, *find_setting(name), value);
        if (change->orientation != Orientation::upright) recipe.orientation = change->orientation;
        recipe.right += change->right;
        recipe.down += change->down;
    }
    return recipe;
}

std::vector<std::string> extra_rules(const Settings& right, const Settings& reference) {
    std::vector<std::string> rules;
    for (const Setting& setting : setting_table()) {
        if (!must_be_listed(setting, reference, right)) continue;
        rules.push_back(fmt::format("{}={}", setting.name, value_text(setting, right)));
    }
    return rules;
}

double assumptions_of(const Attempt& attempt, const Settings& reference) {
    constexpr double of_rule = 0.5, of_odd_number = 1.1, of_bug = 1.0, of_other = 1.2;
    constexpr std::size_t longest_number = 5; // "-0.25", "13.82": one that a person would choose
    double sum = 0.0;
    for (const Change* change : attempt.changes)
        sum += change->bug != nullptr ? of_bug : of_other;
    if (attempt.right == reference) return sum;
    for (const Setting& setting : setting_table()) {
        if (!must_be_listed(setting, reference, attempt.right)) continue;
        // The camera is where the handout puts it, or where the student says.
        const bool is_odd = setting.name.starts_with("camera.") ||
                            (setting.name == "light.power" &&
                             value_text(setting, attempt.right).size() > longest_number);
        sum += is_odd ? of_odd_number : of_rule;
    }
    return sum;
}

double assumption_unit(PictureTrial& trial, const Settings& reference) {
    constexpr double part = 0.01, least = 0.5, most = 20.0;
    double wrong = std::numeric_limits<double>::max();
    for (const StageInfo& info : stage_list()) {
        if (!is_of_use(info, trial.scene())) continue;
        Settings settings = reference;
        set_step(settings, info.step);
        wrong = std::min(wrong, trial.drawn(settings).distance.wrong);
    }
    return std::clamp(part * wrong, least, most);
}

double price_of(PictureTrial& trial, const Attempt& attempt, const Settings& reference,
                double unit) {
    constexpr double of_exact =
        0.05; // an attempt that leaves nothing may assume more than one that leaves a little
    const ImageDistance& left = trial.drawn(recipe_of(attempt)).distance;
    const double assumed = unit * assumptions_of(attempt, reference);
    return left.wrong + (left.different == 0 ? of_exact * assumed : assumed);
}

const Attempt& best_base(PictureTrial& trial, const std::vector<Attempt>& tried,
                         const Settings& reference) {
    const double unit = assumption_unit(trial, reference);
    // Only those that show the same surfaces, because a mostly black picture is near to many.
    constexpr double as_good = 0.1;
    double surface = std::numeric_limits<double>::max();
    for (const Attempt& attempt : tried) {
        if (attempt.changes.empty())
            surface = std::min(surface, trial.drawn(attempt.right).distance.other_surface);
    }
    const Attempt* best = &tried.front();
    double least = std::numeric_limits<double>::max();
    for (const Attempt& attempt : tried) {
        if (!attempt.changes.empty() ||
            trial.drawn(attempt.right).distance.other_surface > surface + as_good)
            continue;
        const double price = price_of(trial, attempt, reference, unit);
        if (price >= least) continue;
        best = &attempt;
        least = price;
    }
    return *best;
}

} // namespace rasterwalk
