#pragma once

#include <memory>
#include <string>

#include "base/image.h"
#include "tests/window/program.h"

namespace rasterwalk::test {

/// A display in memory with a mouse and a keyboard that the test moves as a person would: the
/// program sees the same events.
class VirtualDisplay {
  public:
    /// Starts Xvfb on a display number that is free. Throws if there is none, or no Xvfb.
    explicit VirtualDisplay(const std::string& folder);
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    const std::string& name() const { return name_; } ///< ":99"

    void move_mouse(int x, int y);
    void click();
    /// A key by its X name: "2", "F12", "Control_L".
    void press_key(const std::string& key);
    void hold_key(const std::string& key, bool is_down);

    /// True once a window with this title is shown.
    bool has_window(const std::string& title);
    /// Place of a window on the display. Throws if there is none of this title.
    void window_place(const std::string& title, int& x, int& y, int& width, int& height);
    /// Asks a window to close, as a window manager does when its cross is clicked.
    void ask_to_close(const std::string& title);
    /// Gives a window another size, as a window manager does.
    void resize(const std::string& title, int width, int height);
    /// The number of a window, which it keeps. Throws if there is none of this title.
    unsigned long window_number(const std::string& title);
    /// Takes a window off the display, as a window manager does to minimize it, or brings it
    /// back.
    void show(unsigned long number, bool is_shown);

    /// What the display shows.
    Image picture();

  private:
    struct Connection;
    std::string name_;
    std::unique_ptr<Program> server_;
    std::unique_ptr<Connection> connection_;
};

} // namespace rasterwalk::test
