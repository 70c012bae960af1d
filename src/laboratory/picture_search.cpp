#include "laboratory/picture_search.h"

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

void add_bugs(const std::vector<Bug>& bugs, std::vector<Deed>& deeds) {
    for (const Bug& bug : bugs) {
        Deed deed{.id = bug.id, .name = bug.name, .set = {}, .bug = &bug};
        for (const auto& assignment : bug.set) {
            if (assignment.first != "stage") deed.set.push_back(assignment);
        }
        if (changes_rule(bug)) deeds.push_back(std::move(deed));
    }
}

/// Every word of every choice but the stage and its shading.
void add_choices(const Scene& scene, std::vector<Deed>& deeds) {
    for (const Setting& setting : setting_table()) {
        const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
        if (choice == nullptr || setting.name == "stage" || setting.part_of == "stage") continue;
        if (setting.name == "engine" || is_of_equal_rules(setting.name) ||
            !is_of_use(setting, scene))
            continue;
        for (const std::string_view word : choice->words) {
            if (is_word_of_whole(setting, word)) continue;
            const std::string id = fmt::format("{}={}", setting.name, word);
            deeds.push_back({.id = id,
                             .name = "Drawn by " + id,
                             .set = {{std::string(setting.name), std::string(word)}}});
        }
    }
}

void add_turns_and_moves(std::vector<Deed>& deeds) {
    for (const OrientationInfo& info : orientation_list()) {
        if (info.orientation == Orientation::upright) continue;
        deeds.push_back(
            {.id = info.id, .name = info.name, .set = {}, .orientation = info.orientation});
    }
    constexpr std::array<const char*, 3> across{"left", "", "right"}, along{"up", "", "down"};
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            if (dx == 0 && dy == 0) continue;
            const std::string where_x = across[static_cast<std::size_t>(dx + 1)];
            const std::string where_y = along[static_cast<std::size_t>(dy + 1)];
            const std::string both = where_x.empty() || where_y.empty() ? "" : " and a pixel ";
            deeds.push_back(
                {.id = "shifted",
                 .name = fmt::format("Shifted by a pixel {}{}{}", where_x, both, where_y),
                 .set = {},
                 .right = dx,
                 .down = dy});
        }
    }
}

/// The search itself. Each of its functions asks the trial, and gives up as soon as that is
/// waiting.
class Search {
  public:
    Search(PictureTrial& trial, const Settings& reference, const std::vector<Deed>& deeds)
        : trial_(trial), reference_(reference), deeds_(deeds) {}

    std::vector<Trying> run() {
        search();
        return std::move(found_);
    }

  private:
    /// So many of the nearest are looked at more closely.
    static constexpr std::size_t nearest_count = 6;

    double pixel_count() const {
        return static_cast<double>(trial_.picture().width) * trial_.picture().height;
    }

    bool is_waiting() const { return trial_.is_waiting(); }
    const Drawn& drawn(const Trying& trying) { return trial_.drawn(recipe_of(trying)); }

    /// Notes what is drawn.
    void note(const Trying& trying) {
        if (drawn(trying).print != 0) found_.push_back(trying);
    }

    double price(const Trying& trying) { return price_of(trial_, trying, reference_, unit_); }

    void sort(std::vector<Trying>& tryings) {
        sort(tryings, [&](const Trying& trying) { return price(trying); });
    }
    /// By how bright each pixel is: with a lamp that is nearly right every pixel is a little wrong.
    void sort_by_light(std::vector<Trying>& tryings) {
        sort(tryings, [&](const Trying& trying) { return drawn(trying).distance.mean; });
    }

    template <class Value>
    void sort(std::vector<Trying>& tryings, Value value) {
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < tryings.size(); ++i)
            order.emplace_back(value(tryings[i]), i);
        std::sort(order.begin(), order.end());
        std::vector<Trying> sorted;
        for (const auto& [unused, i] : order)
            sorted.push_back(tryings[i]);
        tryings = std::move(sorted);
    }

    /// The nearest of all that was found, none that makes the same picture as another.
    std::vector<Trying> nearest(std::size_t count, std::size_t most_deeds) {
        std::vector<Trying> sorted = found_, best;
        sort(sorted);
        std::vector<std::uint64_t> prints;
        for (const Trying& trying : sorted) {
            if (best.size() == count) break;
            const std::uint64_t print = drawn(trying).print;
            if (trying.deeds.size() > most_deeds ||
                std::find(prints.begin(), prints.end(), print) != prints.end())
                continue;
            prints.push_back(print);
            best.push_back(trying);
        }
        return best;
    }

    /// Is nearly all explained that is wrong without the deeds?
    bool is_explained(const Trying& trying) {
        const std::int64_t left = drawn(trying).distance.different;
        if (left == 0) return true;
        if (trying.deeds.empty()) return false;
        const std::int64_t wrong = drawn({trying.right, {}}).distance.different;
        return static_cast<double>(left) <=
               (1.0 - explains_nearly_all) * static_cast<double>(wrong);
    }

    /// The trying by those of the equally right rules with which it comes nearest, taken one by one
    /// as long as one helps clearly.
    /// @param vertices_only only by rules of how a vertex becomes a pixel
    Trying by_best_rules(Trying trying, bool vertices_only = false) {
        constexpr int most_rules = 3;
        constexpr double least_help = 0.02; // part of what is wrong
        const int most = vertices_only ? 1 : most_rules;
        for (int i = 0; i < most && drawn(trying).distance.different > 0; ++i) {
            std::vector<Trying> others;
            for (const Assignments& rule : equal_rules()) {
                if (vertices_only && rule.front().first != "vertex_rounding") continue;
                Trying other{by_equal_rule(rule, trying.right), trying.deeds};
                if (other.right == trying.right ||
                    !is_equal_there(rule, trying.right, trial_.scene()))
                    continue;
                if (recipe_of(other) == recipe_of(trying)) continue;
                others.push_back(std::move(other));
            }
            for (const Trying& other : others)
                drawn(other);
            if (is_waiting() || others.empty()) break;
            sort(others);
            const double most_wrong = (1.0 - least_help) * drawn(trying).distance.wrong;
            if (price(others.front()) >= price(trying) ||
                drawn(others.front()).distance.wrong > most_wrong)
                break;
            trying = others.front();
        }
        return trying;
    }

    Trying at_step(const StripStep& step) {
        Trying trying{reference_, {}};
        set_step(trying.right, step);
        return trying;
    }

    /// The two stages at which the picture is nearest to having been drawn: the nearest, and the
    /// one that a mistake most easily makes it look like.
    std::vector<Trying> stage_bases() {
        std::vector<Trying> all{{reference_, {}}};
        for (const StageInfo& info : stage_list()) {
            const Trying at = at_step(info.step);
            if (is_of_use(info, trial_.scene()) && !(at.right == reference_)) all.push_back(at);
        }
        for (const Trying& trying : all)
            note(trying);
        if (is_waiting()) return {};
        unit_ = assumption_unit(trial_, reference_);
        // A picture of points is mostly black, and so near to any that shows nothing where it
        // should.
        constexpr double shows_marks = 0.5;
        std::erase_if(all, [&](const Trying& trying) {
            return trying.right.stage <= Stage::rows &&
                   drawn(trying).distance.other_surface > shows_marks;
        });
        sort(all);
        constexpr double as_good = 0.02;
        double least = 2.0;
        for (const Trying& trying : all)
            least = std::min(least, drawn(trying).distance.other_surface);
        std::stable_partition(all.begin(), all.end(), [&](const Trying& trying) {
            return drawn(trying).distance.other_surface <= least + as_good;
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
        std::vector<Trying> bases{all.front()};
        const auto add = [&](const Trying& base) {
            const bool is_there = std::any_of(bases.begin(), bases.end(), [&](const Trying& one) {
                return one.right == base.right;
            });
            if (!is_there) bases.push_back(base);
        };
        const StripStep other = sibling(step_of(all.front().right));
        const StageInfo& info = stage_list()[static_cast<std::size_t>(strip_place(other))];
        if (is_of_use(info, trial_.scene())) add(at_step(other));
        // A shading that is no step of the strip is asked for.
        if (!(at_step(step_of(reference_)).right == reference_)) add({reference_, {}});
        // Much is wrong: then the stage may not be the one it seems, but the one that is asked for.
        constexpr double much = 0.3;
        if (drawn(all.front()).distance.wrong > much * pixel_count()) add({reference_, {}});
        return bases;
    }

    /// Each deed on a base; only bugs, or only the others.
    void try_deeds(const Trying& base, bool bugs) {
        for (const Deed& deed : deeds_) {
            if ((deed.bug != nullptr) != bugs) continue;
            Trying trying = base;
            trying.deeds.push_back(&deed);
            if (!(recipe_of(trying) == recipe_of(base))) note(trying);
        }
    }

    /// One that the reference does not make: the laboratory shows some mistakes against others.
    bool makes_mistake(const Settings& settings) const {
        return std::any_of(deeds_.begin(), deeds_.end(), [&](const Deed& deed) {
            return deed.bug != nullptr && is_made_by(*deed.bug, settings) &&
                   !is_made_by(*deed.bug, reference_);
        });
    }

    /// Mistakes as the laboratory shows them, with its own stage and lamp.
    void try_as_shown() {
        for (const Deed& deed : deeds_) {
            if (deed.bug == nullptr) continue;
            const Trying trying{correct_run(*deed.bug, reference_), {&deed}};
            if (recipe_of(trying).settings == trying.right) continue;
            if (!makes_mistake(trying.right)) note({trying.right, {}});
            note(trying);
        }
    }

    /// The nearest by their best rules.
    void refine(std::size_t count, std::size_t most_deeds) {
        for (const Trying& trying : nearest(count, most_deeds))
            note(by_best_rules(trying));
    }

    Trying fitted(const Trying& trying, FitSubject subject, FitEffort effort) {
        const Settings drawn_by = recipe_of(trying).settings;
        const Settings& found = trial_.fitted(drawn_by, reference_, subject, effort);
        Trying result = trying;
        if (subject == FitSubject::lamp) {
            result.right.light = found.light;
        } else {
            result.right.camera = found.camera;
        }
        return result;
    }

    /// The camera that fits best. Hues tell where it is, whatever the light; and half a pixel, by
    /// which vertices are rounded otherwise, is a few hundredths of a unit.
    Trying with_fitted_camera(const Trying& start) {
        const Trying first = fitted(start, FitSubject::camera, FitEffort::thorough);
        if (is_waiting() || first.right.camera == start.right.camera) return start;
        const auto rounded = [&](const Trying& trying) {
            std::vector<Trying> others{trying};
            for (const Assignments& rule : equal_rules()) {
                if (rule.front().first == "vertex_rounding")
                    others.push_back({by_equal_rule(rule, trying.right), {}});
            }
            return others;
        };
        std::vector<Trying> here = rounded(start), there = rounded(first);
        for (const std::vector<Trying>* others : {&here, &there}) {
            for (const Trying& other : *others)
                drawn(other);
        }
        if (is_waiting()) return start;
        const auto surface = [&](const Trying& other) {
            return drawn(other).distance.other_surface;
        };
        sort(here, surface);
        sort(there, surface);
        constexpr double as_good = 1.3;
        if (surface(here.front()) <= as_good * surface(there.front())) return here.front();
        const Trying closer = fitted(there.front(), FitSubject::camera, FitEffort::closer);
        drawn(closer);
        if (is_waiting()) return start;
        return surface(closer) < surface(there.front()) ? closer : there.front();
    }

    /// The stages with the camera and the lamp that fit best, without a mistake.
    std::vector<Trying> fitted_bases() {
        const Trying camera = with_fitted_camera(at_step({Stage::depth}));
        if (is_waiting()) return {};
        std::vector<Trying> cameras{camera};
        if (!(camera.right.camera == reference_.camera)) {
            // A mistake may only look like another camera.
            cameras.push_back(camera);
            cameras.back().right.camera = reference_.camera;
        }
        std::vector<Trying> starts;
        for (const Trying& at : cameras) {
            for (const StageInfo& info : stage_list()) {
                if (!is_of_use(info, trial_.scene())) continue;
                starts.push_back(at);
                set_step(starts.back().right, info.step);
            }
            Trying straight = at; // as right, for light of the vertices
            set_step(straight.right, StripStep::vertex_light);
            straight.right.interpolation = Interpolation::affine;
            if (is_equal_there({{"interpolation", "affine"}}, straight.right, trial_.scene()))
                starts.push_back(straight);
        }
        for (Trying& start : starts)
            start = fitted(start, FitSubject::lamp, FitEffort::quick);
        if (is_waiting()) return {};
        for (const Trying& start : starts)
            note(start);
        if (is_waiting()) return {};
        sort_by_light(starts);
        // The nearest of each stage.
        std::vector<Trying> nearest;
        for (const Trying& start : starts) {
            const bool has_stage =
                std::any_of(nearest.begin(), nearest.end(), [&](const Trying& one) {
                    return step_of(one.right) == step_of(start.right) &&
                           one.right.camera == start.right.camera;
                });
            if (!has_stage) nearest.push_back(start);
        }
        const std::size_t most_bases = 2 * cameras.size() + 1;
        nearest.resize(std::min(nearest.size(), most_bases));
        for (Trying& start : nearest)
            start = fitted(start, FitSubject::lamp, FitEffort::thorough);
        if (is_waiting()) return {};
        for (Trying& start : nearest)
            note(start);
        if (is_waiting()) return {};
        sort_by_light(nearest);
        for (const Trying& start : nearest)
            note(by_best_rules(start));
        return nearest;
    }

    /// A mistake changes which lamp fits: each bug with a lamp of its own.
    void try_bugs_with_lamps(const std::vector<Trying>& bases) {
        std::vector<Trying> tryings;
        for (const Trying& base : bases) {
            if (shading_rule(base.right) == Shading::unlit) continue;
            for (const Deed& deed : deeds_) {
                if (deed.bug == nullptr) continue;
                Trying trying = base;
                trying.deeds.push_back(&deed);
                const Drawn &one = drawn(trying), &plain = drawn(base);
                if (one.print == 0 || one.print == plain.print) continue;
                tryings.push_back(trying);
            }
        }
        if (is_waiting()) return;
        for (Trying& trying : tryings)
            trying = fitted(trying, FitSubject::lamp, FitEffort::quick);
        if (is_waiting()) return;
        for (const Trying& trying : tryings)
            note(trying);
        if (is_waiting() || tryings.empty()) return;
        sort_by_light(tryings);
        if (tryings.size() > nearest_count) tryings.resize(nearest_count);
        for (const Trying& trying : tryings)
            note(fitted(trying, FitSubject::lamp, FitEffort::thorough));
    }

    /// What helps beside the nearest.
    void try_second_deeds(std::size_t count) {
        for (const Trying& trying : nearest(count, 1)) {
            if (!trying.deeds.empty()) try_deeds(trying, true);
        }
    }

    /// Is it clear what made the picture? Where one mistake explains nearly all, a second one may
    /// hide in the rest.
    bool is_settled() {
        if (is_waiting()) return true; // until it is asked again
        const std::vector<Trying> best = nearest(1, 2);
        if (best.empty() || !is_explained(best.front())) return false;
        if (drawn(best.front()).distance.different == 0) return true;
        constexpr std::size_t looked_at = 2;
        try_second_deeds(looked_at);
        if (!is_waiting()) refine(nearest_count, 2);
        return true;
    }

    void search() {
        const std::vector<Trying> at_stages = stage_bases();
        if (is_waiting()) return;
        std::vector<Trying> bases;
        for (const Trying& base : at_stages) {
            bases.push_back(by_best_rules(base, true));
            note(bases.back());
            note(by_best_rules(bases.back()));
        }
        if (is_settled()) return;
        for (const Trying& base : bases)
            try_deeds(base, true);
        // A mistake may hide that the sum is cut, as most programs do.
        const Trying sum_cut{by_equal_rule(equal_rules().front(), at_stages.front().right), {}};
        if (!(sum_cut.right == bases.front().right)) try_deeds(sum_cut, true);
        try_as_shown();
        if (is_waiting()) return;
        refine(nearest_count, 1);
        if (is_settled()) return;
        // A picture that is moved by a pixel looks as if its vertices were rounded otherwise.
        for (const std::vector<Trying>& all : {bases, at_stages}) {
            for (const Trying& base : all)
                try_deeds(base, false);
        }
        if (is_settled()) return;

        const std::vector<Trying> fitted = fitted_bases();
        if (is_settled()) return;
        for (const bool with_other_camera : {false, true}) {
            // The nearest with the camera that is asked for, and the nearest with another.
            const auto base = std::find_if(fitted.begin(), fitted.end(), [&](const Trying& one) {
                return (one.right.camera == reference_.camera) != with_other_camera;
            });
            if (base != fitted.end()) try_deeds(by_best_rules(*base, true), true);
        }
        if (is_waiting()) return;
        refine(nearest_count, 1);
        if (is_settled()) return;
        try_bugs_with_lamps(fitted);
        if (is_waiting()) return;
        refine(nearest_count, 1);
        if (is_settled()) return;

        try_second_deeds(nearest_count);
        if (is_waiting()) return;
        refine(nearest_count, 2);
        if (is_settled()) return;
        for (const Trying& trying : nearest(2, 2))
            note(this->fitted(trying, FitSubject::lamp, FitEffort::thorough));
        if (is_waiting()) return;
        refine(2, 2);
    }

    PictureTrial& trial_;
    const Settings& reference_;
    const std::vector<Deed>& deeds_;
    double unit_ = 1.0;
    std::vector<Trying> found_;
};

} // namespace

std::vector<Deed> known_deeds(const std::vector<Bug>& bugs, const Scene& scene) {
    std::vector<Deed> deeds;
    add_bugs(bugs, deeds);
    add_choices(scene, deeds);
    add_turns_and_moves(deeds);
    return deeds;
}

PictureRecipe recipe_of(const Trying& trying) {
    PictureRecipe recipe{trying.right};
    for (const Deed* deed : trying.deeds) {
        for (const auto& [name, value] : deed->set)
            set_value(recipe.settings, *find_setting(name), value);
        if (deed->orientation != Orientation::upright) recipe.orientation = deed->orientation;
        recipe.right += deed->right;
        recipe.down += deed->down;
    }
    return recipe;
}

std::vector<std::string> rules_beside(const Settings& right, const Settings& reference) {
    std::vector<std::string> rules;
    for (const Setting& setting : setting_table()) {
        if (!must_be_said(setting, reference, right)) continue;
        rules.push_back(fmt::format("{}={}", setting.name, value_text(setting, right)));
    }
    return rules;
}

double assumptions_of(const Trying& trying, const Settings& reference) {
    constexpr double of_rule = 0.5, of_odd_number = 1.1, of_bug = 1.0, of_other = 1.2;
    constexpr std::size_t longest_number = 5; // "-0.25", "13.82": one that a person would choose
    double sum = 0.0;
    for (const Deed* deed : trying.deeds)
        sum += deed->bug != nullptr ? of_bug : of_other;
    if (trying.right == reference) return sum;
    for (const Setting& setting : setting_table()) {
        if (!must_be_said(setting, reference, trying.right)) continue;
        // The camera is where the handout has it, or where the student says.
        const bool is_odd = setting.name.starts_with("camera.") ||
                            (setting.name == "light.power" &&
                             value_text(setting, trying.right).size() > longest_number);
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

double price_of(PictureTrial& trial, const Trying& trying, const Settings& reference, double unit) {
    constexpr double of_exact =
        0.05; // what leaves nothing may assume more than what leaves a little
    const ImageDistance& left = trial.drawn(recipe_of(trying)).distance;
    const double assumed = unit * assumptions_of(trying, reference);
    return left.wrong + (left.different == 0 ? of_exact * assumed : assumed);
}

std::vector<Trying> search_picture(PictureTrial& trial, const Settings& reference,
                                   const std::vector<Deed>& deeds) {
    return Search(trial, reference, deeds).run();
}

const Trying& best_base(PictureTrial& trial, const std::vector<Trying>& tried,
                        const Settings& reference) {
    const double unit = assumption_unit(trial, reference);
    // Of those that show the same surfaces: a picture that is mostly black is near to many.
    constexpr double as_good = 0.1;
    double surface = std::numeric_limits<double>::max();
    for (const Trying& trying : tried) {
        if (trying.deeds.empty())
            surface = std::min(surface, trial.drawn(trying.right).distance.other_surface);
    }
    const Trying* best = &tried.front();
    double least = std::numeric_limits<double>::max();
    for (const Trying& trying : tried) {
        if (!trying.deeds.empty() ||
            trial.drawn(trying.right).distance.other_surface > surface + as_good)
            continue;
        const double price = price_of(trial, trying, reference, unit);
        if (price >= least) continue;
        best = &trying;
        least = price;
    }
    return *best;
}

} // namespace rasterwalk
