#pragma once

// The light at a point as formulas, term by term.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "explain/formula_writer.h"
#include "pipeline/frame.h"
#include "stages/surface_shader.h"

namespace rasterwalk {

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

/// Are all channels the same? Then one of them is enough to be listed.
bool is_grey_light(const glm::vec3& light);

/// The names of the axes of tangent space in ids and symbols.
inline constexpr std::array<const char*, 3> tangent_names{"t", "b", "n"};

/// A world vector along the axes of tangent space: three dot products.
/// @param id, symbol, help of the result; the help is followed by the name of the axis and a point
/// @param from_symbol      of the vector
SourcedVector add_along_axes(FormulaWriter& write, const std::string& id, const std::string& symbol,
                             const std::string& help, const std::string& from_symbol,
                             const SourcedVector& from, const glm::vec3& result);

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

/// Appends a channel of light times the texture's, with the id painted.red ...
/// @return the same as an input
FormulaInput append_painted(FormulaWriter& write, const std::string& help, int channel,
                            const FormulaInput& light, float texture);

/// Appends a colour as the screen shows it, with the id `prefix` and red ...: each channel encoded,
/// and clamped to 0..1 or wrapped. The first input of a formula is the channel that was worked out;
/// a different one if the channels are out of order.
/// @param channels red, green, blue, each with its symbol in the expression
/// @param about    comes before the help of each, or is empty
void append_shown_colour(const std::string& prefix, const std::array<FormulaInput, 3>& channels,
                         const std::string& about, const Frame& frame,
                         std::vector<Formula>& formulas);

} // namespace rasterwalk
