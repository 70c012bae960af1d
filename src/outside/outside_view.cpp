#include "outside/outside_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/limits.h"
#include "base/numbers.h"
#include "base/text_parts.h"

namespace rasterwalk {

namespace {

constexpr std::string_view camera_word = "camera";

/// NaN becomes the smallest.
float clamped(float value, float smallest, float largest) {
    return value >= smallest ? std::min(value, largest) : smallest;
}

} // namespace

std::string to_text(const OutsideView& view) {
    if (view.is_camera) return std::string(camera_word);
    std::string text = number_text(view.yaw) + "," + number_text(view.pitch);
    if (view.distance <= 0.0f) return text;
    text += "," + number_text(view.distance);
    for (int i = 0; i < 3; ++i)
        text += "," + number_text(view.target[i]);
    return text;
}

std::optional<OutsideView> parse_outside_view(std::string_view text) {
    OutsideView view;
    view.is_camera = text == camera_word;
    if (view.is_camera) return view;
    struct Number {
        float* value;
        float smallest, largest;
    };
    const std::array<Number, 6> numbers{{
        {&view.yaw, -largest_yaw, largest_yaw},
        {&view.pitch, -largest_pitch, largest_pitch},
        {&view.distance, smallest_outside_distance, largest_outside_distance},
        {&view.target.x, -largest_coordinate, largest_coordinate},
        {&view.target.y, -largest_coordinate, largest_coordinate},
        {&view.target.z, -largest_coordinate, largest_coordinate},
    }};
    std::size_t count = 0;
    for (const std::string_view part : split(text, ',')) {
        if (count == numbers.size()) return std::nullopt;
        const Number& number = numbers[count++];
        const std::optional<float> value = parse_number(part, number.smallest, number.largest);
        if (!value) return std::nullopt;
        *number.value = *value;
    }
    const bool is_whole = count == 2 || count == numbers.size();
    return is_whole ? std::optional(view) : std::nullopt;
}

OutsideView within_ranges(OutsideView view) {
    view.yaw = clamped(view.yaw, -largest_yaw, largest_yaw);
    view.pitch = clamped(view.pitch, -largest_pitch, largest_pitch);
    if (!(view.distance > 0.0f)) {
        view.distance = 0.0f;
    } else {
        view.distance = clamped(view.distance, smallest_outside_distance, largest_outside_distance);
    }
    for (int i = 0; i < 3; ++i)
        view.target[i] = clamped(view.target[i], -largest_coordinate, largest_coordinate);
    return view;
}

OutsideView turned(OutsideView view, float yaw, float pitch) {
    view.yaw = std::remainder(view.yaw + yaw, 6.2831853f);
    view.pitch += pitch;
    return within_ranges(view);
}

OutsideView moved_away(OutsideView view, float factor) {
    if (view.distance <= 0.0f || !(factor > 0.0f)) return view;
    view.distance = std::max(view.distance * factor, smallest_outside_distance);
    return within_ranges(view);
}

} // namespace rasterwalk
