#include "laboratory/picture_search.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "laboratory/bug_rule.h"
#include "laboratory/equal_rules.h"
#include "laboratory/rounder_lamps.h"

namespace rasterwalk {

namespace {

/// The search itself. Each of its functions asks the trial, and gives up as soon as that is
/// waiting.
class Search {
  public:
    Search(PictureTrial& trial, const Settings& reference, const std::vector<Change>& changes)
        : trial_(trial), reference_(reference), changes_(changes) {}

    std::vector<Attempt> run() {
        search();
        return std::move(found_);
    }

  private:
    /// How many of the nearest are examined more closely.
    static constexpr std::size_t nearest_count = 6;

    double pixel_count() const {
        return static_cast<double>(trial_.picture().width) * trial_.picture().height;
    }

    bool is_waiting() const { return trial_.is_waiting(); }
    const Drawn& drawn(const Attempt& attempt) { return trial_.drawn(recipe_of(attempt)); }

    /// Notes what is drawn.
    void note(const Attempt& attempt) {
        if (drawn(attempt).print != 0) found_.push_back(attempt);
    }

    double price(const Attempt& attempt) { return price_of(trial_, attempt, reference_, unit_); }

    void sort(std::vector<Attempt>& attempts) {
        sort(attempts, [&](const Attempt& attempt) { return price(attempt); });
    }
    /// Sorts by the difference in brightness, because with a lamp that is nearly right every pixel
    /// is a little wrong.
    void sort_by_light(std::vector<Attempt>& attempts) {
        sort(attempts, [&](const Attempt& attempt) { return drawn(attempt).distance.mean; });
    }

    template <class Value>
    void sort(std::vector<Attempt>& attempts, Value value) {
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < attempts.size(); ++i)
            order.emplace_back(value(attempts[i]), i);
        std::sort(order.begin(), order.end());
        std::vector<Attempt> sorted;
        for (const auto& [unused, i] : order)
            sorted.push_back(attempts[i]);
        attempts = std::move(sorted);
    }

    /// The nearest of all that was found, no two of which make the same picture.
    std::vector<Attempt> nearest(std::size_t count, std::size_t most_changes) {
        std::vector<Attempt> sorted = found_, best;
        sort(sorted);
        std::vector<std::uint64_t> prints;
        for (const Attempt& attempt : sorted) {
            if (best.size() == count) break;
            const std::uint64_t print = drawn(attempt).print;
            if (attempt.changes.size() > most_changes ||
                std::find(prints.begin(), prints.end(), print) != prints.end())
                continue;
            prints.push_back(print);
            best.push_back(attempt);
        }
        return best;
    }

    /// Do the changes explain nearly all that is wrong without them?
    bool is_explained(const Attempt& attempt) {
        const std::int64_t left = drawn(attempt).distance.different;
        if (left == 0) return true;
        if (attempt.changes.empty()) return false;
        std::int64_t wrong = drawn({attempt.right, {}}).distance.different;
        for (const Attempt& one : found_) {
            if (one.changes.empty()) wrong = std::min(wrong, drawn(one).distance.different);
        }
        return static_cast<double>(left) <=
               (1.0 - explains_nearly_all) * static_cast<double>(wrong);
    }

    /// The attempt with the equally right rules that bring it nearest, taken one by one as long as
    /// one helps clearly.
    /// @param vertices_only only rules for how a vertex becomes a pixel
    Attempt by_best_rules(Attempt attempt, bool vertices_only = false) {
        constexpr int most_rules = 3;
        constexpr double least_help = 0.02; // part of what is wrong
        const int most = vertices_only ? 1 : most_rules;
        for (int i = 0; i < most && drawn(attempt).distance.different > 0; ++i) {
            std::vector<Attempt> others;
            for (const Assignments& rule : equal_rules()) {
                if (vertices_only && rule.front().first != "vertex_rounding") continue;
                Attempt other{by_equal_rule(rule, attempt.right), attempt.changes};
                if (other.right == attempt.right ||
                    !is_equal_there(rule, attempt.right, trial_.scene()))
                    continue;
                if (recipe_of(other) == recipe_of(attempt)) continue;
                others.push_back(std::move(other));
            }
            for (const Attempt& other : others)
                drawn(other);
            if (is_waiting() || others.empty()) break;
            sort(others);
            const double most_wrong = (1.0 - least_help) * drawn(attempt).distance.wrong;
            if (price(others.front()) >= price(attempt) ||
                drawn(others.front()).distance.wrong > most_wrong)
                break;
            attempt = others.front();
        }
        return attempt;
    }

    Attempt at_step(const StripStep& step) {
        Attempt attempt{reference_, {}};
        set_step(attempt.right, step);
        return attempt;
    }

    /// The two stages that the picture most probably shows: the nearest, and the one that a mistake
    /// most easily makes it look like.
    std::vector<Attempt> stage_bases() {
        std::vector<Attempt> all{{reference_, {}}};
        for (const StageInfo& info : stage_list()) {
            const Attempt at = at_step(info.step);
            if (is_of_use(info, trial_.scene()) && !(at.right == reference_)) all.push_back(at);
        }
        for (const Attempt& attempt : all)
            note(attempt);
        if (is_waiting()) return {};
        unit_ = assumption_unit(trial_, reference_);
        // A picture of points is mostly black, and so near to any that wrongly shows nothing.
        constexpr double shows_marks = 0.5;
        std::erase_if(all, [&](const Attempt& attempt) {
            return attempt.right.stage <= Stage::rows &&
                   drawn(attempt).distance.other_surface > shows_marks;
        });
        sort(all);
        constexpr double as_good = 0.02;
        double least = 2.0;
        for (const Attempt& attempt : all)
            least = std::min(least, drawn(attempt).distance.other_surface);
        std::stable_partition(all.begin(), all.end(), [&](const Attempt& attempt) {
            return drawn(attempt).distance.other_surface <= least + as_good;
        });
        const auto sibling = [](const StripStep& step) -> StripStep {
            constexpr std::array<std::pair<StripStep, StripStep>, 3> pairs{
                {{StripStep{Stage::points}, StripStep{Stage::edges}},
                 {StripStep{Stage::fill}, StripStep{Stage::depth}},
                 {StripStep::vertex_light, StripStep::pixel_light}}};
            for (const auto& [one, other] : pairs) {
                if (step == one) return other;
                if (step == other) return one;
            }
            return step;
        };
        std::vector<Attempt> bases{all.front()};
        const auto add = [&](const Attempt& base) {
            const bool is_there = std::any_of(bases.begin(), bases.end(), [&](const Attempt& one) {
                return one.right == base.right;
            });
            if (!is_there) bases.push_back(base);
        };
        const StripStep other = sibling(step_of(all.front().right));
        const StageInfo& info = stage_list()[static_cast<std::size_t>(strip_place(other))];
        if (is_of_use(info, trial_.scene())) add(at_step(other));
        // The requested shading is not a step of the strip.
        if (!(at_step(step_of(reference_)).right == reference_)) add({reference_, {}});
        // If much is wrong, the stage may not be the one it seems, but the requested one.
        constexpr double much = 0.3;
        if (drawn(all.front()).distance.wrong > much * pixel_count()) add({reference_, {}});
        return bases;
    }

    /// Tries each change on a base; only bugs, or only the others.
    void try_changes(const Attempt& base, bool bugs) {
        for (const Change& change : changes_) {
            if ((change.bug != nullptr) != bugs) continue;
            Attempt attempt = base;
            attempt.changes.push_back(&change);
            if (!(recipe_of(attempt) == recipe_of(base))) note(attempt);
        }
    }

    /// Do these settings make a mistake that the reference does not make? The laboratory shows some
    /// mistakes compared with others.
    bool makes_mistake(const Settings& settings) const {
        return std::any_of(changes_.begin(), changes_.end(), [&](const Change& change) {
            return change.bug != nullptr && is_made_by(*change.bug, settings) &&
                   !is_made_by(*change.bug, reference_);
        });
    }

    /// Mistakes as the laboratory shows them, with its own stage and lamp.
    void try_as_shown() {
        for (const Change& change : changes_) {
            if (change.bug == nullptr) continue;
            const Attempt attempt{correct_run(*change.bug, reference_), {&change}};
            if (recipe_of(attempt).settings == attempt.right) continue;
            // Another way to hide surfaces is right in its own way, but not the same picture.
            const bool hides_alike = attempt.right.hidden == reference_.hidden;
            if (hides_alike && !makes_mistake(attempt.right)) note({attempt.right, {}});
            note(attempt);
        }
    }

    /// Tries the nearest with their best rules.
    void refine(std::size_t count, std::size_t most_changes) {
        for (const Attempt& attempt : nearest(count, most_changes))
            note(by_best_rules(attempt));
    }

    Attempt fitted(const Attempt& attempt, FitSubject subject, FitEffort effort) {
        const Settings drawn_by = recipe_of(attempt).settings;
        const Settings& found = trial_.fitted(drawn_by, reference_, subject, effort);
        Attempt result = attempt;
        if (subject == FitSubject::lamp) {
            result.right.light = found.light;
        } else {
            result.right.camera = found.camera;
        }
        return result;
    }

    /// The camera that fits best. Hues show where it is, whatever the light; and the half pixel by
    /// which vertices are rounded differently is a few hundredths of a unit.
    Attempt with_fitted_camera(const Attempt& start) {
        const Attempt first = fitted(start, FitSubject::camera, FitEffort::thorough);
        if (is_waiting() || first.right.camera == start.right.camera) return start;
        const auto rounded = [&](const Attempt& attempt) {
            std::vector<Attempt> others{attempt};
            for (const Assignments& rule : equal_rules()) {
                if (rule.front().first == "vertex_rounding")
                    others.push_back({by_equal_rule(rule, attempt.right), {}});
            }
            return others;
        };
        std::vector<Attempt> here = rounded(start), there = rounded(first);
        for (const std::vector<Attempt>* others : {&here, &there}) {
            for (const Attempt& other : *others)
                drawn(other);
        }
        if (is_waiting()) return start;
        const auto surface = [&](const Attempt& other) {
            return drawn(other).distance.other_surface;
        };
        sort(here, surface);
        sort(there, surface);
        constexpr double as_good = 1.3;
        if (surface(here.front()) <= as_good * surface(there.front())) return here.front();
        const Attempt closer = fitted(there.front(), FitSubject::camera, FitEffort::closer);
        drawn(closer);
        if (is_waiting()) return start;
        return surface(closer) < surface(there.front()) ? closer : there.front();
    }

    /// The stages with the camera and the lamp that fit best, without a mistake.
    std::vector<Attempt> fitted_bases() {
        const Attempt camera = with_fitted_camera(at_step({Stage::depth}));
        if (is_waiting()) return {};
        std::vector<Attempt> cameras{camera};
        if (!(camera.right.camera == reference_.camera)) {
            // It may be a mistake that only looks like another camera.
            cameras.push_back(camera);
            cameras.back().right.camera = reference_.camera;
        }
        std::vector<Attempt> starts;
        for (const Attempt& at : cameras) {
            for (const StageInfo& info : stage_list()) {
                if (!is_of_use(info, trial_.scene())) continue;
                starts.push_back(at);
                set_step(starts.back().right, info.step);
            }
            Attempt straight = at; // equally right, for light at the vertices
            set_step(straight.right, StripStep::vertex_light);
            straight.right.interpolation = Interpolation::affine;
            if (is_equal_there({{"interpolation", "affine"}}, straight.right, trial_.scene()))
                starts.push_back(straight);
        }
        for (Attempt& start : starts)
            start = fitted(start, FitSubject::lamp, FitEffort::quick);
        if (is_waiting()) return {};
        for (const Attempt& start : starts)
            note(start);
        if (is_waiting()) return {};
        sort_by_light(starts);
        // The nearest of each stage.
        std::vector<Attempt> nearest;
        for (const Attempt& start : starts) {
            const bool has_stage =
                std::any_of(nearest.begin(), nearest.end(), [&](const Attempt& one) {
                    return step_of(one.right) == step_of(start.right) &&
                           one.right.camera == start.right.camera;
                });
            if (!has_stage) nearest.push_back(start);
        }
        const std::size_t most_bases = 2 * cameras.size() + 1;
        nearest.resize(std::min(nearest.size(), most_bases));
        for (Attempt& start : nearest)
            start = fitted(start, FitSubject::lamp, FitEffort::thorough);
        if (is_waiting()) return {};
        for (Attempt& start : nearest)
            note(start);
        if (is_waiting()) return {};
        sort_by_light(nearest);
        for (const Attempt& start : nearest)
            note(by_best_rules(start));
        return nearest;
    }

    /// A mistake changes which lamp fits, so each bug gets its own lamp.
    void try_bugs_with_lamps(const std::vector<Attempt>& bases) {
        std::vector<Attempt> attempts;
        for (Attempt base : bases) {
            if (shading_rule(base.right) == Shading::unlit) continue;
            // Without a lamp, mistakes of the light do not show.
            if (base.right.light.power == glm::vec3(0.0f)) base.right.light = reference_.light;
            for (const Change& change : changes_) {
                if (change.bug == nullptr) continue;
                Attempt attempt = base;
                attempt.changes.push_back(&change);
                const Drawn &one = drawn(attempt), &plain = drawn(base);
                if (one.print == 0 || one.print == plain.print) continue;
                attempts.push_back(attempt);
            }
        }
        if (is_waiting()) return;
        for (Attempt& attempt : attempts)
            attempt = fitted(attempt, FitSubject::lamp, FitEffort::quick);
        if (is_waiting()) return;
        for (const Attempt& attempt : attempts)
            note(attempt);
        if (is_waiting() || attempts.empty()) return;
        sort_by_light(attempts);
        if (attempts.size() > nearest_count) attempts.resize(nearest_count);
        for (const Attempt& attempt : attempts)
            note(fitted(attempt, FitSubject::lamp, FitEffort::thorough));
    }

    /// Tries the nearest with a lamp that fits better, then with numbers as a person chooses them,
    /// and with those and the rules of the reference, because a fit in a small picture can end next
    /// to them.
    void try_better_lamps(std::size_t count) {
        const Light& usual = reference_.light;
        for (Attempt attempt : nearest(count, 2)) {
            if (shading_rule(attempt.right) == Shading::unlit) continue;
            if (attempt.right.light == usual) continue;
            const bool is_exact = drawn(attempt).distance.different == 0;
            if (!is_exact) {
                attempt = fitted(attempt, FitSubject::lamp, FitEffort::thorough);
                if (is_waiting()) return;
                note(attempt);
            }
            Attempt plain = attempt;
            plain.right = at_step(step_of(attempt.right)).right;
            plain.right.camera = attempt.right.camera;
            plain.right.light = attempt.right.light;
            Attempt in_place = plain;
            in_place.right.light.position = usual.position;
            in_place.right.light.indirect = usual.indirect;
            record_nearest(in_place, with_rounder_powers(in_place.right.light, usual));
            for (Attempt other : {attempt, plain}) {
                if (is_exact) break;
                other = record_nearest(other, with_rounder_places(other.right.light, usual));
                if (is_waiting()) return;
                record_nearest(other, with_rounder_powers(other.right.light, usual));
            }
        }
    }

    /// Notes the attempt with each of these lamps; returns the one that comes nearest.
    Attempt record_nearest(const Attempt& attempt, const std::vector<Light>& lights) {
        std::vector<Attempt> others;
        for (const Light& light : lights) {
            others.push_back(attempt);
            others.back().right.light = light;
            note(others.back());
        }
        if (is_waiting()) return attempt;
        sort(others);
        return others.front();
    }

    /// Tries what helps in addition to the nearest.
    void try_second_changes(std::size_t count) {
        for (const Attempt& attempt : nearest(count, 1)) {
            if (!attempt.changes.empty()) try_changes(attempt, true);
        }
    }

    /// Is it clear what made the picture? If one mistake explains nearly all, a second may hide in
    /// the rest.
    bool is_settled() {
        if (is_waiting()) return true; // until it is asked again
        const std::vector<Attempt> best = nearest(1, 2);
        if (best.empty() || !is_explained(best.front())) return false;
        if (drawn(best.front()).distance.different == 0) {
            try_better_lamps(1);
            return true;
        }
        constexpr std::size_t pairs_tried = 2;
        try_better_lamps(pairs_tried);
        if (!is_waiting()) try_second_changes(pairs_tried);
        if (!is_waiting()) refine(nearest_count, 2);
        return true;
    }

    void search() {
        const std::vector<Attempt> at_stages = stage_bases();
        if (is_waiting()) return;
        std::vector<Attempt> bases;
        for (const Attempt& base : at_stages) {
            bases.push_back(by_best_rules(base, true));
            note(bases.back());
            note(by_best_rules(bases.back()));
        }
        if (is_settled()) return;
        for (const Attempt& base : bases)
            try_changes(base, true);
        // A mistake may hide that the sum is cut, as in most programs.
        const Attempt sum_cut{by_equal_rule(equal_rules().front(), at_stages.front().right), {}};
        if (!(sum_cut.right == bases.front().right)) try_changes(sum_cut, true);
        try_as_shown();
        if (is_waiting()) return;
        refine(nearest_count, 1);
        if (is_settled()) return;
        // A picture moved by a pixel looks as if its vertices were rounded differently.
        for (const std::vector<Attempt>& all : {bases, at_stages}) {
            for (const Attempt& base : all)
                try_changes(base, false);
        }
        if (is_settled()) return;

        const std::vector<Attempt> fitted = fitted_bases();
        if (is_settled()) return;
        for (const bool with_other_camera : {false, true}) {
            // The nearest with the requested camera, and the nearest with another.
            const auto base = std::find_if(fitted.begin(), fitted.end(), [&](const Attempt& one) {
                return (one.right.camera == reference_.camera) != with_other_camera;
            });
            if (base != fitted.end()) try_changes(by_best_rules(*base, true), true);
        }
        if (is_waiting()) return;
        refine(nearest_count, 1);
        if (is_settled()) return;
        try_bugs_with_lamps(fitted);
        if (is_waiting()) return;
        refine(nearest_count, 1);
        if (is_settled()) return;

        try_second_changes(nearest_count);
        if (is_waiting()) return;
        refine(nearest_count, 2);
        if (is_settled()) return;
        try_better_lamps(nearest_count);
        if (is_waiting()) return;
        refine(2, 2);
    }

    PictureTrial& trial_;
    const Settings& reference_;
    const std::vector<Change>& changes_;
    double unit_ = 1.0;
    std::vector<Attempt> found_;
};

} // namespace

std::vector<Attempt> search_picture(PictureTrial& trial, const Settings& reference,
                                    const std::vector<Change>& changes) {
    return Search(trial, reference, changes).run();
}

} // namespace rasterwalk
