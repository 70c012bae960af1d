// The depth test with an epsilon, compared with one in double precision: fragment by fragment, and
// in whole pictures, whose fragments are tested again.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "pipeline/draw.h"
#include "pipeline/observer.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/choose_stages.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace epsilon_tests {

constexpr const char* format_words[] = {"inv_z",       "inv_z_24",    "inv_z_16",
                                        "ndc_32",      "ndc_24",      "ndc_16",
                                        "reversed_32", "reversed_24", "reversed_16"};

Settings settings_with(const Scene& scene, const std::string& format, const std::string& epsilon) {
    Settings settings = default_settings(scene);
    set_from_text(settings, "stage=depth");
    set_from_text(settings, "depth_format=" + format);
    set_from_text(settings, "depth_epsilon=" + epsilon);
    return settings;
}

Scene scene_named(const std::string& name) {
    return read_scene(lessons_folder() + "/scenes/" + name + ".toml");
}

/// A separate depth test. Takes only the fragments and their depths from the drawing.
struct Sorter {
    Sorter(const Framebuffer& like, ClipDepth holds, float limit)
        : kind(holds), epsilon(limit), owner(like.owner.size(), -1),
          depth(like.owner.size(), is_smaller_nearer(holds) ? 1.0f : 0.0f), width(like.size.width) {
    }
    void sort_in(const FragmentEvent& event) {
        const auto at =
            static_cast<std::size_t>(event.fragment.row * width + event.fragment.column);
        // The limit is a float, as in the buffer's own arithmetic; their exact sum is a double.
        const double sign = is_smaller_nearer(kind) ? -1.0 : 1.0;
        const auto limit = static_cast<float>(static_cast<double>(depth[at]) +
                                              sign * static_cast<double>(epsilon));
        if (!(sign * static_cast<double>(event.depth) > sign * static_cast<double>(limit))) return;
        depth[at] = event.depth;
        owner[at] = event.cursor.triangle;
    }
    ClipDepth kind;
    float epsilon;
    std::vector<int> owner;
    std::vector<float> depth;
    int width;
};

} // namespace epsilon_tests
} // namespace

TEST_CASE("Without an epsilon the depth test is the usual one") {
    using namespace epsilon_tests;
    Settings settings;
    CHECK(settings.depth_epsilon == 0.0f);
    CHECK(choose_stages(settings).depth_test == depth_test);
    set_from_text(settings, "stage=depth");
    set_from_text(settings, "depth_epsilon=0.000001");
    CHECK(choose_stages(settings).depth_test == depth_test_with_epsilon);
    // The other tests do not use it.
    for (const char* test : {"linear_z", "off", "reversed"}) {
        Settings other = settings, plain;
        plain.stage = other.stage;
        set_from_text(other, std::string("depth_test=").append(test));
        set_from_text(plain, std::string("depth_test=").append(test));
        INFO(test);
        CHECK(choose_stages(other).depth_test == choose_stages(plain).depth_test);
        CHECK(depth_epsilon_rule(other) == 0.0f);
    }
    settings.stage = Stage::fill;
    CHECK(depth_epsilon_rule(settings) == 0.0f);
}

TEST_CASE("A fragment is drawn if it is nearer by more than epsilon, in every format") {
    using namespace epsilon_tests;
    const Scene room = scene_named("lab-room");
    Random random(610);
    for (const char* word : format_words) {
        const Settings settings = settings_with(room, word, "0.125");
        const DepthRules rules = depth_rules(settings, room.space);
        const auto test = choose_stages(settings).depth_test;
        const double sign = is_smaller_nearer(rules.projection.clip_depth) ? -1.0 : 1.0;
        INFO(word);
        int near_the_limit = 0;
        for (int i = 0; i < rounds(4000, 400); ++i) {
            const auto stored = depth_in_buffer(static_cast<float>(random.number(0, 1)), rules);
            Fragment fragment;
            fragment.depth =
                static_cast<float>(static_cast<double>(stored) + random.number(-0.3, 0.3));
            const DepthResult result = test(fragment, stored, rules);
            CHECK(result.depth == depth_in_buffer(fragment.depth, rules));
            const double ahead =
                sign * (static_cast<double>(result.depth) - static_cast<double>(stored)) - 0.125;
            // A float of this size has steps of 6e-8.
            if (std::abs(ahead) < 1e-6)
                ++near_the_limit;
            else if (result.passed != (ahead > 0.0))
                FAIL(word << ": " << fragment.depth << " over " << stored);
        }
        CHECK(near_the_limit < 40);
        // Exactly epsilon ahead is not more; the next float is.
        if (rules.bits > 0) continue;
        Fragment fragment;
        const float far_side = sign > 0.0 ? 0.25f : 0.75f, step = sign > 0.0 ? 0.125f : -0.125f;
        fragment.depth = far_side + step;
        CHECK_FALSE(test(fragment, far_side, rules).passed);
        fragment.depth = std::nextafter(fragment.depth, sign > 0.0 ? 1.0f : 0.0f);
        CHECK(test(fragment, far_side, rules).passed);
        fragment.depth = std::numeric_limits<float>::quiet_NaN();
        CHECK_FALSE(test(fragment, far_side, rules).passed);
    }
}

TEST_CASE("Pictures with an epsilon are what their fragments give when tested again") {
    using namespace epsilon_tests;
    const Scene paper = scene_named("z-fighting");
    for (const char* word : {"inv_z", "inv_z_16", "ndc_32", "reversed_24"}) {
        for (const char* epsilon : {"0", "0.000001", "0.00007", "0.05"}) {
            const Settings settings = settings_with(paper, word, epsilon);
            const Frame frame = prepare_frame(paper, settings);
            const Framebuffer drawn = draw_frame(frame);
            Framebuffer watched;
            clear(watched, frame);
            Sorter sorter(watched, clip_depth_rule(settings, paper.space), settings.depth_epsilon);
            const Observer sort{
                .fragment = [&](const FragmentEvent& event) { sorter.sort_in(event); }};
            draw(frame, {}, watched, &sort);
            for (std::size_t i = 0; i < drawn.owner.size(); ++i) {
                if (drawn.owner[i] == sorter.owner[i] && drawn.depth[i] == sorter.depth[i])
                    continue;
                FAIL(word << ", epsilon " << epsilon << ", pixel " << i % 200 << "," << i / 200
                          << ": triangle " << drawn.owner[i] << " for " << sorter.owner[i]);
            }
        }
    }
}
