#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "base/image.h"
#include "laboratory/candidate.h"
#include "laboratory/image_variant.h"
#include "pipeline/frame_drawing.h"
#include "pipeline/work.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// What was drawn and measured once.
struct Drawn {
    PictureRecipe recipe;
    ImageDistance distance; ///< from the picture
    std::uint64_t print = 0;
};

/// Everything that is tried on one picture. What a question needs is drawn in parts: until all of
/// it is there, answers are empty and the trial is waiting; then the question is asked again.
class PictureTrial {
  public:
    /// Picture and scene must live as long.
    PictureTrial(const Image& picture, const Scene& scene) : picture_(&picture), scene_(&scene) {}

    /// What the recipe makes; valid as long as the trial. Nothing while it is waiting for it.
    const Drawn& drawn(const PictureRecipe& recipe);
    const Drawn& drawn(const Settings& settings) { return drawn(PictureRecipe{settings}); }

    /// The lamp's power with which the picture comes nearest, all else as it is; none if it does
    /// not show, or while the trial is waiting for it.
    std::optional<float> fitted_power(const Settings& settings);

    /// The picture itself, which is kept until another is asked for; null while the trial is
    /// waiting for it.
    const Image* picture_of(const PictureRecipe& recipe);

    /// Has a question not been answered?
    bool is_waiting() const { return !wanted_.empty(); }
    std::size_t pictures_missing() const { return wanted_.size(); }

    /// Goes on drawing and measuring what was asked for.
    void advance(const WorkLimit& limit);

    /// About how much work a picture is, drawn and measured; known once one is.
    double picture_work() const { return picture_work_; }

    /// Forgets what was added, not what was drawn.
    void begin_again();
    void add(Hypothesis hypothesis, const Drawn& one) {
        hypothesis.distance = one.distance.mean;
        hypothesis.different = one.distance.different;
        hypothesis.result = one.print;
        hypotheses.push_back(std::move(hypothesis));
    }
    /// Of a mistake, with which the lamp's power may be fitted anew.
    void add(Hypothesis hypothesis, const Drawn& one, const Settings& settings) {
        tried.push_back({hypotheses.size(), settings});
        hypothesis.recipe = PictureRecipe{settings};
        add(std::move(hypothesis), one);
    }

    const Scene& scene() const { return *scene_; }
    std::vector<Hypothesis> hypotheses;
    struct Tried {
        std::size_t hypothesis = 0; ///< its number
        Settings settings;
    };
    std::vector<Tried> tried;

  private:
    /// The light of a frame without the lamp and with it, and what fits them to the picture.
    struct Fit {
        std::vector<glm::vec3> without; ///< colours; empty until they are drawn
        int rows = 0;                   ///< that are summed up
        double products = 0.0, squares = 0.0;
    };
    struct Fitted {
        Settings settings;
        std::optional<float> power;
    };
    enum class Want : std::uint8_t { distance, power, picture };
    struct Wanted {
        Want what;
        PictureRecipe recipe;

        friend bool operator==(const Wanted&, const Wanted&) = default;
    };

    void want(const Wanted& wanted);
    double draw(const Settings& settings, double most);
    double measure(const Wanted& wanted, double most);
    double fit(const Wanted& wanted, double most);
    void sum_rows(int end);

    const Image* picture_;
    const Scene* scene_;
    std::deque<Drawn> drawn_; // whose members do not move
    std::vector<Fitted> fitted_;
    std::optional<PictureRecipe> kept_recipe_;
    Image kept_;
    std::deque<Wanted> wanted_;

    // The first that is wanted, on its way:
    FrameDrawing drawing_;
    std::optional<Settings> on_canvas_; ///< what is being drawn, or was drawn last
    Image image_;                       ///< of that, as far as `image_rows_`
    int image_rows_ = 0;
    std::optional<Image> rearranged_; ///< turned and moved
    ImageMeasure measure_;
    Fit fit_;
    double picture_work_ = 0.0;
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
