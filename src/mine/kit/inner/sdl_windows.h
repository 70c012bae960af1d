#pragma once

// Part of SDL.h: windows, renderers and textures of SDL 2. There is one window. A texture that is
// copied to it and shown becomes the picture, in the texture's own size.

#include <vector>

#include "../runtime.h"
#include "sdl_surfaces.h"
#include "sdl_types.h"

#define SDL_WINDOWPOS_UNDEFINED 0x1FFF0000
#define SDL_WINDOWPOS_CENTERED 0x2FFF0000

enum : Uint32 {
    SDL_WINDOW_FULLSCREEN = 1,
    SDL_WINDOW_OPENGL = 2,
    SDL_WINDOW_SHOWN = 4,
    SDL_WINDOW_HIDDEN = 8,
    SDL_WINDOW_BORDERLESS = 0x10,
    SDL_WINDOW_RESIZABLE = 0x20,
    SDL_WINDOW_FULLSCREEN_DESKTOP = 0x1001,
    SDL_WINDOW_ALLOW_HIGHDPI = 0x2000,
    SDL_RENDERER_SOFTWARE = 1,
    SDL_RENDERER_ACCELERATED = 2,
    SDL_RENDERER_PRESENTVSYNC = 4,
    SDL_RENDERER_TARGETTEXTURE = 8
};

enum SDL_TextureAccess {
    SDL_TEXTUREACCESS_STATIC,
    SDL_TEXTUREACCESS_STREAMING,
    SDL_TEXTUREACCESS_TARGET
};
enum SDL_BlendMode {
    SDL_BLENDMODE_NONE,
    SDL_BLENDMODE_BLEND,
    SDL_BLENDMODE_ADD,
    SDL_BLENDMODE_MOD
};

/// Where the colours are in the bytes of a pixel.
enum : Uint32 {
    SDL_PIXELFORMAT_ARGB8888,
    SDL_PIXELFORMAT_RGB888,
    SDL_PIXELFORMAT_RGBA8888,
    SDL_PIXELFORMAT_RGBX8888,
    SDL_PIXELFORMAT_ABGR8888,
    SDL_PIXELFORMAT_BGR888,
    SDL_PIXELFORMAT_BGRA8888,
    SDL_PIXELFORMAT_BGRX8888,
    SDL_PIXELFORMAT_RGB24,
    SDL_PIXELFORMAT_BGR24,
    SDL_PIXELFORMAT_ARGB32 = SDL_PIXELFORMAT_BGRA8888,
    SDL_PIXELFORMAT_RGBA32 = SDL_PIXELFORMAT_ABGR8888,
    SDL_PIXELFORMAT_BGRA32 = SDL_PIXELFORMAT_ARGB8888,
    SDL_PIXELFORMAT_ABGR32 = SDL_PIXELFORMAT_RGBA8888
};

struct SDL_Window {
    int w, h;
};
struct SDL_Texture {
    Uint32 format;
    int access, w, h, bytes_per_pixel;
    std::vector<Uint8> pixels;
};
struct SDL_Renderer {
    SDL_Window* window;
    SDL_Texture* copied;   ///< since the last frame; null: none
    bool is_to_be_cleared; ///< before the first point is drawn
    SDL_Color background;  ///< of that
    SDL_Color colour;      ///< what is drawn next has this
};

namespace rasterwalk_kit {

/// A pixel of a texture as 0xRRGGBB.
inline Uint32 colour_of(const SDL_Texture& texture, std::size_t pixel) {
    const Uint8* bytes =
        texture.pixels.data() + pixel * static_cast<std::size_t>(texture.bytes_per_pixel);
    int red = 2, green = 1, blue = 0; // places of the bytes, the lowest first
    switch (texture.format) {
    case SDL_PIXELFORMAT_RGBA8888:
    case SDL_PIXELFORMAT_RGBX8888:
        red = 3, green = 2, blue = 1;
        break;
    case SDL_PIXELFORMAT_ABGR8888:
    case SDL_PIXELFORMAT_BGR888:
    case SDL_PIXELFORMAT_RGB24:
        red = 0, green = 1, blue = 2;
        break;
    case SDL_PIXELFORMAT_BGRA8888:
    case SDL_PIXELFORMAT_BGRX8888:
        red = 1, green = 2, blue = 3;
        break;
    default:
        break;
    }
    return static_cast<Uint32>(bytes[red]) << 16 | static_cast<Uint32>(bytes[green]) << 8 |
           bytes[blue];
}

/// The texture becomes the picture. Pixels that are in the picture already stay as they were put.
inline void show_texture(const SDL_Texture& texture) {
    const bool is_as_large = canvas().width == texture.w && canvas().height == texture.h;
    if (!is_as_large && !open_canvas(texture.w, texture.h)) return;
    const std::size_t count =
        static_cast<std::size_t>(texture.w) * static_cast<std::size_t>(texture.h);
    for (std::size_t i = 0; i < count; ++i) {
        const Uint32 colour = colour_of(texture, i);
        if ((canvas().pixels[i] & 0xffffff) != colour) canvas().pixels[i] = colour;
    }
}

inline Uint32 packed(const SDL_Color& colour) {
    return SDL_MapRGB(nullptr, colour.r, colour.g, colour.b);
}

inline void clear_as_wanted(SDL_Renderer& renderer) {
    const Uint32 colour = packed(renderer.background);
    if (renderer.is_to_be_cleared) clear(red_of(colour), green_of(colour), blue_of(colour));
    renderer.is_to_be_cleared = false;
}

} // namespace rasterwalk_kit

inline SDL_Window* SDL_CreateWindow(const char*, int, int, int width, int height, Uint32) {
    if (!rasterwalk_kit::open_canvas(width, height)) return nullptr;
    return new SDL_Window{width, height};
}
inline void SDL_DestroyWindow(SDL_Window*) {}
inline void SDL_SetWindowTitle(SDL_Window*, const char*) {}
inline int SDL_SetWindowFullscreen(SDL_Window*, Uint32) {
    return 0;
}
inline void SDL_SetWindowPosition(SDL_Window*, int, int) {}
inline void SDL_ShowWindow(SDL_Window*) {}
inline void SDL_RaiseWindow(SDL_Window*) {}
inline void SDL_WarpMouseInWindow(SDL_Window*, int, int) {}
inline void SDL_GetWindowSize(SDL_Window* window, int* width, int* height) {
    if (width != nullptr) *width = window->w;
    if (height != nullptr) *height = window->h;
}
inline SDL_Surface* SDL_GetWindowSurface(SDL_Window*) {
    return rasterwalk_kit::window_surface();
}
inline int SDL_UpdateWindowSurface(SDL_Window*) {
    rasterwalk_kit::show();
    return 0;
}

inline SDL_Renderer* SDL_CreateRenderer(SDL_Window* window, int, Uint32) {
    return new SDL_Renderer{window, nullptr, false, {0, 0, 0, 255}, {0, 0, 0, 255}};
}
inline int SDL_CreateWindowAndRenderer(int width, int height, Uint32 flags, SDL_Window** window,
                                       SDL_Renderer** renderer) {
    *window = SDL_CreateWindow("", 0, 0, width, height, flags);
    *renderer = SDL_CreateRenderer(*window, -1, 0);
    return *window != nullptr ? 0 : -1;
}
inline void SDL_DestroyRenderer(SDL_Renderer*) {}
inline int SDL_RenderSetLogicalSize(SDL_Renderer*, int, int) {
    return 0;
}
inline int SDL_RenderSetScale(SDL_Renderer*, float, float) {
    return 0;
}
inline int SDL_GetRendererOutputSize(SDL_Renderer* renderer, int* width, int* height) {
    SDL_GetWindowSize(renderer->window, width, height);
    return 0;
}
inline int SDL_SetRenderDrawBlendMode(SDL_Renderer*, SDL_BlendMode) {
    return 0;
}
inline int SDL_SetRenderDrawColor(SDL_Renderer* renderer, Uint8 red, Uint8 green, Uint8 blue,
                                  Uint8 alpha) {
    renderer->colour = SDL_Color{red, green, blue, alpha};
    return 0;
}

/// Clears what the renderer draws. Pixels that the helper keeps in a buffer of its own, and shows
/// as a texture, are not cleared by it.
inline int SDL_RenderClear(SDL_Renderer* renderer) {
    renderer->is_to_be_cleared = true;
    renderer->background = renderer->colour;
    return 0;
}
inline int SDL_RenderDrawPoint(SDL_Renderer* renderer, int x, int y) {
    using namespace rasterwalk_kit;
    clear_as_wanted(*renderer);
    const Uint32 colour = packed(renderer->colour);
    put(x, y, red_of(colour), green_of(colour), blue_of(colour));
    return 0;
}

inline SDL_Texture* SDL_CreateTexture(SDL_Renderer*, Uint32 format, int access, int width,
                                      int height) {
    if (width < 1 || height < 1) return nullptr;
    const int bytes = format == SDL_PIXELFORMAT_RGB24 || format == SDL_PIXELFORMAT_BGR24 ? 3 : 4;
    const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                             static_cast<std::size_t>(bytes);
    return new SDL_Texture{format, access, width, height, bytes, std::vector<Uint8>(size)};
}
inline void SDL_DestroyTexture(SDL_Texture*) {}
inline int SDL_QueryTexture(SDL_Texture* texture, Uint32* format, int* access, int* width,
                            int* height) {
    if (format != nullptr) *format = texture->format;
    if (access != nullptr) *access = texture->access;
    if (width != nullptr) *width = texture->w;
    if (height != nullptr) *height = texture->h;
    return 0;
}
inline int SDL_SetTextureBlendMode(SDL_Texture*, SDL_BlendMode) {
    return 0;
}

inline int SDL_UpdateTexture(SDL_Texture* texture, const SDL_Rect* rectangle, const void* pixels,
                             int pitch) {
    const SDL_Rect part =
        rectangle != nullptr ? *rectangle : SDL_Rect{0, 0, texture->w, texture->h};
    if (part.x < 0 || part.y < 0 || part.w < 0 || part.h < 0 || part.w > texture->w - part.x ||
        part.h > texture->h - part.y) {
        return -1;
    }
    const std::size_t bytes = static_cast<std::size_t>(texture->bytes_per_pixel);
    for (int y = 0; y < part.h; ++y) {
        const std::size_t first =
            static_cast<std::size_t>(part.y + y) * static_cast<std::size_t>(texture->w) +
            static_cast<std::size_t>(part.x);
        std::memcpy(texture->pixels.data() + first * bytes,
                    static_cast<const Uint8*>(pixels) + static_cast<std::ptrdiff_t>(y) * pitch,
                    static_cast<std::size_t>(part.w) * bytes);
    }
    return 0;
}
inline int SDL_LockTexture(SDL_Texture* texture, const SDL_Rect*, void** pixels, int* pitch) {
    *pixels = texture->pixels.data();
    *pitch = texture->w * texture->bytes_per_pixel;
    return 0;
}
inline void SDL_UnlockTexture(SDL_Texture*) {}
inline SDL_Texture* SDL_CreateTextureFromSurface(SDL_Renderer* renderer, SDL_Surface* surface) {
    SDL_Texture* texture = SDL_CreateTexture(renderer, SDL_PIXELFORMAT_ARGB8888,
                                             SDL_TEXTUREACCESS_STATIC, surface->w, surface->h);
    if (texture != nullptr) SDL_UpdateTexture(texture, nullptr, surface->pixels, surface->pitch);
    return texture;
}

inline int SDL_RenderCopy(SDL_Renderer* renderer, SDL_Texture* texture, const SDL_Rect*,
                          const SDL_Rect*) {
    renderer->copied = texture;
    return 0;
}
inline void SDL_RenderPresent(SDL_Renderer* renderer) {
    if (renderer->copied != nullptr) {
        rasterwalk_kit::show_texture(*renderer->copied);
    } else {
        rasterwalk_kit::clear_as_wanted(*renderer);
    }
    renderer->copied = nullptr;
    renderer->is_to_be_cleared = false;
    rasterwalk_kit::show();
}
