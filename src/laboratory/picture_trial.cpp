#include "laboratory/picture_trial.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "picture/view_image.h"

namespace rasterwalk {

namespace {

/// The cost of making a pixel visible and measuring it, relative to a fragment.
constexpr double pixel_work = 1.5;

/// The row up to which this work leads.
int row_after(double work, int done, const Image& picture) {
    const WorkLimit part{.at_once = work, .slice = work};
    return done + rows_within(part, pixel_work, {picture.width, picture.height}, done);
}

} // namespace

/// A hash of the numbers and words that differ most often; others only cost one more comparison.
std::size_t PictureTrial::Hash::operator()(const PictureRecipe& recipe) const {
    const Settings& s = recipe.settings;
    std::size_t hash = 0;
    const auto add = [&](auto value) {
        hash = hash * 1099511628211u ^ std::hash<decltype(value)>()(value);
    };
    for (int i = 0; i < 3; ++i) {
        add(s.camera.position[i]);
        add(s.light.position[i]);
    }
    add(s.camera.yaw);
    add(s.camera.focal_length);
    add(s.light.power.x);
    add(s.light.indirect.x);
    add(s.depth_clear);
    for (const int word : {static_cast<int>(s.stage),
                           static_cast<int>(s.shading),
                           static_cast<int>(s.coverage),
                           static_cast<int>(s.vertex_rounding),
                           static_cast<int>(s.line),
                           static_cast<int>(s.line_rounding),
                           static_cast<int>(s.line_walk),
                           static_cast<int>(s.edge_samples),
                           static_cast<int>(s.row_start),
                           static_cast<int>(s.spans),
                           static_cast<int>(s.bounds),
                           static_cast<int>(s.depth_test),
                           static_cast<int>(s.interpolation),
                           static_cast<int>(s.rotation),
                           static_cast<int>(s.image_axes),
                           static_cast<int>(s.clip),
                           static_cast<int>(s.cull),
                           static_cast<int>(s.light_rules.direction),
                           static_cast<int>(s.light_rules.falloff),
                           static_cast<int>(s.light_rules.sum),
                           static_cast<int>(recipe.orientation),
                           recipe.right,
                           recipe.down}) {
        add(word);
    }
    return hash;
}

const Drawn& PictureTrial::drawn(const PictureRecipe& recipe) {
    const auto found = drawn_.find(recipe);
    if (found != drawn_.end()) return found->second;
    want({Want::distance, recipe});
    static const Drawn nothing;
    return nothing;
}

const Settings& PictureTrial::fitted(const Settings& settings, const Settings& usual,
                                     FitSubject subject, FitEffort effort) {
    const bool counts = scene_->space == SceneSpace::world &&
                        (subject == FitSubject::camera ? settings.camera.aim == CameraAim::angles
                                                       : shading_rule(settings) != Shading::unlit);
    if (!counts) return settings;
    const Wanted wanted{Want::fit, PictureRecipe{settings}, subject, effort, PictureRecipe{usual}};
    const auto found = fitted_.find(wanted);
    if (found != fitted_.end()) return found->second;
    want(wanted);
    return settings;
}

PixelCounts PictureTrial::compared(const PictureRecipe& with, const PictureRecipe& without) {
    const Wanted wanted{.what = Want::comparison, .recipe = with, .without = without};
    const auto found = compared_.find(wanted);
    if (found != compared_.end()) return found->second;
    want(wanted);
    return {};
}

const KeptPicture* PictureTrial::picture_of(const PictureRecipe& recipe) {
    if (kept_recipe_ == recipe) return &kept_;
    want({Want::picture, recipe});
    return nullptr;
}

void PictureTrial::want(const Wanted& wanted) {
    if (is_stopped_) {
        is_answered_ = false;
    } else if (std::find(wanted_.begin(), wanted_.end(), wanted) == wanted_.end()) {
        wanted_.push_back(wanted);
    }
}

void PictureTrial::stop_drawing() {
    is_stopped_ = true;
    wanted_.clear();
    measure_ = {};
    is_fitting_ = false;
}

void PictureTrial::advance(const WorkLimit& limit) {
    for (double left = limit.slice; !wanted_.empty() && left > 0.0;) {
        const Wanted& wanted = wanted_.front();
        switch (wanted.what) {
        case Want::distance:
            left -= measure(wanted, left);
            break;
        case Want::fit:
            left -= fit(wanted, left);
            break;
        case Want::comparison:
            left -= compare(wanted, left);
            break;
        case Want::picture:
            left -= keep(wanted, left);
            break;
        }
    }
}

/// Draws the settings, then makes them visible; what was drawn last is kept. Returns 0 when nothing
/// is left to do.
double PictureTrial::draw(const Settings& settings, double most) {
    if (on_canvas_ != settings) {
        on_canvas_ = settings;
        drawing_.begin(*scene_, settings);
        image_ = {picture_->width, picture_->height, {}};
        image_.rgba.resize(picture_->rgba.size());
        image_rows_ = 0;
    }
    if (!drawing_.is_done()) {
        // Never 0, or it would seem to be done.
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

/// The same, turned and moved into `rearranged_`.
double PictureTrial::draw_recipe(const PictureRecipe& recipe, double most) {
    const double done = draw(recipe.settings, most);
    if (done > 0.0) return done;
    picture_work_ = drawing_.work() + pixel_work * image_.width * image_.height;
    rearranged_ = shifted(oriented(image_, recipe.orientation), recipe.right, recipe.down);
    return 0.0;
}

double PictureTrial::measure(const Wanted& wanted, double most) {
    const PictureRecipe& recipe = wanted.recipe;
    const bool is_plain = recipe == PictureRecipe{recipe.settings};
    if (measure_.rows() == 0 || on_canvas_ != recipe.settings) {
        const double done = is_plain ? draw(recipe.settings, most) : draw_recipe(recipe, most);
        if (done > 0.0) return done;
        picture_work_ = drawing_.work() + pixel_work * image_.width * image_.height;
    }
    const Image& image = is_plain ? image_ : rearranged_;
    const int begun = measure_.rows(), end = row_after(most, begun, image);
    measure_.measure_to(image, *picture_, end);
    if (end == image.height) {
        drawn_.emplace(recipe, Drawn{measure_.distance(), measure_.print()});
        measure_ = {};
        wanted_.pop_front();
    }
    return std::max(0.5 * pixel_work * (end - begun) * picture_->width, 1.0);
}

double PictureTrial::fit(const Wanted& wanted, double most) {
    if (!is_fitting_) {
        fit_.begin(*picture_, *scene_, {wanted.recipe.settings, wanted.without.settings},
                   wanted.subject, wanted.effort);
        is_fitting_ = true;
    }
    const double done = fit_.advance(most);
    if (fit_.is_done()) {
        fitted_.emplace(wanted, fit_.found());
        is_fitting_ = false;
        wanted_.pop_front();
    }
    return done;
}

double PictureTrial::compare(const Wanted& wanted, double most) {
    const bool is_begun = without_ == wanted.without;
    const PictureRecipe& recipe = is_begun ? wanted.recipe : wanted.without;
    if (const double done = draw_recipe(recipe, most); done > 0.0) return done;
    const std::size_t count = picture_->rgba.size() / 4;
    const auto is_right = [&](std::size_t i) {
        return is_same_pixel(rearranged_.rgba.data() + 4 * i, picture_->rgba.data() + 4 * i);
    };
    if (!is_begun) {
        is_right_.resize(count);
        for (std::size_t i = 0; i < count; ++i)
            is_right_[i] = is_right(i);
        without_ = wanted.without;
    } else {
        PixelCounts counts;
        for (std::size_t i = 0; i < count; ++i) {
            const bool was_right = is_right_[i], is_now = is_right(i);
            ++(was_right ? counts.right : counts.wrong);
            if (was_right != is_now) ++(is_now ? counts.explained : counts.spoilt);
            if (is_black(picture_->rgba.data() + 4 * i)) continue;
            ++counts.drawn_on;
            if (is_now) ++counts.shown;
        }
        compared_.emplace(wanted, counts);
        wanted_.pop_front();
    }
    return static_cast<double>(count);
}

double PictureTrial::keep(const Wanted& wanted, double most) {
    if (const double done = draw_recipe(wanted.recipe, most); done > 0.0) return done;
    kept_ = {rearranged_, drawing_.picture().owner};
    kept_recipe_ = wanted.recipe;
    wanted_.pop_front();
    return static_cast<double>(kept_.owners.size());
}

} // namespace rasterwalk
