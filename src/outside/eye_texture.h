#pragma once

// The texture of a triangle as seen from outside: nearest texels, of the level that suits their
// distance.

#include <span>

#include "outside/outside_eye.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// The texture of one triangle in the space of the eye; white if it has none.
class EyeTexture {
  public:
    EyeTexture() = default;
    /// @param corners of the triangle, whose area must not be 0, in the space of the eye
    EyeTexture(const Frame& frame, int triangle, std::span<const glm::dvec3> corners,
               const OutsideEye& eye);

    bool is_there() const { return texture_ != nullptr; }

    /// The colour at a point on the triangle, by the rules of the frame.
    /// @param place in the space of the eye
    glm::vec3 at(const glm::dvec3& place) const;

  private:
    const Texture* texture_ = nullptr;
    const Stages* stages_ = nullptr;
    glm::dvec3 corner_{0.0};
    glm::dvec2 texcoord_{0.0};               ///< at the corner
    glm::dvec3 u_slope_{0.0}, v_slope_{0.0}; ///< growth of u and v along each axis
    double texels_ = 0.0;                    ///< that a sample covers at distance 1
};

} // namespace rasterwalk
