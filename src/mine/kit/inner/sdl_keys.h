#pragma once

// Part of SDL.h: which keys are held.

#include "../runtime.h"
#include "sdl_key_numbers.h"
#include "sdl_types.h"

namespace rasterwalk_kit {

/// The numbers of one key.
struct Key {
    int number; ///< SDLK_... of this header
    int scancode;
    int keycode; ///< SDLK_... of the real SDL 2
};

inline const Key* key_list(int& count) {
    static const Key keys[] = {
        {SDLK_BACKSPACE, SDL_SCANCODE_BACKSPACE, SDLK_BACKSPACE},
        {SDLK_TAB, SDL_SCANCODE_TAB, SDLK_TAB},
        {SDLK_RETURN, SDL_SCANCODE_RETURN, SDLK_RETURN},
        {SDLK_ESCAPE, SDL_SCANCODE_ESCAPE, SDLK_ESCAPE},
        {SDLK_SPACE, SDL_SCANCODE_SPACE, SDLK_SPACE},
        {SDLK_QUOTE, SDL_SCANCODE_APOSTROPHE, SDLK_QUOTE},
        {SDLK_COMMA, SDL_SCANCODE_COMMA, SDLK_COMMA},
        {SDLK_MINUS, SDL_SCANCODE_MINUS, SDLK_MINUS},
        {SDLK_PERIOD, SDL_SCANCODE_PERIOD, SDLK_PERIOD},
        {SDLK_SLASH, SDL_SCANCODE_SLASH, SDLK_SLASH},
        {SDLK_0, SDL_SCANCODE_0, SDLK_0},
        {SDLK_1, SDL_SCANCODE_1, SDLK_1},
        {SDLK_2, SDL_SCANCODE_2, SDLK_2},
        {SDLK_3, SDL_SCANCODE_3, SDLK_3},
        {SDLK_4, SDL_SCANCODE_4, SDLK_4},
        {SDLK_5, SDL_SCANCODE_5, SDLK_5},
        {SDLK_6, SDL_SCANCODE_6, SDLK_6},
        {SDLK_7, SDL_SCANCODE_7, SDLK_7},
        {SDLK_8, SDL_SCANCODE_8, SDLK_8},
        {SDLK_9, SDL_SCANCODE_9, SDLK_9},
        {SDLK_SEMICOLON, SDL_SCANCODE_SEMICOLON, SDLK_SEMICOLON},
        {SDLK_EQUALS, SDL_SCANCODE_EQUALS, SDLK_EQUALS},
        {SDLK_LEFTBRACKET, SDL_SCANCODE_LEFTBRACKET, SDLK_LEFTBRACKET},
        {SDLK_BACKSLASH, SDL_SCANCODE_BACKSLASH, SDLK_BACKSLASH},
        {SDLK_RIGHTBRACKET, SDL_SCANCODE_RIGHTBRACKET, SDLK_RIGHTBRACKET},
        {SDLK_BACKQUOTE, SDL_SCANCODE_GRAVE, SDLK_BACKQUOTE},
        {SDLK_a, SDL_SCANCODE_A, SDLK_a},
        {SDLK_b, SDL_SCANCODE_B, SDLK_b},
        {SDLK_c, SDL_SCANCODE_C, SDLK_c},
        {SDLK_d, SDL_SCANCODE_D, SDLK_d},
        {SDLK_e, SDL_SCANCODE_E, SDLK_e},
        {SDLK_f, SDL_SCANCODE_F, SDLK_f},
        {SDLK_g, SDL_SCANCODE_G, SDLK_g},
        {SDLK_h, SDL_SCANCODE_H, SDLK_h},
        {SDLK_i, SDL_SCANCODE_I, SDLK_i},
        {SDLK_j, SDL_SCANCODE_J, SDLK_j},
        {SDLK_k, SDL_SCANCODE_K, SDLK_k},
        {SDLK_l, SDL_SCANCODE_L, SDLK_l},
        {SDLK_m, SDL_SCANCODE_M, SDLK_m},
        {SDLK_n, SDL_SCANCODE_N, SDLK_n},
        {SDLK_o, SDL_SCANCODE_O, SDLK_o},
        {SDLK_p, SDL_SCANCODE_P, SDLK_p},
        {SDLK_q, SDL_SCANCODE_Q, SDLK_q},
        {SDLK_r, SDL_SCANCODE_R, SDLK_r},
        {SDLK_s, SDL_SCANCODE_S, SDLK_s},
        {SDLK_t, SDL_SCANCODE_T, SDLK_t},
        {SDLK_u, SDL_SCANCODE_U, SDLK_u},
        {SDLK_v, SDL_SCANCODE_V, SDLK_v},
        {SDLK_w, SDL_SCANCODE_W, SDLK_w},
        {SDLK_x, SDL_SCANCODE_X, SDLK_x},
        {SDLK_y, SDL_SCANCODE_Y, SDLK_y},
        {SDLK_z, SDL_SCANCODE_Z, SDLK_z},
        {SDLK_DELETE, SDL_SCANCODE_DELETE, SDLK_DELETE},
        {SDLK_KP_0, SDL_SCANCODE_KP_0, 0x40000062},
        {SDLK_KP_1, SDL_SCANCODE_KP_1, 0x40000059},
        {SDLK_KP_2, SDL_SCANCODE_KP_2, 0x4000005a},
        {SDLK_KP_3, SDL_SCANCODE_KP_3, 0x4000005b},
        {SDLK_KP_4, SDL_SCANCODE_KP_4, 0x4000005c},
        {SDLK_KP_5, SDL_SCANCODE_KP_5, 0x4000005d},
        {SDLK_KP_6, SDL_SCANCODE_KP_6, 0x4000005e},
        {SDLK_KP_7, SDL_SCANCODE_KP_7, 0x4000005f},
        {SDLK_KP_8, SDL_SCANCODE_KP_8, 0x40000060},
        {SDLK_KP_9, SDL_SCANCODE_KP_9, 0x40000061},
        {SDLK_KP_PERIOD, SDL_SCANCODE_KP_PERIOD, 0x40000063},
        {SDLK_KP_DIVIDE, SDL_SCANCODE_KP_DIVIDE, 0x40000054},
        {SDLK_KP_MULTIPLY, SDL_SCANCODE_KP_MULTIPLY, 0x40000055},
        {SDLK_KP_MINUS, SDL_SCANCODE_KP_MINUS, 0x40000056},
        {SDLK_KP_PLUS, SDL_SCANCODE_KP_PLUS, 0x40000057},
        {SDLK_KP_ENTER, SDL_SCANCODE_KP_ENTER, 0x40000058},
        {SDLK_UP, SDL_SCANCODE_UP, 0x40000052},
        {SDLK_DOWN, SDL_SCANCODE_DOWN, 0x40000051},
        {SDLK_RIGHT, SDL_SCANCODE_RIGHT, 0x4000004f},
        {SDLK_LEFT, SDL_SCANCODE_LEFT, 0x40000050},
        {SDLK_INSERT, SDL_SCANCODE_INSERT, 0x40000049},
        {SDLK_HOME, SDL_SCANCODE_HOME, 0x4000004a},
        {SDLK_END, SDL_SCANCODE_END, 0x4000004d},
        {SDLK_PAGEUP, SDL_SCANCODE_PAGEUP, 0x4000004b},
        {SDLK_PAGEDOWN, SDL_SCANCODE_PAGEDOWN, 0x4000004e},
        {SDLK_F1, SDL_SCANCODE_F1, 0x4000003a},
        {SDLK_F2, SDL_SCANCODE_F2, 0x4000003b},
        {SDLK_F3, SDL_SCANCODE_F3, 0x4000003c},
        {SDLK_F4, SDL_SCANCODE_F4, 0x4000003d},
        {SDLK_F5, SDL_SCANCODE_F5, 0x4000003e},
        {SDLK_F6, SDL_SCANCODE_F6, 0x4000003f},
        {SDLK_F7, SDL_SCANCODE_F7, 0x40000040},
        {SDLK_F8, SDL_SCANCODE_F8, 0x40000041},
        {SDLK_F9, SDL_SCANCODE_F9, 0x40000042},
        {SDLK_F10, SDL_SCANCODE_F10, 0x40000043},
        {SDLK_F11, SDL_SCANCODE_F11, 0x40000044},
        {SDLK_F12, SDL_SCANCODE_F12, 0x40000045},
        {SDLK_RSHIFT, SDL_SCANCODE_RSHIFT, 0x400000e5},
        {SDLK_LSHIFT, SDL_SCANCODE_LSHIFT, 0x400000e1},
        {SDLK_RCTRL, SDL_SCANCODE_RCTRL, 0x400000e4},
        {SDLK_LCTRL, SDL_SCANCODE_LCTRL, 0x400000e0},
        {SDLK_RALT, SDL_SCANCODE_RALT, 0x400000e6},
        {SDLK_LALT, SDL_SCANCODE_LALT, 0x400000e2},
    };
    count = static_cast<int>(sizeof(keys) / sizeof(keys[0]));
    return keys;
}

/// The key that is held now; all numbers 0: none that is known.
inline Key held_key_numbers() {
    const int held = held_key();
    int count = 0;
    const Key* keys = key_list(count);
    for (int i = 0; i < count; ++i) {
        if (held != 0 && keys[i].keycode == held) return keys[i];
    }
    return Key{0, 0, 0};
}

} // namespace rasterwalk_kit

/// Of SDL 1.2: indexed by SDLK_...
inline Uint8* SDL_GetKeyState(int* count) {
    static Uint8 keys[SDLK_LAST];
    std::memset(keys, 0, sizeof(keys));
    const int held = rasterwalk_kit::held_key_numbers().number;
    if (held != 0) keys[held] = 1;
    if (count != nullptr) *count = SDLK_LAST;
    return keys;
}

namespace rasterwalk_kit {

/// What SDL_GetKeyboardState() returns stays the same array, and is brought up to date when events
/// are read, as with the real one.
inline Uint8* scancode_state() {
    static Uint8 keys[SDL_NUM_SCANCODES];
    std::memset(keys, 0, sizeof(keys));
    const int held = held_key_numbers().scancode;
    if (held != 0) keys[held] = 1;
    return keys;
}

} // namespace rasterwalk_kit

/// Of SDL 2: indexed by SDL_SCANCODE_...
inline const Uint8* SDL_GetKeyboardState(int* count) {
    if (count != nullptr) *count = SDL_NUM_SCANCODES;
    return rasterwalk_kit::scancode_state();
}

inline SDL_Scancode SDL_GetScancodeFromKey(SDL_Keycode key) {
    int count = 0;
    const rasterwalk_kit::Key* keys = rasterwalk_kit::key_list(count);
    for (int i = 0; i < count; ++i) {
        if (keys[i].number == key) return static_cast<SDL_Scancode>(keys[i].scancode);
    }
    return SDL_SCANCODE_UNKNOWN;
}

inline SDL_Keycode SDL_GetKeyFromScancode(SDL_Scancode scancode) {
    int count = 0;
    const rasterwalk_kit::Key* keys = rasterwalk_kit::key_list(count);
    for (int i = 0; i < count; ++i) {
        if (keys[i].scancode == scancode) return keys[i].number;
    }
    return SDLK_UNKNOWN;
}

inline SDLMod SDL_GetModState() {
    return KMOD_NONE;
}
inline int SDL_EnableKeyRepeat(int, int) {
    return 0;
}
#define SDL_DEFAULT_REPEAT_DELAY 500
#define SDL_DEFAULT_REPEAT_INTERVAL 30
