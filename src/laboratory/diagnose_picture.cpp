#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/numbers.h"
#include "laboratory/bug_rule.h"
#include "laboratory/diagnose.h"
#include "laboratory/picture_trial.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

/// What is right on this base.
std::optional<Settings> right_on(const Base& base) {
    if (base.assumptions == 0) return std::nullopt;
    return base.settings;
}

void try_bases(PictureTrial& trial, const std::vector<Base>& bases) {
    for (const Base& base : bases) {
        if (base.assumptions == 0) continue;
        const Settings& first = bases.front().settings;
        const bool other_stage = step_of(base.settings) != step_of(first);
        const bool other_power = !(base.settings.light == first.light);
        const std::string stage(stage_info(base.settings).name);
        std::string name = other_stage ? "Drawn at stage " + stage : "";
        if (other_power) {
            name += name.empty() ? "Another light power" : " with another light power";
        }
        trial.add({.id = other_power ? "light_power" : "stage",
                   .name = std::move(name),
                   .remark = other_power ? base.remark : "", // the name says the stage
                   .assumptions = base.assumptions,
                   .recipe = PictureRecipe{base.settings}},
                  trial.drawn(base.settings));
    }
}

void try_orientations(PictureTrial& trial, const std::vector<Base>& bases) {
    for (const Base& base : bases) {
        for (const OrientationInfo& info : orientation_list()) {
            if (info.orientation == Orientation::upright) continue;
            const PictureRecipe recipe{base.settings, info.orientation};
            trial.add({.id = info.id,
                       .name = info.name,
                       .remark = base.remark,
                       .assumptions = base.assumptions + 1,
                       .recipe = recipe,
                       .right = right_on(base)},
                      trial.drawn(recipe));
        }
    }
}

void try_shifts(PictureTrial& trial, const std::vector<Base>& bases) {
    constexpr std::array<const char*, 3> across{"left", "", "right"}, along{"up", "", "down"};
    for (const Base& base : bases) {
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                if (dx == 0 && dy == 0) continue;
                const std::string where_x = across[static_cast<std::size_t>(dx + 1)];
                const std::string where_y = along[static_cast<std::size_t>(dy + 1)];
                const std::string both = where_x.empty() || where_y.empty() ? "" : " and a pixel ";
                const PictureRecipe recipe{base.settings, Orientation::upright, dx, dy};
                trial.add({.id = "shifted",
                           .name = fmt::format("Shifted by a pixel {}{}{}", where_x, both, where_y),
                           .remark = base.remark,
                           .assumptions = base.assumptions + 1,
                           .recipe = recipe,
                           .right = right_on(base)},
                          trial.drawn(recipe));
            }
        }
    }
}

/// What a mistake must take away from the distance to explain anything: this part of it.
constexpr double least_gain = 0.01;

bool is_clearly_nearer(const Drawn& one, double distance) {
    return one.distance.mean <= (1.0 - least_gain) * distance;
}

/// The settings with a bug, unless it changes nothing about the picture.
void try_settings(PictureTrial& trial, Hypothesis hypothesis, const Settings& settings,
                  const Settings& without) {
    const Drawn& one = trial.drawn(settings);
    const Drawn& other = trial.drawn(without);
    if (one.print == other.print) return;
    hypothesis.right = without;
    hypothesis.explains_more =
        hypothesis.assumptions == 1 || is_clearly_nearer(one, other.distance.mean);
    trial.add(std::move(hypothesis), one, settings);
}

Hypothesis suspicion(const Bug& bug, const std::string& remark, int assumptions) {
    return {.id = bug.id,
            .name = bug.name,
            .remark = remark,
            .assumptions = assumptions,
            .is_bug = true};
}

void try_bug(PictureTrial& trial, const std::vector<Base>& bases, const Bug& bug) {
    const Settings& reference = bases.front().settings;
    // The reference makes this mistake itself: it is not what makes the picture another one.
    if (!changes_rule(bug) || is_made_by(bug, reference)) return;
    for (const Base& base : bases) {
        Settings settings = base.settings;
        apply_bug_rule(bug, settings);
        try_settings(trial, suspicion(bug, base.remark, base.assumptions + 1), settings,
                     base.settings);
    }
    // As the laboratory shows it, with its own stage and lamp.
    try_settings(trial, suspicion(bug, "", 1), wrong_run(bug, reference),
                 correct_run(bug, reference));
}

/// With a mistake in the picture the lamp's power was not fitted well: again with the mistakes that
/// come nearest.
void try_powers_again(PictureTrial& trial, const std::vector<Base>& bases) {
    constexpr std::size_t most_tried = 10;
    double without = trial.drawn(bases.front().settings).distance.mean;
    for (const Base& base : bases)
        without = std::min(without, trial.drawn(base.settings).distance.mean);
    std::vector<PictureTrial::Tried> nearest = trial.tried;
    std::sort(nearest.begin(), nearest.end(),
              [&](const PictureTrial::Tried& a, const PictureTrial::Tried& b) {
                  return trial.hypotheses[a.hypothesis].distance <
                         trial.hypotheses[b.hypothesis].distance;
              });
    if (nearest.size() > most_tried) nearest.resize(most_tried);
    for (const PictureTrial::Tried& one : nearest) {
        const std::optional<Settings> lit = with_fitted_power(trial, one.settings);
        if (!lit) continue;
        Hypothesis hypothesis = trial.hypotheses[one.hypothesis];
        const std::size_t old = hypothesis.remark.find("light.power=");
        if (old != std::string::npos) {
            hypothesis.remark.replace(old, std::string::npos,
                                      "light.power=" + number_text(lit->light.power.x));
        } else {
            hypothesis.remark = power_remark(hypothesis.remark, *lit);
            ++hypothesis.assumptions;
        }
        Settings right = hypothesis.right.value_or(bases.front().settings);
        right.light.power = lit->light.power;
        hypothesis.right = right;
        const Drawn& drawn = trial.drawn(*lit);
        hypothesis.explains_more = is_clearly_nearer(drawn, without);
        hypothesis.recipe = PictureRecipe{*lit};
        trial.add(std::move(hypothesis), drawn);
    }
}

/// Every other word of every choice but the stage and its shading.
void try_choices(PictureTrial& trial, const std::vector<Base>& bases) {
    for (const Setting& setting : setting_table()) {
        const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
        if (choice == nullptr || setting.name == "stage" || setting.part_of == "stage") continue;
        if (!is_of_use(setting, trial.scene())) continue;
        for (const std::string_view word : choice->words) {
            if (is_word_of_whole(setting, word)) continue;
            for (const Base& base : bases) {
                if (!is_of_use(setting, trial.scene(), base.settings)) continue;
                Settings settings = base.settings;
                set_value(settings, setting, word);
                const std::string id = fmt::format("{}={}", setting.name, word);
                Hypothesis hypothesis{.id = id,
                                      .name = "Drawn by " + id,
                                      .remark = base.remark,
                                      .assumptions = base.assumptions + 1,
                                      .recipe = PictureRecipe{settings},
                                      .right = right_on(base)};
                const Drawn& one = trial.drawn(settings);
                if (one.print == trial.drawn(base.settings).print) continue;
                trial.add(std::move(hypothesis), one);
            }
        }
    }
}

} // namespace

Settings fitted_to(const Settings& settings, const Image& picture, SceneSpace space) {
    Settings fitted = settings;
    const std::string size = fmt::format("{}x{}", picture.width, picture.height);
    if (settings.viewport == Viewport{picture.width, picture.height}) return fitted;
    set_value(fitted, *find_setting("viewport.size"), size);
    if (space == SceneSpace::pixels) return fitted;
    const float growth = static_cast<float>(picture.height) /
                         static_cast<float>(std::max(settings.viewport.height, 1));
    set_value(fitted, *find_setting("camera.focal_length"),
              number_text(settings.camera.focal_length * growth));
    return fitted;
}

DiagnosisWork::DiagnosisWork(Image picture, const std::string& name, const Scene& scene,
                             const Settings& reference, const std::vector<Bug>& bugs)
    : picture_(std::move(picture)), name_(name), reference_(reference), bugs_(&bugs),
      trial_(std::make_unique<PictureTrial>(picture_, scene)) {}

DiagnosisWork::~DiagnosisWork() = default;

void DiagnosisWork::advance(const WorkLimit& limit) {
    while (!is_done()) {
        trial_->advance(limit);
        pictures_.done = pictures_.all - static_cast<int>(trial_->pictures_missing());
        if (trial_->is_waiting()) return;
        ask();
        pictures_ = {0, static_cast<int>(trial_->pictures_missing())};
    }
}

/// Asks all that can be asked with what is drawn, and notes what must be drawn next.
void DiagnosisWork::ask() {
    PictureTrial& trial = *trial_;
    trial.begin_again();
    const ImageDistance apart = trial.drawn(reference_).distance;
    if (trial.is_waiting()) return;
    Diagnosis found;
    found.distance = apart.mean;
    found.different = apart.different;
    if (!found.is_same()) {
        if (!is_affordable_) refuse_too_much();
        is_affordable_ = true;
        const std::vector<Base> bases = find_bases(trial, reference_);
        if (trial.is_waiting()) return;
        try_bases(trial, bases);
        for (const Bug& bug : *bugs_)
            try_bug(trial, bases, bug);
        if (trial.is_waiting()) return;
        const bool is_found =
            std::any_of(trial.hypotheses.begin(), trial.hypotheses.end(),
                        [](const Hypothesis& h) { return h.is_bug && h.distance == 0.0; });
        if (!is_found) {
            try_powers_again(trial, bases);
            try_choices(trial, bases);
            try_orientations(trial, bases);
            try_shifts(trial, bases);
        }
        if (trial.is_waiting()) return;
    }
    std::erase_if(trial.hypotheses, [](const Hypothesis& h) { return !h.explains_more; });
    rank_candidates(std::move(trial.hypotheses), "this very picture", found);
    // What the mistake is held against is as the student set it.
    const Candidate* const likely = likely_candidate(found);
    const Settings right = likely == nullptr ? reference_ : likely->right.value_or(reference_);
    const Image* const picture = trial.picture_of(PictureRecipe{right});
    if (trial.is_waiting()) return;
    right_picture_ = *picture;
    const Differences differences = differences_of(right_picture_, picture_);
    if (differences.pixels > 0) found.different = differences.pixels;
    found.place = place_words(differences);
    found_ = std::move(found);
}

void DiagnosisWork::refuse_too_much() const {
    if (pictures_tried * trial_->picture_work() <= most_diagnosis_work) return;
    throw InputError(fmt::format("{}: it is too much work to draw {} triangles in {} x {} pixels "
                                 "for every mistake.",
                                 name_, trial_->scene().triangle_count(), picture_.width,
                                 picture_.height));
}

Diagnosis diagnose_picture(const Image& picture, const Scene& scene, const Settings& reference,
                           const std::vector<Bug>& bugs) {
    DiagnosisWork work(picture, "the picture", scene, reference, bugs);
    work.advance();
    return work.found();
}

} // namespace rasterwalk
