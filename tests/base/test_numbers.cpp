#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include "base/numbers.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("The shortest text of a number is read as the same number") {
    CHECK(shortest(0.1f) == "0.1");
    CHECK(shortest(0.1) == "0.1");
    CHECK(shortest(static_cast<double>(0.1f)) == "0.10000000149011612");
    CHECK(shortest(-0.0f) == "-0");
    CHECK(shortest(100000.0f) == "1e+05");
    CHECK(shortest(std::numeric_limits<float>::infinity()) == "inf");
    std::mt19937 random(3);
    for (int i = 0; i < 10000; ++i) {
        const float value = std::ldexp(static_cast<float>(random()) - 2e9f, i % 100 - 70);
        CHECK(std::stof(shortest(value)) == value);
        CHECK(std::stof(number_text(value)) == value);
        CHECK(std::stof(nine_digits(value)) == value);
    }
}

TEST_CASE("Numbers that people read have the usual notation") {
    CHECK(number_text(0.0f) == "0");
    CHECK(number_text(100000.0f) == "100000");
    CHECK(number_text(9999999.0f) == "9999999");
    CHECK(number_text(1e7f) == "1e+07");
    CHECK(number_text(0.0001f) == "0.0001");
    CHECK(number_text(0.00005f) == "5e-05");
    CHECK(number_text(-2.5f) == "-2.5");
}

TEST_CASE("Digits are those of the C library, with ties rounded to even") {
    CHECK(significant(1.0 / 3.0, 6) == "0.333333");
    CHECK(significant(2.0, 6) == "2");
    CHECK(significant(1e-5, 6) == "1e-05");
    CHECK(nine_digits(0.1f) == "0.100000001");
    CHECK(decimals(0.125, 2) == "0.12");
    CHECK(decimals(-0.0, 1) == "-0.0");
    CHECK(decimals(1e22, 0) == "10000000000000000000000");
    CHECK(scientific(0.0000462, 2) == "4.62e-05");
    CHECK(decimals(std::numeric_limits<double>::quiet_NaN(), 3) == "nan");
    std::mt19937 random(4);
    for (int i = 0; i < 10000; ++i) {
        const double value = std::ldexp(static_cast<double>(random()) - 2e9, i % 90 - 60);
        const int digits = i % 10;
        char text[200];
        std::snprintf(text, sizeof text, "%.*g", digits + 1, value);
        CHECK(significant(value, digits + 1) == text);
        std::snprintf(text, sizeof text, "%.*f", digits, value);
        CHECK(decimals(value, digits) == text);
        std::snprintf(text, sizeof text, "%.*e", digits, value);
        CHECK(scientific(value, digits) == text);
    }
}

TEST_CASE("Zeros at the end are left out only after the point") {
    CHECK(decimals_without_zeros(0.25, 4) == "0.25");
    CHECK(decimals_without_zeros(-12.5, 1) == "-12.5");
    CHECK(decimals_without_zeros(3.0, 2) == "3");
    CHECK(decimals_without_zeros(2.999, 2) == "3");
    CHECK(decimals_without_zeros(1.05, 3) == "1.05");
    CHECK(decimals_without_zeros(100.0, 0) == "100");
    CHECK(decimals_without_zeros(100.0, 3) == "100");
    CHECK(decimals_without_zeros(0.0, 2) == "0");
    CHECK(decimals_without_zeros(-0.001, 2) == "-0");
    CHECK(decimals_without_zeros(std::numeric_limits<double>::infinity(), 2) == "inf");
}

TEST_CASE("Numbers are written as people write them") {
    CHECK(number_text(0.1f) == "0.1");
    CHECK(number_text(-3.001f) == "-3.001");
    CHECK(number_text(100000.0f) == "100000");
    CHECK(number_text(0.0f) == "0");
    CHECK(number_text(0.0001f) == "0.0001");
    CHECK(number_text(1e-10f) == "1e-10");
}

TEST_CASE("A count of 1 takes the singular") {
    CHECK(counted(0, "sample", "samples") == "0 samples");
    CHECK(counted(1, "sample", "samples") == "1 sample");
    CHECK(counted(2, "vertex", "vertices") == "2 vertices");
    CHECK(unit_for("1", "samples") == "sample");
    CHECK(unit_for(" 1 ", "pixels") == "pixel");
    CHECK(unit_for("1", "vertices") == "vertex");
    CHECK(unit_for("1", "less") == "less");
    CHECK(unit_for("1", "m") == "m");
    for (const char* many : {"0", "2", "11", "1.5", "-1", ""}) {
        INFO(many);
        CHECK(unit_for(many, "samples") == "samples");
    }
}
