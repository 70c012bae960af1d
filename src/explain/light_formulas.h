#pragma once

// The light at a point as formulas, term by term.

#include <array>
#include <string>
#include <vector>

#include "explain/formula.h"
#include "pipeline/frame.h"
#include "stages/light.h"

namespace rasterwalk {

/// A value of three parts and where each of them comes from.
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
    LightTerms terms; ///< as reflected_light gave them
};

/// The names of the parts: x y z, and red green blue.
inline constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};
inline constexpr std::array<const char*, 3> channel_names{"red", "green", "blue"};

/// Appends, in this order and with these ids after the prefix: r.x r.y r.z, r2, cosine, area,
/// D.red D.green D.blue, R.red ..., colour.red ... (as the screen shows it).
void append_light_formulas(const LitPoint& point, const Frame& frame,
                           std::vector<Formula>& formulas);

/// A channel as the screen shows it: cut to 0..1, or wrapped. The formula's one input, and its
/// symbol in the expression, is the channel as it was worked out.
Formula shown_channel(std::string id, std::string name, const FormulaInput& channel,
                      const Frame& frame);

} // namespace rasterwalk
