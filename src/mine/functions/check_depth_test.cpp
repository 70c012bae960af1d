#include <map>
#include <utility>

#include "mine/functions/check_parts.h"
#include "mistakes/depth_test.h"
#include "stages/depth_test.h"

namespace rasterwalk {

namespace {

/// A depth test, and what its buffer holds when it is asked.
struct DepthRule {
    decltype(&depth_test) test;
    float epsilon, start;
    std::string_view name, value, bug;
};

constexpr DepthRule depth_rules_tried[] = {
    {depth_test, 0.0f, 0.0f, "depth_test", "inverse_z", {}},
    {depth_test_reversed, 0.0f, 0.0f, "depth_test", "reversed", "B17a"},
    {depth_test_reversed, 0.0f, 1000.0f, "depth_test", "reversed", "B17d"},
    {depth_test_or_equal, 0.0f, 0.0f, "depth_test", "or_equal", "B88a"},
    {depth_test_with_epsilon, 0.0001f, 0.0f, "depth_epsilon", "0.0001", "B88b"},
    {depth_test_with_epsilon, 0.05f, 0.0f, "depth_epsilon", "0.05", "B61"},
};

using DepthAnswers = std::vector<std::vector<bool>>;

/// What a rule answers.
/// @param is_kept the buffer is not cleared between questions
DepthAnswers answers_by(const DepthRule& rule, bool is_kept, std::size_t count,
                        const Questions& questions) {
    DepthRules rules;
    rules.epsilon = rule.epsilon;
    std::map<std::pair<int, int>, float> buffer;
    DepthAnswers made;
    for (std::size_t q = 0; q < count; ++q) {
        if (!is_kept) buffer.clear();
        std::vector<bool>& passed = made.emplace_back();
        for (const DepthFragment& asked : questions.depths[q].fragments) {
            Fragment fragment;
            fragment.column = static_cast<int>(asked.at.x);
            fragment.row = static_cast<int>(asked.at.y);
            fragment.depth = fragment.inv_w = static_cast<float>(asked.at.zinv);
            const auto cell = std::pair(fragment.column, fragment.row);
            float& stored = buffer.try_emplace(cell, rule.start).first->second;
            const DepthResult result = rule.test(fragment, stored, rules);
            if (result.passed) stored = result.depth;
            passed.push_back(result.passed);
        }
    }
    return made;
}

bool are_all(const DepthAnswers& answers, bool flag) {
    return std::all_of(answers.begin(), answers.end(), [flag](const std::vector<bool>& passed) {
        return std::all_of(passed.begin(), passed.end(), [flag](bool one) { return one == flag; });
    });
}

bool is_answered_by(const DepthRule& rule, const DepthAnswers& theirs, const Questions& questions) {
    return answers_by(rule, false, theirs.size(), questions) == theirs ||
           answers_by(rule, true, theirs.size(), questions) == theirs;
}

void say_first_fragment(const DepthAnswers& theirs, const Questions& questions,
                        FunctionCheck& check) {
    const DepthAnswers ours = answers_by(depth_rules_tried[0], false, theirs.size(), questions);
    for (std::size_t q = 0; q < theirs.size(); ++q) {
        for (std::size_t f = 0; f < theirs[q].size(); ++f) {
            if (theirs[q][f] == ours[q][f]) continue;
            const DepthQuestion& question = questions.depths[q];
            check.difference.question = static_cast<int>(q);
            check.difference.item = static_cast<int>(f);
            check.difference.ours = question.fragments[f].at;
            check.first = fmt::format(
                "{}: fragment {} at {} with 1/z = {:.6g} {} where it {}.", question.name, f,
                pixel_text(question.fragments[f].at.x, question.fragments[f].at.y),
                question.fragments[f].at.zinv, theirs[q][f] ? "is drawn" : "is not drawn",
                ours[q][f] ? "must be" : "must not be");
            return;
        }
    }
}

} // namespace

FunctionCheck check_depth_test(const Questions& questions, const Answers& answers) {
    FunctionCheck check =
        begin_check("depth test", rasterwalk_kit::part_depth_test, questions, answers.depths);
    if (!has_answers(check)) return check;
    const DepthAnswers& theirs = answers.depths.answers;
    if (check.state == CheckState::died) {
        check.first =
            fmt::format("The program ended at group {} of {}.", theirs.size(), check.asked);
    }
    if (theirs.empty()) return check;
    if (are_all(theirs, true) || are_all(theirs, false)) {
        const bool all = are_all(theirs, true);
        if (check.state == CheckState::right) check.state = CheckState::not_written;
        check.notes.emplace_back(
            all ? "Every fragment is drawn: there is no depth test yet."
                : "No fragment is drawn: DrawPolygonRows does nothing, or the depth buffer is not "
                  "cleared to 0, or the test is the wrong way round (B17a).");
        return check;
    }
    const DepthAnswers ours = answers_by(depth_rules_tried[0], false, theirs.size(), questions);
    for (std::size_t q = 0; q < theirs.size(); ++q)
        check.right += theirs[q] == ours[q] ? 1 : 0;
    for (const DepthRule& rule : depth_rules_tried) {
        if (!is_answered_by(rule, theirs, questions)) continue;
        check.rules = {{std::string(rule.name), std::string(rule.value)}};
        if (rule.bug.empty()) {
            check.right = static_cast<int>(theirs.size());
            check.rule = "larger 1/z is nearer, and of two that are equally near the first stays";
            return check;
        }
        add_once(rule.bug, check.bugs);
    }
    set_wrong(check);
    say_first_fragment(theirs, questions, check);
    return check;
}

} // namespace rasterwalk
