#pragma once

// One point through the conventions that books and programs choose differently, and which of these
// choices cancel each other. Each choice alone moves or mirrors the picture; some sets of two or
// three together leave it unchanged, and a program with only part of a set is wrong.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/enum_words.h"
#include "scene/scene.h"

namespace rasterwalk {

/// A choice that differs from the lab's.
enum class Convention : std::uint8_t {
    column_vectors, ///< R v in place of v R, with the same R
    transposed,     ///< R's transpose in place of R
    y_up,           ///< y of the world and of the camera runs up: their signs are flipped
    z_backward,     ///< z runs out of the picture: with y up, this makes the axes right-handed
    negative_f,     ///< −f for f
    rows_up,        ///< rows are counted from the bottom
};

inline constexpr std::size_t convention_count = enum_words<Convention>.size();

/// Some of the choices: bit i is that of Convention i.
using Conventions = std::uint8_t;

/// What a choice does to the picture.
enum class PictureChange : std::uint8_t { same, half_turn, upside_down, mirrored, elsewhere };

std::string_view change_words(PictureChange change); ///< "rotated by half a turn"

/// A point under some choices.
struct ConventionPlace {
    Conventions chosen = 0;
    std::string formula;     ///< what the program writes: "−f · (R d).x / z"
    glm::dvec3 camera{0.0};  ///< the point in front of the camera, in the chosen axes
    glm::dvec2 picture{0.0}; ///< f x/z and f y/z: pixels from the middle, y down in the picture
    PictureChange change = PictureChange::same; ///< of the whole picture, compared with the lab's
};

/// One point under the conventions, side by side.
struct ConventionReport {
    ConventionPlace lab;
    std::array<ConventionPlace, convention_count> alone; ///< each choice alone
    std::vector<ConventionPlace> cancelling; ///< the smallest sets that leave the picture unchanged
    std::vector<std::string> sentences;      ///< what cancels, one per set
};

/// Takes a point of the world through all choices, by the lab's projection, which uses the focal
/// length and ignores any other projection or window that is set.
/// @param point in the lab's axes; should lie in front of the camera
ConventionReport convention_report(const Camera& camera, const glm::vec3& point);

/// The point under these choices.
ConventionPlace convention_place(const Camera& camera, const glm::dvec3& point, Conventions chosen);

/// The name of each choice in a sentence, indexed by Convention: "R v for v R".
const std::array<std::string_view, convention_count>& convention_names();

/// Is this one among them?
constexpr bool has(Conventions chosen, Convention one) {
    return (chosen >> static_cast<unsigned>(one) & 1u) != 0;
}

} // namespace rasterwalk
