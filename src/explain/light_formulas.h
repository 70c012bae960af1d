#pragma once

// The light at a point as formulas, term by term.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "explain/formula.h"
#include "pipeline/frame.h"
#include "stages/surface_shader.h"

namespace rasterwalk {

/// A value with three components, and where each of them comes from.
struct SourcedVector {
    glm::vec3 value{0.0f};
    std::array<Source, 3> sources;
};

/// A point whose light is worked out.
struct LitPoint {
    std::string prefix; ///< of the formulas' ids: "pixel_light."
    SourcedVector position;
    SourcedVector normal;
    SourcedVector reflectance;
    Shine shine{};
    SurfaceLight light; ///< from the functions of the table
    /// For light worked out in tangent space: the axes, whose components have the ids
    /// bump.square.t.x ..., and the normal in the world, which shadows need. `normal` is then the
    /// one along the axes.
    struct InSpace {
        TangentFrame axes;
        glm::vec3 normal_world{0.0f};
    };
    std::optional<InSpace> space{};
    /// The colour of a texture that the finished light is multiplied by; none: it is not.
    std::optional<glm::vec3> paint{};
};

/// Does the light have a direction? At the lamp itself, or if the distance is NaN, it has none.
bool has_direction(const LightTerms& terms);

/// The names of the components: x y z, and red green blue.
inline constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};
inline constexpr std::array<const char*, 3> channel_names{"red", "green", "blue"};

/// The components of a vector as inputs: "n.x", "n.y", "n.z".
std::vector<FormulaInput> parts_of_vector(const std::string& symbol, const SourcedVector& vector);

/// The names of the axes of tangent space in ids and symbols.
inline constexpr std::array<const char*, 3> tangent_names{"t", "b", "n"};

/// One of the axes along which the light is worked out, whose components have the ids
/// bump.square.t.x ...
/// @param axis 0 to 2: t, b, n
SourcedVector axis_of_space(const TangentFrame& axes, std::size_t axis);

/// A component of a world vector along the axes of tangent space: their dot product.
/// @param symbol of the vector; the formulas `way` + ".x" ... are its components
Formula along_axis_formula(const std::string& id, const std::string& name, const std::string& help,
                           const std::string& symbol, const SourcedVector& way,
                           const TangentFrame& axes, std::size_t axis, float result);

/// Appends how the normal gets to the lit side, if both are lit (light.sides=two): away, side (1,
/// or -1: it is flipped) and lit_n.x lit_n.y lit_n.z, which are then the sources of the point's
/// normal. If only one side is lit there is nothing to append.
/// @param point   with the normal to be flipped or not, which is replaced
/// @param surface the normal that decides the side, before a normal map bends it
void append_side_formulas(LitPoint& point, const SourcedVector& surface, const Frame& frame,
                          std::vector<Formula>& formulas);

/// Appends, in this order and with these ids after the prefix: if the light is worked out in
/// tangent space way.x way.y way.z, the vector to the lamp in the world; r.x r.y r.z, r2, cosine,
/// area, those of shadow_formulas.h if something casts shadows, D.red D.green D.blue, those of
/// highlight_formulas.h if the model has highlights, R.red ..., which includes the highlight,
/// colour.red ... (as the screen shows it). If the point has paint, painted.red comes before
/// colour.red, and so on; that is then what the screen shows.
void append_light_formulas(const LitPoint& point, const Frame& frame,
                           std::vector<Formula>& formulas);

/// Appends a channel of light times the texture's, with the id `prefix` and painted.red ...
/// @return the same as an input
FormulaInput append_painted(const std::string& prefix, const std::string& help, int channel,
                            const FormulaInput& light, float texture,
                            std::vector<Formula>& formulas);

/// Appends a colour as the screen shows it, with the id `prefix` and red ...: each channel encoded,
/// and clamped to 0..1 or wrapped. The first input of a formula is the channel that was worked out;
/// a different one if the channels are out of order.
/// @param channels red, green, blue, each with its symbol in the expression
/// @param about    comes before the help of each, or is empty
void append_shown_colour(const std::string& prefix, const std::array<FormulaInput, 3>& channels,
                         const std::string& about, const Frame& frame,
                         std::vector<Formula>& formulas);

} // namespace rasterwalk
