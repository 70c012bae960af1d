#include "stages/interpolate.h"

#include <algorithm>
#include <cmath>

namespace rasterwalk {

namespace {

/// (a (n - i) + b i) / n as a whole number, without any error. 64 bits hold it for all |a|, |b|, n
/// < 2^30.
int exact_pixel(int a, int b, int i, int n, Rounding rounding) {
    if (a == b || n == 0) return a;
    if (b - a == n) return a + i;
    const std::int64_t numerator =
        static_cast<std::int64_t>(a) * (n - i) + static_cast<std::int64_t>(b) * i;
    const auto floor_divide = [](std::int64_t p, std::int64_t q) {
        return p / q - (p % q < 0 ? 1 : 0);
    };
    switch (rounding) {
    case Rounding::truncate:
        return static_cast<int>(numerator / n);
    case Rounding::floor:
        return static_cast<int>(floor_divide(numerator, n));
    case Rounding::round:
        return static_cast<int>(floor_divide(2 * numerator + n, 2 * static_cast<std::int64_t>(n)));
    }
    return a;
}

bool adds_up(LineWalk walk) {
    return walk == LineWalk::accumulate || walk == LineWalk::integer_step;
}

} // namespace

int to_pixel(float value, Rounding rounding) {
    switch (rounding) {
    case Rounding::truncate:
        return static_cast<int>(value);
    case Rounding::floor:
        return static_cast<int>(std::floor(value));
    case Rounding::round:
        // In double: in float, 0.49999997 + 0.5 is 1.
        return static_cast<int>(std::floor(static_cast<double>(value) + 0.5));
    }
    return 0;
}

LineWalker::LineWalker(const Fragment& a, const Fragment& b, int count, const LineRules& rules)
    : a_(a), b_(b), at_(a), rules_(rules), count_(std::max(count, 1)),
      x_(static_cast<float>(a.column)), y_(static_cast<float>(a.row)) {
    const float divisor = static_cast<float>(std::max(count_ - 1, 1));
    step_x_ = static_cast<float>(b.column - a.column) / divisor;
    step_y_ = static_cast<float>(b.row - a.row) / divisor;
    if (rules.walk == LineWalk::integer_step) {
        // The mistake: the division of whole numbers drops the fraction of the step.
        const int steps = std::max(count_ - 1, 1);
        const int step_x = (b.column - a.column) / steps, step_y = (b.row - a.row) / steps;
        step_x_ = static_cast<float>(step_x);
        step_y_ = static_cast<float>(step_y);
    }
    step_zinv_ = (b.zinv - a.zinv) / divisor;
    step_z_ = (b.z - a.z) / divisor;
    each_in(
        rules.carried, step_varyings_, a.varyings, b.varyings,
        [divisor](auto& step, const auto& from, const auto& to) { step = (to - from) / divisor; });
}

const Fragment& LineWalker::sample() {
    if (rules_.walk == LineWalk::exact) {
        return sample_at(exact_pixel(a_.column, b_.column, index_, count_ - 1, rules_.rounding),
                         exact_pixel(a_.row, b_.row, index_, count_ - 1, rules_.rounding));
    }
    return sample_at(to_pixel(x_, rules_.rounding), to_pixel(y_, rules_.rounding));
}

void LineWalker::advance() {
    ++index_;
    if (!adds_up(rules_.walk)) {
        set_by_index();
        return;
    }
    x_ += step_x_;
    y_ += step_y_;
    at_.zinv += step_zinv_;
    at_.z += step_z_;
    each_in(rules_.carried, at_.varyings, at_.varyings, step_varyings_,
            [](auto& sum, const auto& value, const auto& step) { sum = value + step; });
}

void LineWalker::advance_to(int index) {
    if (adds_up(rules_.walk)) {
        while (index_ < index)
            advance();
    } else if (index_ < index) {
        index_ = index;
        set_by_index();
    }
}

void LineWalker::set_by_index() {
    const float i = static_cast<float>(index_);
    if (rules_.walk == LineWalk::multiply) {
        x_ = static_cast<float>(a_.column) + i * step_x_;
        y_ = static_cast<float>(a_.row) + i * step_y_;
        at_.zinv = a_.zinv + i * step_zinv_;
        at_.z = a_.z + i * step_z_;
        each_in(rules_.carried, at_.varyings, a_.varyings, step_varyings_,
                [i](auto& value, const auto& from, const auto& step) { value = from + step * i; });
        return;
    }
    const float t = i / static_cast<float>(std::max(count_ - 1, 1));
    const float s = 1.0f - t;
    x_ = static_cast<float>(a_.column) * s + static_cast<float>(b_.column) * t;
    y_ = static_cast<float>(a_.row) * s + static_cast<float>(b_.row) * t;
    at_.zinv = a_.zinv * s + b_.zinv * t;
    at_.z = a_.z * s + b_.z * t;
    each_in(rules_.carried, at_.varyings, a_.varyings, b_.varyings,
            [s, t](auto& value, const auto& from, const auto& to) { value = from * s + to * t; });
}

void interpolate(const Fragment& a, const Fragment& b, const LineRules& rules,
                 std::span<Fragment> result) {
    LineWalker walker(a, b, static_cast<int>(result.size()), rules);
    for (Fragment& sample : result) {
        sample = walker.sample();
        walker.advance();
    }
}

} // namespace rasterwalk
