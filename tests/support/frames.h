#pragma once

#include <string>

#include "pipeline/draw.h"
#include "support/bits.h"
#include "support/samples.h"
#include "tests/support/catch.h"

namespace rasterwalk::test {

/// The frame of a step of the strip with the scene's own view.
inline Frame frame_of(const Scene& scene, const StripStep& step, const Variant& variant) {
    Settings settings = default_settings(scene);
    set_step(settings, step);
    variant.apply(settings);
    return prepare_frame(scene, settings);
}
inline Frame frame_of(const Scene& scene, Stage stage, const Variant& variant) {
    return frame_of(scene, StripStep{stage}, variant);
}

/// Fails with the first wrong pixel.
inline void require_same(const Framebuffer& a, const Framebuffer& b) {
    const std::string difference = first_difference(a, b);
    if (!difference.empty()) FAIL(difference);
}

/// Calls the function with the frame of every stage under every variant.
template <class Function>
void for_each_frame(const Scene& scene, Function function) {
    for (const Variant& variant : rule_variants()) {
        for (const StageInfo& info : stage_list()) {
            CAPTURE(variant.name, std::string(info.name));
            function(frame_of(scene, info.step, variant));
        }
    }
}

/// A cursor in a triangle, which need not be a moment of any frame.
inline Cursor any_cursor(Random& random, int triangles) {
    const int phases = static_cast<int>(Phase::resolve); // comes after all triangles
    return {random.integer(0, triangles), static_cast<Phase>(random.integer(0, phases - 1)),
            random.integer(0, 12), random.integer(0, 16)};
}

} // namespace rasterwalk::test
