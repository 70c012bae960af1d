#pragma once

// While a large picture turns under the hand, the steps cannot follow. Until they have drawn theirs
// the fast engine's picture of what is asked for now is shown in its place.

#include <cstdint>
#include <memory>
#include <optional>

#include "base/image.h"
#include "engines/engine_picture.h"
#include "pipeline/run.h"
#include "scene/scene.h"
#include "session/session.h"
#include "settings/settings.h"

namespace rasterwalk {

/// The fast engine's picture in the place of the steps'.
struct Preview {
    Image picture;
    std::uint64_t number = 0; ///< another one whenever `picture` is another
    bool is_shown = false;

    std::shared_ptr<const Scene> scene; ///< of the picture
    std::optional<Settings> settings;   ///< of the picture; none: there is no picture
};

/// Draws a preview, unless it shows this already.
/// @param engine  one for both runs: to take a scene is much work
/// @param numbers the last number given to a picture; counts on
void show_preview(const std::shared_ptr<const Scene>& scene, const Settings& settings,
                  FastRun& engine, std::uint64_t& numbers, Preview& preview);

/// Notices when the hand moves: when what is asked for changes from update to update.
class HandWatch {
  public:
    /// To be called once in each update. The hand has come to rest when two updates in a row have
    /// asked for nothing new: a frame of the window in which it moves makes two, the first with
    /// what was asked for in the previous frame.
    void watch(const Session& session);

    /// Did the hand move, as the last update saw it?
    bool has_moved() const { return updates_at_rest_ < updates_of_rest; }

  private:
    static constexpr int updates_of_rest = 2;

    std::shared_ptr<const Scene> scene_; ///< null: nothing was asked for yet
    Run a_;
    std::optional<Run> b_;
    int updates_at_rest_ = updates_of_rest;
};

} // namespace rasterwalk
