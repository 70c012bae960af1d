#include "lessons/lesson_run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "base/text_parts.h"
#include "session/content.h"

namespace rasterwalk {

namespace {

using PredictionKind = LessonPrediction::Kind;

/// The word before the place of a pixel in an answer.
constexpr std::string_view pixel_word = "pixel ";

std::string pixel_text(const glm::ivec2& pixel) {
    return fmt::format("({}, {})", pixel.x, pixel.y);
}

/// NaN if there is no number.
double value_of(const Expression& expression, const FactReader& fact) {
    return number_of(expression, fact).value_or(std::nan(""));
}

bool is_within(double given, double number, double tolerance) {
    // What was typed and what was computed may differ in the last bits.
    const double slack = std::abs(tolerance) + 1e-6 * std::max(1.0, std::abs(number));
    return std::abs(given - number) <= slack;
}

void judge_number(const LessonPrediction& prediction, const Facts& facts, double given,
                  Judgement& result) {
    const FactReader reader = std::cref(facts);
    const double number = prediction.answer ? value_of(*prediction.answer, reader) : std::nan("");
    const double tolerance = prediction.tolerance ? value_of(*prediction.tolerance, reader) : 0.0;
    if (std::isnan(number) || std::isnan(tolerance)) {
        result.fault = "The program has no answer here because something that it needs is missing.";
        return;
    }
    result.number = number;
    result.is_right = is_within(given, number, tolerance);
    result.answer = answer_text(number);
    if (!prediction.unit.empty()) {
        const std::string unit = unit_for(result.answer, prediction.unit);
        result.answer.append(" ").append(unit);
    }
}

void judge_choice(const LessonPrediction& prediction, const Facts& facts, int given,
                  Judgement& result) {
    const FactReader reader = std::cref(facts);
    for (std::size_t i = 0; i < prediction.right.size(); ++i) {
        if (!holds(prediction.right[i], reader)) continue;
        if (result.choice >= 0) {
            result.fault = "More than one of the choices is right.";
            return;
        }
        result.choice = static_cast<int>(i);
    }
    if (result.choice < 0 || prediction.choices.size() != prediction.right.size()) {
        result.fault = "None of the choices is right.";
        return;
    }
    result.is_right = given == result.choice;
    result.answer = prediction.choices[static_cast<std::size_t>(result.choice)];
}

/// Does the misconception lead to this answer?
bool gives(const Misconception& one, const LessonPrediction& prediction, const GivenAnswer& given,
           const FactReader& fact) {
    if (const int* const choice = std::get_if<int>(&given.value)) return *choice == one.choice;
    if (!one.answer) return false;
    const double* const number = std::get_if<double>(&given.value);
    if (number == nullptr) return holds(*one.answer, fact);
    const std::optional<Expression>& own = one.tolerance ? one.tolerance : prediction.tolerance;
    const double tolerance = own ? value_of(*own, fact) : 0.0;
    return is_within(*number, value_of(*one.answer, fact), tolerance);
}

/// The text with all numbers filled in. If it begins with a number and a full stop, it stays a
/// sentence, instead of becoming a list item in Markdown.
std::string filled(std::string_view text, std::string_view answer, std::optional<double> number,
                   const FactReader& fact) {
    std::string result = fill_in(text, answer, number, fact);
    const std::size_t end = result.find_first_not_of("0123456789");
    if (end != 0 && end != result.npos && (result[end] == '.' || result[end] == ')'))
        result.insert(end, "\\");
    return result;
}

} // namespace

bool is_in_lessons_folder(const Lesson& lesson) {
    std::error_code fault;
    const std::string folder = lesson.folder.empty() ? "." : lesson.folder;
    return std::filesystem::equivalent(folder, lessons_folder(), fault) && !fault;
}

std::vector<Fault> open_step(Session& session, const Lesson& lesson, int step) {
    const int last = static_cast<int>(lesson.steps.size()) - 1;
    // A different step leaves the student's own tab; the same step again does not.
    const bool keeps_tab = session.tab_guide.is_own && session.lesson == lesson.id &&
                           session.step != std::clamp(step, 0, last);
    const std::string own_tab(tab_below(session));
    session.lesson = lesson.id;
    session.lesson_folder = is_in_lessons_folder(lesson) ? "" : lesson.folder;
    session.step = std::clamp(step, 0, last);
    const LessonStep& shown = lesson.steps[static_cast<std::size_t>(session.step)];
    std::vector<Fault> faults = show_state(session, shown.state, lesson.folder);
    if (keeps_tab) keep_own_tab(session, own_tab);
    return faults;
}

bool is_done(const LessonTask& task, const Facts& facts) {
    return task.done && holds(*task.done, std::cref(facts));
}

std::string reason_of(const LessonTask& task, const Facts& facts) {
    return filled(task.because, "", std::nullopt, std::cref(facts));
}

std::string not_yet(const LessonTask& task, const Facts& facts) {
    const FactReader reader = std::cref(facts);
    for (const NotYet& one : task.not_yet) {
        if (holds(one.when, reader)) return filled(one.says, "", std::nullopt, reader);
    }
    return {};
}

std::vector<Fault> LessonTrial::open(const ViewState& state, const std::string& folder,
                                     const Session& like) {
    const std::shared_ptr<const Scene> before = session.scene;
    session = Session{};
    session.presets = like.presets;
    session.glossary = like.glossary;
    std::vector<Fault> faults = show_state(session, state, folder);
    if (session.scene == nullptr) return faults;
    // The same file read again is the same scene.
    if (before != nullptr && *before == *session.scene) session.scene = before;
    finish(session, results);
    return faults;
}

Judgement judge(const Lesson& lesson, const LessonPrediction& prediction, const GivenAnswer& answer,
                const Session& session) {
    LessonTrial trial;
    return judge(lesson, prediction, answer, session, trial);
}

Judgement judge(const Lesson& lesson, const LessonPrediction& prediction, const GivenAnswer& answer,
                const Session& session, LessonTrial& trial) {
    Judgement result;
    ViewState at = prediction.at;
    if (const auto* pixel = std::get_if<glm::ivec2>(&answer.value)) at.pixel = *pixel;
    const std::vector<Fault> faults = trial.open(at, lesson.folder, session);
    if (!faults.empty()) {
        result.fault = faults.front().sentence;
        return result;
    }
    const Facts facts = trial.facts();
    const FactReader reader = std::cref(facts);
    const double* const number = std::get_if<double>(&answer.value);
    const int* const choice = std::get_if<int>(&answer.value);
    switch (prediction.kind) {
    case PredictionKind::number:
        judge_number(prediction, facts, number != nullptr ? *number : std::nan(""), result);
        break;
    case PredictionKind::choice:
        judge_choice(prediction, facts, choice != nullptr ? *choice : -1, result);
        break;
    case PredictionKind::pixel:
        result.is_right = prediction.where && holds(*prediction.where, reader);
        if (prediction.right_pixel) result.answer = pixel_text(*prediction.right_pixel);
        break;
    }
    try {
        const bool is_number = prediction.kind == PredictionKind::number && result.fault.empty();
        const auto own = is_number ? std::optional(result.number) : std::nullopt;
        result.because = filled(prediction.because, result.answer, own, reader);
        if (result.is_right) return result;
        for (const Misconception& one : prediction.misconceptions) {
            if (!gives(one, prediction, answer, reader)) continue;
            result.says = filled(one.says, result.answer, own, reader);
            break;
        }
    } catch (const Error& fault) {
        if (result.fault.empty()) result.fault = fault.what();
    }
    return result;
}

std::string answer_words(const LessonPrediction& prediction, const GivenAnswer& answer,
                         std::string_view typed) {
    if (const auto* pixel = std::get_if<glm::ivec2>(&answer.value)) {
        return std::string(pixel_word).append(pixel_text(*pixel));
    }
    if (const int* const choice = std::get_if<int>(&answer.value)) {
        return prediction.choices[static_cast<std::size_t>(*choice)];
    }
    const std::string number = with_minus_signs(typed);
    return prediction.unit.empty() ? number
                                   : fmt::format("{} {}", number, unit_for(typed, prediction.unit));
}

std::optional<GivenAnswer> answer_in_words(const LessonPrediction& prediction,
                                           std::string_view said) {
    switch (prediction.kind) {
    case PredictionKind::choice: {
        const auto& choices = prediction.choices;
        const auto found = std::find(choices.begin(), choices.end(), said);
        if (found == choices.end()) return std::nullopt;
        return GivenAnswer{static_cast<int>(found - choices.begin())};
    }
    case PredictionKind::number: {
        for (const std::string& unit : {prediction.unit, unit_for("1", prediction.unit)}) {
            if (unit.empty() || !said.ends_with(unit)) continue;
            said.remove_suffix(unit.size());
            break;
        }
        const std::optional<double> number = read_answer(said);
        return number ? std::optional(GivenAnswer{*number}) : std::nullopt;
    }
    case PredictionKind::pixel: {
        if (!said.starts_with(pixel_word)) return std::nullopt;
        said.remove_prefix(pixel_word.size());
        if (said.size() < 2 || said.front() != '(' || said.back() != ')') return std::nullopt;
        std::string place(said.substr(1, said.size() - 2));
        std::erase(place, ' ');
        const std::optional<glm::ivec2> pixel = parse_pixel(place);
        return pixel ? std::optional(GivenAnswer{*pixel}) : std::nullopt;
    }
    }
    return std::nullopt;
}

std::optional<double> read_answer(std::string_view text) {
    std::string written(trimmed(text));
    if (const auto comma = written.find(','); comma != written.npos) written[comma] = '.';
    // Typographic minus signs, as in the lessons.
    for (const std::string_view minus : {"\xe2\x88\x92", "\xe2\x80\x93"}) {
        for (std::size_t at = 0; (at = written.find(minus, at)) != written.npos; ++at)
            written.replace(at, minus.size(), "-");
    }
    try {
        const Expression expression = parse_expression(written);
        if (!expression.is_constant()) return std::nullopt;
        return number_of(expression, [](std::string_view) { return Value(); });
    } catch (const Error&) {
        return std::nullopt;
    }
}

std::string answer_text(double number, int digits) {
    if (digits >= 0) return with_minus_signs(decimals(number, std::min(digits, 12)));
    const double size = std::abs(number);
    const bool is_whole = number == std::floor(number) && size < 1e15;
    if (is_whole) return with_minus_signs(decimals(number + 0.0, 0));
    // Five significant figures, with at most four zeros in front of them.
    const int before = size >= 1.0 ? static_cast<int>(std::floor(std::log10(size))) + 1
                                   : -static_cast<int>(std::floor(-std::log10(size)));
    if (size >= 1e15 || before < -4) return with_minus_signs(scientific(number, 4));
    const std::string text = decimals_without_zeros(number, std::clamp(5 - before, 0, 12));
    return text == "-0" ? "0" : with_minus_signs(text);
}

bool needs_numbers(std::string_view text) {
    bool asks = false;
    fill_in(text, "", std::nullopt, [&](std::string_view) {
        asks = true;
        return Value();
    });
    return asks;
}

std::string fill_in(std::string_view text, std::string_view answer, std::optional<double> number,
                    const FactReader& fact) {
    std::string result;
    while (true) {
        const std::size_t begin = std::min(text.find_first_of("{`$"), text.size());
        result += text.substr(0, begin);
        text.remove_prefix(begin);
        if (text.empty()) return result;
        // Code and formulas have their own braces.
        if (text[0] != '{') {
            const std::size_t end = text.find(text[0], 1);
            const std::size_t length = end == text.npos ? 1 : end + 1;
            result += text.substr(0, length);
            text.remove_prefix(length);
            continue;
        }
        const std::size_t end = text.find('}');
        if (end == text.npos) throw UsageError("a '}' is missing after " + in_quotes(text) + ".");
        std::string_view inner = text.substr(1, end - 1);
        text.remove_prefix(end + 1);
        int digits = -1;
        if (const std::size_t colon = inner.find(':'); colon != inner.npos) {
            const std::string_view after = trimmed(inner.substr(colon + 1));
            if (after.size() != 1 || after[0] < '0' || after[0] > '9') {
                throw UsageError(fmt::format(
                    "the part after the colon in {} must be the number of digits, 0 to 9.",
                    in_quotes(inner)));
            }
            digits = after[0] - '0';
            inner = inner.substr(0, colon);
        }
        if (trimmed(inner) == "answer") {
            result += number ? answer_text(*number, digits) : std::string(answer);
            continue;
        }
        const std::optional<double> value = number_of(parse_expression(inner), fact);
        result += value ? answer_text(*value, digits) : "\xe2\x80\x93";
    }
}

} // namespace rasterwalk
