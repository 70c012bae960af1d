#include "laboratory/picture_trial.h"

#include <cmath>

#include <fmt/format.h>

#include "base/limits.h"
#include "base/numbers.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

/// The lamp's power with which the picture comes nearest, all else as it is; none if it does not
/// show. Light is the sum of a part without the lamp and one that grows with its power, so two
/// pictures tell it.
std::optional<float> fitted_power(const PictureTrial& trial, Settings settings) {
    if (shading_rule(settings) == Shading::unlit) return std::nullopt;
    const auto light = [&](float power) {
        settings.light.power = glm::vec3(power);
        return draw_frame(prepare_frame(trial.scene(), settings));
    };
    const Framebuffer without = light(0.0f), with = light(1.0f);
    double products = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < without.colour.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            const std::uint8_t byte =
                trial.picture().rgba[4 * i + static_cast<std::size_t>(channel)];
            const double part = static_cast<double>(with.colour[i][channel]) -
                                static_cast<double>(without.colour[i][channel]);
            // Black may be a gap, and white may be cut off.
            if (byte == 0 || byte == 255 || !(part > 0.0) || !std::isfinite(part)) continue;
            const double wanted =
                (byte + 0.5) / 255.0 - static_cast<double>(without.colour[i][channel]);
            products += part * wanted;
            squares += part * part;
        }
    }
    if (!(squares > 0.0)) return std::nullopt;
    const double power = products / squares;
    if (!(power > 0.0 && power < static_cast<double>(largest_power))) return std::nullopt;
    return static_cast<float>(power);
}

/// The power as a person would have chosen it, if that fits no worse.
float rounded_power(PictureTrial& trial, Settings settings, float power) {
    const auto distance = [&](float value) {
        settings.light.power = glm::vec3(value);
        return trial.drawn(settings).distance.mean;
    };
    float best = power;
    double smallest = distance(power);
    for (const float digits : {1.0f, 10.0f, 100.0f}) {
        const float candidate = std::round(power * digits) / digits;
        if (candidate <= 0.0f) continue;
        const double there = distance(candidate);
        if (there < smallest) {
            best = candidate;
            smallest = there;
        }
    }
    return best;
}

/// The step at which the picture comes nearest to having been drawn.
StripStep nearest_step(PictureTrial& trial, const Settings& reference) {
    Settings settings = reference;
    StripStep nearest = step_of(reference);
    double smallest = trial.drawn(reference).distance.mean;
    for (const StageInfo& info : stage_list()) {
        set_step(settings, info.step);
        const double distance = trial.drawn(settings).distance.mean;
        if (distance < smallest) {
            nearest = info.step;
            smallest = distance;
        }
    }
    return nearest;
}

} // namespace

Image picture_of(const Scene& scene, const PictureRecipe& recipe, Occluders* known) {
    Frame frame;
    if (known != nullptr) frame.occluders = *known;
    prepare_frame(scene, recipe.settings, nullptr, frame);
    const Image image = view_image(draw_frame(frame), View::colour);
    if (known != nullptr && frame.occluders.map != nullptr) *known = frame.occluders;
    return shifted(oriented(image, recipe.orientation), recipe.right, recipe.down);
}

const Drawn& PictureTrial::drawn(const Settings& settings) {
    for (const Drawn& one : drawn_) {
        if (one.settings == settings) return one;
    }
    const Image image = picture_of(scene_, {settings}, &occluders_);
    drawn_.push_back({settings, image_distance(image, picture_), fingerprint(image)});
    return drawn_.back();
}

Image PictureTrial::draw_again(const Settings& settings) const {
    return picture_of(scene_, {settings});
}

std::string power_remark(const std::string& remark, const Settings& settings) {
    return fmt::format("{} light.power={}", remark.empty() ? "with" : remark + " and",
                       number_text(settings.light.power.x));
}

std::optional<Settings> with_fitted_power(PictureTrial& trial, const Settings& settings) {
    const std::optional<float> power = fitted_power(trial, settings);
    if (!power) return std::nullopt;
    Settings lit = settings;
    lit.light.power = glm::vec3(rounded_power(trial, settings, *power));
    constexpr double clearly_nearer = 0.9;
    const double nearer = trial.drawn(lit).distance.mean;
    if (nearer > clearly_nearer * trial.drawn(settings).distance.mean) return std::nullopt;
    return lit;
}

std::vector<Base> find_bases(PictureTrial& trial, const Settings& reference) {
    std::vector<Base> bases{{reference, "", 0}};
    const auto add = [&](const Settings& settings, const std::string& remark, int assumptions) {
        for (const Base& base : bases) {
            if (base.settings == settings) return;
        }
        bases.push_back({settings, remark, assumptions});
    };
    const auto at_step = [&](const StripStep& step) {
        Settings settings = reference;
        set_step(settings, step);
        return settings;
    };
    const auto remark_of = [&](const StripStep& step) {
        if (step == step_of(reference)) return std::string();
        return fmt::format("with stage={}",
                           stage_list()[static_cast<std::size_t>(strip_place(step))].name);
    };
    const StripStep nearest = nearest_step(trial, reference);
    add(at_step(nearest), remark_of(nearest), 1);
    for (const StripStep& step : {StripStep::vertex_light, StripStep::pixel_light}) {
        const std::optional<Settings> lit = with_fitted_power(trial, at_step(step));
        if (!lit) continue;
        const std::string remark = remark_of(step);
        add(*lit, power_remark(remark, *lit), remark.empty() ? 1 : 2);
    }
    return bases;
}

} // namespace rasterwalk
