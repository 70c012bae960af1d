#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/image.h"
#include "session/session.h"
#include "ui/app/options_state.h"

namespace rasterwalk {

/// Something done to the interface before its picture is taken.
struct HandAction {
    enum class Kind : std::uint8_t {
        click, ///< on a widget, by its name
        hover, ///< the pointer rests on a widget, by its name
        pick,  ///< on a pixel of the picture: "X,Y"
        press, ///< of a key: "F1", "Ctrl+Z", "period", "A"
    };
    Kind kind;
    std::string what;
};

/// What the picture of the interface should look like.
struct OffscreenOptions {
    int width = 1600; ///< pixels
    int height = 1000;
    UiOptions ui;
    std::string tab; ///< of the inspector, brought to the front; empty: the session's own
    std::vector<HandAction> actions;
    std::string ladder_times; ///< file of times for the Speed tab, see made_times.h; empty: none
    /// The student's own program, checked before the actions; its times are left out. Empty: none.
    std::string code;
    std::string report_path; ///< file that takes report_of(); "-" for standard output; empty: none
};

/// Limits of the window that can be drawn, pixels.
inline constexpr int smallest_offscreen_width = 320;
inline constexpr int smallest_offscreen_height = 240;
inline constexpr int largest_offscreen_side = 8192;

/// The interface on a session as a picture, drawn without a display. Throws Error: UsageError for
/// an action that cannot be done, AccessError if there is no way to draw.
Image draw_offscreen(Session session, const OffscreenOptions& options);

} // namespace rasterwalk
