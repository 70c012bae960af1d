#pragma once

// Part of SDL.h: events and the mouse. The only event that ever comes is the press of the key that
// Rasterwalk holds, once a frame; the mouse rests.

#include "../runtime.h"
#include "sdl_keys.h"
#include "sdl_types.h"

enum SDL_EventType : Uint32 {
    SDL_NOEVENT = 0,
    SDL_FIRSTEVENT = 0,
    SDL_QUIT = 0x100,
    SDL_WINDOWEVENT = 0x200,
    SDL_KEYDOWN = 0x300,
    SDL_KEYUP = 0x301,
    SDL_TEXTINPUT = 0x303,
    SDL_MOUSEMOTION = 0x400,
    SDL_MOUSEBUTTONDOWN = 0x401,
    SDL_MOUSEBUTTONUP = 0x402,
    SDL_MOUSEWHEEL = 0x403,
    SDL_VIDEORESIZE = 0x500,
    SDL_VIDEOEXPOSE = 0x501,
    SDL_ACTIVEEVENT = 0x502,
    SDL_USEREVENT = 0x8000
};

enum : int {
    SDL_RELEASED = 0,
    SDL_PRESSED = 1,
    SDL_BUTTON_LEFT = 1,
    SDL_BUTTON_MIDDLE = 2,
    SDL_BUTTON_RIGHT = 3,
    SDL_BUTTON_WHEELUP = 4,
    SDL_BUTTON_WHEELDOWN = 5,
    SDL_BUTTON_LMASK = 1,
    SDL_BUTTON_MMASK = 2,
    SDL_BUTTON_RMASK = 4,
    SDL_QUERY = -1,
    SDL_IGNORE = 0,
    SDL_DISABLE = 0,
    SDL_ENABLE = 1
};
#define SDL_BUTTON(button) (1 << ((button)-1))

enum : Uint8 {
    SDL_WINDOWEVENT_SHOWN = 1,
    SDL_WINDOWEVENT_EXPOSED = 3,
    SDL_WINDOWEVENT_RESIZED = 5,
    SDL_WINDOWEVENT_SIZE_CHANGED = 6,
    SDL_WINDOWEVENT_CLOSE = 14
};

struct SDL_Keysym {
    SDL_Scancode scancode;
    SDL_Keycode sym;
    Uint16 mod;
    Uint32 unicode;
};
typedef SDL_Keysym SDL_keysym;

struct SDL_KeyboardEvent {
    Uint32 type, timestamp, windowID;
    Uint8 state, repeat;
    SDL_Keysym keysym;
};
struct SDL_MouseMotionEvent {
    Uint32 type, timestamp, windowID, which, state;
    Sint32 x, y, xrel, yrel;
};
struct SDL_MouseButtonEvent {
    Uint32 type, timestamp, windowID, which;
    Uint8 button, state, clicks;
    Sint32 x, y;
};
struct SDL_MouseWheelEvent {
    Uint32 type, timestamp, windowID, which;
    Sint32 x, y;
};
struct SDL_WindowEvent {
    Uint32 type, timestamp, windowID;
    Uint8 event;
    Sint32 data1, data2;
};
struct SDL_ResizeEvent {
    Uint32 type;
    int w, h;
};
struct SDL_QuitEvent {
    Uint32 type, timestamp;
};

union SDL_Event {
    Uint32 type;
    SDL_KeyboardEvent key;
    SDL_MouseMotionEvent motion;
    SDL_MouseButtonEvent button;
    SDL_MouseWheelEvent wheel;
    SDL_WindowEvent window;
    SDL_ResizeEvent resize;
    SDL_QuitEvent quit;
};

inline int SDL_PollEvent(SDL_Event* event) {
    rasterwalk_kit::scancode_state();
    if (event != nullptr) std::memset(static_cast<void*>(event), 0, sizeof(*event));
    if (event == nullptr || !rasterwalk_kit::take_key_press()) {
        rasterwalk_kit::ask_for_events();
        return 0;
    }
    const rasterwalk_kit::Key held = rasterwalk_kit::held_key_numbers();
    event->key.type = SDL_KEYDOWN;
    event->key.state = SDL_PRESSED;
    event->key.keysym.sym = held.number;
    event->key.keysym.scancode = static_cast<SDL_Scancode>(held.scancode);
    return 1;
}

inline int SDL_WaitEvent(SDL_Event* event) {
    if (SDL_PollEvent(event) == 0) rasterwalk_kit::wait_for_events();
    return 1;
}
inline int SDL_WaitEventTimeout(SDL_Event* event, int) {
    return SDL_PollEvent(event);
}
inline void SDL_PumpEvents() {
    rasterwalk_kit::scancode_state();
}
inline void SDL_FlushEvents(Uint32, Uint32) {}
inline int SDL_PushEvent(SDL_Event*) {
    return 0;
}
inline Uint8 SDL_EventState(Uint32, int) {
    return 0;
}
inline SDL_bool SDL_QuitRequested() {
    return SDL_FALSE;
}

namespace rasterwalk_kit {

/// The mouse is at the origin and has not moved.
inline Uint32 resting_mouse(int* x, int* y) {
    if (x != nullptr) *x = 0;
    if (y != nullptr) *y = 0;
    return 0;
}

} // namespace rasterwalk_kit

inline Uint32 SDL_GetMouseState(int* x, int* y) {
    return rasterwalk_kit::resting_mouse(x, y);
}
inline Uint32 SDL_GetRelativeMouseState(int* x, int* y) {
    return rasterwalk_kit::resting_mouse(x, y);
}
inline int SDL_SetRelativeMouseMode(SDL_bool) {
    return 0;
}
inline int SDL_ShowCursor(int) {
    return 0;
}
inline void SDL_WarpMouse(Uint16, Uint16) {}
