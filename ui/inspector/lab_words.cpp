#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "base/text_parts.h"
#include "settings/value_words.h"
#include "text/markdown_text.h"
#include "ui/actions/compare.h"
#include "ui/actions/lab.h"
#include "ui/inspector/lab_parts.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// Numbers as the command line writes them, "0.1,-2", each with its significant digits.
std::string numbers_in_words(std::string_view text) {
    constexpr int digits = 4;
    std::string words;
    while (!text.empty()) {
        const std::string part(take_part(text, ','));
        char* rest = nullptr;
        const double number = std::strtod(part.c_str(), &rest);
        const bool is_number = !part.empty() && *rest == '\0';
        words += (words.empty() ? "" : ", ") + (is_number ? significant(number, digits) : part);
    }
    return with_minus_signs(words);
}

/// Settings as the command line writes them, "line_walk=exact", in the screen's words.
std::string in_words(const std::string& text) {
    std::string result;
    std::size_t done = 0;
    for (std::size_t equals = text.find('='); equals != text.npos;
         equals = text.find('=', equals + 1)) {
        const std::size_t blank = text.find_last_of(" (", equals);
        const std::size_t first = blank == text.npos ? 0 : blank + 1;
        std::size_t last = std::min(text.find_first_of(" )", equals), text.size());
        if (text[last - 1] == '.' || text[last - 1] == ',') --last; // ends the sentence
        const Setting* const setting = find_setting(text.substr(first, equals - first));
        if (setting == nullptr || first < done) continue;
        const std::string word = text.substr(equals + 1, last - equals - 1);
        const std::string value = std::holds_alternative<ChoiceSetting>(setting->kind)
                                      ? choice_words(*setting, word)
                                      : numbers_in_words(word);
        result += text.substr(done, first - done) + "“" + std::string(setting->title) + ": " +
                  value + "”";
        done = last;
    }
    return result + text.substr(done);
}

/// One mistake by one of its names.
std::string name_words(const Suspect& suspect, std::size_t i) {
    Candidate alone;
    alone.mistakes = {{{suspect.ids[i]}, {suspect.names[i]}}};
    return in_words(candidate_text(alone));
}

/// Each name of each mistake on a line.
std::vector<std::string> name_lines(const Candidate& candidate) {
    std::vector<std::string> lines;
    for (const Suspect& suspect : candidate.mistakes) {
        for (std::size_t i = 0; i < suspect.ids.size(); ++i) {
            const char* const joint = i > 0 ? "or " : lines.empty() ? "" : "together with ";
            lines.push_back(joint + name_words(suspect, i));
        }
    }
    return lines;
}

/// How much of the fault the likely mistakes explain.
std::string explained_words(const LabAnswer& answer, const Candidate& likely) {
    const bool is_exact = likely.different == 0;
    const bool are_several = likely.mistakes.size() > 1;
    const bool is_choice = !are_several && likely.ids().size() > 1;
    const char* const who = are_several ? "Together they explain"
                            : is_choice ? "Each of them alone explains"
                                        : "It explains";
    if (!is_exact)
        return fmt::format("{} {} of what is wrong.", who, explained_text(likely.explained, 0));
    return fmt::format("{} {}.", who,
                       answer.subject.is_picture ? "your picture down to the last pixel"
                                                 : "your rows down to the last end");
}

/// What there is to say about one of the likely mistakes; empty: the laboratory does not have it.
/// @param is_named there are several, so it is named
std::string remedy_of_suspect(Ui& ui, const Suspect& suspect, bool is_named) {
    std::string text;
    for (std::size_t i = 0; i < suspect.ids.size(); ++i) {
        const Bug* const bug = bug_of_id(lab_bugs(ui), suspect.ids[i]);
        if (bug == nullptr) continue;
        const std::string name = "**" + bug->id + " “" + as_markdown(bug->name) + "”.** ";
        const std::string sentence = as_markdown(bug->sentence);
        if (!text.empty()) {
            text += "\n\nOr " + name + sentence;
        } else {
            text = (is_named || suspect.ids.size() > 1 ? name : "") + sentence + "\n\n" +
                   remedy_of(ui, *bug);
        }
    }
    return text;
}

} // namespace

const Bug* bug_of(Ui& ui, const Candidate& candidate) {
    for (const std::string& id : candidate.ids()) {
        if (const Bug* const bug = bug_of_id(lab_bugs(ui), id)) return bug;
    }
    return nullptr;
}

std::string candidate_words(const Candidate& candidate) {
    std::string names = candidate_text(candidate);
    if (!candidate.remark.empty()) names += ", " + candidate.remark;
    return in_words(names);
}

LabHeadline headline_of(const LabAnswer& answer) {
    const Diagnosis& diagnosis = answer.diagnosis;
    const bool is_picture = answer.subject.is_picture;
    if (diagnosis.is_same()) {
        const bool is_by_other_rules = !diagnosis.rules.empty() || !diagnosis.findings.empty();
        if (is_by_other_rules) return {{"Your picture is correct."}, ""};
        return {{is_picture ? "Your picture matches the reference, pixel for pixel."
                            : "Your rows match the reference, end for end."},
                ""};
    }
    if (const Candidate* const likely = likely_candidate(diagnosis))
        return {name_lines(*likely), explained_words(answer, *likely)};
    // The second half of the verdict names the nearest.
    const std::string verdict = in_words(diagnosis.verdict);
    const std::size_t half = verdict.find("; ");
    if (half == verdict.npos) return {{verdict}, ""};
    std::string rest = verdict.substr(half + 2);
    rest[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(rest[0])));
    return {{verdict.substr(0, half) + "."}, rest};
}

std::string difference_words(const LabAnswer& answer) {
    const Diagnosis& diagnosis = answer.diagnosis;
    if (diagnosis.is_same()) return "";
    const bool is_one = diagnosis.different == 1;
    const char* const what =
        answer.subject.is_picture
            ? (is_one ? " pixel differs from the correct picture. "
                      : " pixels differ from the correct picture. ")
            : (is_one ? " row differs from the reference. " : " rows differ from the reference. ");
    return grouped(diagnosis.different) + what + diagnosis.place;
}

std::string rules_words(const Diagnosis& diagnosis) {
    if (diagnosis.rules.empty()) return "";
    const std::string rules = in_words(diagnosis.rules);
    const bool is_sure = diagnosis.is_same() || likely_candidate(diagnosis) != nullptr;
    return is_sure ? "Your program draws with " + rules + ", which is just as correct."
                   : "The nearest correct picture is drawn with " + rules + ".";
}

std::string remedy_words(Ui& ui, const Diagnosis& diagnosis) {
    const Candidate* const likely = likely_candidate(diagnosis);
    std::string text;
    if (likely == nullptr) return text;
    for (const Suspect& suspect : likely->mistakes) {
        const std::string remedy = remedy_of_suspect(ui, suspect, likely->mistakes.size() > 1);
        if (!text.empty() && !remedy.empty()) text += "\n\n";
        text += remedy;
    }
    return text;
}

} // namespace rasterwalk
