#pragma once

// Part of SDL.h: time. It does not pass by itself, so that each run draws the same frames, but
// reading it moves it on, so that waiting ends.

#include "../runtime.h"
#include "sdl_types.h"

inline Uint32 SDL_GetTicks() {
    return rasterwalk_kit::read_clock();
}
inline Uint64 SDL_GetTicks64() {
    return rasterwalk_kit::read_clock();
}
inline void SDL_Delay(Uint32 milliseconds) {
    rasterwalk_kit::delay(milliseconds);
}
inline Uint64 SDL_GetPerformanceFrequency() {
    return 1000;
}
inline Uint64 SDL_GetPerformanceCounter() {
    return rasterwalk_kit::read_clock();
}
