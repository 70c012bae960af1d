// What the depth buffer can hold, 1/z, NDC z and reversed NDC z in 32, 24 and 16 bits, compared
// with formulas computed again in double, and under every depth test.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "pipeline/draw.h"
#include "session/content.h"
#include "settings/choose_stages.h"
#include "settings/setting_table.h"
#include "stages/orthographic.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/random.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr double near = 0.1, far = 100.0;

/// The depth at a z, and the z of a depth, by the formulas of the books.
double depth_in_double(ClipDepth kind, double z) {
    const double ndc = far / (far - near) * (1.0 - near / z);
    return kind == ClipDepth::inv_z ? 1.0 / z : kind == ClipDepth::ndc ? ndc : 1.0 - ndc;
}

Settings with_format(Settings settings, std::string_view word) {
    set_from_text(settings, std::string("depth_format=").append(word));
    return settings;
}

DepthRules rules_of(std::string_view word) {
    return depth_rules(with_format({}, word), SceneSpace::world);
}

float depth_at_distance(double z, const DepthRules& rules) {
    return depth_in_buffer(depth_at(static_cast<float>(z), rules), rules);
}

/// The smallest distance at which the buffer separates every pair of surfaces behind z, up to 1 %.
double smallest_separation(double z, const DepthRules& rules, Random& random) {
    const auto separates = [&](double distance) {
        for (int i = 0; i < rounds(2000, 500); ++i) {
            const double front = z + 0.01 * random.number(-1, 1);
            if (depth_at_distance(front, rules) == depth_at_distance(front + distance, rules))
                return false;
        }
        return true;
    };
    double distance = 1e-5;
    while (!separates(distance))
        distance *= 1.01;
    return distance;
}

/// The meaning of a depth format's word.
struct Format {
    const char* word;
    ClipDepth kind;
    int bits;
};
constexpr Format formats[] = {
    {"inv_z", ClipDepth::inv_z, 0},           {"inv_z_24", ClipDepth::inv_z, 24},
    {"inv_z_16", ClipDepth::inv_z, 16},       {"ndc_32", ClipDepth::ndc, 0},
    {"ndc_24", ClipDepth::ndc, 24},           {"ndc_16", ClipDepth::ndc, 16},
    {"reversed_32", ClipDepth::reversed, 0},  {"reversed_24", ClipDepth::reversed, 24},
    {"reversed_16", ClipDepth::reversed, 16},
};

} // namespace

TEST_CASE("Each word of the depth format is a quantity and its bits") {
    CHECK(std::size(formats) == enum_words<DepthFormat>.size());
    for (const Format& format : formats) {
        CAPTURE(format.word);
        const DepthRules rules = rules_of(format.word);
        CHECK(rules.projection.clip_depth == format.kind);
        CHECK(rules.bits == format.bits);
        for (const double z : {0.1, 0.15, 0.2, 1.0, 4.0, 30.0, 99.0}) {
            const double expected = depth_in_double(format.kind, z);
            const double largest = format.kind == ClipDepth::inv_z ? 1.0 / near : 1.0;
            const double step = format.bits == 0 ? 0.0 : largest / (std::exp2(format.bits) - 1.0);
            CAPTURE(z, expected);
            CHECK(std::abs(static_cast<double>(depth_at_distance(z, rules)) - expected) <=
                  0.5 * step + 4e-7 * largest);
            if (format.bits == 0)
                CHECK(z_of_depth(depth_at_distance(z, rules), rules) == Approx(z).epsilon(2e-3));
        }
    }
}

TEST_CASE("Half of the steps of NDC z are used up at twice the near plane") {
    const DepthRules ndc = rules_of("ndc_32"), reversed = rules_of("reversed_32");
    CHECK(depth_at(0.2f, ndc) == Approx(0.5005).margin(5e-5));
    CHECK(depth_at(4.0f, ndc) == Approx(0.97598).margin(5e-6));
    CHECK(depth_at(0.2f, reversed) == Approx(1.0 - 0.5005).margin(5e-5));
    CHECK(depth_at(4.0f, reversed) == Approx(1.0 - 0.97598).margin(5e-6));
    CHECK(depth_at(0.1f, ndc) == 0.0f);
    CHECK(depth_at(100.0f, ndc) == Approx(1.0));
    CHECK(depth_at(100.0f, reversed) == 0.0f);
}

TEST_CASE(
    "At z = 4 a buffer of 16 bits separates surfaces 0.0024 apart, in either direction of NDC z") {
    Random random(160);
    // A step of the buffer over the slope of the depth: d(1 - n/z) f/(f - n) = f n / ((f - n) z^2).
    const double slope = far * near / ((far - near) * 16.0);
    const double of_step = 1.0 / 65535.0 / slope;
    CHECK(of_step == Approx(0.0024).epsilon(0.02));
    for (const char* word : {"ndc_16", "reversed_16"}) {
        CAPTURE(word);
        CHECK(smallest_separation(4.0, rules_of(word), random) == Approx(of_step).epsilon(0.04));
    }
    // 1/z has as many steps, from 0 to 1/near.
    CHECK(smallest_separation(4.0, rules_of("inv_z_16"), random) ==
          Approx(1.0 / near / 65535.0 * 16.0).epsilon(0.04));
    // In 32 bits only the reversed form gains from float's small steps near 0.
    const double reversed = smallest_separation(50.0, rules_of("reversed_32"), random);
    const double normal = smallest_separation(50.0, rules_of("ndc_32"), random);
    CHECK(reversed < 0.1 * normal);
}

TEST_CASE("Two surfaces very close together fight only if the buffer has few bits") {
    // The one behind is drawn last; it must not be visible where the buffer separates them.
    const Format sixteen[] = {formats[2], formats[5], formats[8]};
    for (const Format& format : sixteen) {
        const DepthRules rules = rules_of(format.word);
        Random random(161);
        int ties = 0;
        for (int i = 0; i < 1000; ++i) {
            const double z = 4.0 + 0.01 * random.number(-1, 1), distance = 0.0008;
            Fragment behind;
            behind.depth = depth_at(static_cast<float>(z + distance), rules);
            const float stored = depth_at_distance(z, rules);
            const DepthResult result = depth_test_in_buffer(behind, stored, rules);
            CHECK_FALSE(result.passed);
            ties += result.depth == stored ? 1 : 0;
        }
        // The share of pairs in the same step: 1 - 0.0008 / 0.0024.
        CAPTURE(format.word);
        CHECK(ties > 580);
        CHECK(ties < 750);
    }
}

TEST_CASE("Every depth test acts with every format, the right way round") {
    const Scene room = lab_room();
    Random random(162);
    for (const Format& format : formats) {
        for (const char* test : {"inverse_z", "linear_z", "off", "reversed"}) {
            Settings settings = with_format(default_settings(room), format.word);
            set_from_text(settings, std::string("depth_test=").append(test));
            const Stages stages = choose_stages(settings);
            const DepthRules rules = depth_rules(settings, SceneSpace::world);
            const float clear = depth_clear_rule(settings, SceneSpace::world);
            CAPTURE(format.word, test);
            CHECK(clear == (format.kind == ClipDepth::ndc ? 1.0f : 0.0f));
            const std::string word = test;
            for (int i = 0; i < rounds(500, 100); ++i) {
                const double z = random.number(0.11, 20), before = random.number(0.11, 20);
                Fragment fragment;
                fragment.depth = depth_at(static_cast<float>(z), rules);
                fragment.z = static_cast<float>(z);
                const float stored = depth_at_distance(before, rules),
                            held = depth_at_distance(z, rules);
                const DepthResult over = stages.depth_test(fragment, stored, rules);
                CHECK(over.depth == held);
                // If the buffer holds both as equally near, only a missing test lets z pass.
                const bool is_nearer_by_z = z < before && held != stored;
                const bool is_farther_by_z = z > before && held != stored;
                const bool expected = word == "off"        ? true
                                      : word == "reversed" ? is_farther_by_z
                                                           : is_nearer_by_z;
                if (over.passed != expected)
                    FAIL(format.word << " " << word << ": " << z << " over " << before);
                // Everything in sight is nearer than an empty buffer.
                CHECK(stages.depth_test(fragment, clear, rules).passed == (word != "reversed"));
            }
        }
    }
}

TEST_CASE("Depths that are not numbers never pass") {
    for (const Format& format : formats) {
        const DepthRules rules = rules_of(format.word);
        const float clear = depth_clear_rule(with_format({}, format.word), SceneSpace::world);
        Fragment fragment;
        fragment.depth = std::numeric_limits<float>::quiet_NaN();
        CAPTURE(format.word);
        CHECK_FALSE(depth_test_in_buffer(fragment, clear, rules).passed);
        CHECK(std::isfinite(depth_in_buffer(fragment.depth, rules)) == (format.bits > 0));
    }
}

TEST_CASE("Normal and reversed NDC z show the same surfaces of the room, except for ties") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    set_from_text(settings, "stage=depth");
    for (const char* projection : {"perspective", "orthographic"}) {
        set_from_text(settings, std::string("projection=").append(projection));
        const Framebuffer reversed =
            draw_frame(prepare_frame(room, with_format(settings, "reversed_32")));
        const Framebuffer normal = draw_frame(prepare_frame(room, with_format(settings, "ndc_32")));
        int ties = 0, drawn = 0;
        for (std::size_t i = 0; i < normal.depth.size(); ++i) {
            if ((normal.owner[i] < 0) != (reversed.owner[i] < 0)) FAIL("a hole at " << i);
            if (normal.owner[i] < 0) {
                CHECK(normal.depth[i] == 1.0f);
                CHECK(reversed.depth[i] == 0.0f);
                continue;
            }
            ++drawn;
            const double sum =
                static_cast<double>(normal.depth[i]) + static_cast<double>(reversed.depth[i]);
            if (std::abs(sum - 1.0) > 2e-5)
                FAIL(projection << ": the depths at " << i << " add up to " << sum);
            ties += normal.owner[i] == reversed.owner[i] ? 0 : 1;
        }
        CAPTURE(projection, ties);
        CHECK(drawn > 100'000);
        // On the edges that two triangles share both are drawn, and rounding decides.
        CHECK(ties < 2000);
    }
}

TEST_CASE("With parallel rays linear z is not a mistake, in any format") {
    const Scene room = lab_room();
    for (const Format& format : formats) {
        Settings settings = with_format(default_settings(room), format.word);
        set_from_text(settings, "stage=depth");
        set_from_text(settings, "projection=orthographic");
        const Framebuffer right = draw_frame(prepare_frame(room, settings));
        set_from_text(settings, "depth_test=linear_z");
        const Framebuffer linear = draw_frame(prepare_frame(room, settings));
        int others = 0;
        for (std::size_t i = 0; i < right.owner.size(); ++i)
            others += right.owner[i] == linear.owner[i] ? 0 : 1;
        CAPTURE(format.word, others);
        CHECK(others < 2000);
    }
}

TEST_CASE("A buffer that begins nearer hides everything farther, in any format") {
    const Scene room = lab_room();
    for (const char* word : {"ndc_32", "reversed_32", "ndc_16", "reversed_16"}) {
        Settings settings = with_format(default_settings(room), word);
        set_from_text(settings, "stage=depth");
        settings.depth_clear = 0.026f; // z of about 3.7
        const Framebuffer drawn = draw_frame(prepare_frame(room, settings));
        const DepthRules rules = depth_rules(settings, SceneSpace::world);
        int hidden = 0, seen = 0;
        for (std::size_t i = 0; i < drawn.owner.size(); ++i) {
            if (drawn.owner[i] < 0) {
                ++hidden;
                continue;
            }
            ++seen;
            if (z_of_depth(drawn.depth[i], rules) > 3.75) FAIL(word << ": too far at " << i);
        }
        CAPTURE(word);
        CHECK(hidden > 10'000);
        CHECK(seen > 10'000);
    }
}
