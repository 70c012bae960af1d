#pragma once

#include <string>

#include <catch2/catch.hpp>

#include "pipeline/draw.h"
#include "support/bits.h"
#include "support/samples.h"

namespace rasterwalk::test {

/// The frame of a stage with the scene's own view.
inline Frame frame_of(const Scene& scene, Stage stage, const Variant& variant) {
    Settings settings = default_settings(scene);
    settings.stage = stage;
    variant.apply(settings);
    return prepare_frame(scene, settings);
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
        for (int stage = 0; stage < stage_count; ++stage) {
            CAPTURE(variant.name, stage);
            function(frame_of(scene, static_cast<Stage>(stage), variant));
        }
    }
}

/// A cursor that may be no moment at all.
inline Cursor any_cursor(Random& random, int triangles) {
    return {random.integer(0, triangles), static_cast<Phase>(random.integer(0, 2)),
            random.integer(0, 12), random.integer(0, 16)};
}

} // namespace rasterwalk::test
