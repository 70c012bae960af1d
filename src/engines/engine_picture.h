#pragma once

// Pictures of the fast engine, and others like them, as planes and as images.

#include <memory>
#include <optional>

#include "base/image.h"
#include "engines/fast/fast_engine.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/work.h"

namespace rasterwalk {

/// The planes of a picture. Colours are those of the bytes; fragments are not
/// counted, overdraw is 0.
/// @param frame of the same scene and settings: it has the start values of the planes
void copy_picture(const FastPicture& picture, const Frame& frame, Framebuffer& planes);

/// The same from the top as far as the limit allows, in planes that begin_clearing() has begun.
/// @return true if all rows are copied
bool copy_rows(const FastPicture& picture, const WorkLimit& limit, Framebuffer& planes);

/// The picture that is shown, without planes.
/// @param image its memory is reused
void copy_image(const FastPicture& picture, Image& image);

/// A fast engine that follows a scene and its settings.
class FastRun {
  public:
    explicit FastRun(const FastOptions& options = {}) : options_(options) {}

    /// Draws, unless the last picture showed the same.
    /// @return true if the picture is a new one
    bool draw(const std::shared_ptr<const Scene>& scene, const Settings& settings);

    const FastPicture& picture() const { return picture_; }
    /// Does the picture show this?
    bool shows(const std::shared_ptr<const Scene>& scene, const Settings& settings) const {
        return scene_ == scene && settings_ == settings;
    }

  private:
    FastOptions options_;
    std::shared_ptr<const Scene> scene_; ///< null: nothing is drawn yet
    std::optional<Settings> settings_;
    std::optional<FastEngine> engine_;
    FastPicture picture_;
};

} // namespace rasterwalk
