#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <vector>

#include "base/image.h"
#include "laboratory/candidate.h"
#include "laboratory/image_variant.h"
#include "laboratory/parameter_fit.h"
#include "pipeline/frame_drawing.h"
#include "pipeline/work.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// The result of drawing and measuring something once.
struct Drawn {
    ImageDistance distance; ///< from the picture
    std::uint64_t print = 0;
};

/// What a mistake does to the pixels of a picture drawn without it, compared with the one that is
/// to be explained.
struct PixelCounts {
    std::int64_t wrong = 0;     ///< without the mistake
    std::int64_t explained = 0; ///< of these, right with it
    std::int64_t right = 0;     ///< without the mistake
    std::int64_t spoilt = 0;    ///< of these, wrong with it
    std::int64_t drawn_on = 0;  ///< not black in the picture that is to be explained
    std::int64_t shown = 0;     ///< of these, right with the mistake
};

/// A picture with what is needed of it at the end.
struct KeptPicture {
    Image image;
    std::vector<std::int32_t> owners; ///< triangle that each pixel shows; -1: none
};

/// Everything that is tried on one picture. What a question needs is drawn in parts. Until all of
/// it exists, answers are empty and the trial is waiting; then the question must be asked again.
class PictureTrial {
  public:
    /// Picture and scene must outlive this.
    PictureTrial(const Image& picture, const Scene& scene) : picture_(&picture), scene_(&scene) {}

    /// What the recipe makes; valid as long as the trial. Empty while the trial is waiting for it.
    const Drawn& drawn(const PictureRecipe& recipe);
    const Drawn& drawn(const Settings& settings) { return drawn(PictureRecipe{settings}); }

    /// The settings with the numbers that bring their picture nearest; unchanged while the trial is
    /// waiting for it, and if no light or no camera counts.
    /// @param usual see FitStart
    const Settings& fitted(const Settings& settings, const Settings& usual, FitSubject subject,
                           FitEffort effort);

    /// How the picture of one recipe compares with that of another.
    PixelCounts compared(const PictureRecipe& with, const PictureRecipe& without);

    /// The picture itself, kept until another is requested; null while the trial is waiting for it.
    const KeptPicture* picture_of(const PictureRecipe& recipe);

    /// Is a question still unanswered?
    bool is_waiting() const { return !wanted_.empty() || !is_answered_; }
    std::size_t pictures_missing() const { return wanted_.size(); }

    /// Continues drawing and measuring what was requested.
    void advance(const WorkLimit& limit);

    /// About how much work it is to draw and measure a picture; known once one is done.
    double picture_work() const { return picture_work_; }

    /// From now on nothing new is drawn: what is missing stays missing, and requests are dropped.
    void stop_drawing();
    void draw_again() {
        is_stopped_ = false;
        is_answered_ = true;
    }

    const Scene& scene() const { return *scene_; }
    const Image& picture() const { return *picture_; }

  private:
    enum class Want : std::uint8_t { distance, fit, comparison, picture };
    struct Wanted {
        Want what;
        PictureRecipe recipe;
        FitSubject subject = FitSubject::lamp;
        FitEffort effort = FitEffort::quick;
        PictureRecipe without{}; ///< for a comparison; for a fit, the usual numbers

        friend bool operator==(const Wanted&, const Wanted&) = default;
    };
    struct Hash {
        std::size_t operator()(const PictureRecipe& recipe) const;
        std::size_t operator()(const Wanted& wanted) const { return (*this)(wanted.recipe); }
    };

    void want(const Wanted& wanted);
    double draw(const Settings& settings, double most);
    double draw_recipe(const PictureRecipe& recipe, double most);
    double measure(const Wanted& wanted, double most);
    double fit(const Wanted& wanted, double most);
    double compare(const Wanted& wanted, double most);
    double keep(const Wanted& wanted, double most);

    const Image* picture_;
    const Scene* scene_;
    std::unordered_map<PictureRecipe, Drawn, Hash> drawn_;
    std::unordered_map<Wanted, Settings, Hash> fitted_;
    std::unordered_map<Wanted, PixelCounts, Hash> compared_;
    std::optional<PictureRecipe> kept_recipe_;
    KeptPicture kept_;
    std::deque<Wanted> wanted_;
    bool is_answered_ = true; ///< false: a question was refused because drawing has ended
    bool is_stopped_ = false;

    // The first that is wanted, in progress:
    FrameDrawing drawing_;
    std::optional<Settings> on_canvas_; ///< what is being drawn, or was drawn last
    Image image_;                       ///< of that, as far as `image_rows_`
    int image_rows_ = 0;
    Image rearranged_; ///< turned and moved
    ImageMeasure measure_;
    ParameterFit fit_;
    bool is_fitting_ = false;
    std::optional<PictureRecipe> without_; ///< that `is_right_` belongs to
    std::vector<bool> is_right_;           ///< its pixels
    double picture_work_ = 0.0;
};

} // namespace rasterwalk
