#pragma once

// The ways in which a program may compute the light of a point: the lab's, and the mistakes, alone
// and in pairs.

#include <string>
#include <vector>

#include "mine/functions/function_checks.h"
#include "stages/stage_table.h"

namespace rasterwalk {

/// What is left out of the formula, or done to its result.
enum class LightGap : std::uint8_t {
    none,
    no_max,      ///< the cosine may be negative
    no_indirect, ///< N is missing
    no_direct,   ///< D is missing
    no_colour,   ///< the reflectance is missing
    gamma,       ///< B80: raised to 1/2.2
};

/// A formula for the light.
struct LightRule {
    RuleSettings settings; ///< what differs from the lab
    Stages stages;         ///< its slot reflected_light
    LightGap gap = LightGap::none;
    std::vector<std::string> bugs;   ///< ids of its mistakes
    std::vector<std::string> causes; ///< sentences for those that the laboratory lacks
    int mistakes = 0;                ///< 0: it is right
};

/// All of them, those with fewer mistakes first; at most two.
const std::vector<LightRule>& light_rules();

/// A colour, and how far off a program may be that is as right.
struct LitColour {
    glm::dvec3 colour{0.0};
    /// Of each channel: a thousandth of the direct light, because pi may be 3.14, and 2^-16 of the
    /// colour, because float loses some of the last bits in a dozen operations.
    glm::dvec3 tolerance{0.0};
};

/// The reflected light of a point, by a rule.
LitColour lit_colour(const LightRule& rule, const glm::vec3& position, const glm::vec3& normal,
                     const glm::vec3& reflectance, const Light& light);

/// Is it the same, as it is or with each channel cut at 1?
bool is_same_colour(const glm::dvec3& theirs, const LitColour& ours);

} // namespace rasterwalk
