#pragma once

// Numbers, pixels and places in writing: read from links, lessons and the command line, and made
// into text. Every text of a float on the screen, in a file or in an answer is made here or by fmt;
// both ignore the locale.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

namespace rasterwalk {

/// The whole text as a whole number; none if it is not one.
std::optional<int> parse_int(std::string_view text);

/// The whole text as a number of this range; none if it is not one.
std::optional<float> parse_number(std::string_view text, float smallest, float largest);

/// "250,131": column and row.
std::optional<glm::ivec2> parse_pixel(std::string_view text);

/// "250.5,131": two finite numbers.
std::optional<glm::vec2> parse_place(std::string_view text);

/// The fewest digits that read back as the very same number: "0.1", "1e-05", "inf".
std::string shortest(float value);
std::string shortest(double value);

/// The same, in the usual notation where people read it, from 0.0001 to 9,999,999: "0.1", "100000",
/// "1e+07". Settings, links and files are written this way.
std::string number_text(float value);

/// This many significant digits, without zeros at the end: "0.333333", "2", "1e-05".
std::string significant(double value, int digits);

/// Nine significant digits: they distinguish every float from its neighbours.
std::string nine_digits(float value);

/// This many digits after the point: "0.250".
std::string decimals(double value, int digits);

/// The same without zeros at the end, nor a point that nothing follows: "0.25", "3", "-0".
std::string decimals_without_zeros(double value, int digits);

/// A digit, this many after the point, and the power of ten: "4.62e-05".
std::string scientific(double value, int digits);

/// "1 edge", "3 edges", "2 vertices": every count with its word is made here.
std::string counted(std::int64_t count, std::string_view one, std::string_view many);

/// The word that goes with a written number: for "samples" it is "sample" after "1", and "samples"
/// after every other.
std::string unit_for(std::string_view number, std::string_view many);

/// The text of a number with minus signs for hyphens: "−2.5e−05".
std::string with_minus_signs(std::string_view text);

} // namespace rasterwalk
