#include "laboratory/candidate.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/enumerated.h"

namespace rasterwalk {

namespace {

/// A candidate that explains less is shown as "0.0 %".
constexpr double least_explained = 0.0005;

/// Below this part, the verdict does not name an unlikely mistake.
constexpr double worth_naming = 0.5;

std::string suspect_text(const Suspect& suspect) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < suspect.names.size(); ++i) {
        // The name of a mistake is a separate sentence.
        names.push_back(is_bug_id(suspect.ids[i]) ? suspect.ids[i] + " “" + suspect.names[i] + "”"
                                                  : suspect.names[i]);
    }
    return enumerated(names, "or");
}

bool has_name(const Suspect& suspect, const std::string& id) {
    return std::find(suspect.ids.begin(), suspect.ids.end(), id) != suspect.ids.end();
}

/// Does the candidate have a mistake with this name?
bool is_in(const Suspect& one, const Candidate& candidate) {
    return std::any_of(candidate.mistakes.begin(), candidate.mistakes.end(),
                       [&](const Suspect& other) { return has_name(other, one.ids.front()); });
}

/// Does the candidate have all the mistakes of the other, under one of their names?
bool contains(const Candidate& candidate, const Candidate& other) {
    return std::all_of(other.mistakes.begin(), other.mistakes.end(), [&](const Suspect& suspect) {
        return std::any_of(suspect.ids.begin(), suspect.ids.end(), [&](const std::string& id) {
            return is_in({{id}, {}}, candidate);
        });
    });
}

/// Takes the one mistake that only the other has as another name of the one that only this has.
void add_names(const Candidate& other, Candidate& candidate) {
    std::vector<Suspect*> own;
    std::vector<const Suspect*> others;
    for (Suspect& suspect : candidate.mistakes) {
        const bool is_shared =
            std::any_of(suspect.ids.begin(), suspect.ids.end(), [&](const std::string& id) {
                return is_in({{id}, {}}, other);
            });
        if (!is_shared) own.push_back(&suspect);
    }
    for (const Suspect& suspect : other.mistakes) {
        if (!is_in(suspect, candidate)) others.push_back(&suspect);
    }
    if (own.size() != 1 || others.size() != 1) return;
    own.front()->ids.push_back(others.front()->ids.front());
    own.front()->names.push_back(others.front()->names.front());
}

} // namespace

std::vector<std::string> Candidate::ids() const {
    std::vector<std::string> all;
    for (const Suspect& suspect : mistakes)
        all.insert(all.end(), suspect.ids.begin(), suspect.ids.end());
    return all;
}

bool is_bug_id(std::string_view id) {
    return id.size() > 1 && id[0] == 'B' && id[1] >= '0' && id[1] <= '9';
}

std::vector<Candidate> ranked(std::vector<Hypothesis> hypotheses) {
    std::stable_sort(hypotheses.begin(), hypotheses.end(),
                     [](const Hypothesis& a, const Hypothesis& b) {
                         if (a.price != b.price) return a.price < b.price;
                         return a.is_of_bugs && !b.is_of_bugs;
                     });
    std::vector<Candidate> candidates;
    std::vector<const Hypothesis*> leaders; // one for each candidate
    for (const Hypothesis& h : hypotheses) {
        const auto leader = std::find_if(leaders.begin(), leaders.end(), [&](const Hypothesis* l) {
            return l->result == h.result && l->candidate.distance == h.candidate.distance;
        });
        if (leader != leaders.end()) {
            // One that assumes more, or is only another name of a bug's setting, adds nothing.
            if (h.is_of_bugs == (*leader)->is_of_bugs && h.assumed == (*leader)->assumed)
                add_names(h.candidate,
                          candidates[static_cast<std::size_t>(leader - leaders.begin())]);
            continue;
        }
        if (candidates.size() == most_candidates || h.candidate.explained < least_explained)
            continue;
        // After a candidate that makes the same result, others explain nothing more; nor does the
        // same mistake under different assumptions, or with a second one that leaves more
        // unexplained, or without the second one.
        const bool adds_nothing =
            std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& better) {
                return better.different == 0 || contains(h.candidate, better) ||
                       contains(better, h.candidate);
            });
        if (adds_nothing) continue;
        leaders.push_back(&h);
        candidates.push_back(h.candidate);
    }
    return candidates;
}

std::string candidate_text(const Candidate& candidate) {
    std::vector<std::string> texts;
    for (const Suspect& suspect : candidate.mistakes)
        texts.push_back(suspect_text(suspect));
    return fmt::format("{}", fmt::join(texts, " together with "));
}

const Candidate* likely_candidate(const Diagnosis& diagnosis) {
    if (diagnosis.is_same() || diagnosis.candidates.empty()) return nullptr;
    const Candidate& first = diagnosis.candidates.front();
    return first.is_likely ? &first : nullptr;
}

std::string verdict_on(const Diagnosis& diagnosis) {
    if (diagnosis.is_same()) return "no difference";
    const std::string none = diagnosis.is_complete
                                 ? "No known mistake explains the difference"
                                 : "No mistake tried so far explains the difference";
    if (diagnosis.candidates.empty()) return none + ".";
    const Candidate& first = diagnosis.candidates.front();
    const std::string who =
        candidate_text(first) + (first.remark.empty() ? "" : " (" + first.remark + ")");
    if (first.different == 0) return "Exact match: " + who + ".";
    const std::string explained = explained_text(first.explained, 0);
    if (first.explained < worth_naming) return none + ".";
    if (!first.is_likely) {
        return fmt::format("{}; the best match, {}, explains {} of it.", none, who, explained);
    }
    return fmt::format("Most likely {}, which explains {} of the difference.", who, explained);
}

std::string explained_text(double part, int digits) {
    const std::string percent = fmt::format("{:.{}f} %", 100.0 * part, digits);
    if (part >= 1.0 || !percent.starts_with("100")) return percent;
    return digits == 0 ? explained_text(part, 1)
                       : "99." + std::string(static_cast<std::size_t>(digits), '9') + " %";
}

} // namespace rasterwalk
