#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include <imgui.h>

#include "session/session.h"
#include "stages/stages.h"
#include "ui/app/options_state.h"

namespace rasterwalk {

/// A scene drawn at each step of the strip, made small.
struct StagePictures {
    std::shared_ptr<const Scene> scene; ///< that they show
    int side = 0;                       ///< screen pixels for which they were made
    bool is_drawn = false;              ///< false: there are none, the scene is too large
    std::array<ImTextureID, stage_count> textures{};
};

/// What the ways lead to, in pictures on their cards.
struct WayPictures {
    std::shared_ptr<const Scene> scene; ///< that they show
    int side = 0;                       ///< screen pixels for which they were made
    Theme theme{};                      ///< of their colours
    std::array<bool, way_count> is_shown{};
    std::array<std::array<ImTextureID, 3>, way_count> textures{};
};

/// The page with which the program begins the first time.
struct StartPage {
    bool is_open = false;
    Way chosen = Way::lessons; ///< the card that Enter takes
    /// What lies behind the page since the first frame in which it is open: what changes it closes
    /// the page.
    std::optional<SessionInputs> behind;
    std::string lesson; ///< that is open behind it
    StagePictures pictures;
    WayPictures way_pictures;
};

} // namespace rasterwalk
