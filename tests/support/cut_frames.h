#pragma once

// Frames where planes cut triangles or take them away, and where some are culled.

#include <string>

#include "pipeline/frame.h"
#include "support/random.h"
#include "support/samples.h"
#include "tests/support/catch.h"

namespace rasterwalk::test {

/// Triangles all around a camera at the origin; the part meant to be seen is between near
/// 0.3 and far 2.
inline Scene cut_scene() {
    Random random(91);
    const auto place = [&random] {
        // In braces: their order is the same under every compiler.
        return glm::vec3{random.number(-1.5, 1.5), random.number(-1.5, 1.5),
                         random.number(-0.6, 2.4)};
    };
    std::vector<std::array<glm::vec3, 3>> triangles;
    for (int i = 0; i < 12; ++i)
        triangles.push_back({place(), place(), place()});
    Scene scene = pixel_scene(triangles, {24, 18});
    scene.space = SceneSpace::world;
    scene.camera = {{0.0f, 0.0f, 0.0f}, 0.0f, 0.0f, 14.0f};
    return scene;
}

/// A way to clip and to cull.
struct CutRules {
    Clip clip = Clip::all;
    Cull cull = Cull::none;
    Reject reject = Reject::none;
};
inline constexpr CutRules cut_rules[] = {
    {Clip::all, Cull::screen_area, Reject::none},
    {Clip::near, Cull::none, Reject::none},
    {Clip::all, Cull::none, Reject::outcodes},
    {Clip::guard_band, Cull::screen_area, Reject::outcodes},
    {Clip::leave_out, Cull::screen_area, Reject::none},
};

inline Frame cut_frame(const Scene& scene, const StripStep& step, const CutRules& rules) {
    Settings settings = default_settings(scene);
    set_step(settings, step);
    settings.near = 0.3f;
    settings.far = 2.0f;
    settings.clip = rules.clip;
    settings.cull = rules.cull;
    settings.reject = rules.reject;
    return prepare_frame(scene, settings);
}

/// Calls the function with a frame of every stage, each under different rules, until each stage has
/// had `rounds_of_rules` of them.
template <class Function>
void for_each_cut_frame(const Scene& scene, int rounds_of_rules, Function function) {
    std::size_t next = 0;
    for (int round = 0; round < rounds_of_rules; ++round) {
        for (const StageInfo& info : stage_list()) {
            const CutRules& rules = cut_rules[next++ % std::size(cut_rules)];
            CAPTURE(std::string(info.name), word_of(rules.clip), word_of(rules.cull));
            function(cut_frame(scene, info.step, rules));
        }
    }
}

} // namespace rasterwalk::test
