#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/enumerated.h"
#include "base/error.h"
#include "base/numbers.h"
#include "laboratory/diagnose.h"
#include "laboratory/picture_findings.h"
#include "scene/tessellation.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

Candidate candidate_of(const Attempt& attempt, const Settings& reference) {
    Candidate candidate;
    for (const Change* change : attempt.changes)
        candidate.mistakes.push_back({{change->id}, {change->name}});
    const std::string rules = enumerated(extra_rules(attempt.right, reference));
    if (!rules.empty()) candidate.remark = "with " + rules;
    candidate.recipe = recipe_of(attempt);
    candidate.right = attempt.right;
    return candidate;
}

/// Does each of its changes reduce what is wrong without it?
bool needs_each_change(PictureTrial& trial, const Attempt& attempt) {
    constexpr double least_gain = 0.01;
    const double wrong = trial.drawn(recipe_of(attempt)).distance.wrong;
    for (std::size_t i = 0; i < attempt.changes.size(); ++i) {
        Attempt less = attempt;
        less.changes.erase(less.changes.begin() + static_cast<std::ptrdiff_t>(i));
        const double without = trial.drawn(recipe_of(less)).distance.wrong;
        if (wrong >= (1.0 - least_gain) * without) return false; // also if nothing is wrong
    }
    return true;
}

/// The attempts that come nearer than the picture without any mistake.
std::vector<Hypothesis> hypotheses_of(PictureTrial& trial, const std::vector<Attempt>& tried,
                                      const Attempt& base, const Settings& reference) {
    const double unit = assumption_unit(trial, reference);
    const double base_price = price_of(trial, base, reference, unit);
    std::vector<Hypothesis> hypotheses;
    for (const Attempt& attempt : tried) {
        const PictureRecipe recipe = recipe_of(attempt);
        const Drawn& drawn = trial.drawn(recipe);
        // An attempt is not listed if the base explains as much and assumes less.
        const double price = price_of(trial, attempt, reference, unit);
        if (attempt.changes.empty() || price >= base_price) continue;
        if (!needs_each_change(trial, attempt)) continue;
        const ImageDistance& without = trial.drawn(attempt.right).distance;
        Hypothesis h;
        h.candidate = candidate_of(attempt, reference);
        h.candidate.distance = drawn.distance.mean;
        h.candidate.different = drawn.distance.different;
        h.candidate.explained = std::clamp(1.0 - drawn.distance.wrong / without.wrong, 0.0, 1.0);
        h.assumed = assumptions_of(attempt, reference);
        h.price = price;
        h.result = drawn.print;
        h.is_of_bugs = std::all_of(attempt.changes.begin(), attempt.changes.end(),
                                   [](const Change* change) { return change->bug != nullptr; });
        hypotheses.push_back(std::move(h));
    }
    return hypotheses;
}

/// The reference if no mistake is likely: with different rules and numbers only if they explain
/// most of what differs, or else the verdict on the program could be false.
const Attempt& convincing_base(PictureTrial& trial, const std::vector<Attempt>& tried,
                               const Attempt& best, const Settings& reference) {
    constexpr double convincing = 0.5;
    const Attempt* plain = nullptr;
    const auto different = [&](const Attempt& attempt) {
        return static_cast<double>(trial.drawn(attempt.right).distance.different);
    };
    const auto light = [&](const Attempt& attempt) {
        return trial.drawn(attempt.right).distance.mean;
    };
    const auto surface = [&](const Attempt& attempt) {
        return trial.drawn(attempt.right).distance.other_surface;
    };
    for (const Attempt& attempt : tried) {
        Settings same = reference;
        set_step(same, step_of(attempt.right));
        if (!attempt.changes.empty() || !(attempt.right == same)) continue;
        if (plain == nullptr || surface(attempt) < surface(*plain) - 0.02 ||
            (surface(attempt) < surface(*plain) + 0.02 && light(attempt) < light(*plain)))
            plain = &attempt;
    }
    if (plain == nullptr || different(best) <= convincing * different(*plain)) return best;
    return *plain;
}

/// Counts, pixel by pixel, the evidence for and against a candidate. What its own lamp or camera
/// spoils and its mistakes mend again explains nothing; neither does what is black in both, which
/// has many causes, unless what is drawn is explained too.
/// @param base  the nearest without a mistake
/// @param shown the one whose differences are reported
void weigh(PictureTrial& trial, const Attempt& base, const Attempt& shown, Candidate& candidate) {
    const PixelCounts counts = trial.compared(*candidate.recipe, PictureRecipe{*candidate.right});
    const auto part = [](std::int64_t some, std::int64_t all) {
        return all > 0 ? static_cast<double>(some) / static_cast<double>(all) : 0.0;
    };
    const std::int64_t wrong = trial.drawn(recipe_of(shown)).distance.different;
    const double own_part = part(counts.explained, counts.wrong);
    const double shown_part = counts.drawn_on > 0 ? part(counts.shown, counts.drawn_on) : 1.0;
    candidate.explained =
        std::clamp(part(wrong - candidate.different, wrong), 0.0, std::min(own_part, shown_part));
    const auto least_wrong = static_cast<double>(trial.drawn(recipe_of(base)).distance.different);
    candidate.is_likely =
        own_part >= explains_nearly_all && shown_part >= shows_enough &&
        part(counts.spoilt, counts.right) <= speaks_against &&
        static_cast<double>(candidate.different) <= (1.0 - explains_nearly_all) * least_wrong;
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
                             const Settings& reference, const std::vector<Bug>& bugs,
                             bool is_step_known)
    : picture_(std::move(picture)), name_(name), reference_(reference),
      changes_(known_changes(bugs, scene)), trial_(std::make_unique<PictureTrial>(picture_, scene)),
      is_step_known_(is_step_known) {}

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

void DiagnosisWork::stop_searching() {
    if (is_done() || tried_) return;
    is_stopped_ = true;
    trial_->stop_drawing();
    tried_ = search();
    trial_->draw_again();
    pictures_ = {};
}

/// Asks all that can be answered with what is drawn, and notes what must be drawn next.
void DiagnosisWork::ask() {
    PictureTrial& trial = *trial_;
    const ImageDistance& apart = trial.drawn(reference_).distance;
    if (trial.is_waiting()) return;
    if (apart.different > 0) {
        if (!is_affordable_) refuse_too_much();
        is_affordable_ = true;
    }
    if (!tried_) {
        std::vector<Attempt> tried{{reference_, {}}};
        if (apart.different > 0) tried = search();
        if (trial.is_waiting()) return;
        tried_ = std::move(tried);
    }
    look_closely(*tried_);
}

/// What was tried; the first is the reference.
std::vector<Attempt> DiagnosisWork::search() {
    std::vector<Attempt> tried = search_picture(*trial_, reference_, changes_);
    if (is_step_known_) {
        std::erase_if(tried, [&](const Attempt& attempt) {
            return !(step_of(attempt.right) == step_of(reference_));
        });
    }
    return tried;
}

void DiagnosisWork::look_closely(const std::vector<Attempt>& tried) {
    PictureTrial& trial = *trial_;
    const Attempt none{reference_, {}};
    const bool is_as_requested = tried.size() <= 1; // nothing was searched, or only one picture
    const Attempt& base = is_as_requested ? none : best_base(trial, tried, reference_);
    Diagnosis found;
    std::vector<Hypothesis> hypotheses;
    if (!is_as_requested) hypotheses = hypotheses_of(trial, tried, base, reference_);
    if (trial.is_waiting()) return;
    found.candidates = ranked(std::move(hypotheses));
    const Attempt& shown = convincing_base(trial, tried, base, reference_);
    for (Candidate& candidate : found.candidates)
        weigh(trial, base, shown, candidate);
    if (trial.is_waiting()) return;
    const Candidate* const likely = !found.candidates.empty() && found.candidates.front().is_likely
                                        ? &found.candidates.front()
                                        : nullptr;
    const Settings right = likely == nullptr ? shown.right : *likely->right;
    const KeptPicture* const kept = trial.picture_of(PictureRecipe{right});
    if (trial.is_waiting()) return;
    const Differences differences = differences_of(kept->image, picture_);
    found.different = differences.pixels;
    if (likely == nullptr && is_rounding(kept->image, picture_, is_same_pixel)) {
        found.candidates.clear();
        if (found.different > 0) {
            found.findings = {counted(found.different, "pixel has", "pixels have") +
                              " the colour of a neighbour, which the rounding of floats along "
                              "edges can cause."};
        }
        found.different = 0;
    } else {
        found.place = place_words(differences);
        if (likely == nullptr) {
            const int parts = tessellation_of(trial.scene(), right.tessellation);
            found.findings = findings_of(*kept, picture_, trial.scene(), parts);
        }
    }
    found.is_complete = !is_stopped_ || found.is_same();
    found.distance = trial.drawn(right).distance.mean;
    if (trial.is_waiting()) return;
    right_picture_ = kept->image;
    found.rules = enumerated(extra_rules(right, reference_));
    found.verdict = verdict_on(found);
    found_ = std::move(found);
}

void DiagnosisWork::refuse_too_much() const {
    if (pictures_tried * trial_->picture_work() <= most_diagnosis_work) return;
    throw InputError(fmt::format("{}: drawing {} triangles in {} x {} pixels for every mistake is "
                                 "too much work.",
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
