#include "ui/widgets/number_text.h"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "base/numbers.h"

namespace rasterwalk {

std::string nine_digits_shown(float value) {
    return with_minus_signs(nine_digits(value));
}

std::string float_text(float value) {
    const bool is_leftover = value != 0.0f && std::abs(value) < 1e-4f;
    const double wide = static_cast<double>(value);
    return with_minus_signs(is_leftover ? scientific(wide, 2) : nine_digits(value));
}

std::string drift_text(double drift) {
    return drift == 0.0 ? "0" : with_minus_signs(scientific(drift, 2));
}

std::string whole_text(std::int64_t value) {
    return with_minus_signs(fmt::format("{}", value));
}

std::string mixed_text(const Fraction& f) {
    if (f.denominator == 1) return whole_text(f.numerator);
    const std::int64_t size = std::abs(f.numerator);
    const char* const sign = f.numerator < 0 ? "−" : "";
    const std::string part = to_text(Fraction{size % f.denominator, f.denominator});
    if (size < f.denominator) return sign + part;
    return fmt::format("{}{} {}", sign, size / f.denominator, part);
}

std::string fraction_text(const Fraction& f) {
    const std::string sign = f.numerator < 0 ? "−" : "";
    return sign + to_text(Fraction{std::abs(f.numerator), f.denominator});
}

} // namespace rasterwalk
