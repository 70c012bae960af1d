#pragma once

// A window to draw pixels in, with SDL 2.

#include <cstdio>
#include <cstdlib>

#include <glm/glm.hpp>

#include "SDL.h"

// The window that InitializeSDL() has opened.
inline SDL_Window*& WindowSDL() {
    static SDL_Window* window = nullptr;
    return window;
}

// Opens a window of this size and returns the surface to draw on. Ends the program if there can be
// no window.
inline SDL_Surface* InitializeSDL(int width, int height, bool fullscreen = false) {
    if (SDL_Init(SDL_INIT_VIDEO) != 0) {
        std::fprintf(stderr, "SDL cannot be started: %s\n", SDL_GetError());
        std::exit(1);
    }
    std::atexit(SDL_Quit);
    const Uint32 flags = fullscreen ? SDL_WINDOW_FULLSCREEN : SDL_WINDOW_SHOWN;
    WindowSDL() = SDL_CreateWindow("Rasterizer", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                   width, height, flags);
    SDL_Surface* surface = WindowSDL() != nullptr ? SDL_GetWindowSurface(WindowSDL()) : nullptr;
    if (surface == nullptr) {
        std::fprintf(stderr, "There is no window: %s\n", SDL_GetError());
        std::exit(1);
    }
    return surface;
}

// False once the window is closed or Escape is pressed. To be called once a frame.
inline bool NoQuitMessageSDL() {
    SDL_Event event;
    while (SDL_PollEvent(&event)) {
        if (event.type == SDL_QUIT) return false;
        if (event.type == SDL_KEYDOWN && event.key.keysym.sym == SDLK_ESCAPE) return false;
    }
    return true;
}

// Gives a pixel a colour: red, green and blue, 0..1. Pixels outside the surface are left out.
inline void PutPixelSDL(SDL_Surface* surface, int x, int y, glm::vec3 color) {
    if (x < 0 || y < 0 || x >= surface->w || y >= surface->h) return;
    const glm::vec3 levels = 255.0f * glm::clamp(color, 0.0f, 1.0f);
    Uint8* row = static_cast<Uint8*>(surface->pixels) + y * surface->pitch;
    reinterpret_cast<Uint32*>(row)[x] =
        SDL_MapRGB(surface->format, static_cast<Uint8>(levels.r), static_cast<Uint8>(levels.g),
                   static_cast<Uint8>(levels.b));
}

// Makes the whole surface black.
inline void ClearSDL(SDL_Surface* surface) {
    SDL_FillRect(surface, nullptr, 0);
}

// Shows what was drawn.
inline void ShowSDL(SDL_Surface*) {
    SDL_UpdateWindowSurface(WindowSDL());
}
