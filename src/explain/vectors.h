#pragma once

// The vectors at the picked pixel, with which its light is worked out; or those by which a triangle
// faces the eye, at the selected vertex; or the two sides of the triangle shown that begin at
// vertices[0], with what the dot and the cross product measure: the shadow of one on the other, and
// the parallelogram. As places and directions, before anything is projected.
//
// Source: the dot product as a shadow and the cross product as an area, P. Shirley, S. Marschner,
// Fundamentals of Computer Graphics, 4th edition, section 2.4.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "explain/fragment_report.h"
#include "outside/outside_marks.h"

namespace rasterwalk {

enum class VectorName : std::uint8_t {
    normal,    ///< n, as the light has it
    unbent,    ///< n before a normal map bends it
    to_lamp,   ///< l
    to_eye,    ///< v
    half,      ///< h, halfway between l and v
    tangent,   ///< t
    bitangent, ///< b
    u,         ///< from vertices[0] to vertices[1]
    v,         ///< from vertices[0] to vertices[2]
    from_eye,  ///< p - C, from the eye to the selected vertex
};

/// How a vector is named.
struct VectorWords {
    std::string_view symbol; ///< at its tip
    std::string_view title;  ///< "to the lamp"
};
VectorWords vector_words(VectorName name);

/// The symbol, if it is a single letter, by which text knows the vector; 0: it is longer.
char letter_of(VectorName name);

/// Is it a direction, for which a view chooses how long 1 is? Any other vector leads from one point
/// to another.
bool is_direction(VectorName name);

/// Is it the letter of one of these vectors?
bool is_vector_letter(char letter);

struct ShownVector {
    VectorName name{};
    glm::dvec3 from{0.0};
    glm::dvec3 along{0.0}; ///< its components
};

/// What dot and cross product measure of u and v, which both begin at `start`.
struct SpannedSides {
    glm::dvec3 start{0.0}, u{0.0}, v{0.0};
    glm::dvec3 foot{0.0}; ///< of the perpendicular from the tip of v on the line through u
    double shadow = 0.0;  ///< from the start to the foot; negative if it points against u
    double area = 0.0;    ///< of the parallelogram

    /// Of the parallelogram, in turn: the start, the tip of u, the one across, the tip of v.
    std::array<glm::dvec3, 4> corners() const {
        return {start, start + u, start + u + v, start + v};
    }
};

/// All that is shown. Places are in the world, or in a scene in pixels columns and rows, whose
/// whole numbers are the middles of pixels.
struct VectorReport {
    std::optional<glm::ivec2> pixel; ///< whose light it is; none: the sides of the triangle
    int triangle = 0;
    std::vector<ShownVector> vectors;  ///< in the order of their names; none is infinite or NaN
    std::optional<SpannedSides> sides; ///< none if u has no length
};

/// The vectors at a fragment, if it has light; otherwise those of the triangle. None without
/// either.
/// @param fragment may be null
/// @param vertex the selected one, 0 to 2: in the world, the normal there and the way from the eye
///               take the place of the sides
std::optional<VectorReport> vector_report(const Frame& frame, const FragmentReport* fragment,
                                          std::optional<int> triangle, std::optional<int> vertex);

/// "length 1", "2.24 pixels", "0.52 world units".
std::string length_words(const ShownVector& vector, SceneSpace space);

/// The lines that show a report, in drawing order; the numbers of arrows are VectorName.
/// @param unit  how long a direction of length 1 is drawn, world units
/// @param angle the side of the right-angle sign, at most; in the report's units
std::vector<OutsideArrow> vector_lines(const VectorReport& report, double unit, double angle);

/// A line in the picture: columns and rows, whose whole numbers are the middles of pixels.
struct PictureLine {
    glm::dvec2 from{0.0}, to{0.0};
    bool is_from_cut = false, is_to_cut = false; ///< that end is on the near plane instead
};

/// Where the frame's camera sees a line of the world, or of a scene in pixels; none if all of it is
/// nearer than the near plane. Not rounded to pixels.
std::optional<PictureLine> line_in_picture(const Frame& frame, const glm::dvec3& from,
                                           const glm::dvec3& to);

/// How many pixels of the picture a world unit at this place takes, seen face on; 1 in a scene in
/// pixels, 0 behind the near plane.
double pixels_per_unit(const Frame& frame, const glm::dvec3& place);

} // namespace rasterwalk
