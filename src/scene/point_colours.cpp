#include "scene/point_colours.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

#include "base/limits.h"

namespace rasterwalk {

namespace {

constexpr float not_given = std::numeric_limits<float>::quiet_NaN();

} // namespace

void PointColours::add(std::size_t point, std::span<const double> numbers, int line) {
    given_.resize(point, glm::vec4(not_given));
    glm::vec4 given(not_given);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        given[static_cast<int>(i)] = static_cast<float>(numbers[i]);
    given_.push_back(given);
    if (numbers.size() == 4 && numbers[0] != 1.0) is_weight_first_ = false;
    if (numbers.size() == 4 && numbers[3] != 1.0) is_alpha_last_ = false;
    const double largest = *std::max_element(numbers.begin(), numbers.end());
    const bool were_bytes = are_bytes();
    largest_ = std::max(largest_, largest);
    if (!were_bytes && are_bytes()) line_of_bytes_ = line;
}

void PointColours::add_polypaint(std::string_view text) {
    constexpr std::size_t digits = 8;
    while (text.size() >= digits && polypaint_.size() < most_model_points) {
        std::uint32_t colour = 0;
        const auto [end, fault] = std::from_chars(text.data(), text.data() + digits, colour, 16);
        if (fault != std::errc{} || end != text.data() + digits) return;
        polypaint_.push_back(colour);
        text.remove_prefix(digits);
    }
}

std::vector<glm::vec3> PointColours::colours(std::size_t points) const {
    if (given_.empty() && polypaint_.empty()) return {};
    std::vector<glm::vec3> colours(points, glm::vec3(1.0f));
    if (given_.empty()) {
        for (std::size_t i = 0; i < std::min(points, polypaint_.size()); ++i) {
            const std::uint32_t bytes = polypaint_[i];
            colours[i] = glm::vec3(bytes >> 16 & 255u, bytes >> 8 & 255u, bytes & 255u) / 255.0f;
        }
        return colours;
    }
    const float full = are_bytes() ? 255.0f : 1.0f;
    for (std::size_t i = 0; i < std::min(points, given_.size()); ++i) {
        const glm::vec4& given = given_[i];
        if (std::isnan(given.x)) continue;
        const bool skips_first = is_weight_first_ && !is_alpha_last_ && !std::isnan(given.w);
        const glm::vec3 colour =
            skips_first ? glm::vec3(given.y, given.z, given.w) : glm::vec3(given);
        colours[i] = glm::clamp(colour / full, 0.0f, 1.0f);
    }
    return colours;
}

} // namespace rasterwalk
