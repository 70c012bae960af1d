// How the numbers of a guess become settings, and how far the picture they make is from the
// student's.

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "laboratory/parameter_fit.h"
#include "settings/setting_table.h"

namespace rasterwalk {

double ParameterFit::huber(double difference) {
    const double size = std::max(std::abs(difference) - 1.0, 0.0);
    return size <= far_apart ? size * size : far_apart * (2.0 * size - far_apart);
}

ParameterFit::Numbers ParameterFit::numbers_of(const Settings& settings) const {
    if (subject_ == FitSubject::lamp) {
        const Light& light = settings.light;
        return {light.position.x, light.position.y, light.position.z, light.power.x,
                light.power.y,    light.power.z,    light.indirect.x};
    }
    const Camera& camera = settings.camera;
    return {camera.position.x, camera.position.y, camera.position.z, camera.yaw,
            camera.focal_length};
}

Settings ParameterFit::with(const Numbers& numbers) const {
    if (numbers == numbers_of(start_)) return start_;
    Settings settings = start_;
    std::array<float, most_numbers> values{};
    for (std::size_t i = 0; i < most_numbers; ++i)
        values[i] = static_cast<float>(numbers[i]);
    const glm::vec3 position(values[0], values[1], values[2]);
    if (subject_ == FitSubject::lamp) {
        settings.light.position = position;
        settings.light.power = glm::max(glm::vec3(values[3], values[4], values[5]), 0.0f);
        settings.light.indirect = glm::vec3(std::max(values[6], 0.0f));
    } else {
        settings.camera.position = position;
        settings.camera.yaw = values[3];
        settings.camera.focal_length = values[4];
    }
    clamp_to_ranges(settings);
    return settings;
}

/// The same in the size for comparing it with the picture.
Settings ParameterFit::in_sight(const Numbers& numbers) const {
    Settings settings = with(numbers);
    settings.viewport = sight_.size;
    settings.camera.focal_length /= static_cast<float>(sight_.shrunk);
    if (subject_ == FitSubject::camera && !is_larger_) {
        // Rounding a vertex to a whole pixel of a small picture would hide how far it is from its
        // place.
        settings.coverage = Coverage::edge_functions;
        settings.fill_rule = FillRule::top_left;
        settings.snap = Snap::subpixel;
    }
    return settings;
}

/// For the lamp the colours themselves; for the camera the share of each channel, which white light
/// does not change.
std::vector<float> ParameterFit::values_of(const Image& image) const {
    std::vector<float> values;
    values.reserve(image.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
        const std::array<float, 3> c{static_cast<float>(image.rgba[i]),
                                     static_cast<float>(image.rgba[i + 1]),
                                     static_cast<float>(image.rgba[i + 2])};
        const float sum = c[0] + c[1] + c[2];
        const float scale = subject_ == FitSubject::lamp ? 1.0f : 255.0f / (sum + 1.0f);
        for (const float channel : c)
            values.push_back(scale * channel);
    }
    return values;
}

ParameterFit::Sight ParameterFit::make_sight(int largest_side) const {
    Sight sight;
    const int side = std::max(picture_->width, picture_->height);
    sight.shrunk = std::max(1, (side + largest_side - 1) / largest_side);
    sight.size = {std::max(1, picture_->width / sight.shrunk),
                  std::max(1, picture_->height / sight.shrunk)};
    const auto place = [&](int i, int small, int full) {
        const double from_middle = (i + 0.5 - 0.5 * small) * sight.shrunk;
        return std::clamp(static_cast<int>(std::floor(from_middle + 0.5 * full)), 0, full - 1);
    };
    Image image{sight.size.width, sight.size.height, {}};
    for (int row = 0; row < sight.size.height; ++row) {
        for (int column = 0; column < sight.size.width; ++column) {
            const auto x =
                static_cast<std::size_t>(place(column, sight.size.width, picture_->width));
            const auto y =
                static_cast<std::size_t>(place(row, sight.size.height, picture_->height));
            const auto from = picture_->rgba.begin() +
                              static_cast<std::ptrdiff_t>(
                                  4 * (y * static_cast<std::size_t>(picture_->width) + x));
            image.rgba.insert(image.rgba.end(), from, from + 4);
        }
    }
    sight.colours = values_of(image);
    return sight;
}

double ParameterFit::cost_of(const std::vector<float>& colours) const {
    double cost = 0.0;
    for (std::size_t i = 0; i < colours.size(); ++i)
        cost += huber(static_cast<double>(colours[i]) - static_cast<double>(sight_.colours[i]));
    return cost;
}

} // namespace rasterwalk
