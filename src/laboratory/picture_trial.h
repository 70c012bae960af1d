#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/image.h"
#include "laboratory/candidate.h"
#include "laboratory/image_variant.h"
#include "scene/scene.h"
#include "settings/settings.h"
#include "stages/shadow.h"

namespace rasterwalk {

/// The picture of this scene, made by the recipe.
/// @param known a shadow map, drawn for another picture of the scene and used again where it fits;
/// or null
Image picture_of(const Scene& scene, const PictureRecipe& recipe, Occluders* known = nullptr);

/// What was drawn and measured once.
struct Drawn {
    Settings settings;
    ImageDistance distance; ///< from the picture
    std::uint64_t print = 0;
};

/// Everything that is tried on one picture.
class PictureTrial {
  public:
    PictureTrial(const Image& picture, const Scene& scene) : picture_(picture), scene_(scene) {}

    /// What these settings draw; valid as long as the trial.
    const Drawn& drawn(const Settings& settings);

    /// The picture itself, which is not kept.
    Image draw_again(const Settings& settings) const;

    void add(Hypothesis hypothesis, const ImageDistance& distance, std::uint64_t print) {
        hypothesis.distance = distance.mean;
        hypothesis.different = distance.different;
        hypothesis.result = print;
        hypotheses.push_back(std::move(hypothesis));
    }
    void add(Hypothesis hypothesis, const Image& image) {
        add(std::move(hypothesis), image_distance(image, picture_), fingerprint(image));
    }
    void add(Hypothesis hypothesis, const Drawn& one) {
        add(std::move(hypothesis), one.distance, one.print);
    }
    /// Of a mistake, with which the lamp's power may be fitted anew.
    void add(Hypothesis hypothesis, const Drawn& one, const Settings& settings) {
        tried.push_back({hypotheses.size(), settings});
        hypothesis.recipe = PictureRecipe{settings};
        add(std::move(hypothesis), one);
    }

    const Scene& scene() const { return scene_; }
    const Image& picture() const { return picture_; }
    std::vector<Hypothesis> hypotheses;
    struct Tried {
        std::size_t hypothesis = 0; ///< its number
        Settings settings;
    };
    std::vector<Tried> tried;

  private:
    const Image& picture_;
    const Scene& scene_;
    std::deque<Drawn> drawn_; // whose members do not move
    Occluders occluders_;     ///< six faces of a shadow map take longer than a picture
};

/// Settings from which the mistakes are tried, and what they assume beside the reference.
struct Base {
    Settings settings;
    std::string remark;
    int assumptions = 0;
};

/// The reference, and what else the student may have set without it being a mistake: the stage and
/// the lamp's power.
std::vector<Base> find_bases(PictureTrial& trial, const Settings& reference);

/// The settings with the lamp's power that fits best; none if it does not show, or no power brings
/// the picture clearly nearer.
std::optional<Settings> with_fitted_power(PictureTrial& trial, const Settings& settings);

/// "with light.power=14", behind what is assumed already.
std::string power_remark(const std::string& remark, const Settings& settings);

} // namespace rasterwalk
