#pragma once

// A result that a student brings, a picture or a printed row table, compared with the reference:
// the mistakes that may have made it are carried out, alone and two at once, and each is measured
// by how near it comes.

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
/// follows the height. Throws UsageError if that makes it too long or too short.
Settings fitted_to(const Settings& settings, const Image& picture, SceneSpace space);

/// How many of the pictures that are known to be needed are drawn. Each answer may need more: then
/// both begin again from 0.
struct PicturesDrawn {
    int done = 0;
    int all = 0;
};

/// What may be wrong with a picture, found in parts. The reference draws the scene by the settings,
/// whose viewport must have the picture's size. What differs in rules of which none is wrong, in
/// the stage, the lamp and the camera is found and becomes the reference; what then remains is
/// explained by the mistakes, one or two at once, by other words of settings, and by a picture that
/// is turned or moved.
class DiagnosisWork {
  public:
    /// Scene and bugs must live as long.
    /// @param name of the picture, for messages
    DiagnosisWork(Image picture, const std::string& name, const Scene& scene,
                  const Settings& reference, const std::vector<Bug>& bugs);
    ~DiagnosisWork();
    DiagnosisWork(const DiagnosisWork&) = delete; // the trial refers to the picture
    DiagnosisWork& operator=(const DiagnosisWork&) = delete;

    /// Goes on by about a slice. Throws InputError if all of it is more than most_diagnosis_work.
    void advance(const WorkLimit& limit = {});

    /// Searches no further: what remains is to look closely at what was found so far.
    void stop_searching();

    bool is_done() const { return found_.has_value(); }
    PicturesDrawn pictures() const { return pictures_; }

    const Image& picture() const { return picture_; }
    /// What was found, once it is done.
    const Diagnosis& found() const { return *found_; }
    /// And the picture of the reference, by the rules that it has taken over.
    const Image& right_picture() const { return right_picture_; }

  private:
    void ask();
    void look_closely(const std::vector<Attempt>& tried);
    void refuse_too_much() const;

    Image picture_;
    std::string name_;
    Settings reference_;
    std::vector<Change> changes_;
    std::unique_ptr<PictureTrial> trial_;
    PicturesDrawn pictures_;
    Image right_picture_;
    bool is_affordable_ = false; ///< by the work that the reference is
    bool is_stopped_ = false;
    std::optional<std::vector<Attempt>> tried_; ///< once nothing more is searched
    std::optional<Diagnosis> found_;
};

/// The same at once.
Diagnosis diagnose_picture(const Image& picture, const Scene& scene, const Settings& reference,
                           const std::vector<Bug>& bugs);

/// What may be wrong with a printed row table. It is compared with the polygon's, or without one,
/// with the nearest of those of the lab's test polygon and of every triangle of the scene.
/// @param polygon vertices, pixels
/// @param about   receives what it was compared with: "the polygon (10,5) (5,10) (15,15)"
Diagnosis diagnose_rows(const std::vector<PrintedRow>& rows, const std::vector<glm::ivec2>& polygon,
                        const Scene& scene, Settings reference, const std::vector<Bug>& bugs,
                        std::string& about);

static_assert(largest_image_side <= largest_viewport,
              "a picture that is read is drawn in its size");

/// About how many pictures are drawn before it is known that no mistake explains a picture.
inline constexpr double pictures_tried = 1500.0;

/// The most work that all these pictures may be, in fragments (see FrameWork): enough for the room
/// in the largest picture.
inline constexpr double most_diagnosis_work = 1.5e11;

} // namespace rasterwalk
