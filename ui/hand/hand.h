#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "ui/widgets/widget_state.h"

namespace rasterwalk {

struct Ui;

/// Keys that are held while something else is done.
struct Modifiers {
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
};

/// Mouse and keyboard, played by a program: for tests and for pictures of the interface in any
/// state. Widgets are addressed by the names they are registered under, never by coordinates.
/// Everything is done as a person would do it, one change a frame, and the interface has come to
/// rest when a function returns.
///
/// A widget that is scrolled away is scrolled into view first. One that is not on the screen at all
/// is a UsageError that lists names like it.
class Hand {
  public:
    /// @param build builds one frame; build_ui with whatever the host does around it
    explicit Hand(Ui& with, std::function<void()> build);

    /// Builds frames, `seconds` of time each.
    void frames(int count = 1, float seconds = 1.0f / 60.0f);
    /// Builds frames_to_rest frames; the last is left out if the two before it draw the same.
    void rest();

    /// Moves the pointer onto the widget and leaves it there.
    void hover(std::string_view name);
    void click(std::string_view name, Modifiers modifiers = {}, int mouse_button = 0);
    void double_click(std::string_view name);
    /// Presses on the widget, moves by screen pixels, lets go.
    void drag(std::string_view name, float dx, float dy, Modifiers modifiers = {},
              int mouse_button = 0);
    /// Turns the wheel over the widget; up is positive.
    void wheel(std::string_view name, float steps, Modifiers modifiers = {});
    /// Moves the pointer off everything.
    void leave();

    /// Presses and releases a key (see ui/widgets/keys.h), which writes its letter into an open
    /// field.
    void press(int key, Modifiers modifiers = {});
    /// Holds a key down for a number of frames.
    void hold(int key, int count, Modifiers modifiers = {});
    /// Types into the field that has the keyboard.
    void type_text(std::string_view text);
    /// Replaces the content of an input field and ends it with Enter. A number that can be dragged
    /// is turned into a field first.
    void enter(std::string_view name, std::string_view text);

    /// The same on a pixel of the picture, which must be on the screen.
    void hover_picture(int column, int row);
    void click_picture(int column, int row, Modifiers modifiers = {});
    void double_click_picture(int column, int row);
    /// Drags from the middle of a pixel to the middle of another.
    void drag_picture(int column, int row, int to_column, int to_row, Modifiers modifiers = {});
    void wheel_picture(int column, int row, float steps);

    /// True if the widget is drawn and can be seen at least in part.
    bool is_visible(std::string_view name) const;
    /// Brings the widget into view if necessary, as far as possible. Throws UsageError if it does
    /// not exist.
    WidgetPlace find(std::string_view name);
    /// All names on the screen, sorted.
    std::vector<std::string> names() const;

  private:
    ImVec2 middle_of(std::string_view name);
    ImVec2 pixel_middle(int column, int row);
    void move_to(ImVec2 place);
    void press_mouse(int mouse_button, Modifiers modifiers, int times = 1);
    void drag_to(ImVec2 from, ImVec2 to, Modifiers modifiers, int mouse_button);
    bool scroll_into_view(std::string_view name);
    void scroll_until_uncut(std::string_view name);
    std::string not_found(std::string_view name) const;

    Ui& ui_;
    std::function<void()> build_frame_;
};

/// How many frames it takes until hover, popups and sizes that follow their content are at rest.
inline constexpr int frames_to_rest = 3;

} // namespace rasterwalk
