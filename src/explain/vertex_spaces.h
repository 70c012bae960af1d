#pragma once

// A vertex in every space by name, with the matrix that took it there, in double like the matrices;
// the lab's float can differ by a few bits.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>

#include "pipeline/frame.h"

namespace rasterwalk {

/// A vertex in one space.
struct SpacePlace {
    std::string_view space;           ///< "object", "world", "camera", "clip", "ndc" or "window"
    std::string about;                ///< what the space is
    std::string_view matrix_name;     ///< "Tm", "Tv", "Tp", "Ts"; empty for the first space and ndc
    std::optional<glm::dmat4> matrix; ///< from the previous space, for column vectors
    glm::dvec4 place{0.0};            ///< x, y, z, w
    /// How x, y, z and w were found, with numbers: "x = 2 · 0.5 + 0.1 · 1 = 1.1". Only the terms
    /// that are not 0. Empty in the first space.
    std::array<std::string, 4> formulas;
};

/// The normal of a vertex on its way to the world, unit length.
struct NormalPlace {
    glm::dvec3 object{0.0};
    glm::dvec3 world{0.0};    ///< by the inverse transpose of Tm
    glm::dvec3 as_point{0.0}; ///< by Tm itself, as a direction: right only if Tm just rotates
};

/// A vertex in all spaces that it reaches.
struct SpacesOfVertex {
    int triangle = -1;
    int vertex = -1; ///< 0..2
    MatrixOrder order = MatrixOrder::row_vectors;
    std::string chain; ///< "Ts · Tp · Tv · Tm · p", or "p · Tm · Tv · Tp · Ts" with row vectors
    std::vector<SpacePlace> places; ///< in order; without ndc and window if w <= 0
    NormalPlace normal;
};

/// The names of the spaces, in order.
inline constexpr std::array<std::string_view, 6> space_names{"object", "world", "camera",
                                                             "clip",   "ndc",   "window"};

/// The matrices of a triangle, for column vectors, with the mistakes that they can contain.
struct SpaceMatrices {
    glm::dmat4 to_world{1.0};  ///< Tm
    glm::dmat4 to_camera{1.0}; ///< Tv
    glm::dmat4 to_clip{1.0};   ///< Tp
    glm::dmat4 to_window{1.0}; ///< Ts, from ndc
};

/// Of a triangle of a scene with a camera.
SpaceMatrices space_matrices(const Frame& frame, int triangle);

/// The corners of a triangle where the scene file places them, before its model transformation.
std::array<glm::dvec3, triangle_corners> object_corners(const Scene& scene, int triangle);

/// The spaces of vertex 0, 1 or 2 of a triangle, whichever transform draws it. In a scene in pixel
/// space there is only the window.
/// @param order how formulas are written: whether matrix or vector comes first
SpacesOfVertex spaces_of_vertex(const Frame& frame, int triangle, int vertex, MatrixOrder order);

/// An entry of the matrix as written in this order: for row vectors it is transposed.
double entry(const glm::dmat4& matrix, MatrixOrder order, int row, int column);

} // namespace rasterwalk
