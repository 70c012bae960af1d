#include "lessons/puzzle_judge.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/numbers.h"
#include "code/code_machine.h"

namespace rasterwalk {

namespace {

/// Lines that a function may begin for one question: many more than any right one needs.
constexpr std::int64_t most_begun_lines = 20'000;

/// Words of memory that its vectors may have: more than an endless loop adds in so many lines.
/// Clearing them takes time as well.
constexpr std::int64_t most_vector_words = 3 * most_begun_lines;

constexpr std::string_view puzzle_file = "code";

int line_count(std::string_view text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

/// A line that is indented under one that begins nothing, or by too much.
std::optional<PuzzleVerdict> wrong_indent(const std::vector<PuzzleLine>& lines) {
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].depth <= depth_after(lines[i - 1])) continue;
        const bool begins = begins_block(lines[i - 1].text);
        return PuzzleVerdict{false,
                             begins ? "This line is indented too far."
                                    : "This line is indented, but the line above it begins no "
                                      "loop and no condition.",
                             static_cast<int>(i) + 1};
    }
    return std::nullopt;
}

/// A function in the machine, ready to be asked.
class Examinee {
  public:
    /// Throws InputError if the function is not understood.
    Examinee(const PuzzleExam& exam, const std::vector<PuzzleLine>& lines)
        : lines_before_(line_count(exam.before)), lines_(static_cast<int>(lines.size())),
          machine_(std::make_shared<const CodeProgram>(
              compile_code(std::string(exam.before) + source_of(lines) + std::string(exam.after),
                           std::string(puzzle_file)))),
          has_begun_(begin()) {}

    /// The answer; empty and a verdict if there is none.
    std::vector<float> ask(const PuzzleQuestion& question, PuzzleVerdict& verdict) {
        if (!has_begun_) {
            verdict.sentence = "The variables before the functions cannot get their values. " +
                               machine_.fault().sentence;
            return {};
        }
        machine_.resize_list("given", question.given.size());
        const std::span<std::uint32_t> given = machine_.list("given");
        for (std::size_t i = 0; i < question.given.size(); ++i)
            given[i] = std::bit_cast<std::uint32_t>(question.given[i]);
        machine_.resize_list("answer", 0);
        machine_.allow(machine_.lines() + most_begun_lines);
        machine_.call(machine_.program().find_function("Ask"));
        const CodeEnd end = machine_.run();
        if (end == CodeEnd::too_long) {
            verdict.line = line_reached();
            verdict.sentence = "The loop around this line never ends.";
            return {};
        }
        if (end != CodeEnd::done) {
            verdict.line = own_line(machine_.fault().line);
            verdict.sentence = question.words + ": " + machine_.fault().sentence;
            return {};
        }
        std::vector<float> answer;
        for (const std::uint32_t word : machine_.list("answer"))
            answer.push_back(std::bit_cast<float>(word));
        return answer;
    }

  private:
    bool begin() {
        machine_.allow_words(most_vector_words);
        return machine_.begin() == CodeEnd::done;
    }

    /// A line of the source as a line of the function; 0 if it is outside of it.
    int own_line(int line) const {
        const int own = line - lines_before_;
        return own >= 1 && own <= lines_ ? own : 0;
    }

    /// The line of the function that is being carried out, or that calls another one.
    int line_reached() const {
        int line = 0;
        for (const CodeCall& call : machine_.calls())
            line = std::max(line, own_line(call.line));
        return line;
    }

    int lines_before_;
    int lines_;
    CodeMachine machine_;
    bool has_begun_; ///< the global variables have their values
};

/// "code:12: sentence." in its parts.
PuzzleVerdict verdict_of_fault(const PuzzleExam& exam, const std::vector<PuzzleLine>& lines,
                               std::string_view what) {
    PuzzleVerdict verdict;
    verdict.sentence = what;
    const std::size_t begin = puzzle_file.size() + 1, end = what.find(": ");
    if (!what.starts_with(puzzle_file) || end == what.npos || end < begin) return verdict;
    int line = 0;
    std::from_chars(what.data() + begin, what.data() + end, line);
    const int own = line - line_count(exam.before);
    if (own >= 1 && own <= static_cast<int>(lines.size())) verdict.line = own;
    verdict.sentence = what.substr(end + 2);
    return verdict;
}

std::string answer_number(float value) {
    if (value >= 2147483520.0f) return "INT_MAX";
    if (value <= -2147483520.0f) return "-INT_MAX";
    return significant(value, 5);
}

std::string name_of_answer(const PuzzleExam& exam, std::size_t place) {
    std::string name(exam.names[place % exam.names.size()]);
    const std::size_t mark = name.find('#');
    if (mark == name.npos) return name;
    const std::size_t round = place / exam.names.size();
    const std::string words =
        exam.columns == 0 ? std::to_string(round)
                          : fmt::format("({}, {})", round % exam.columns, round / exam.columns);
    return name.replace(mark, 1, words);
}

/// Floats that were added up in a different order are equal, too.
bool is_same(float a, float b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return a == b || std::abs(a - b) <= 1e-5f * std::max(std::abs(b), 1.0f);
}

/// What is wrong with the answer; empty: nothing.
std::string difference(const PuzzleExam& exam, const std::vector<float>& answer,
                       const std::vector<float>& right) {
    const std::size_t common = std::min(answer.size(), right.size());
    for (std::size_t i = 0; i < common; ++i) {
        if (is_same(answer[i], right[i])) continue;
        return fmt::format("{} is {} and should be {}.", name_of_answer(exam, i),
                           answer_number(answer[i]), answer_number(right[i]));
    }
    if (answer.size() > right.size())
        return fmt::format("{} is one too many.", name_of_answer(exam, common));
    if (answer.size() < right.size())
        return fmt::format("{} is missing.", name_of_answer(exam, common));
    return {};
}

} // namespace

PuzzleVerdict judge_function(const PuzzleExam& exam, const std::vector<PuzzleLine>& lines,
                             const std::vector<PuzzleLine>& right) {
    if (const std::optional<PuzzleVerdict> verdict = wrong_indent(lines)) return *verdict;
    try {
        Examinee examinee(exam, lines), model(exam, right);
        PuzzleVerdict verdict;
        for (const PuzzleQuestion& question : exam.questions) {
            const std::vector<float> answer = examinee.ask(question, verdict);
            if (!verdict.sentence.empty()) return verdict;
            PuzzleVerdict none;
            const std::string wrong = difference(exam, answer, model.ask(question, none));
            if (wrong.empty()) continue;
            verdict.sentence = question.words + ": " + wrong;
            return verdict;
        }
        verdict.is_right = true;
        return verdict;
    } catch (const InputError& fault) {
        return verdict_of_fault(exam, lines, fault.what());
    }
}

PuzzleVerdict judge_order(const LessonPuzzle& puzzle, const std::vector<PlacedPiece>& placed) {
    return judge_function(*find_exam(puzzle.exam), function_of(puzzle, placed), puzzle.lines);
}

} // namespace rasterwalk
