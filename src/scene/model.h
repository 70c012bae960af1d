#pragma once

// The model transformation Tm: from the object's own space to the world.
//
// A house is modelled once, around its own origin; a list of steps says where it stands, how it is
// turned and how large it is. Each step is a matrix, and Tm is their product. With column vectors
// the first step is on the right, next to the point: Tm = step[n] ... step[1] step[0]. The order
// matters: turning and then moving leads to a different place from moving and then turning, because
// every step is about the origin of the world.
//
// A normal is not a point. It stays perpendicular to its surface only under the inverse transpose:
// n . t = 0 is nT t = 0, and (A n)T (M t) = nT AT M t is 0 for every t if AT M = 1. Where a
// direction is scaled by s, the normal is scaled by 1/s.
//
// Source: Akenine-Moeller, Haines, Hoffman, Real-Time Rendering, 4th edition, section 4.1, basic
// transforms, and 4.1.7, normal transforms; Shirley, Marschner, Fundamentals of Computer Graphics,
// 4th edition, chapter 6, transformation matrices.

#include <cstdint>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "base/enum_words.h"

namespace rasterwalk {

/// What a step of a model transformation does, as scene files write it.
enum class ModelStepKind : std::uint8_t {
    translate, ///< moves by `amount`, world units
    scale,     ///< times `amount`, axis by axis; a negative one mirrors the axis
    rotate_x,  ///< turns about the x axis by `amount.x` radians: y toward z
    rotate_y,  ///< about the y axis: z toward x
    rotate_z,  ///< about the z axis: x toward y, clockwise in the picture, since y runs down
};

struct ModelStep {
    ModelStepKind kind = ModelStepKind::translate;
    glm::vec3 amount{0.0f};

    friend bool operator==(const ModelStep&, const ModelStep&) = default;
};

/// An object before its steps. In the mesh it is in world space already.
struct Model {
    std::vector<ModelStep> steps; ///< in the order they are carried out
    /// Three per triangle, in object space and in the order of the mesh; none: no steps.
    std::vector<glm::vec3> positions;

    friend bool operator==(const Model&, const Model&) = default;
};

/// The matrix of one step, for column vectors.
glm::dmat4 step_matrix(const ModelStep& step);

/// Tm, for column vectors: the product of the steps, the first on the right.
glm::dmat4 model_matrix(const std::vector<ModelStep>& steps);

/// The inverse transpose of the linear part of Tm, times its determinant. This changes only the
/// length, and saves the division. If an axis is mirrored, the sign is corrected.
/// @return all zero if Tm flattens the object to a line
glm::dmat3 normal_matrix(const glm::dmat4& model);

/// A point: with w = 1, translations apply.
glm::dvec3 transform_point(const glm::dmat4& matrix, const glm::dvec3& point);

/// A direction: with w = 0, translations do not apply.
glm::dvec3 transform_direction(const glm::dmat4& matrix, const glm::dvec3& direction);

/// Does Tm swap left and right? Then the corners go round the other way, and an object that is put
/// into the world has them in reverse order, so that its fronts stay fronts.
bool is_mirrored(const glm::dmat4& model);

} // namespace rasterwalk
