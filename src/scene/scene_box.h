#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace rasterwalk {

/// The smallest box, along the world's axes, around everything a scene draws.
struct SceneBox {
    glm::dvec3 low{-1.0}, high{1.0};

    glm::dvec3 middle() const { return 0.5 * (low + high); }
    /// Radius of the ball around it; never 0.
    double radius() const;
};

/// Around all vertices that are finite; a scene without any gets the box from -1 to 1.
SceneBox box_of(const Scene& scene);

} // namespace rasterwalk
