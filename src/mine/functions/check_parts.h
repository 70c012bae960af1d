#pragma once

// What the checks of all functions have in common.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "mine/functions/function_checks.h"

namespace rasterwalk {

/// Begins a check with what the end of the answers says about it: not_asked, not_written, died or
/// unreadable; `right` until something else is found.
template <class Answer>
FunctionCheck begin_check(std::string_view function, rasterwalk_kit::Part part,
                          const Questions& questions, const PartAnswers<Answer>& answers) {
    FunctionCheck check;
    check.function = function;
    check.part = part;
    check.fed = questions.fed[part];
    check.asked = static_cast<int>(question_count(questions, part));
    switch (answers.end) {
    case PartEnd::not_asked:
        check.state = CheckState::not_asked;
        break;
    case PartEnd::not_askable:
        check.notes.emplace_back("It has parameters of its own, so it cannot be asked.");
        break;
    case PartEnd::not_written:
        check.state = CheckState::not_written;
        break;
    case PartEnd::unreadable:
        check.state = CheckState::unreadable;
        check.first = answers.fault;
        break;
    case PartEnd::cut_short:
        check.state = CheckState::died;
        break;
    case PartEnd::complete:
        check.state = CheckState::right;
        break;
    }
    return check;
}

/// Can its answers be compared? Those before the end of a program that died can.
inline bool has_answers(const FunctionCheck& check) {
    return check.state == CheckState::right || check.state == CheckState::died;
}

/// Wrong, unless the program died, which counts more.
inline void set_wrong(FunctionCheck& check) {
    if (check.state == CheckState::right) check.state = CheckState::wrong;
}

/// Which of the questions that were answered are answered right, in all that is judged of them.
using RightQuestions = std::vector<bool>;

/// How many they are.
inline int count_right(const RightQuestions& right) {
    return static_cast<int>(std::count(right.begin(), right.end(), true));
}

/// Those that are right in both.
inline RightQuestions right_in_both(RightQuestions first, const RightQuestions& second) {
    for (std::size_t i = 0; i < first.size(); ++i)
        first[i] = first[i] && second[i];
    return first;
}

/// Adds a word to a list, once.
inline void add_once(std::string_view word, std::vector<std::string>& list) {
    if (std::find(list.begin(), list.end(), word) == list.end()) list.emplace_back(word);
}

/// Does the pixel of a program have these values?
inline bool has_field(const rasterwalk_kit::PixelValues& values, rasterwalk_kit::PixelField field) {
    return (static_cast<std::uint32_t>(values.fields) & field) != 0;
}

/// Is it close to what is right? NaN is not.
inline bool is_close(double theirs, double ours, double tolerance) {
    return std::abs(theirs - ours) <= tolerance;
}

/// "(250, 123)"
inline std::string pixel_text(double x, double y) {
    return fmt::format("({:.9g}, {:.9g})", x, y);
}

} // namespace rasterwalk
