#pragma once

// The helper itself: see SDLauxiliary.h.

#include <glm/glm.hpp>

#include "../SDL.h"
#include "../runtime.h"

/// The window of programs that draw into `buffer`. A program may have a variable of the same name.
struct screen : SDL_Surface {
    SDL_Window* window;
    SDL_Renderer* renderer;
    SDL_Texture* texture;
    int height, width;
    std::uint32_t* buffer; ///< the same memory as `pixels`
};

namespace rasterwalk_kit {

inline struct screen* open_screen(int width, int height) {
    SDL_Window* window = SDL_CreateWindow("", 0, 0, width, height, 0);
    if (window == nullptr) return nullptr;
    auto* opened = new struct screen;
    set_surface(*opened, width, height, canvas().pixels);
    opened->window = window;
    opened->renderer = SDL_CreateRenderer(window, -1, 0);
    opened->texture = SDL_CreateTexture(opened->renderer, SDL_PIXELFORMAT_ARGB8888,
                                        SDL_TEXTUREACCESS_STREAMING, width, height);
    opened->width = width;
    opened->height = height;
    opened->buffer = canvas().pixels;
    return opened;
}

/// Puts a pixel into the window, or into another surface of the program.
inline void put_on_surface(SDL_Surface* surface, int x, int y, const glm::vec3& colour) {
    // While a function is asked there may be no window yet.
    if (is_capturing() || is_window(surface)) {
        put(x, y, colour.x, colour.y, colour.z);
    } else if (x >= 0 && y >= 0 && x < surface->w && y < surface->h) {
        pixel_of(surface, x, y) = packed_colour(colour.x, colour.y, colour.z);
    }
}

} // namespace rasterwalk_kit

// The surface and the struct.

inline struct screen* InitializeSDL(int width, int height, bool = false) {
    return rasterwalk_kit::open_screen(width, height);
}
inline struct screen* InitializeSDL(const char*, int width, int height, bool = false) {
    return rasterwalk_kit::open_screen(width, height);
}

/// False would end the program: it goes on until the last frame that is wanted.
inline bool NoQuitMessageSDL() {
    rasterwalk_kit::ask_to_go_on();
    return true;
}

inline void PutPixelSDL(SDL_Surface* surface, int x, int y, glm::vec3 color) {
    rasterwalk_kit::use_dialect(rasterwalk_kit::dialect_surface);
    rasterwalk_kit::put_on_surface(surface, x, y, color);
}
inline void PutPixelSDL(struct screen* target, int x, int y, glm::vec3 color) {
    rasterwalk_kit::use_dialect(rasterwalk_kit::dialect_screen);
    rasterwalk_kit::put_on_surface(target, x, y, color);
}

// Names of the helper that comes with our own skeleton, new/SDLauxiliary.h.

inline void ClearSDL(SDL_Surface* surface) {
    SDL_FillRect(surface, nullptr, 0);
}
inline void ShowSDL(SDL_Surface* surface) {
    SDL_Flip(surface);
}

// Only with the struct.

inline void SDL_Renderframe(struct screen*) {
    rasterwalk_kit::use_dialect(rasterwalk_kit::dialect_screen);
    rasterwalk_kit::show();
}
inline void KillSDL(struct screen*) {}
/// Nothing is written.
inline void SDL_SaveImage(struct screen*, const char*) {}

// The class.

class SDL2Aux {
  public:
    /// Opens the window.
    SDL2Aux(int width = 500, int height = 500, bool = false) {
        rasterwalk_kit::use_dialect(rasterwalk_kit::dialect_class);
        rasterwalk_kit::open_canvas(width, height);
    }

    void putPixel(int x, int y, glm::vec3 color) {
        rasterwalk_kit::put(x, y, color.x, color.y, color.z);
    }
    void clearPixels() { rasterwalk_kit::clear(0, 0, 0); }
    void render() { rasterwalk_kit::show(); }

    /// False would end the program: it goes on until the last frame that is wanted.
    bool noQuitMessage() {
        rasterwalk_kit::ask_to_go_on();
        return true;
    }
    /// The same question the other way round.
    bool quitEvent() { return !noQuitMessage(); }

    /// Nothing is written, but the answer is that all went well.
    bool saveBMP(const char*) { return true; }
    void setWindowTitle(const char*) {}
};
