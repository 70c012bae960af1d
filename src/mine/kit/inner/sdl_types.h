#pragma once

// Part of SDL.h: numbers, and starting and ending SDL.

#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

typedef std::uint8_t Uint8;
typedef std::int8_t Sint8;
typedef std::uint16_t Uint16;
typedef std::int16_t Sint16;
typedef std::uint32_t Uint32;
typedef std::int32_t Sint32;
typedef std::uint64_t Uint64;
typedef std::int64_t Sint64;

enum SDL_bool { SDL_FALSE = 0, SDL_TRUE = 1 };

#define SDL_LIL_ENDIAN 1234
#define SDL_BIG_ENDIAN 4321
#define SDL_BYTEORDER SDL_LIL_ENDIAN
#define SDL_MAJOR_VERSION 2
#define SDL_MINOR_VERSION 0
#define SDL_PATCHLEVEL 20
#define SDLCALL
#define DECLSPEC

enum : Uint32 {
    SDL_INIT_TIMER = 0x1,
    SDL_INIT_AUDIO = 0x10,
    SDL_INIT_VIDEO = 0x20,
    SDL_INIT_JOYSTICK = 0x200,
    SDL_INIT_EVENTS = 0x4000,
    SDL_INIT_NOPARACHUTE = 0x100000,
    SDL_INIT_EVERYTHING = 0xffff
};

inline int SDL_Init(Uint32) {
    return 0;
}
inline int SDL_InitSubSystem(Uint32) {
    return 0;
}
inline void SDL_QuitSubSystem(Uint32) {}
inline Uint32 SDL_WasInit(Uint32 flags) {
    return flags;
}
inline void SDL_Quit() {}
inline void SDL_SetMainReady() {}

/// Nothing goes wrong in here that has a text.
inline const char* SDL_GetError() {
    return "";
}
inline void SDL_ClearError() {}
inline int SDL_SetError(const char*, ...) {
    return -1;
}

inline void SDL_Log(const char* format, ...) {
    va_list values;
    va_start(values, format);
    std::vfprintf(stderr, format, values);
    va_end(values);
    std::fputc('\n', stderr);
}

inline SDL_bool SDL_SetHint(const char*, const char*) {
    return SDL_TRUE;
}
#define SDL_HINT_RENDER_SCALE_QUALITY "SDL_RENDER_SCALE_QUALITY"
#define SDL_HINT_RENDER_VSYNC "SDL_RENDER_VSYNC"

inline void* SDL_malloc(std::size_t size) {
    return std::malloc(size);
}
inline void SDL_free(void* memory) {
    std::free(memory);
}
inline void* SDL_memset(void* memory, int value, std::size_t size) {
    return std::memset(memory, value, size);
}
inline void* SDL_memcpy(void* to, const void* from, std::size_t size) {
    return std::memcpy(to, from, size);
}

#define SDL_arraysize(array) (sizeof(array) / sizeof((array)[0]))
#define SDL_zero(object) std::memset(static_cast<void*>(&(object)), 0, sizeof(object))
