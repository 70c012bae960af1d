#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "laboratory/image_variant.h"
#include "settings/settings.h"

namespace rasterwalk {

/// How to make a picture to try: drawn with the settings, then turned, then moved.
struct PictureRecipe {
    Settings settings;
    Orientation orientation = Orientation::upright;
    int right = 0, down = 0; ///< pixels

    friend bool operator==(const PictureRecipe&, const PictureRecipe&) = default;
};

/// One mistake with all its possible names: each of them makes exactly the same result.
struct Suspect {
    std::vector<std::string> ids;   ///< of bugs: "B9"; of others, a word: "upside_down"
    std::vector<std::string> names; ///< their names, in the same order
};

/// A possible explanation of a result: one mistake, or a few together.
struct Candidate {
    std::vector<Suspect> mistakes;
    std::string remark;         ///< its rules besides those of the requested reference: "with
                                ///< light.power=14"; may be empty
    double distance = 0.0;      ///< from the result; 0: exactly the same
    std::int64_t different = 0; ///< pixels or rows that still differ from the result
    double explained = 0.0;     ///< part of the wrong pixels that it explains, 0..1
    bool is_likely = false;     ///< it explains nearly all, and almost nothing contradicts it
    std::optional<PictureRecipe> recipe{}; ///< of its picture; none: it makes rows
    std::optional<Settings> right{};       ///< the same without the mistakes; none: the reference

    /// Of all its mistakes.
    std::vector<std::string> ids() const;
};

/// What may be wrong with a result, compared with the reference.
struct Diagnosis {
    std::string verdict;        ///< a sentence; "no difference"
    std::string rules;          ///< other rules, just as right, and numbers that the result was
                                ///< made with: "stage=fill and light.power=9". The reference has
                                ///< taken them over. Empty: those asked for
    double distance = 0.0;      ///< of the reference from the result
    std::int64_t different = 0; ///< pixels or rows that differ from it
    std::string place;          ///< where they do, a sentence; empty if none does
    std::vector<std::string> findings; ///< sentences about what is known even if no mistake is
                                       ///< likely
    std::vector<Candidate> candidates; ///< most likely first
    bool is_complete = true;           ///< everything was tried; otherwise it was stopped

    bool is_same() const { return different == 0; }
};

/// A candidate before it is known which others make the same result.
struct Hypothesis {
    Candidate candidate;      ///< each mistake with one name
    double price = 0.0;       ///< of what it leaves unexplained and what it assumes
    double assumed = 0.0;     ///< of only what it assumes
    std::uint64_t result = 0; ///< the same number for the same result
    bool is_of_bugs = false;  ///< all its mistakes are the laboratory's
};

/// The best hypotheses, at most most_candidates: those with the same result are one candidate, and
/// one that adds nothing to a better one is not listed.
std::vector<Candidate> ranked(std::vector<Hypothesis> hypotheses);

/// The candidate that the verdict calls likely; null if there is none.
const Candidate* likely_candidate(const Diagnosis& diagnosis);

/// The verdict on what differs.
std::string verdict_on(const Diagnosis& diagnosis);

/// The mistakes of a candidate, without its remark: "B3 “Position interpolated as it is”".
std::string candidate_text(const Candidate& candidate);

/// How much of the difference is explained, as text: "87 %", "87.2 %". Less than all is never
/// rounded up to it: it then has one more digit, or stays below it, "99.9 %".
/// @param part   Candidate::explained
/// @param digits after the point
std::string explained_text(double part, int digits);

/// B and a number: is this the id of a mistake from the laboratory?
bool is_bug_id(std::string_view id);

/// The most candidates that are listed.
inline constexpr std::size_t most_candidates = 10;

/// A candidate is likely if it explains at least this part of what is wrong, spoils at most this
/// part of what is right, and shows at least this part of the pixels that are not black.
inline constexpr double explains_nearly_all = 0.99, speaks_against = 0.001, shows_enough = 0.5;

} // namespace rasterwalk
