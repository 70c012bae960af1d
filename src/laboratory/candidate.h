#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "laboratory/image_variant.h"
#include "settings/settings.h"

namespace rasterwalk {

/// How a picture that was tried is made: drawn by the settings, then turned, then moved.
struct PictureRecipe {
    Settings settings;
    Orientation orientation = Orientation::upright;
    int right = 0, down = 0; ///< pixels

    friend bool operator==(const PictureRecipe&, const PictureRecipe&) = default;
};

/// A mistake that may have made a result. Mistakes that make the very same result are one
/// candidate.
struct Candidate {
    std::vector<std::string> ids;   ///< of bugs: "B9"; of others a word: "upside_down"
    std::vector<std::string> names; ///< what they are, in the same order
    std::string remark;         ///< what it is assumed with: "with light.power=14"; may be empty
    double distance = 0.0;      ///< from the result; 0: the very same
    std::int64_t different = 0; ///< pixels or rows that differ from the result
    double explained = 0.0;     ///< part of the difference from the reference, 0..1
    std::optional<PictureRecipe> recipe{}; ///< of its picture; none: it makes rows
    std::optional<Settings> right{}; ///< without the mistake but with what the remark assumes;
                                     ///< none: the reference
};

/// What may be wrong with a result that was compared with the reference.
struct Diagnosis {
    std::string verdict;               ///< a sentence; "no difference"
    double distance = 0.0;             ///< of the reference from the result
    std::int64_t different = 0;        ///< pixels or rows that differ from the reference, drawn
                                       ///< with what the likely candidate assumes
    std::string place;                 ///< where they do, a sentence; empty if none does
    std::vector<Candidate> candidates; ///< most likely first

    bool is_same() const { return different == 0; }
};

/// A candidate before it is known which others come to the same.
struct Hypothesis {
    std::string id{}, name{}, remark{};
    int assumptions = 1;       ///< how many things differ from the reference
    bool is_bug = false;       ///< of the laboratory
    bool explains_more = true; ///< than what it assumes beside the mistake does alone
    double distance = 0.0;
    std::int64_t different = 0;
    std::uint64_t result = 0;              ///< the same number for the same result
    std::optional<PictureRecipe> recipe{}; ///< as that of the candidate
    std::optional<Settings> right{};       ///< likewise
};

/// Ranks the hypotheses, names those of the same result together, and says the verdict.
/// @param same what a candidate of distance 0 makes: "this very picture"
void rank_candidates(std::vector<Hypothesis> hypotheses, std::string_view same,
                     Diagnosis& diagnosis);

/// The candidate of which the verdict says that it is likely; null if there is none.
const Candidate* likely_candidate(const Diagnosis& diagnosis);

/// How much of the difference is explained, as it is said: "87 %", "87.2 %". Less than all is never
/// rounded up to it: it then has a digit more, or ends below it, "99.9 %".
/// @param part   Candidate::explained
/// @param digits behind the point
std::string explained_text(double part, int digits);

/// So many candidates are named at most.
inline constexpr std::size_t most_candidates = 10;

} // namespace rasterwalk
