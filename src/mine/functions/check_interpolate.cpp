#include <array>
#include <functional>

#include "mine/functions/asked_lines.h"
#include "mine/functions/check_parts.h"
#include "mine/functions/line_rules.h"
#include "mine/functions/row_reach.h"
#include "mistakes/coverage.h"

namespace rasterwalk {

namespace {

using rasterwalk_kit::PixelValues;

bool has_fractions(const AskedLines& asked) {
    for (const PixelList& answer : asked.answers) {
        for (const PixelValues& values : answer.pixels) {
            const double sum = values.x + values.y;
            if (std::isfinite(sum) && std::abs(sum) < 1e6 && sum != std::floor(sum)) return true;
        }
    }
    return false;
}

double position_tolerance(const LineQuestion& question) {
    const auto& [a, b, count] = question;
    const double largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
    return value_tolerance(largest, count);
}

int full_count(const LineQuestion& question) {
    return static_cast<int>(std::max(std::abs(question.a.x - question.b.x),
                                     std::abs(question.a.y - question.b.y))) +
           1;
}

/// The first sample that a rule has elsewhere; -1: none.
int first_other_sample(const LineRule& rule, const AskedLines& asked, int index) {
    const LineQuestion& question = asked.questions[static_cast<std::size_t>(index)];
    const PixelList& answer = asked.answers[static_cast<std::size_t>(index)];
    const std::vector<LineSample> ours =
        samples_by(rule, to_line_end(question.a), to_line_end(question.b), question.count);
    if (answer.pixels.size() != ours.size())
        return static_cast<int>(std::min(answer.pixels.size(), ours.size()));
    const double tolerance = position_tolerance(question);
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const PixelValues& theirs = answer.pixels[i];
        const bool same =
            asked.is_real ? is_close(theirs.x, double{ours[i].x}, tolerance) &&
                                is_close(theirs.y, double{ours[i].y}, tolerance)
                          : theirs.x == ours[i].fragment.column && theirs.y == ours[i].fragment.row;
        if (!same) return static_cast<int>(i);
    }
    return -1;
}

bool can_walk(const LineRule& rule, const AskedLines& asked, int index) {
    const LineQuestion& question = asked.questions[static_cast<std::size_t>(index)];
    return !rule.needs_full_count || question.count == full_count(question);
}

bool explains_all_lines(const LineRule& rule, const AskedLines& asked) {
    for (int i = 0; i < asked.count(); ++i) {
        if (can_walk(rule, asked, i) && first_other_sample(rule, asked, i) >= 0) return false;
    }
    return true;
}

/// The first sample that no rounding explains, because it is too far from the line; -1: none.
/// Counts the samples that are on the line along its longer axis, where a step is a whole pixel.
int first_far_sample(const AskedLines& asked, int index, int& on_line, int& samples) {
    const LineQuestion& question = asked.questions[static_cast<std::size_t>(index)];
    const PixelList& answer = asked.answers[static_cast<std::size_t>(index)];
    const std::size_t count = static_cast<std::size_t>(question.count);
    if (answer.pixels.size() != count)
        return static_cast<int>(std::min(answer.pixels.size(), count));
    const double reach = (asked.is_real ? 0.0 : farthest_rounding) + position_tolerance(question);
    const double dx = question.b.x - question.a.x, dy = question.b.y - question.a.y;
    const double steps = std::max(question.count - 1, 1);
    for (std::size_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / steps;
        const double x = question.a.x + t * dx, y = question.a.y + t * dy;
        const PixelValues& theirs = answer.pixels[i];
        if (!is_close(theirs.x, x, reach) || !is_close(theirs.y, y, reach))
            return static_cast<int>(i);
        if (question.count != full_count(question) || i == 0) continue;
        ++samples;
        const double along = std::abs(dx) >= std::abs(dy) ? theirs.x - x : theirs.y - y;
        if (std::abs(along) < 0.5) ++on_line;
    }
    return -1;
}

void say_first(FunctionCheck& check, const AskedLines& asked, int index, int sample) {
    const LineQuestion& question = asked.questions[static_cast<std::size_t>(index)];
    const PixelList& answer = asked.answers[static_cast<std::size_t>(index)];
    const std::string line =
        fmt::format("Interpolate({}, {}) with {} samples", pixel_text(question.a.x, question.a.y),
                    pixel_text(question.b.x, question.b.y), question.count);
    check.difference.question = index;
    check.difference.item = sample;
    const auto place = static_cast<std::size_t>(sample);
    if (place >= answer.pixels.size() || sample >= question.count) {
        check.first = fmt::format("{}: {:.0f} samples came back.", line, answer.size);
        return;
    }
    const LineSample ours = samples_by(right_line_rules().front(), to_line_end(question.a),
                                       to_line_end(question.b), question.count)[place];
    PixelValues& right = check.difference.ours;
    right.fields = rasterwalk_kit::field_xy;
    right.x = asked.is_real ? double{ours.x} : ours.fragment.column;
    right.y = asked.is_real ? double{ours.y} : ours.fragment.row;
    check.difference.theirs = answer.pixels[place];
    check.first = fmt::format("{}: sample {} is {} where {} is right.", line, sample,
                              pixel_text(answer.pixels[place].x, answer.pixels[place].y),
                              pixel_text(right.x, right.y));
}

/// Is a number what a division by zero leaves, as a float or converted to int?
bool is_from_zero_division(double number) {
    return !std::isfinite(number) || std::abs(number) >= 2147483647.0;
}

/// Only lines of one sample are wrong, and by a division by zero.
bool divides_by_zero(const AskedLines& asked) {
    bool found = false;
    for (int i = 0; i < asked.count(); ++i) {
        const auto index = static_cast<std::size_t>(i);
        if (asked.questions[index].count != 1) continue;
        for (const PixelValues& values : asked.answers[index].pixels) {
            const double numbers[] = {values.x,        values.y,        values.zinv,
                                      values.place[0], values.place[1], values.place[2],
                                      values.light[0], values.light[1], values.light[2]};
            found =
                found || std::any_of(std::begin(numbers), std::end(numbers), is_from_zero_division);
        }
    }
    return found;
}

/// Are all samples at the origin, as a function that does nothing leaves them?
bool does_nothing(const AskedLines& asked) {
    for (const PixelList& answer : asked.answers) {
        for (const PixelValues& values : answer.pixels) {
            if (values.x != 0.0 || values.y != 0.0 || values.zinv != 0.0) return false;
        }
    }
    return true;
}

/// The lines whose samples are where a rule has them.
RightQuestions explained_by(const LineRule& rule, const AskedLines& asked) {
    RightQuestions explained;
    for (int i = 0; i < asked.count(); ++i)
        explained.push_back(!can_walk(rule, asked, i) || first_other_sample(rule, asked, i) < 0);
    return explained;
}

/// A number of samples that Interpolate finds itself, whatever the size of the vector it is given.
struct OwnCount {
    int (*count)(const LineQuestion&);
    std::string_view bug; ///< empty: it is right
};

int count_of_rows(const LineQuestion& question) {
    return edge_sample_count_by_rows(to_screen_vertex(question.a), to_screen_vertex(question.b));
}
int shifted_count(const LineQuestion& question) {
    return edge_sample_count_shifted(to_screen_vertex(question.a), to_screen_vertex(question.b));
}

constexpr OwnCount own_counts[] = {
    {full_count, {}},
    {count_of_rows, "B5"},
    {shifted_count, "B12"},
};

bool has_size(const PixelList& answer, int count) {
    return answer.size == static_cast<double>(count);
}

bool has_sizes_asked(const std::vector<LineQuestion>& questions,
                     const std::vector<PixelList>& answers) {
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (!has_size(answers[i], questions[i].count)) return false;
    }
    return true;
}

/// The same questions, each with the count of its answer if that is the function's own.
std::vector<LineQuestion> counted_by(const OwnCount& own, std::vector<LineQuestion> questions,
                                     const std::vector<PixelList>& answers) {
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const int count = own.count(questions[i]);
        if (has_size(answers[i], count)) questions[i].count = count;
    }
    return questions;
}

/// Do all answers have this count, and is it a mistake with samples that are right under it?
bool explains_counts(const OwnCount& own, const AskedLines& asked) {
    const std::vector<LineQuestion> counted = counted_by(own, asked.questions, asked.answers);
    if (own.bug.empty() || !has_sizes_asked(counted, asked.answers)) return false;
    const AskedLines lines{counted, asked.answers, asked.is_real};
    const std::vector<LineRule>& rules = right_line_rules();
    return std::any_of(rules.begin(), rules.end(), [&](const LineRule& rule) {
        // Such a rule says nothing about lines of another count.
        return !rule.needs_full_count && explains_all_lines(rule, lines);
    });
}

/// Names a count that is wrong. False: none explains the answers.
bool name_wrong_count(const AskedLines& asked, FunctionCheck& check) {
    for (const OwnCount& own : own_counts) {
        if (explains_counts(own, asked)) add_once(own.bug, check.bugs);
    }
    if (check.bugs.empty()) return false;
    set_wrong(check);
    int first = -1;
    for (int i = 0; i < asked.count(); ++i) {
        const LineQuestion& question = asked.questions[static_cast<std::size_t>(i)];
        const PixelList& answer = asked.answers[static_cast<std::size_t>(i)];
        if (has_size(answer, question.count) || has_size(answer, full_count(question))) {
            ++check.right;
        } else if (first < 0) {
            first = i;
        }
    }
    const auto at = static_cast<std::size_t>(first);
    say_first(check, asked, first,
              std::min(asked.questions[at].count, static_cast<int>(asked.answers[at].size)));
    return true;
}

/// Takes the rule that explains all lines, or the mistakes that do.
/// @returns the lines whose samples are right
RightQuestions explain_positions(const AskedLines& asked, FunctionCheck& check) {
    const RightQuestions all(static_cast<std::size_t>(asked.count()), true);
    for (const LineRule& rule : right_line_rules()) {
        if (!explains_all_lines(rule, asked)) continue;
        check.rule = rule.words;
        check.rules = rule.settings;
        if (&rule == &right_line_rules().front())
            check.rule += ": the handout's own rule, which loses the end of some lines (B1)";
        if (asked.is_real) check.rule = "positions keep their fractions";
        return all;
    }
    const LineRule* closest = &right_line_rules().front();
    RightQuestions most = explained_by(*closest, asked);
    for (const LineRule& rule : right_line_rules()) {
        RightQuestions explained = explained_by(rule, asked);
        if (count_right(explained) <= count_right(most)) continue;
        most = std::move(explained);
        closest = &rule;
    }
    check.rules = closest->settings;
    for (const LineRule& rule : mistaken_line_rules()) {
        if (!explains_all_lines(rule, asked)) continue;
        if (!rule.bug.empty()) add_once(rule.bug, check.bugs);
        if (!rule.cause.empty()) add_once(rule.cause, check.causes);
        check.rules = rule.settings;
    }
    const bool is_named = !check.bugs.empty() || !check.causes.empty();
    int on_line = 0, samples = 0, far_question = -1, far_sample = -1;
    for (int i = 0; i < asked.count(); ++i) {
        const int sample = first_far_sample(asked, i, on_line, samples);
        if (sample >= 0 && far_question < 0) far_question = i, far_sample = sample;
    }
    // A line that lags, or falls short, is within a pixel too, but misses its own columns.
    const bool is_within_rounding = far_question < 0 && on_line * 10 >= samples * 8;
    if (!is_named && is_within_rounding) {
        check.rule = fmt::format("within the rounding of a pixel everywhere; {} of {} lines as if "
                                 "{}",
                                 count_right(most), asked.count(), closest->words);
        return all;
    }
    set_wrong(check);
    if (far_question < 0 || is_named) {
        for (int i = 0; i < asked.count(); ++i) {
            far_sample = first_other_sample(*closest, asked, i);
            far_question = i;
            if (can_walk(*closest, asked, i) && far_sample >= 0) break;
        }
    }
    say_first(check, asked, far_question, far_sample);
    return most;
}

} // namespace

FunctionCheck check_interpolate(const Questions& questions, const Answers& answers) {
    FunctionCheck check =
        begin_check("Interpolate", rasterwalk_kit::part_interpolate, questions, answers.lines);
    if (!has_answers(check)) return check;
    std::vector<PixelList> answered = answers.lines.answers;
    // To find the number of samples from the ends is as right as to take the size of the vector.
    std::vector<LineQuestion> lines = counted_by(own_counts[0], questions.lines, answered);
    const bool counts_itself = !has_sizes_asked(questions.lines, answered);
    const bool has_right_count = has_sizes_asked(lines, answered);
    if (!has_right_count) lines = questions.lines;
    AskedLines asked{lines, answered, false};
    if (check.state == CheckState::died) {
        const auto dead = static_cast<std::size_t>(asked.count());
        const bool is_point = dead < questions.lines.size() && questions.lines[dead].count == 1;
        check.first = fmt::format("The program ended at line {} of {}{}.", dead, check.asked,
                                  is_point ? ", whose ends are the same pixel" : "");
        if (is_point) check.causes.emplace_back("A line of one sample is divided by N - 1 = 0.");
    }
    if (answered.empty()) return check;
    if (does_nothing(asked)) {
        if (check.state == CheckState::right) check.state = CheckState::not_written;
        return check;
    }
    asked.is_real = has_fractions(asked);
    const bool zero = divides_by_zero(asked);
    if (zero) {
        // What a point gives says nothing about the lines.
        while (!answered.empty() && lines[answered.size() - 1].count == 1)
            answered.pop_back();
    }
    if (!has_right_count && name_wrong_count(asked, check)) return check;
    RightQuestions right = explain_positions(asked, check);
    const bool is_explained = check.bugs.empty() && check.causes.empty();
    if (is_explained && (check.state == CheckState::right || check.state == CheckState::died)) {
        check_carried_values(asked, right, check);
    }
    check.right = count_right(right);
    if (counts_itself && has_right_count && !check.rule.empty())
        check.rule += "; it counts the samples itself";
    if (zero) {
        set_wrong(check);
        check.causes.emplace_back("A line of one sample is divided by N - 1 = 0.");
        if (check.first.empty()) {
            check.first = "A line whose ends are the same pixel gives numbers that are not finite, "
                          "or what an int is made from them.";
        }
        check.difference.question = std::max(check.difference.question, asked.count());
    }
    return check;
}

} // namespace rasterwalk
