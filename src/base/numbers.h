#pragma once

// Whole numbers, pixels and places as they are written in links, lessons and on the command line.

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

} // namespace rasterwalk
