#include "tests/window/virtual_display.h"

#include <cstdint>
#include <fstream>
#include <stdexcept>

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>

namespace rasterwalk::test {

struct VirtualDisplay::Connection {
    Display* display;

    explicit Connection(const std::string& name) : display(XOpenDisplay(name.c_str())) {
        if (display == nullptr) throw std::runtime_error("Xvfb " + name + " does not answer");
    }
    ~Connection() { XCloseDisplay(display); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// The window of this title below another; 0 if there is none.
    Window find(Window above, const std::string& title) const {
        Window root = 0, parent = 0;
        Window* children = nullptr;
        unsigned count = 0;
        if (XQueryTree(display, above, &root, &parent, &children, &count) == 0) return 0;
        Window found = 0;
        for (unsigned i = 0; i < count && found == 0; ++i) {
            char* name = nullptr;
            if (XFetchName(display, children[i], &name) != 0) {
                XWindowAttributes attributes{};
                XGetWindowAttributes(display, children[i], &attributes);
                if (title == name && attributes.map_state == IsViewable) found = children[i];
                XFree(name);
            }
            if (found == 0) found = find(children[i], title);
        }
        if (children != nullptr) XFree(children);
        return found;
    }
    Window window(const std::string& title) const {
        const Window found = find(DefaultRootWindow(display), title);
        if (found == 0) throw std::runtime_error("there is no window '" + title + "'");
        return found;
    }
};

VirtualDisplay::VirtualDisplay(const std::string& folder) {
    // The server looks for a free number and writes it to the descriptor that it is given.
    server_ =
        std::make_unique<Program>(std::vector<std::string>{"Xvfb", "-displayfd", "1", "-screen",
                                                           "0", "1700x1100x24", "-nolisten", "tcp"},
                                  std::map<std::string, std::string>{}, folder);
    std::string number;
    const bool is_there = becomes_true(30.0, [&] {
        std::ifstream file(folder + "/stdout");
        return std::getline(file, number) && !file.eof();
    });
    if (!is_there) throw std::runtime_error("Xvfb does not start; is the package xvfb installed?");
    name_ = ":" + number;
    connection_ = std::make_unique<Connection>(name_);
}

VirtualDisplay::~VirtualDisplay() = default;

void VirtualDisplay::move_mouse(int x, int y) {
    XTestFakeMotionEvent(connection_->display, -1, x, y, CurrentTime);
    XSync(connection_->display, False);
}

void VirtualDisplay::click() {
    XTestFakeButtonEvent(connection_->display, 1, True, CurrentTime);
    XTestFakeButtonEvent(connection_->display, 1, False, CurrentTime);
    XSync(connection_->display, False);
}

void VirtualDisplay::hold_key(const std::string& key, bool is_down) {
    const KeySym symbol = XStringToKeysym(key.c_str());
    const KeyCode code = XKeysymToKeycode(connection_->display, symbol);
    if (code == 0) throw std::runtime_error("there is no key '" + key + "'");
    XTestFakeKeyEvent(connection_->display, code, is_down ? True : False, CurrentTime);
    XSync(connection_->display, False);
}

void VirtualDisplay::press_key(const std::string& key) {
    hold_key(key, true);
    hold_key(key, false);
}

bool VirtualDisplay::has_window(const std::string& title) {
    return connection_->find(DefaultRootWindow(connection_->display), title) != 0;
}

void VirtualDisplay::window_place(const std::string& title, int& x, int& y, int& width,
                                  int& height) {
    Display* const display = connection_->display;
    const Window window = connection_->window(title);
    XWindowAttributes attributes{};
    XGetWindowAttributes(display, window, &attributes);
    Window ignored = 0;
    XTranslateCoordinates(display, window, DefaultRootWindow(display), 0, 0, &x, &y, &ignored);
    width = attributes.width;
    height = attributes.height;
}

void VirtualDisplay::ask_to_close(const std::string& title) {
    Display* const display = connection_->display;
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = connection_->window(title);
    event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
    event.xclient.data.l[1] = CurrentTime;
    XSendEvent(display, event.xclient.window, False, NoEventMask, &event);
    XSync(display, False);
}

void VirtualDisplay::resize(const std::string& title, int width, int height) {
    XResizeWindow(connection_->display, connection_->window(title), static_cast<unsigned>(width),
                  static_cast<unsigned>(height));
    XSync(connection_->display, False);
}

unsigned long VirtualDisplay::window_number(const std::string& title) {
    return connection_->window(title);
}

void VirtualDisplay::show(unsigned long number, bool is_shown) {
    if (is_shown) {
        XMapWindow(connection_->display, number);
    } else {
        XUnmapWindow(connection_->display, number);
    }
    XSync(connection_->display, False);
}

Image VirtualDisplay::picture() {
    Display* const display = connection_->display;
    const int screen = DefaultScreen(display);
    Image image{DisplayWidth(display, screen), DisplayHeight(display, screen), {}};
    XImage* const pixels =
        XGetImage(display, DefaultRootWindow(display), 0, 0, static_cast<unsigned>(image.width),
                  static_cast<unsigned>(image.height), AllPlanes, ZPixmap);
    if (pixels == nullptr) throw std::runtime_error("the display cannot be read");
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
            const unsigned long rgb = XGetPixel(pixels, column, row);
            for (const int shift : {16, 8, 0})
                image.rgba.push_back(static_cast<std::uint8_t>((rgb >> shift) & 0xFF));
            image.rgba.push_back(255);
        }
    }
    XDestroyImage(pixels);
    return image;
}

} // namespace rasterwalk::test
