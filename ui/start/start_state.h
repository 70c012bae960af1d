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

/// A scene drawn small at each step of the strip.
struct StagePictures {
    std::shared_ptr<const Scene> scene; ///< the one they show
    int side = 0;                       ///< the size they were made for, screen pixels
    bool is_drawn = false;              ///< false: there are none, the scene is too large
    std::array<ImTextureID, stage_count> textures{};
};

/// What the choices lead to, in pictures on their cards.
struct StartPictures {
    std::shared_ptr<const Scene> scene; ///< the one they show
    int side = 0;                       ///< the size they were made for, screen pixels
    Theme theme{};                      ///< of their colours
    std::array<bool, start_choice_count> is_shown{};
    std::array<std::array<ImTextureID, 3>, start_choice_count> textures{};
};

/// The page that the program begins with the first time.
struct StartPage {
    bool is_open = false;
    StartChoice chosen = StartChoice::lessons; ///< the card that Enter takes
    /// What lies behind the page since the first frame in which it is open: any change to it closes
    /// the page.
    std::optional<SessionInputs> behind;
    std::string lesson; ///< the one open behind it
    StagePictures pictures;
    StartPictures start_pictures;
};

} // namespace rasterwalk
