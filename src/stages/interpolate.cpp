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

/// Stores the values a walk has reached; varyings that are not carried are left alone.
void put_sample(const LineStep& at, const LinePart& part, LineSample& sample) {
    sample.x = at.x;
    sample.y = at.y;
    sample.fragment.column = to_pixel(at.x, part.rounding);
    sample.fragment.row = to_pixel(at.y, part.rounding);
    sample.fragment.depth = at.depth;
    sample.fragment.inv_w = at.inv_w;
    sample.fragment.z = at.z;
    each_in(part.carried, sample.fragment.varyings, at.varyings, at.varyings,
            [](auto& value, const auto& now, const auto&) { value = now; });
}

/// The values a walk begins with.
LineStep values_at(const LineEnd& end) {
    return {end.x, end.y, end.depth, end.inv_w, end.z, end.varyings};
}

/// op(into, a, b) for the position and for every value that is carried.
template <class Op>
void each_value(VaryingSet carried, LineStep& into, const LineStep& a, const LineStep& b, Op op) {
    op(into.x, a.x, b.x);
    op(into.y, a.y, b.y);
    op(into.depth, a.depth, b.depth);
    op(into.inv_w, a.inv_w, b.inv_w);
    op(into.z, a.z, b.z);
    each_in(carried, into.varyings, a.varyings, b.varyings, op);
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

LineEnd line_end(const ScreenVertex& vertex) {
    return {static_cast<float>(vertex.column),
            static_cast<float>(vertex.row),
            vertex.depth,
            vertex.inv_w,
            vertex.z,
            vertex.varyings};
}

LineEnd line_end(const RowEnd& end, int row) {
    return {static_cast<float>(end.column),
            static_cast<float>(row),
            end.depth,
            end.inv_w,
            end.z,
            end.varyings};
}

std::span<LineSample> samples_of(std::vector<LineSample>& buffer, int count) {
    const auto size = static_cast<std::size_t>(count);
    if (buffer.size() < size) buffer.resize(size);
    return {buffer.data(), size};
}

LineStep line_step(const LineEnd& a, const LineEnd& b, const LinePart& part) {
    const float steps = static_cast<float>(std::max(part.count - 1, 1));
    LineStep step{(b.x - a.x) / steps,         (b.y - a.y) / steps, (b.depth - a.depth) / steps,
                  (b.inv_w - a.inv_w) / steps, (b.z - a.z) / steps, {}};
    each_in(
        part.carried, step.varyings, a.varyings, b.varyings,
        [steps](auto& value, const auto& from, const auto& to) { value = (to - from) / steps; });
    return step;
}

void interpolate(const LineEnd& a, const LineEnd&, const LineStep& step, const LinePart& part,
                 std::span<LineSample> result) {
    const auto add_up = [&](auto value, const auto& more, auto put) {
        for (int i = 0; i < part.first; ++i)
            value = value + more;
        for (LineSample& sample : result) {
            put(sample, value);
            value = value + more;
        }
    };
    // One after the other: then nothing has to be decided at each sample.
    if (part.needs_positions) {
        const glm::vec2 start(a.x, a.y);
        add_up(start, glm::vec2(step.x, step.y), [&](LineSample& sample, const glm::vec2& at) {
            sample.x = at.x;
            sample.y = at.y;
            sample.fragment.column = to_pixel(at.x, part.rounding);
            sample.fragment.row = to_pixel(at.y, part.rounding);
        });
    }
    add_up(glm::vec3(a.depth, a.inv_w, a.z), glm::vec3(step.depth, step.inv_w, step.z),
           [](LineSample& sample, const glm::vec3& at) {
               sample.fragment.depth = at.x;
               sample.fragment.inv_w = at.y;
               sample.fragment.z = at.z;
           });
    int index = 0;
    for_each_varying([&](auto member) {
        if (!part.carried.has(index++)) return;
        add_up(a.varyings.*member, step.varyings.*member,
               [&](LineSample& sample, const auto& value) {
                   sample.fragment.varyings.*member = value;
               });
    });
}

void interpolate_by_multiplying(const LineEnd& a, const LineEnd&, const LineStep& step,
                                const LinePart& part, std::span<LineSample> result) {
    const LineStep start = values_at(a);
    LineStep current = start;
    int index = part.first;
    for (LineSample& sample : result) {
        const float i = static_cast<float>(index);
        // The first sample is the end itself, even where 0 times the step is not 0.
        if (index > 0) {
            each_value(
                part.carried, current, start, step,
                [i](auto& value, const auto& from, const auto& more) { value = from + more * i; });
        }
        put_sample(current, part, sample);
        ++index;
    }
}

void mix_ends(const LineEnd& a, const LineEnd& b, const LinePart& part,
              std::span<LineSample> result) {
    const int steps = part.count - 1;
    const LineStep start = values_at(a), end = values_at(b);
    LineStep current = start;
    int index = part.first;
    for (LineSample& sample : result) {
        const float t = static_cast<float>(index) / static_cast<float>(std::max(steps, 1));
        const float s = 1.0f - t;
        if (index > 0) {
            each_value(part.carried, current, start, end,
                       [s, t](auto& value, const auto& from, const auto& to) {
                           value = from * s + to * t;
                       });
        }
        put_sample(current, part, sample);
        ++index;
    }
}

void interpolate_exactly(const LineEnd& a, const LineEnd& b, const LineStep&, const LinePart& part,
                         std::span<LineSample> result) {
    mix_ends(a, b, part, result);
    const int steps = part.count - 1;
    const glm::ivec2 first(a.x, a.y), last(b.x, b.y);
    int index = part.first;
    for (LineSample& sample : result) {
        sample.fragment.column = exact_pixel(first.x, last.x, index, steps, part.rounding);
        sample.fragment.row = exact_pixel(first.y, last.y, index, steps, part.rounding);
        ++index;
    }
}

} // namespace rasterwalk
