#pragma once

#include <string>

#include "ui/hand/hand.h"
#include "ui/ui.h"

namespace rasterwalk {

/// Takes pictures and shows none of them.
struct KeptTextures : TextureHost {
    ImTextureID upload(ImTextureID old, const Image& image) override;
    Image last;      ///< what was uploaded last
    int uploads = 0; ///< how often
};

/// The interface without a window. A test plays mouse and keyboard through `hand`, which addresses
/// widgets by their registered names (one that is not there fails the test with names like it), and
/// then looks at `ui.session`, `ui.results` and `textures.last`:
///
///     Driver driver;
///     driver.hand.click("stage.depth");
///     CHECK(driver.ui.session.a.settings.stage == Stage::depth);
///
/// One at a time: ImGui has one context.
class Driver {
  public:
    /// @param scene file in the folder of scenes that come with the program
    /// @param window screen pixels
    explicit Driver(const std::string& scene = "lab-room.toml", ImVec2 window = {1600, 1000},
                    float text_scale = 1.0f);
    /// With a separate session.
    explicit Driver(Session session, ImVec2 window = {1600, 1000}, float text_scale = 1.0f);
    ~Driver();
    Driver(const Driver&) = delete;
    Driver& operator=(const Driver&) = delete;

    void resize(ImVec2 window);

    /// Clicks what leads to a tab of the inspector (its group or the list of tabs), then the tab.
    void open(std::string_view tab);

    /// Presses Tab until a widget has the frame. Returns false if it never has.
    bool tab_to(std::string_view name, Modifiers modifiers = {});

    Ui ui;
    KeptTextures textures;
    Hand hand;
};

/// What is wrong with the last frame as it would be drawn: a corner without a place on the screen,
/// and in which window. Empty: nothing.
std::string fault_of_frame();

} // namespace rasterwalk
