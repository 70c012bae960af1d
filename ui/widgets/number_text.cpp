#include "ui/widgets/number_text.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace rasterwalk {

std::string printed(const char* format, double value) {
    char buffer[48];
    std::snprintf(buffer, sizeof buffer, format, value);
    std::string text;
    for (const char* c = buffer; *c != '\0'; ++c)
        text += *c == '-' ? std::string("−") : std::string(1, *c);
    return text;
}

std::string nine_digits(float value) {
    return printed("%.9g", static_cast<double>(value));
}

std::string float_text(float value) {
    const bool is_leftover = value != 0.0f && std::abs(value) < 1e-4f;
    return is_leftover ? printed("%.2e", static_cast<double>(value)) : nine_digits(value);
}

std::string drift_text(double drift) {
    return drift == 0.0 ? "0" : printed("%.2e", drift);
}

std::string whole_text(std::int64_t value) {
    return (value < 0 ? "−" : "") + std::to_string(std::abs(value));
}

std::string mixed_text(const Fraction& f) {
    if (f.denominator == 1) return whole_text(f.numerator);
    const std::int64_t size = std::abs(f.numerator);
    std::string text = f.numerator < 0 ? "−" : "";
    if (size >= f.denominator) text.append(std::to_string(size / f.denominator)).append(" ");
    return text + to_text(Fraction{size % f.denominator, f.denominator});
}

std::string fraction_text(const Fraction& f) {
    const std::string sign = f.numerator < 0 ? "−" : "";
    return sign + to_text(Fraction{std::abs(f.numerator), f.denominator});
}

} // namespace rasterwalk
