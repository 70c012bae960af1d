#pragma once

// Part of SDL.h: surfaces, which are all of 32 bits a pixel, 0xAARRGGBB, and the window of SDL 1.2,
// which is a surface.

#include "../runtime.h"
#include "sdl_types.h"

struct SDL_Color {
    Uint8 r, g, b, a;
};
struct SDL_Point {
    int x, y;
};
struct SDL_Rect {
    int x, y, w, h;
};
struct SDL_Palette;

struct SDL_PixelFormat {
    SDL_Palette* palette;
    Uint8 BitsPerPixel, BytesPerPixel;
    Uint8 Rloss, Gloss, Bloss, Aloss;
    Uint8 Rshift, Gshift, Bshift, Ashift;
    Uint32 Rmask, Gmask, Bmask, Amask;
    Uint32 format;
};

struct SDL_Surface {
    Uint32 flags;
    SDL_PixelFormat* format;
    int w, h;
    int pitch;
    void* pixels;
    void* userdata;
    SDL_Rect clip_rect;
    int refcount;
};

enum : Uint32 {
    SDL_SWSURFACE = 0,
    SDL_HWSURFACE = 1,
    SDL_ASYNCBLIT = 4,
    SDL_ANYFORMAT = 0x10000000,
    SDL_HWPALETTE = 0x20000000,
    SDL_DOUBLEBUF = 0x40000000,
    SDL_FULLSCREEN = 0x80000000,
    SDL_OPENGL = 2,
    SDL_RESIZABLE = 0x10,
    SDL_NOFRAME = 0x20,
    SDL_SRCCOLORKEY = 0x1000,
    SDL_SRCALPHA = 0x10000
};
#define SDL_MUSTLOCK(surface) ((void)(surface), 0)

namespace rasterwalk_kit {

inline SDL_PixelFormat* pixel_format() {
    static SDL_PixelFormat format = {
        nullptr, 32, 4, 0, 0, 0, 0, 16, 8, 0, 24, 0xff0000, 0xff00, 0xff, 0xff000000, 0x16362004};
    return &format;
}

/// Makes a surface of these pixels.
inline void set_surface(SDL_Surface& surface, int width, int height, void* pixels) {
    surface.flags = 0;
    surface.format = pixel_format();
    surface.w = width;
    surface.h = height;
    surface.pitch = width * 4;
    surface.pixels = pixels;
    surface.userdata = nullptr;
    surface.clip_rect = SDL_Rect{0, 0, width, height};
    surface.refcount = 1;
}

/// The window as a surface.
inline SDL_Surface* window_surface() {
    static SDL_Surface surface;
    set_surface(surface, canvas().width, canvas().height, canvas().pixels);
    return &surface;
}

// Without a sanitizer's check a null surface is a crash, which leads to the program's own line.
__attribute__((no_sanitize("undefined"))) inline bool is_window(const SDL_Surface* surface) {
    return surface->pixels == canvas().pixels;
}

inline Uint32& pixel_of(const SDL_Surface* surface, int x, int y) {
    auto* row = static_cast<Uint8*>(surface->pixels) +
                static_cast<std::ptrdiff_t>(y) * static_cast<std::ptrdiff_t>(surface->pitch);
    return reinterpret_cast<Uint32*>(row)[x];
}

/// The part of a rectangle that is in the surface; of none, all of it.
inline SDL_Rect inside(const SDL_Surface* surface, const SDL_Rect* rectangle) {
    if (rectangle == nullptr) return SDL_Rect{0, 0, surface->w, surface->h};
    const long right = static_cast<long>(rectangle->x) + rectangle->w;
    const long bottom = static_cast<long>(rectangle->y) + rectangle->h;
    SDL_Rect part = *rectangle;
    if (part.x < 0) part.x = 0;
    if (part.y < 0) part.y = 0;
    part.w = static_cast<int>((right < surface->w ? right : surface->w) - part.x);
    part.h = static_cast<int>((bottom < surface->h ? bottom : surface->h) - part.y);
    return part;
}

inline float red_of(Uint32 colour) {
    return static_cast<float>(colour >> 16 & 0xff) / 255.0f;
}
inline float green_of(Uint32 colour) {
    return static_cast<float>(colour >> 8 & 0xff) / 255.0f;
}
inline float blue_of(Uint32 colour) {
    return static_cast<float>(colour & 0xff) / 255.0f;
}

} // namespace rasterwalk_kit

inline SDL_Surface* SDL_SetVideoMode(int width, int height, int, Uint32) {
    if (!rasterwalk_kit::open_canvas(width, height)) return nullptr;
    return rasterwalk_kit::window_surface();
}
inline SDL_Surface* SDL_GetVideoSurface() {
    return rasterwalk_kit::window_surface();
}
inline void SDL_WM_SetCaption(const char*, const char*) {}
inline int SDL_WM_ToggleFullScreen(SDL_Surface*) {
    return 1;
}

inline int SDL_LockSurface(SDL_Surface*) {
    return 0;
}
inline void SDL_UnlockSurface(SDL_Surface*) {}

inline Uint32 SDL_MapRGB(const SDL_PixelFormat*, Uint8 red, Uint8 green, Uint8 blue) {
    return static_cast<Uint32>(red) << 16 | static_cast<Uint32>(green) << 8 | blue;
}
inline Uint32 SDL_MapRGBA(const SDL_PixelFormat* format, Uint8 red, Uint8 green, Uint8 blue,
                          Uint8 alpha) {
    return static_cast<Uint32>(alpha) << 24 | SDL_MapRGB(format, red, green, blue);
}
inline void SDL_GetRGB(Uint32 colour, const SDL_PixelFormat*, Uint8* red, Uint8* green,
                       Uint8* blue) {
    *red = static_cast<Uint8>(colour >> 16);
    *green = static_cast<Uint8>(colour >> 8);
    *blue = static_cast<Uint8>(colour);
}

/// All of the window is a clear, and one pixel of it is a put.
inline int SDL_FillRect(SDL_Surface* surface, const SDL_Rect* rectangle, Uint32 colour) {
    using namespace rasterwalk_kit;
    const SDL_Rect part = inside(surface, rectangle);
    if (is_window(surface) && part.x == 0 && part.y == 0 && part.w == surface->w &&
        part.h == surface->h) {
        clear(red_of(colour), green_of(colour), blue_of(colour));
        return 0;
    }
    if (is_window(surface) && rectangle != nullptr && rectangle->w == 1 && rectangle->h == 1) {
        put(rectangle->x, rectangle->y, red_of(colour), green_of(colour), blue_of(colour));
        return 0;
    }
    for (int y = part.y; y < part.y + part.h; ++y) {
        for (int x = part.x; x < part.x + part.w; ++x)
            pixel_of(surface, x, y) = colour;
    }
    return 0;
}

inline void SDL_UpdateRect(SDL_Surface*, Sint32, Sint32, Uint32, Uint32) {
    rasterwalk_kit::use_dialect(rasterwalk_kit::dialect_surface);
    rasterwalk_kit::show();
}
inline void SDL_UpdateRects(SDL_Surface*, int, SDL_Rect*) {
    rasterwalk_kit::show();
}
inline int SDL_Flip(SDL_Surface*) {
    rasterwalk_kit::use_dialect(rasterwalk_kit::dialect_surface);
    rasterwalk_kit::show();
    return 0;
}

/// Nothing is written, but the answer is that all went well.
inline int SDL_SaveBMP(SDL_Surface*, const char*) {
    return 0;
}
/// There are no images to read.
inline SDL_Surface* SDL_LoadBMP(const char*) {
    return nullptr;
}

inline SDL_Surface* SDL_CreateRGBSurface(Uint32, int width, int height, int, Uint32, Uint32, Uint32,
                                         Uint32) {
    if (width < 0 || height < 0) return nullptr;
    auto* surface = new SDL_Surface;
    void* pixels = std::calloc(
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + 1, sizeof(Uint32));
    rasterwalk_kit::set_surface(*surface, width, height, pixels);
    return surface;
}
/// Pixels of the program itself: they are not copied.
inline SDL_Surface* SDL_CreateRGBSurfaceFrom(void* pixels, int width, int height, int, int pitch,
                                             Uint32, Uint32, Uint32, Uint32) {
    auto* surface = new SDL_Surface;
    rasterwalk_kit::set_surface(*surface, width, height, pixels);
    surface->pitch = pitch;
    return surface;
}
/// The memory stays: it may be the window's, or the program's.
inline void SDL_FreeSurface(SDL_Surface*) {}

inline int SDL_BlitSurface(SDL_Surface* from, const SDL_Rect* what, SDL_Surface* to,
                           SDL_Rect* where) {
    using namespace rasterwalk_kit;
    const SDL_Rect part = inside(from, what);
    const int left = where != nullptr ? where->x : 0;
    const int top = where != nullptr ? where->y : 0;
    for (int y = 0; y < part.h; ++y) {
        for (int x = 0; x < part.w; ++x) {
            const int to_x = left + x, to_y = top + y;
            if (to_x < 0 || to_y < 0 || to_x >= to->w || to_y >= to->h) continue;
            pixel_of(to, to_x, to_y) = pixel_of(from, part.x + x, part.y + y);
        }
    }
    return 0;
}
inline SDL_Surface* SDL_DisplayFormat(SDL_Surface* surface) {
    SDL_Surface* copy = SDL_CreateRGBSurface(0, surface->w, surface->h, 32, 0, 0, 0, 0);
    SDL_BlitSurface(surface, nullptr, copy, nullptr);
    return copy;
}
inline SDL_Surface* SDL_ConvertSurface(SDL_Surface* surface, const SDL_PixelFormat*, Uint32) {
    return SDL_DisplayFormat(surface);
}
