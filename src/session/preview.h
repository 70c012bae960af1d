#pragma once

// While the user turns a large picture, the steps cannot keep up. Until their picture is drawn, the
// fast engine's picture for the current input is shown in its place.

#include <cstdint>
#include <memory>
#include <optional>

#include "base/image.h"
#include "engines/engine_picture.h"
#include "scene/scene.h"
#include "session/second_run.h"
#include "session/session.h"
#include "settings/settings.h"

namespace rasterwalk {

/// The fast engine's picture in place of the steps'.
struct Preview {
    Image picture;
    std::uint64_t number = 0; ///< changes whenever `picture` does
    bool is_shown = false;

    std::shared_ptr<const Scene> scene; ///< of the picture
    std::optional<Settings> settings;   ///< of the picture; none: there is no picture
};

/// Draws a preview, unless it already shows this.
/// @param engine  one for both runs, because loading a scene is a lot of work
/// @param numbers the last number given to a picture; is incremented
void show_preview(const std::shared_ptr<const Scene>& scene, const Settings& settings,
                  FastRun& engine, std::uint64_t& numbers, Preview& preview);

/// Notices when the hand moves: when the input changes from update to update.
class HandWatch {
  public:
    /// Call it once in each update. The hand is at rest when two updates in a row ask for nothing
    /// new: while it moves, a frame of the window makes two updates, the first with the input of
    /// the previous frame.
    void watch(const Session& session);

    /// Did the hand move, as the last update saw it?
    bool has_moved() const { return updates_at_rest_ < updates_of_rest; }

  private:
    static constexpr int updates_of_rest = 2;

    std::shared_ptr<const Scene> scene_; ///< null: nothing has been asked for yet
    Run a_;
    std::optional<Run> b_;
    int updates_at_rest_ = updates_of_rest;
};

} // namespace rasterwalk
