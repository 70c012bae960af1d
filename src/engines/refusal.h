#pragma once

// What only the steps support, in words: engines without moments share these refusals.

#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// A setting, and its value by the right rule: any other is a mistake, or another right way.
struct RightValue {
    std::string_view setting, value;
};

/// The first of these settings that has another value: "depth_test other than inverse_z"; empty if
/// none has.
std::string other_than_right(const Settings& settings, std::span<const RightValue> right);

/// What the scene or the settings ask for and only the steps have, for a sentence that ends in
/// "does not support": "several samples of a pixel"; empty if there is nothing. For scenes in the
/// world.
std::string only_steps_have(const Scene& scene, const Settings& settings);

} // namespace rasterwalk
