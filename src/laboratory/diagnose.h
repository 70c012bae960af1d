#pragma once

// Compares a student's result, a picture or a printed row table, with the reference: mistakes that
// may have made it are tried, alone and in pairs, and each is measured by how near it comes.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "base/image.h"
#include "base/limits.h"
#include "laboratory/bug.h"
#include "laboratory/candidate.h"
#include "laboratory/picture_search.h"
#include "laboratory/printed_rows.h"
#include "pipeline/work.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Settings whose picture has the same size as this one and shows the same view: the focal length
/// changes with the height. Throws UsageError if that makes it too long or too short.
Settings fitted_to(const Settings& settings, const Image& picture, SceneSpace space);

/// How many of the pictures known to be needed are drawn. Each answer may need more; both then
/// restart from 0.
struct PicturesDrawn {
    int done = 0;
    int all = 0;
};

/// Finds in parts what may be wrong with a picture. The reference draws the scene with the
/// settings, whose viewport must have the picture's size. Differences in equally right rules, in
/// the stage, the lamp and the camera are found and taken into the reference; what remains is
/// explained by one or two mistakes, by other words of settings, and by a picture that is turned or
/// moved.
class DiagnosisWork {
  public:
    /// Scene and bugs must outlive this.
    /// @param name          of the picture, for messages
    /// @param is_step_known the picture is known to show the reference's step of the strip; only
    ///                      what is drawn at that step explains it
    DiagnosisWork(Image picture, const std::string& name, const Scene& scene,
                  const Settings& reference, const std::vector<Bug>& bugs,
                  bool is_step_known = false);
    ~DiagnosisWork();
    DiagnosisWork(const DiagnosisWork&) = delete; // the trial refers to the picture
    DiagnosisWork& operator=(const DiagnosisWork&) = delete;

    /// Does about a slice of the work. Throws InputError if all of it exceeds most_diagnosis_work.
    void advance(const WorkLimit& limit = {});

    /// Ends the search; only a closer look at what was found so far remains.
    void stop_searching();

    bool is_done() const { return found_.has_value(); }
    PicturesDrawn pictures() const { return pictures_; }

    const Image& picture() const { return picture_; }
    /// The result, once it is done.
    const Diagnosis& found() const { return *found_; }
    /// The picture of the reference, by the rules that it has taken over.
    const Image& right_picture() const { return right_picture_; }

  private:
    void ask();
    std::vector<Attempt> search();
    void look_closely(const std::vector<Attempt>& tried);
    void refuse_too_much() const;

    Image picture_;
    std::string name_;
    Settings reference_;
    std::vector<Change> changes_;
    std::unique_ptr<PictureTrial> trial_;
    PicturesDrawn pictures_;
    Image right_picture_;
    bool is_step_known_;
    bool is_affordable_ = false; ///< judged by the work of the reference
    bool is_stopped_ = false;
    std::optional<std::vector<Attempt>> tried_; ///< set once the search has ended
    std::optional<Diagnosis> found_;
};

/// The same in one call.
Diagnosis diagnose_picture(const Image& picture, const Scene& scene, const Settings& reference,
                           const std::vector<Bug>& bugs);

/// What may be wrong with a printed row table. It is compared with the polygon's, or without a
/// polygon, with the nearest table among the lab's test polygon and every triangle of the scene.
/// @param polygon vertices, pixels
/// @param about   receives what it was compared with: "the polygon (10,5) (5,10) (15,15)"
Diagnosis diagnose_rows(const std::vector<PrintedRow>& rows, const std::vector<glm::ivec2>& polygon,
                        const Scene& scene, Settings reference, const std::vector<Bug>& bugs,
                        std::string& about);

static_assert(largest_image_side <= largest_viewport,
              "a picture that is read is drawn in its size");

/// About how many pictures must be drawn to find that no mistake explains a picture.
inline constexpr double pictures_tried = 1500.0;

/// The most work allowed for all these pictures, in fragments (see FrameWork): enough for the room
/// in the largest picture.
inline constexpr double most_diagnosis_work = 1.5e11;

} // namespace rasterwalk
