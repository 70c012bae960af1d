// The depths that the buffer can tell apart, computed a second time: whole numbers and the next
// float for its values, and the projection solved for z in long double.

#include "inspect/depth_ruler.h"

#include <cmath>
#include <limits>

#include "stages/orthographic.h"
#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

using Exact = long double;

struct OwnFormat {
    const char* word;
    ClipDepth kind;
    int bits;
};
constexpr OwnFormat own_formats[] = {
    {"inv_z", ClipDepth::inv_z, 0},          {"inv_z_24", ClipDepth::inv_z, 24},
    {"inv_z_16", ClipDepth::inv_z, 16},      {"ndc_32", ClipDepth::ndc, 0},
    {"ndc_24", ClipDepth::ndc, 24},          {"ndc_16", ClipDepth::ndc, 16},
    {"reversed_32", ClipDepth::reversed, 0}, {"reversed_24", ClipDepth::reversed, 24},
    {"reversed_16", ClipDepth::reversed, 16}};

DepthRules rules_between(const OwnFormat& format, float near, float far, float mix = 0.0f) {
    DepthRules rules;
    rules.projection.clip_depth = format.kind;
    rules.projection.mix = mix;
    rules.near = near;
    rules.far = far;
    rules.bits = format.bits;
    return rules;
}

/// z at a depth between the planes, under perspective or with parallel rays.
Exact own_z(ClipDepth kind, Exact stored, Exact near, Exact far, bool is_parallel = false) {
    if (kind == ClipDepth::inv_z) return 1 / stored;
    const Exact ndc = kind == ClipDepth::ndc ? stored : 1 - stored;
    if (is_parallel) return near + ndc * (far - near);
    return near * far / (far - ndc * (far - near));
}

/// The value of a buffer of whole numbers.
float own_value(const DepthRules& rules, std::int64_t number) {
    const auto largest = static_cast<float>((std::int64_t{1} << rules.bits) - 1);
    const float part = static_cast<float>(number) / largest;
    return rules.projection.clip_depth == ClipDepth::inv_z ? part / rules.near : part;
}

/// The next value that the buffer can hold; NaN: it has none.
float own_next(const DepthRules& rules, const DepthStep& step, bool is_nearer) {
    const bool grows = is_nearer != (rules.projection.clip_depth == ClipDepth::ndc);
    if (rules.bits == 0) {
        const float infinity = std::numeric_limits<float>::infinity();
        return std::nextafter(step.stored, grows ? infinity : -infinity);
    }
    std::int64_t number = step.number.value();
    do {
        number += grows ? 1 : -1;
        if (number < 0 || number >= std::int64_t{1} << rules.bits)
            return std::numeric_limits<float>::quiet_NaN();
    } while (own_value(rules, number) == step.stored);
    return own_value(rules, number);
}

/// Checks a window against the values and distances above.
void check_window(const DepthWindow& window, const DepthRules& rules, bool is_parallel) {
    REQUIRE(window.middle < window.steps.size());
    REQUIRE(window.gaps.size() + 1 == window.steps.size());
    const ClipDepth kind = rules.projection.clip_depth;
    const auto z_of = [&](float stored) {
        return own_z(kind, stored, rules.near, rules.far, is_parallel);
    };
    for (std::size_t i = 0; i < window.steps.size(); ++i) {
        const DepthStep& step = window.steps[i];
        CAPTURE(i, step.stored);
        if (rules.bits > 0) CHECK(own_value(rules, step.number.value()) == step.stored);
        CHECK(step.number.has_value() == (rules.bits > 0));
        CHECK(step.z == Approx(static_cast<double>(z_of(step.stored))).epsilon(1e-9));
        if (i == 0) continue;
        CHECK(own_next(rules, step, true) == window.steps[i - 1].stored);
        CHECK(own_next(rules, window.steps[i - 1], false) == step.stored);
        const Exact gap = z_of(step.stored) - z_of(window.steps[i - 1].stored);
        CHECK(window.gaps[i - 1] > 0.0);
        // Just behind the near plane, floats of NDC z are closer together than a long double tells.
        const double lost =
            step.z * 8.0 * static_cast<double>(std::numeric_limits<Exact>::epsilon());
        CHECK(window.gaps[i - 1] == Approx(static_cast<double>(gap)).epsilon(1e-6).margin(lost));
    }
}

} // namespace

TEST_CASE("The window round a depth has the values next to it, and their distances") {
    Random random(461);
    for (const OwnFormat& format : own_formats) {
        for (int i = 0; i < rounds(200, 40); ++i) {
            const auto near = static_cast<float>(std::pow(10.0, random.number(-2, 0.5)));
            const auto far = static_cast<float>(near * std::pow(10.0, random.number(0.3, 4)));
            const bool is_parallel = format.kind != ClipDepth::inv_z && random.integer(0, 1) == 1;
            const DepthRules rules = rules_between(format, near, far, is_parallel ? 1.0f : 0.0f);
            const auto z = static_cast<float>(random.number(near, far));
            const float stored = depth_in_buffer(depth_at(z, rules), rules);
            CAPTURE(format.word, near, far, z, is_parallel);
            const std::optional<DepthWindow> window = depth_window(stored, rules);
            if (!window) {
                // Only a 1/z that is rounded to 0 lies nowhere.
                CHECK(stored == 0.0f);
                continue;
            }
            CHECK(window->asked().stored == stored);
            check_window(*window, rules, is_parallel);
        }
    }
}

TEST_CASE("At z = 4 between 0.1 and 100 a buffer of 16 bits has steps of 0.0024") {
    // A step of the buffer over the slope of the depth: f n / ((f - n) z^2).
    const double expected = (100.0 - 0.1) * 16.0 / (100.0 * 0.1) / 65535.0;
    CHECK(expected == Approx(0.00244).epsilon(0.01));
    for (const OwnFormat& format : {own_formats[5], own_formats[8]}) {
        CAPTURE(format.word);
        const DepthRules rules = rules_between(format, 0.1f, 100.0f);
        const auto window = depth_window(depth_in_buffer(depth_at(4.0f, rules), rules), rules);
        REQUIRE(window);
        CHECK(window->gap_nearer().value() == Approx(expected).epsilon(0.002));
        CHECK(window->gap_farther().value() == Approx(expected).epsilon(0.002));
    }
    // Parallel rays have equal steps everywhere.
    const DepthRules parallel = rules_between(own_formats[5], 0.1f, 100.0f, 1.0f);
    // They are rounded to floats, which are close together near 0 and not near 1.
    for (const float z : {0.5f, 4.0f, 90.0f}) {
        const auto window =
            depth_window(depth_in_buffer(depth_at(z, parallel), parallel), parallel);
        REQUIRE(window);
        CHECK(window->gap_farther().value() == Approx(99.9 / 65535.0).epsilon(0.004));
    }
}

TEST_CASE("At its ends a buffer has neighbours on one side only") {
    const DepthRules ndc = rules_between(own_formats[5], 0.1f, 100.0f);
    const auto first = depth_window(0.0f, ndc), last = depth_window(1.0f, ndc);
    REQUIRE(first);
    REQUIRE(last);
    CHECK_FALSE(first->gap_nearer());
    CHECK(first->gap_farther());
    CHECK(last->gap_nearer());
    CHECK_FALSE(last->gap_farther());
    CHECK(first->steps.size() == 3);
    // 1/z of 0 is infinitely far: no window there, and none of it in the one next to it.
    const DepthRules inverse = rules_between(own_formats[2], 0.1f, 100.0f);
    CHECK_FALSE(depth_window(0.0f, inverse));
    const auto farthest = depth_window(own_value(inverse, 1), inverse);
    REQUIRE(farthest);
    CHECK_FALSE(farthest->gap_farther());
    for (const float depth :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
          -std::numeric_limits<float>::infinity(), -1.0f})
        CHECK_FALSE(depth_window(depth, rules_between(own_formats[0], 0.1f, 100.0f)));
}

TEST_CASE("The ruler joins z with what the buffer holds, near to far") {
    for (const OwnFormat& format : own_formats) {
        CAPTURE(format.word);
        const DepthRules rules = rules_between(format, 0.5f, 100.0f);
        const std::optional<DepthRuler> ruler = depth_ruler(rules, 0.01);
        REQUIRE(ruler);
        CHECK(ruler->is_logarithmic);
        CHECK(ruler->place(0.5) == 0.0);
        CHECK(ruler->place(100.0) == Approx(1.0));
        CHECK(ruler->place(std::sqrt(50.0)) == Approx(0.5));
        CHECK(ruler->stored_place(depth_at(0.5f, rules)) == Approx(0.0).margin(1e-6));
        CHECK(ruler->stored_place(depth_at(100.0f, rules)) == Approx(1.0).margin(1e-6));
        // 1/z is linear in what is stored, so its mean lies in the middle.
        const float middle = 2.0f / (1.0f / 0.5f + 1.0f / 100.0f);
        CHECK(ruler->stored_place(depth_at(middle, rules)) == Approx(0.5).margin(1e-5));
        CHECK(ruler->round == std::vector<double>{0.5, 1, 2, 5, 10, 20, 50, 100});
    }
    const std::optional<DepthRuler> linear =
        depth_ruler(rules_between(own_formats[3], 1.0f, 5.0f), 0.01);
    REQUIRE(linear);
    CHECK_FALSE(linear->is_logarithmic);
    CHECK(linear->place(2.0) == Approx(0.25));
    const std::optional<DepthRuler> parallel =
        depth_ruler(rules_between(own_formats[3], 1.0f, 101.0f, 1.0f), 0.01);
    REQUIRE(parallel);
    CHECK_FALSE(parallel->is_logarithmic);
    CHECK(parallel->place(26.0) == Approx(0.25));
    CHECK(parallel->stored_place(depth_at(26.0f, parallel->rules)) == Approx(0.25));
}

TEST_CASE("Ticks are the depths whose neighbours are far enough apart on the scale") {
    constexpr double least = 0.01;
    for (const OwnFormat& format : own_formats) {
        for (const float far : {100.0f, 5000.0f}) {
            CAPTURE(format.word, far);
            const DepthRules rules = rules_between(format, 0.01f, far);
            const std::optional<DepthRuler> ruler = depth_ruler(rules, least);
            REQUIRE(ruler);
            if (format.bits != 16) {
                if (format.bits == 0 && format.kind != ClipDepth::ndc)
                    CHECK(ruler->told_apart.empty());
                continue;
            }
            // All values of the buffer, by their numbers.
            std::size_t count = 0;
            const double scale = std::log(static_cast<double>(far) / 0.01f);
            const auto place = [&](std::int64_t number) {
                const Exact z = own_z(format.kind, own_value(rules, number), 0.01f, far);
                return static_cast<double>(std::log(z / 0.01f)) / scale;
            };
            const std::int64_t step = format.kind == ClipDepth::ndc ? 1 : -1;
            const std::int64_t begin = step > 0 ? 0 : 65535, end = step > 0 ? 65535 : 0;
            for (std::int64_t number = end; number != begin; number -= step) {
                const double here = place(number), nearer = place(number - step);
                if (here > 1.0 + 1e-6) continue;
                if (here - nearer < least) break;
                ++count;
            }
            CHECK(count > 0);
            CHECK(ruler->told_apart.size() == count);
            for (const DepthStep& tick : ruler->told_apart)
                CHECK(own_value(rules, tick.number.value()) == tick.stored);
        }
    }
}

TEST_CASE("Planes that are no view have no ruler") {
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const auto& [near, far] : {std::pair{0.0f, 1.0f},
                                    {1.0f, 1.0f},
                                    {2.0f, 1.0f},
                                    {-1.0f, 1.0f},
                                    {nan, 1.0f},
                                    {1.0f, nan},
                                    {1.0f, infinity}})
        for (const OwnFormat& format : own_formats) {
            const DepthRules rules = rules_between(format, near, far);
            CHECK_FALSE(depth_ruler(rules, 0.01));
            // 1/z itself needs no planes.
            if (rules.projection.clip_depth != ClipDepth::inv_z)
                CHECK_FALSE(depth_window(0.5f, rules));
        }
    CHECK_FALSE(depth_ruler(rules_between(own_formats[0], 0.1f, 100.0f), 0.0));
    for (const OwnFormat& format : own_formats)
        for (const double least : {1e-300, 1.0, 1e300})
            CHECK_NOTHROW(depth_ruler(rules_between(format, 1e-6f, 3e38f), least));
}

TEST_CASE("Between perspective and parallel rays the steps are those of the mixture") {
    for (const OwnFormat& format : {own_formats[3], own_formats[5], own_formats[8]}) {
        for (const float mix : {0.25f, 0.75f}) {
            const DepthRules rules = rules_between(format, 0.1f, 40.0f, mix);
            const auto ndc_at = [&](Exact z) {
                const auto w = [&](Exact at) { return (1 - Exact{mix}) * at + Exact{mix}; };
                const Exact near = rules.near, far = rules.far;
                const Exact ndc = w(far) * (z - near) / ((far - near) * w(z));
                return format.kind == ClipDepth::ndc ? ndc
                                                     : w(near) * (far - z) / ((far - near) * w(z));
            };
            // z by halving: the depth goes one way only.
            const auto z_at = [&](float stored) {
                Exact low = rules.near, high = rules.far;
                for (int i = 0; i < 200; ++i) {
                    const Exact middle = (low + high) / 2;
                    const bool is_before = format.kind == ClipDepth::ndc ? ndc_at(middle) < stored
                                                                         : ndc_at(middle) > stored;
                    (is_before ? low : high) = middle;
                }
                return low;
            };
            for (const float z : {0.4f, 3.0f, 25.0f}) {
                CAPTURE(format.word, mix, z);
                const auto window = depth_window(depth_in_buffer(depth_at(z, rules), rules), rules);
                REQUIRE(window);
                const float here = window->asked().stored,
                            next = own_next(rules, window->asked(), false);
                CHECK(window->asked().z == Approx(static_cast<double>(z_at(here))).epsilon(1e-9));
                CHECK(window->gap_farther().value() ==
                      Approx(static_cast<double>(z_at(next) - z_at(here))).epsilon(1e-6));
            }
        }
    }
}
