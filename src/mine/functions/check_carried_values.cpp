#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "mine/functions/asked_lines.h"
#include "mine/functions/check_parts.h"

namespace rasterwalk {

namespace {

using rasterwalk_kit::PixelValues;

/// How a value that a line carries is found from its two ends.
struct ValueRule {
    std::string_view words; ///< for rules that are right
    std::string_view cause; ///< for those that are not
    std::string_view bug;
    /// @param t      share of the way
    /// @param za, zb 1/z at the ends
    double (*value)(double a, double b, double t, double za, double zb);
};

double linear(double a, double b, double t, double, double) {
    return a + t * (b - a);
}
double with_perspective(double a, double b, double t, double za, double zb) {
    return linear(a * za, b * zb, t, za, zb) / linear(za, zb, t, za, zb);
}
double multiplied(double a, double b, double t, double za, double zb) {
    return linear(a * za, b * zb, t, za, zb);
}
double divided(double a, double b, double t, double za, double zb) {
    return linear(a, b, t, za, zb) / linear(za, zb, t, za, zb);
}
double from_start(double a, double, double, double, double) {
    return a;
}
double from_end(double, double b, double, double, double) {
    return b;
}
double never(double, double, double, double, double) {
    return 0.0;
}
double through_z(double a, double b, double t, double, double) {
    return 1.0 / linear(1.0 / a, 1.0 / b, t, 0.0, 0.0);
}

constexpr ValueRule zinv_rules[] = {
    {"in equal steps", {}, {}, linear},
    {{}, "1/z stays as it is at the first end.", {}, from_start},
    {{}, "1/z is that of the last end everywhere.", {}, from_end},
    {{}, "1/z is never set.", {}, never},
    {{}, "z is interpolated in equal steps, and 1/z is taken from it.", {}, through_z},
};
constexpr ValueRule carried_rules[] = {
    {"in equal steps, as it is carried", {}, {}, linear},
    {"with perspective: times 1/z, in equal steps, divided by 1/z", {}, {}, with_perspective},
    {{}, "{} is multiplied by 1/z in Interpolate and not divided by it again.", {}, multiplied},
    {{}, "{} is divided by 1/z in Interpolate without being multiplied by it first.", {}, divided},
    {{}, "{} is not interpolated: it stays as it is at the first end.", {}, from_start},
    {{}, "{} is that of the last end everywhere.", {}, from_end},
    {{}, "{} is never set by Interpolate.", {}, never},
};

/// A number that pixels carry.
struct CarriedNumber {
    std::string_view name;
    rasterwalk_kit::PixelField field;
    double (*read)(const PixelValues&);
};

constexpr CarriedNumber zinv_number{"1/z", rasterwalk_kit::field_zinv,
                                    [](const PixelValues& p) { return p.zinv; }};
constexpr std::array place_numbers{
    CarriedNumber{"the position", rasterwalk_kit::field_place,
                  [](const PixelValues& p) { return p.place[0]; }},
    CarriedNumber{"the position", rasterwalk_kit::field_place,
                  [](const PixelValues& p) { return p.place[1]; }},
    CarriedNumber{"the position", rasterwalk_kit::field_place,
                  [](const PixelValues& p) { return p.place[2]; }},
};
constexpr std::array light_numbers{
    CarriedNumber{"the light", rasterwalk_kit::field_light,
                  [](const PixelValues& p) { return p.light[0]; }},
    CarriedNumber{"the light", rasterwalk_kit::field_light,
                  [](const PixelValues& p) { return p.light[1]; }},
    CarriedNumber{"the light", rasterwalk_kit::field_light,
                  [](const PixelValues& p) { return p.light[2]; }},
};

struct PlaceOfSample {
    int question = -1, sample = -1;
};

/// The sample of a line where a rule for a value fails first; -1: nowhere.
int first_other_value(const ValueRule& rule, const CarriedNumber& number, const AskedLines& asked,
                      int index) {
    const LineQuestion& question = asked.questions[static_cast<std::size_t>(index)];
    const std::vector<PixelValues>& theirs = asked.answers[static_cast<std::size_t>(index)].pixels;
    const double a = number.read(question.a), b = number.read(question.b);
    // Perspective multiplies and divides by 1/z, which lies between those of the ends.
    const double spread =
        std::max(question.a.zinv, question.b.zinv) / std::min(question.a.zinv, question.b.zinv);
    const double tolerance =
        value_tolerance(std::max({std::abs(a), std::abs(b), 1e-3}), question.count) * spread *
        (rule.value == divided ? 1.0 / std::min(question.a.zinv, question.b.zinv) : 1.0);
    const double steps = std::max(question.count - 1, 1);
    const std::size_t count = std::min(theirs.size(), static_cast<std::size_t>(question.count));
    for (std::size_t i = 0; i < count; ++i) {
        const double ours =
            rule.value(a, b, static_cast<double>(i) / steps, question.a.zinv, question.b.zinv);
        if (!is_close(number.read(theirs[i]), ours, tolerance)) return static_cast<int>(i);
    }
    return -1;
}

/// Where a rule for a value fails first; question -1: nowhere.
PlaceOfSample first_other_value(const ValueRule& rule, const CarriedNumber& number,
                                const AskedLines& asked) {
    for (int q = 0; q < asked.count(); ++q) {
        const int sample = first_other_value(rule, number, asked, q);
        if (sample >= 0) return {q, sample};
    }
    return {};
}

/// The lines on which a rule is right for all of these numbers.
RightQuestions carried_by(const ValueRule& rule, std::span<const CarriedNumber> numbers,
                          const AskedLines& asked) {
    RightQuestions carried;
    for (int q = 0; q < asked.count(); ++q) {
        carried.push_back(std::all_of(numbers.begin(), numbers.end(), [&](const auto& number) {
            return first_other_value(rule, number, asked, q) < 0;
        }));
    }
    return carried;
}

/// Checks what a line carries. The rule that is right for one number must be so for all.
/// @param right loses the lines on which a value is wrong
void check_carried(std::span<const CarriedNumber> numbers, std::span<const ValueRule> rules,
                   const AskedLines& asked, RightQuestions& right, FunctionCheck& check) {
    for (const PixelList& answer : asked.answers) {
        for (const PixelValues& values : answer.pixels) {
            if (!has_field(values, numbers[0].field)) return;
        }
    }
    PlaceOfSample first;
    std::size_t which = 0;
    for (const ValueRule& rule : rules) {
        PlaceOfSample other;
        std::size_t n = 0;
        for (; n < numbers.size() && other.question < 0; ++n)
            other = first_other_value(rule, numbers[n], asked);
        if (other.question < 0 && rule.cause.empty()) {
            check.rule += fmt::format("; {} {}", numbers[0].name, rule.words);
            return;
        }
        if (&rule == &rules.front()) first = other, which = n - 1;
        if (other.question >= 0) continue;
        std::string cause(rule.cause);
        const auto gap = cause.find("{}");
        if (gap != cause.npos) cause.replace(gap, 2, numbers[0].name);
        if (!cause.empty() && cause[0] == 't') cause[0] = 'T';
        add_once(cause, check.causes);
        break;
    }
    set_wrong(check);
    RightQuestions closest;
    for (const ValueRule& rule : rules) {
        if (!rule.cause.empty()) continue;
        RightQuestions carried = carried_by(rule, numbers, asked);
        if (closest.empty() || count_right(carried) > count_right(closest))
            closest = std::move(carried);
    }
    right = right_in_both(std::move(right), closest);
    if (!check.first.empty()) return;
    const auto q = static_cast<std::size_t>(first.question);
    const auto s = static_cast<std::size_t>(first.sample);
    const LineQuestion& question = asked.questions[q];
    const double t = static_cast<double>(first.sample) / std::max(question.count - 1, 1);
    const double a = numbers[which].read(question.a), b = numbers[which].read(question.b);
    check.difference.question = first.question;
    check.difference.item = first.sample;
    check.difference.theirs = asked.answers[q].pixels[s];
    check.first = fmt::format(
        "Interpolate({}, {}) with {} samples: {} of sample {} is {:.6g} where {:.6g} is right.",
        pixel_text(question.a.x, question.a.y), pixel_text(question.b.x, question.b.y),
        question.count, numbers[0].name, first.sample, numbers[which].read(check.difference.theirs),
        linear(a, b, t, 0.0, 0.0));
}

} // namespace

void check_carried_values(const AskedLines& asked, RightQuestions& right, FunctionCheck& check) {
    check_carried(std::span(&zinv_number, 1), zinv_rules, asked, right, check);
    check_carried(place_numbers, carried_rules, asked, right, check);
    check_carried(light_numbers, carried_rules, asked, right, check);
}

} // namespace rasterwalk
