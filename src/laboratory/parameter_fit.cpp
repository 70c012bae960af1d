#include "laboratory/parameter_fit.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/vec3.hpp>

#include "base/linear_system.h"
#include "picture/view_image.h"
#include "scene/scene.h"

namespace rasterwalk {

namespace {

/// The longer side, pixels, of the small picture for most of the search, and of the one in which
/// it ends for the lamp. For the camera it ends in the picture's own size, up to a limit, because
/// an edge shows each pixel.
constexpr int small_side = 100, larger_side = 200, largest_side_of_edges = 1000;
/// The longer side of the picture for finding the camera's starts, or a lamp quickly.
constexpr int smallest_side = 50;

/// Rounder numbers are taken if they are worse by at most this factor.
constexpr double hardly_worse = 1.02;
/// Unusual numbers are taken only if the usual ones are worse by more than this factor.
constexpr double clearly_worse = 1.15;
/// Each further number of the camera must be worth this part, another position of the lamp this.
constexpr double for_each_number = 0.1, for_position = 0.03;
/// Coloured light is taken only if white light is worse by more than this factor.
constexpr double much_worse = 2.0;

/// The lamp's power in the pictures that the right one is computed from: neither hardly visible
/// nor cut off at white.
constexpr double trial_power = 5.0;

/// Numbers of the camera that programs change together: a camera that turns or moves sideways
/// mostly moves forward too.
constexpr std::array<std::pair<std::size_t, std::size_t>, 6> camera_pairs{
    {{2, 3}, {0, 3}, {0, 2}, {1, 2}, {2, 4}, {0, 1}}};

/// The first stride of a coarse search, as a part of what was scanned.
constexpr double longest_stride = 0.125;

constexpr std::uint32_t all_free = ~0u, all_but_focal = ~(1u << 4u), all_but_position = ~7u;

constexpr int most_steps = 12, most_larger_steps = 8, most_refused = 4;

double rounded_to(double value, double unit) {
    return std::round(value / unit) * unit;
}

} // namespace

void ParameterFit::begin(const Image& picture, const Scene& scene, const FitStart& start,
                         FitSubject subject, FitEffort effort) {
    picture_ = &picture;
    scene_ = &scene;
    start_ = start.settings;
    subject_ = subject;
    usual_ = numbers_of(start.usual);
    effort_ = effort;
    is_larger_ = false;
    is_white_ = subject == FitSubject::lamp;
    is_drawing_ = false;
    rounded_ = 0;
    best_ = {};
    // About a pixel of the small picture, or a hundredth of the light.
    steps_ = subject == FitSubject::lamp
                 ? Numbers{0.02, 0.02, 0.02, 0.2, 0.2, 0.2, 0.01}
                 : Numbers{0.02, 0.02, 0.02, 0.008,
                           0.01 * static_cast<double>(start_.camera.focal_length)};
    const glm::dvec3 half = 0.5 * (box_of(scene).high - box_of(scene).low);
    const double unit = std::max({half.x, half.y, half.z});
    reach_ = {1.2 * unit, 1.2 * unit, 1.6 * unit, 0.8, 0.0};
    if (effort == FitEffort::closer) {
        sight_ = make_sight(small_side);
        best_.cost = std::numeric_limits<double>::max();
        starts_ = {{numbers_of(start_), all_free}};
        begin_descent();
    } else {
        begin_scan();
    }
}

void ParameterFit::begin_scan() {
    const Numbers own = numbers_of(start_);
    probes_.assign(1, {own});
    const auto ask = [&](Numbers numbers) { probes_.push_back({numbers}); };
    const SceneBox box = box_of(*scene_);
    if (subject_ == FitSubject::lamp) {
        sight_ = make_sight(effort_ == FitEffort::quick ? smallest_side : small_side);
        // What is black, and the picture without the lamp, then with it in many positions.
        const auto lit = [](const glm::dvec3& p, double power, double indirect) {
            return Numbers{p.x, p.y, p.z, power, power, power, indirect};
        };
        const glm::dvec3 place(own[0], own[1], own[2]);
        ask(lit(place, 0.0, 0.0));
        ask(lit(place, 0.0, 1.0));
        for (const double x : {-0.6, 0.0, 0.6}) {
            for (const double y : {-0.6, 0.0, 0.6}) {
                for (const double z : {-1.5, -0.7, 0.0, 0.6}) {
                    ask(lit(box.middle() + 0.5 * (box.high - box.low) * glm::dvec3(x, y, z),
                            trial_power, 0.0));
                }
            }
        }
        ask(lit(place, trial_power, 0.0));
        ask(lit({usual_[0], usual_[1], usual_[2]}, trial_power, 0.0));
    } else {
        sight_ = make_sight(smallest_side);
        constexpr int places = 8; // to each side, alone; half as many in pairs
        for (std::size_t which = 0; which < number_count(); ++which) {
            for (int i = -places; i <= places; ++i) {
                ask(moved(own, which, static_cast<double>(i) / places));
                probes_.back().free = 1u << which;
            }
        }
        for (const auto& [one, other] : camera_pairs) {
            for (int i = -places / 2; i <= places / 2; ++i) {
                for (int j = -places / 2; j <= places / 2; ++j) {
                    ask(moved(moved(own, one, 2.0 * i / places), other, 2.0 * j / places));
                    probes_.back().free = 1u << one | 1u << other;
                }
            }
        }
    }
    drawn_ = 0;
    phase_ = Phase::scan;
}

/// The nearest starts, and the one it began with.
void ParameterFit::end_scan() {
    const std::size_t wanted = effort_ == FitEffort::quick    ? 1
                               : subject_ == FitSubject::lamp ? 2
                                                              : 11;
    starts_.clear();
    const Probe own = probes_.front();
    if (subject_ == FitSubject::camera) probes_.erase(probes_.begin()); // own is added below
    if (subject_ == FitSubject::lamp) {
        // Light is a sum of a part without the lamp and parts proportional to each of the two
        // numbers, so the best of these are known without another picture.
        const std::vector<float>&black = probes_[1].colours, &indirect = probes_[2].colours;
        for (std::size_t p = 3; p < probes_.size(); ++p) {
            const std::vector<float>& lit = probes_[p].colours;
            std::array<std::array<double, 2>, 2> squares{};
            std::array<double, 2> sums{};
            for (std::size_t i = 0; i < lit.size(); ++i) {
                const double target = static_cast<double>(sight_.colours[i]);
                if (target <= 0.0 || target >= 255.0 || lit[i] >= 255.0f) continue;
                const std::array<double, 2> part{static_cast<double>(lit[i] - black[i]),
                                                 static_cast<double>(indirect[i] - black[i])};
                for (std::size_t a = 0; a < 2; ++a) {
                    for (std::size_t b = 0; b < 2; ++b)
                        squares[a][b] += part[a] * part[b];
                    sums[a] += part[a] * (target - static_cast<double>(black[i]));
                }
            }
            probes_[p].cost = std::numeric_limits<double>::max();
            if (!solve_linear_system(squares, sums) || sums[0] < 0.0 || sums[1] < 0.0) continue;
            for (std::size_t channel = 3; channel < 6; ++channel)
                probes_[p].place[channel] = trial_power * sums[0];
            probes_[p].place[6] = sums[1];
            double cost = 0.0;
            for (std::size_t i = 0; i < lit.size(); ++i) {
                const double drawn = static_cast<double>(black[i]) +
                                     sums[0] * static_cast<double>(lit[i] - black[i]) +
                                     sums[1] * static_cast<double>(indirect[i] - black[i]);
                cost +=
                    huber(std::clamp(drawn, 0.0, 255.0) - static_cast<double>(sight_.colours[i]));
            }
            probes_[p].cost = cost;
        }
        probes_.erase(probes_.begin(), probes_.begin() + 3);
    }
    const Probe in_place = probes_.back(); // of a lamp in its usual position
    std::stable_sort(probes_.begin(), probes_.end(),
                     [](const Probe& a, const Probe& b) { return a.cost < b.cost; });
    // For the camera, the nearest of each kind: one number alone, a pair.
    for (const Probe& probe : probes_) {
        if (starts_.size() == wanted || probe.cost == std::numeric_limits<double>::max()) break;
        const bool is_there = std::any_of(starts_.begin(), starts_.end(), [&](const Probe& start) {
            return subject_ == FitSubject::camera && start.free == probe.free;
        });
        if (is_there) continue;
        starts_.push_back(probe);
        if (subject_ == FitSubject::lamp) starts_.back().free = all_free;
    }
    if (subject_ == FitSubject::camera) starts_.push_back({starts_.front().place, all_but_focal});
    starts_.push_back({own.place, subject_ == FitSubject::camera ? all_but_focal : all_free});
    if (subject_ == FitSubject::lamp && effort_ == FitEffort::thorough)
        starts_.push_back({in_place.place, all_but_position});
    std::reverse(starts_.begin(), starts_.end()); // taken from the end
    sight_ = make_sight(effort_ == FitEffort::quick && subject_ == FitSubject::lamp ? smallest_side
                                                                                    : small_side);
    best_.cost = std::numeric_limits<double>::max();
    approached_ = 0;
    stride_ = longest_stride;
    if (subject_ == FitSubject::camera) return approach();
    begin_descent();
}

/// The numbers with one of them changed by a part of its reach.
ParameterFit::Numbers ParameterFit::moved(Numbers numbers, std::size_t which, double part) const {
    if (which == 4) {
        numbers[4] *= std::pow(2.0, part);
    } else {
        numbers[which] += part * reach_[which];
    }
    return numbers;
}

/// Looks around a start of the camera, one number or a pair at a time, as long as there is a nearer
/// place; then with shorter strides (Hooke and Jeeves 1961).
void ParameterFit::approach() {
    const Probe& start = starts_[approached_];
    const Numbers from = start.place;
    probes_.assign(1, {from});
    const auto is_free = [&](std::size_t which) { return (start.free >> which & 1u) != 0; };
    for (std::size_t which = 0; which < number_count(); ++which) {
        if (!is_free(which)) continue;
        for (const double sign : {-1.0, 1.0})
            probes_.push_back({moved(from, which, sign * stride_)});
    }
    for (const auto& [one, other] : camera_pairs) {
        if (!is_free(one) || !is_free(other)) continue;
        for (const double sign : {-1.0, 1.0}) {
            for (const double sign_of_other : {-1.0, 1.0}) {
                probes_.push_back(
                    {moved(moved(from, one, sign * stride_), other, sign_of_other * stride_)});
            }
        }
    }
    drawn_ = 0;
    phase_ = Phase::approach;
}

void ParameterFit::take_approach() {
    constexpr double shortest = 0.01;
    const auto best =
        std::min_element(probes_.begin(), probes_.end(),
                         [](const Probe& a, const Probe& b) { return a.cost < b.cost; });
    if (best->cost < probes_.front().cost) {
        starts_[approached_].place = best->place;
        return approach();
    }
    stride_ *= 0.5;
    if (stride_ < shortest) {
        stride_ = longest_stride;
        ++approached_;
    }
    approached_ < starts_.size() ? approach() : begin_descent();
}

/// Begins from the last of the starts.
void ParameterFit::begin_descent() {
    damping_ = 1e-2;
    steps_taken_ = 0;
    const Probe from = starts_.back();
    starts_.pop_back();
    begin_slopes(from);
}

/// Asks what a small change of each number does. Light changes smoothly; an edge only shows the
/// pixels that it crosses, so the camera must be moved to both sides.
void ParameterFit::begin_slopes(const Probe& from) {
    from_ = from; // whose numbers are free
    probes_.assign(1, {from.place, from.free});
    for (const double sign : {1.0, -1.0}) {
        if (sign < 0.0 && subject_ == FitSubject::lamp) continue;
        for (std::size_t i = 0; i < number_count(); ++i) {
            Numbers there = from.place;
            there[i] += sign * steps_[i];
            probes_.push_back({there});
        }
    }
    drawn_ = 0;
    phase_ = Phase::slopes;
}

void ParameterFit::take_slopes() {
    from_ = probes_.front();
    squares_ = {};
    slopes_ = {};
    for (std::size_t i = 0; i < sight_.colours.size(); ++i) {
        const double here = static_cast<double>(from_.colours[i]);
        const double apart = static_cast<double>(sight_.colours[i]) - here;
        const double weight = std::abs(apart) <= far_apart ? 1.0 : far_apart / std::abs(apart);
        Numbers slope{};
        for (std::size_t k = 0; k < number_count(); ++k) {
            const double there = static_cast<double>(probes_[k + 1].colours[i]);
            slope[k] =
                subject_ == FitSubject::lamp
                    ? there - here
                    : 0.5 *
                          (there - static_cast<double>(probes_[k + 1 + number_count()].colours[i]));
        }
        for (std::size_t k = 0; k < number_count(); ++k)
            slope[k] = is_free(k) ? slope[k] : 0.0;
        if (is_white_) {
            slope[3] += slope[4] + slope[5];
            slope[4] = slope[5] = 0.0;
        }
        for (std::size_t a = 0; a < number_count(); ++a) {
            if (slope[a] == 0.0) continue;
            for (std::size_t b = 0; b < number_count(); ++b)
                squares_[a][b] += weight * slope[a] * slope[b];
            slopes_[a] += weight * slope[a] * apart;
        }
    }
    steps_refused_ = 0;
    solve_step();
}

void ParameterFit::solve_step() {
    auto damped = squares_;
    double largest = 0.0;
    for (std::size_t i = 0; i < most_numbers; ++i)
        largest = std::max(largest, squares_[i][i]);
    for (std::size_t i = 0; i < most_numbers; ++i)
        damped[i][i] += damping_ * squares_[i][i] + 1e-9 * largest + 1e-12;
    Numbers step = slopes_;
    if (!solve_linear_system(damped, step)) return end_descent();
    if (is_white_) step[4] = step[5] = step[3];
    Numbers next = from_.place;
    for (std::size_t i = 0; i < number_count(); ++i)
        next[i] += step[i] * steps_[i];
    probes_.assign(1, {next, from_.free});
    drawn_ = 0;
    phase_ = Phase::step;
}

void ParameterFit::take_step() {
    Probe& there = probes_.front();
    if (there.cost < from_.cost) {
        const bool is_little = there.cost > (is_larger_ ? 0.998 : 0.99) * from_.cost;
        from_ = std::move(there);
        damping_ = std::max(0.2 * damping_, 1e-6);
        const int most = is_larger_ ? most_larger_steps : most_steps;
        if (++steps_taken_ >= most || is_little) return end_descent();
        return begin_slopes(from_);
    }
    damping_ *= 10.0;
    if (++steps_refused_ >= most_refused) return end_descent();
    solve_step();
}

void ParameterFit::end_descent() {
    // Each further number that is chosen must be worth it.
    double price = 1.0;
    if (subject_ == FitSubject::camera) {
        price += for_each_number * static_cast<double>(std::popcount(from_.free & 31u));
    } else {
        if (from_.free == all_free) price += for_position;
        if (!is_white_) price *= much_worse;
    }
    // A fit to within a step has no cost, but still a price.
    if (price * (from_.cost + 1.0) < best_.cost) {
        best_ = from_;
        best_.cost = price * (best_.cost + 1.0);
    }
    if (!starts_.empty()) return begin_descent();
    if (is_white_ && is_larger_) {
        // A coloured lamp, if that is much better.
        is_white_ = false;
        starts_ = {{best_.place, best_.free}};
        return begin_descent();
    }
    if (effort_ == FitEffort::quick) {
        phase_ = Phase::done;
        return;
    }
    if (is_larger_) return begin_rounding();
    is_larger_ = true;
    sight_ = make_sight(subject_ == FitSubject::camera ? largest_side_of_edges : larger_side);
    starts_.assign(1, {best_.place, best_.free});
    if (subject_ == FitSubject::camera) starts_.insert(starts_.begin(), {best_.place, all_free});
    if (subject_ == FitSubject::camera) {
        for (double& step : steps_)
            step *= 0.5;
    }
    best_.cost = std::numeric_limits<double>::max();
    begin_descent();
}

/// Rounds the numbers as a person would have chosen them: all to so many digits, then one by one.
void ParameterFit::begin_rounding() {
    const Numbers& own = usual_;
    probes_.clear();
    const auto unit = [&](std::size_t i, double digits) {
        if (subject_ == FitSubject::camera) return i == 4 ? 100.0 * digits : digits;
        return i >= 3 && i <= 5 ? 10.0 * digits : digits;
    };
    constexpr std::array<double, 5> units{0.1, 0.05, 0.01, 0.005, 0.001};
    if (rounded_ == 0) {
        probes_.push_back({best_.place}); // in a different size from the one it was measured in
        best_.cost = std::numeric_limits<double>::max();
        probes_.push_back({own});
        for (const double digits : units) {
            Numbers all = best_.place;
            for (std::size_t i = 0; i < number_count(); ++i) {
                all[i] = rounded_to(all[i], unit(i, digits));
                // The start's own number is at least as near as rounding.
                if (std::abs(own[i] - best_.place[i]) <= 0.5 * unit(i, digits)) all[i] = own[i];
            }
            probes_.push_back({all});
            if (subject_ == FitSubject::lamp) { // white, as most lamps are
                all[3] = all[4] = all[5] =
                    rounded_to((all[3] + all[4] + all[5]) / 3.0, unit(3, digits));
                probes_.insert(probes_.end() - 1, {all});
            }
        }
    } else {
        const std::size_t i = (rounded_ - 1) % number_count();
        Numbers one = best_.place;
        // The power of a white lamp is one number.
        const bool is_white = subject_ == FitSubject::lamp && one[3] == one[4] && one[3] == one[5];
        const auto ask = [&](double value) {
            one[i] = value;
            if (is_white && i >= 3 && i <= 5) one[3] = one[4] = one[5] = value;
            probes_.push_back({one});
        };
        ask(own[i]);
        for (const double digits : units) {
            const double rounded = rounded_to(best_.place[i], unit(i, digits));
            ask(rounded);
            if (subject_ == FitSubject::lamp || digits > 0.05 || digits < 0.01) continue;
            // An edge does not determine it so exactly: try the neighbouring numbers too.
            ask(rounded - unit(i, digits));
            ask(rounded + unit(i, digits));
        }
    }
    drawn_ = 0;
    phase_ = Phase::rounding;
}

void ParameterFit::take_rounding() {
    constexpr std::size_t rounds = 2;
    // The first that is hardly worse: the roundest.
    double least = best_.cost;
    for (const Probe& probe : probes_)
        least = std::min(least, probe.cost);
    // The numbers without rounding come last.
    if (rounded_ == 0) std::rotate(probes_.begin(), probes_.begin() + 1, probes_.end());
    for (Probe& probe : probes_) {
        const bool is_usual = rounded_ == 0 && probe.place == usual_;
        if (probe.cost > (is_usual ? clearly_worse : hardly_worse) * least + 1.0) continue;
        best_ = std::move(probe);
        break;
    }
    if (++rounded_ > rounds * number_count()) {
        phase_ = Phase::done;
        return;
    }
    begin_rounding();
}

void ParameterFit::next() {
    switch (phase_) {
    case Phase::scan:
        end_scan();
        break;
    case Phase::approach:
        take_approach();
        break;
    case Phase::slopes:
        take_slopes();
        break;
    case Phase::step:
        take_step();
        break;
    case Phase::rounding:
        take_rounding();
        break;
    case Phase::done:
        break;
    }
}

double ParameterFit::advance(double most) {
    double done = 0.0;
    while (!is_done() && done < most) {
        if (drawn_ == probes_.size()) {
            next();
            continue;
        }
        Probe& probe = probes_[drawn_];
        if (!is_drawing_) {
            drawing_.begin(*scene_, in_sight(probe.place));
            is_drawing_ = true;
        }
        if (!drawing_.is_done()) {
            done += std::max(drawing_.advance(most - done), 1.0);
            continue;
        }
        make_view_image(drawing_.picture(), View::colour, std::nullopt, image_);
        std::vector<float> colours = values_of(image_);
        probe.cost = cost_of(colours);
        // Only these are read again.
        const bool is_read =
            phase_ == Phase::slopes || (phase_ == Phase::scan && subject_ == FitSubject::lamp);
        if (is_read) probe.colours = std::move(colours);
        done += 2.0 * static_cast<double>(image_.width) * image_.height;
        is_drawing_ = false;
        ++drawn_;
    }
    return std::max(done, 1.0);
}

} // namespace rasterwalk
