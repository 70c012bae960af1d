#include "inspect/depth_ruler.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stages/orthographic.h"

namespace rasterwalk {

namespace {

/// If the scale has more powers of ten than this, only they are marked.
constexpr int most_fine_decades = 3;

/// Rounding may put the value stored for a plane just beyond it; share of the scale.
constexpr double beyond_end = 1e-6;

/// Is there anything between near and far?
bool has_planes(const DepthRules& rules) {
    return std::isfinite(rules.near) && std::isfinite(rules.far) && rules.near > 0.0f &&
           rules.near < rules.far;
}

float buffer_value(int number, const DepthRules& rules) {
    const float part = static_cast<float>(number) / static_cast<float>((1 << rules.bits) - 1);
    return rules.projection.clip_depth == ClipDepth::inv_z ? part / rules.near : part;
}

DepthStep step_of(float stored, std::optional<int> number, const DepthRules& rules) {
    return {stored, number, z_of_depth(stored, rules)};
}

/// The step of a value that the buffer holds, or of the one that it holds instead.
DepthStep held_step(float depth, const DepthRules& rules) {
    if (rules.bits == 0) return step_of(depth, std::nullopt, rules);
    const int nearest = buffer_step(depth, rules), largest = (1 << rules.bits) - 1;
    int held = nearest;
    // 1/z times near is rounded, so that the number can be off by one.
    for (int number = std::max(nearest - 1, 0); number <= std::min(nearest + 1, largest); ++number)
        if (buffer_value(number, rules) == depth) held = number;
    return step_of(buffer_value(held, rules), held, rules);
}

/// The next value that the buffer can hold, toward the camera or away from it.
std::optional<DepthStep> next_step(const DepthStep& step, bool is_nearer, const DepthRules& rules) {
    const bool grows = is_nearer != is_smaller_nearer(rules.projection.clip_depth);
    if (!step.number) {
        const float infinity = std::numeric_limits<float>::infinity();
        const float next = std::nextafter(step.stored, grows ? infinity : -infinity);
        if (!std::isfinite(next)) return std::nullopt;
        return step_of(next, std::nullopt, rules);
    }
    const int largest = (1 << rules.bits) - 1;
    int number = *step.number;
    float stored = step.stored;
    // With 24 bits, two of the numbers can be the same float.
    while (stored == step.stored) {
        number += grows ? 1 : -1;
        if (number < 0 || number > largest) return std::nullopt;
        stored = buffer_value(number, rules);
    }
    return step_of(stored, number, rules);
}

/// Is it in front of the camera, at a finite distance?
bool is_in_front(const DepthStep& step) {
    return std::isfinite(step.z) && step.z > 0.0;
}

/// As far as neighbours can be told apart, from one end of the scale toward the other.
std::vector<DepthStep> told_apart(const DepthRuler& ruler, bool is_from_far, double least) {
    std::vector<DepthStep> steps;
    const double end = is_from_far ? ruler.stored.high : ruler.stored.low;
    const auto most = static_cast<std::size_t>(std::min(1.0 / least, 1e4)) + 1;
    std::optional<DepthStep> step = held_step(static_cast<float>(end), ruler.rules);
    while (step && steps.size() < most) {
        const std::optional<DepthStep> next = next_step(*step, is_from_far, ruler.rules);
        if (!next) break;
        const double apart = std::abs(ruler.place(next->z) - ruler.place(step->z));
        // Where z is infinite this is NaN, which ends the ticks too.
        if (!(apart >= least)) break;
        const auto is_shown = [&](const DepthStep& one) {
            const double place = ruler.place(one.z);
            return place >= -beyond_end && place <= 1.0 + beyond_end;
        };
        if (is_shown(*step)) steps.push_back(*step);
        if (!is_shown(*next) && !steps.empty()) break;
        step = next;
    }
    return steps;
}

/// Powers of ten, and 2 and 5 times those if there are few.
std::vector<double> round_places(const Interval& range) {
    std::vector<double> places;
    const int first = static_cast<int>(std::floor(std::log10(range.low)));
    const int last = static_cast<int>(std::floor(std::log10(range.high)));
    for (int power = first; power <= last; ++power) {
        for (const double times : {1.0, 2.0, 5.0}) {
            if (times > 1.0 && last - first > most_fine_decades) continue;
            const double place = times * std::pow(10.0, power);
            if (place >= range.low && place <= range.high) places.push_back(place);
        }
    }
    return places;
}

} // namespace

std::optional<double> DepthWindow::gap_nearer() const {
    if (middle == 0) return std::nullopt;
    return gaps[middle - 1];
}

std::optional<double> DepthWindow::gap_farther() const {
    if (middle + 1 >= steps.size()) return std::nullopt;
    return gaps[middle];
}

std::optional<DepthWindow> depth_window(float stored, const DepthRules& rules) {
    const bool needs_planes = rules.projection.clip_depth != ClipDepth::inv_z;
    if (!std::isfinite(stored) || (needs_planes && !has_planes(rules))) return std::nullopt;
    const DepthStep asked = held_step(stored, rules);
    if (!is_in_front(asked)) return std::nullopt;
    DepthWindow window;
    const auto neighbours = [&](bool is_nearer) {
        std::vector<DepthStep> found;
        std::optional<DepthStep> step = next_step(asked, is_nearer, rules);
        while (step && is_in_front(*step) && found.size() < depth_window_reach) {
            found.push_back(*step);
            step = next_step(*step, is_nearer, rules);
        }
        return found;
    };
    window.steps = neighbours(true);
    std::reverse(window.steps.begin(), window.steps.end());
    window.middle = window.steps.size();
    window.steps.push_back(asked);
    const std::vector<DepthStep> farther = neighbours(false);
    window.steps.insert(window.steps.end(), farther.begin(), farther.end());
    for (std::size_t i = 0; i + 1 < window.steps.size(); ++i)
        window.gaps.push_back(z_between(window.steps[i].stored, window.steps[i + 1].stored, rules));
    return window;
}

double DepthRuler::place(double z_world) const {
    if (is_logarithmic) return std::log(z_world / z.low) / std::log(z.high / z.low);
    return (z_world - z.low) / (z.high - z.low);
}

double DepthRuler::stored_place(double value) const {
    return (value - stored.low) / (stored.high - stored.low);
}

std::optional<DepthRuler> depth_ruler(const DepthRules& rules, double least) {
    if (!has_planes(rules) || !(least > 0.0)) return std::nullopt;
    DepthRuler ruler;
    ruler.rules = rules;
    ruler.z = {rules.near, rules.far};
    // With parallel rays the buffer itself is linear in z.
    ruler.is_logarithmic =
        rules.projection.mix < 1.0f && ruler.z.high >= logarithmic_ratio * ruler.z.low;
    ruler.stored = {depth_at(rules.near, rules), depth_at(rules.far, rules)};
    if (!std::isfinite(ruler.stored.low) || !std::isfinite(ruler.stored.high) ||
        ruler.stored.low == ruler.stored.high)
        return std::nullopt;
    ruler.round = ruler.is_logarithmic ? round_places(ruler.z) : nice_ticks(ruler.z, 6).places;
    ruler.told_apart = told_apart(ruler, true, least);
    const std::vector<DepthStep> at_near = told_apart(ruler, false, least);
    std::vector<DepthStep>& all = ruler.told_apart;
    all.insert(all.end(), at_near.begin(), at_near.end());
    std::sort(all.begin(), all.end(),
              [](const DepthStep& a, const DepthStep& b) { return a.z < b.z; });
    all.erase(
        std::unique(all.begin(), all.end(),
                    [](const DepthStep& a, const DepthStep& b) { return a.stored == b.stored; }),
        all.end());
    return ruler;
}

} // namespace rasterwalk
