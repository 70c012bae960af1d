#pragma once

#include <string>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "engines/fast/fast_data.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Why the fast engine cannot draw this: a sentence, without the full stop, that names the setting;
/// empty if it can. It draws surfaces by its own rules for pixels and edges: a pixel is covered if
/// its centre is, edges belong to the triangle that has them as a top or a left edge, corners are
/// on 256ths of a pixel, and parts behind the near plane are cut off.
std::string fast_engine_refuses(const Scene& scene, const Settings& settings);

/// The same for an engine that draws by these rules, under another name.
/// @param engine at the beginning of the sentence: "the fast engine"
std::string fixed_rules_refuse(const std::string& engine, const Scene& scene,
                               const Settings& settings);

/// Camera, light and rules as the loops need them.
fast::View fast_view(const Settings& settings);

/// Just a pinhole camera.
struct FastEye {
    Viewport size;
    glm::vec3 position{0.0f};
    glm::mat3 rotation{1.0f};  ///< R, for row vectors
    float focal_length = 1.0f; ///< pixels
    glm::vec2 middle{0.0f};    ///< where it looks, pixels from the picture's corner
    float near = 1e-3f;        ///< anything nearer is cut off, world units
};

/// The view of it, without light and textures; it culls nothing.
fast::View fast_view(const FastEye& eye);

} // namespace rasterwalk
