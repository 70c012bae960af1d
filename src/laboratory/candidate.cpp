#include "laboratory/candidate.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rasterwalk {

namespace {

/// Each further assumption must be worth this part of the distance.
constexpr double price_of_assumption = 0.02;

/// What explains less is said to explain nothing, "0.0 %".
constexpr double least_explained = 0.0005;

/// Below this part nothing is likely.
constexpr double explains_nothing = 0.3;

double price(const Hypothesis& h) {
    return h.distance * (1.0 + price_of_assumption * h.assumptions);
}

/// B and a number: a mistake of the laboratory.
bool is_bug_id(const std::string& id) {
    return id.size() > 1 && id[0] == 'B' && id[1] >= '0' && id[1] <= '9';
}

std::string candidate_text(const Candidate& candidate) {
    std::string text;
    for (std::size_t i = 0; i < candidate.names.size(); ++i) {
        if (i > 0) text += i + 1 == candidate.names.size() ? " or " : ", ";
        // The name of a mistake is a sentence of its own.
        text += is_bug_id(candidate.ids[i]) ? candidate.ids[i] + " “" + candidate.names[i] + "”"
                                            : candidate.names[i];
    }
    return candidate.remark.empty() ? text : fmt::format("{} ({})", text, candidate.remark);
}

bool is_likely(const Candidate& candidate) {
    return candidate.distance == 0.0 || candidate.explained >= explains_nothing;
}

std::string verdict_text(const Candidate& first, std::string_view same) {
    const std::string who = candidate_text(first);
    if (first.distance == 0.0) {
        return fmt::format("{} {} {}.", who, first.ids.size() > 1 ? "make" : "makes", same);
    }
    const std::string explained = explained_text(first.explained, 0);
    if (!is_likely(first)) {
        return fmt::format("No known mistake explains the difference; the nearest, {}, explains "
                           "{} of it.",
                           who, explained);
    }
    return fmt::format("Most likely {}, which explains {} of the difference.", who, explained);
}

} // namespace

void rank_candidates(std::vector<Hypothesis> hypotheses, std::string_view same,
                     Diagnosis& diagnosis) {
    std::stable_sort(hypotheses.begin(), hypotheses.end(),
                     [](const Hypothesis& a, const Hypothesis& b) {
                         if (price(a) != price(b)) return price(a) < price(b);
                         if (a.assumptions != b.assumptions) return a.assumptions < b.assumptions;
                         return a.is_bug && !b.is_bug;
                     });
    std::vector<const Hypothesis*> leaders; // of each candidate
    for (const Hypothesis& h : hypotheses) {
        const auto leader = std::find_if(leaders.begin(), leaders.end(), [&](const Hypothesis* l) {
            return l->result == h.result && l->distance == h.distance;
        });
        if (leader != leaders.end()) {
            // What needs more assumptions, or is only another name of a bug's setting, adds
            // nothing.
            Candidate& candidate =
                diagnosis.candidates[static_cast<std::size_t>(leader - leaders.begin())];
            const bool is_equal =
                h.is_bug == (*leader)->is_bug && h.assumptions == (*leader)->assumptions;
            const bool is_new =
                std::find(candidate.ids.begin(), candidate.ids.end(), h.id) == candidate.ids.end();
            if (is_equal && is_new) {
                candidate.ids.push_back(h.id);
                candidate.names.push_back(h.name);
            }
            continue;
        }
        // The same mistake with other assumptions is worse than what is listed already.
        const bool is_listed =
            std::any_of(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                        [&](const Candidate& candidate) {
                            return std::find(candidate.ids.begin(), candidate.ids.end(), h.id) !=
                                   candidate.ids.end();
                        });
        if (is_listed || diagnosis.candidates.size() == most_candidates) continue;
        // Beside what makes the very same, nothing else explains anything more.
        if (!leaders.empty() && leaders.front()->distance == 0.0) continue;
        const double explained =
            diagnosis.distance > 0.0 ? 1.0 - h.distance / diagnosis.distance : 0.0;
        // What brings nothing nearer is not worth naming.
        if (explained < least_explained) continue;
        leaders.push_back(&h);
        diagnosis.candidates.push_back({{h.id},
                                        {h.name},
                                        h.remark,
                                        h.distance,
                                        h.different,
                                        std::clamp(explained, 0.0, 1.0),
                                        h.recipe,
                                        h.right});
    }
    if (diagnosis.is_same()) {
        diagnosis.verdict = "no difference";
    } else if (leaders.empty()) {
        diagnosis.verdict = "No known mistake explains the difference.";
    } else {
        diagnosis.verdict = verdict_text(diagnosis.candidates.front(), same);
    }
}

const Candidate* likely_candidate(const Diagnosis& diagnosis) {
    if (diagnosis.is_same() || diagnosis.candidates.empty()) return nullptr;
    const Candidate& first = diagnosis.candidates.front();
    return is_likely(first) ? &first : nullptr;
}

std::string explained_text(double part, int digits) {
    const std::string percent = fmt::format("{:.{}f} %", 100.0 * part, digits);
    if (part >= 1.0 || !percent.starts_with("100")) return percent;
    return digits == 0 ? explained_text(part, 1)
                       : "99." + std::string(static_cast<std::size_t>(digits), '9') + " %";
}

} // namespace rasterwalk
