#include "laboratory/picture_trial.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/limits.h"
#include "base/numbers.h"
#include "picture/view_image.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

/// What a pixel costs beside a fragment, that is made visible and measured.
constexpr double pixel_work = 1.5;

/// The row up to which this work leads.
int row_after(double work, int done, const Image& picture) {
    const WorkLimit part{.at_once = work, .slice = work};
    return done + rows_within(part, pixel_work, {picture.width, picture.height}, done);
}

Settings with_power(Settings settings, float power) {
    settings.light.power = glm::vec3(power);
    return settings;
}

/// The power as a person would have chosen it, if that fits no worse.
float rounded_power(PictureTrial& trial, const Settings& settings, float power) {
    const auto distance = [&](float value) {
        return trial.drawn(with_power(settings, value)).distance.mean;
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

const Drawn& PictureTrial::drawn(const PictureRecipe& recipe) {
    for (const Drawn& one : drawn_) {
        if (one.recipe == recipe) return one;
    }
    want({Want::distance, recipe});
    static const Drawn nothing;
    return nothing;
}

/// Light is the sum of a part without the lamp and one that grows with its power, so two pictures
/// tell it.
std::optional<float> PictureTrial::fitted_power(const Settings& settings) {
    if (shading_rule(settings) == Shading::unlit) return std::nullopt;
    for (const Fitted& one : fitted_) {
        if (one.settings == settings) return one.power;
    }
    want({Want::power, PictureRecipe{settings}});
    return std::nullopt;
}

const Image* PictureTrial::picture_of(const PictureRecipe& recipe) {
    if (kept_recipe_ == recipe) return &kept_;
    want({Want::picture, recipe});
    return nullptr;
}

void PictureTrial::want(const Wanted& wanted) {
    if (std::find(wanted_.begin(), wanted_.end(), wanted) == wanted_.end())
        wanted_.push_back(wanted);
}

void PictureTrial::begin_again() {
    hypotheses.clear();
    tried.clear();
}

void PictureTrial::advance(const WorkLimit& limit) {
    for (double left = limit.slice; is_waiting() && left > 0.0;) {
        const Wanted& wanted = wanted_.front();
        left -= wanted.what == Want::power ? fit(wanted, left) : measure(wanted, left);
    }
}

/// Draws the settings, then makes them visible; what was drawn last is there already. Returns 0
/// when nothing of it is left to do.
double PictureTrial::draw(const Settings& settings, double most) {
    if (on_canvas_ != settings) {
        on_canvas_ = settings;
        drawing_.begin(*scene_, settings);
        image_ = {picture_->width, picture_->height, {}};
        image_.rgba.resize(picture_->rgba.size());
        image_rows_ = 0;
    }
    if (!drawing_.is_done()) {
        // Never for nothing, or it would seem to be done.
        return std::max(drawing_.advance(most), 1.0);
    }
    const int end = row_after(most, image_rows_, image_);
    const int rows = end - image_rows_;
    if (rows == 0) return 0.0;
    update_view_image(drawing_.picture(), View::colour, {0, image_rows_, image_.width, end},
                      image_);
    image_rows_ = end;
    return 0.5 * pixel_work * rows * image_.width;
}

double PictureTrial::measure(const Wanted& wanted, double most) {
    const PictureRecipe& recipe = wanted.recipe;
    if (const double done = draw(recipe.settings, most); done > 0.0) return done;
    const bool is_plain = recipe == PictureRecipe{recipe.settings};
    if (!is_plain && !rearranged_)
        rearranged_ = shifted(oriented(image_, recipe.orientation), recipe.right, recipe.down);
    const Image& image = is_plain ? image_ : *rearranged_;
    const int begun = measure_.rows(), end = row_after(most, begun, image);
    measure_.measure_to(image, *picture_, end);
    if (end == image.height) {
        picture_work_ = drawing_.work() + pixel_work * image.width * image.height;
        if (wanted.what == Want::picture) {
            kept_ = image;
            kept_recipe_ = recipe;
        } else {
            drawn_.push_back({recipe, measure_.distance(), measure_.print()});
        }
        rearranged_.reset();
        measure_ = {};
        wanted_.pop_front();
    }
    return std::max(0.5 * pixel_work * (end - begun) * picture_->width, 1.0);
}

double PictureTrial::fit(const Wanted& wanted, double most) {
    const Settings& settings = wanted.recipe.settings;
    const bool has_without = !fit_.without.empty();
    if (const double done = draw(with_power(settings, has_without ? 1.0f : 0.0f), most); done > 0.0)
        return done;
    if (!has_without) {
        fit_.without = drawing_.picture().colour;
        return 1.0;
    }
    const int begun = fit_.rows, end = row_after(most, begun, *picture_);
    sum_rows(end);
    if (end == picture_->height) {
        const double power = fit_.squares > 0.0 ? fit_.products / fit_.squares : 0.0;
        const bool fits = power > 0.0 && power < static_cast<double>(largest_power);
        fitted_.push_back(
            {settings, fits ? std::optional(static_cast<float>(power)) : std::nullopt});
        fit_ = {};
        wanted_.pop_front();
    }
    return std::max(pixel_work * (end - begun) * picture_->width, 1.0);
}

void PictureTrial::sum_rows(int end) {
    const std::vector<glm::vec3>&without = fit_.without, &with = drawing_.picture().colour;
    const auto width = static_cast<std::size_t>(picture_->width);
    const bool is_encoded = drawing_.picture().rules.screen.encode == encode_srgb;
    const auto light_of = [&](std::uint8_t byte) {
        const double channel = (byte + 0.5) / 255.0;
        return is_encoded ? double{decode_srgb(static_cast<float>(channel))} : channel;
    };
    for (std::size_t i = static_cast<std::size_t>(fit_.rows) * width;
         i < static_cast<std::size_t>(end) * width; ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            const std::uint8_t byte = picture_->rgba[4 * i + static_cast<std::size_t>(channel)];
            const double part =
                static_cast<double>(with[i][channel]) - static_cast<double>(without[i][channel]);
            // Black may be a gap, and white may be cut off.
            if (byte == 0 || byte == 255 || !(part > 0.0) || !std::isfinite(part)) continue;
            const double wanted = light_of(byte) - static_cast<double>(without[i][channel]);
            fit_.products += part * wanted;
            fit_.squares += part * part;
        }
    }
    fit_.rows = end;
}

std::string power_remark(const std::string& remark, const Settings& settings) {
    return fmt::format("{} light.power={}", remark.empty() ? "with" : remark + " and",
                       number_text(settings.light.power.x));
}

std::optional<Settings> with_fitted_power(PictureTrial& trial, const Settings& settings) {
    const std::optional<float> power = trial.fitted_power(settings);
    if (!power) return std::nullopt;
    const Settings lit = with_power(settings, rounded_power(trial, settings, *power));
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
    if (trial.is_waiting()) return bases;
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
