#include "ui/hosts/gl2.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#ifdef __EMSCRIPTEN__ // WebGL 2, with ImGui's renderer for OpenGL 3; everything else is the same
#include <GLES3/gl3.h>
#include <backends/imgui_impl_opengl3.h>
#else
#include <GL/gl.h>
#include <backends/imgui_impl_opengl2.h>
#endif

#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

/// ImGui's renderer.
namespace renderer {
#ifdef __EMSCRIPTEN__
constexpr auto init = [] { ImGui_ImplOpenGL3_Init(); };
constexpr auto shut_down = ImGui_ImplOpenGL3_Shutdown;
constexpr auto begin_frame = ImGui_ImplOpenGL3_NewFrame;
constexpr auto make_font_texture = ImGui_ImplOpenGL3_CreateFontsTexture;
constexpr auto render = ImGui_ImplOpenGL3_RenderDrawData;
#else
constexpr auto init = ImGui_ImplOpenGL2_Init;
constexpr auto shut_down = ImGui_ImplOpenGL2_Shutdown;
constexpr auto begin_frame = ImGui_ImplOpenGL2_NewFrame;
constexpr auto make_font_texture = ImGui_ImplOpenGL2_CreateFontsTexture;
constexpr auto render = ImGui_ImplOpenGL2_RenderDrawData;
#endif
} // namespace renderer

ImTextureID as_id(GLuint name) {
    return ImTextureID(static_cast<std::intptr_t>(name));
}

GLuint as_name(ImTextureID id) {
    return static_cast<GLuint>(std::intptr_t(id));
}

/// Every n-th column and row, with the smallest n that makes the sides at most `largest`.
Image thinned_out(const Image& image, int largest) {
    const int step = (std::max(image.width, image.height) + largest - 1) / largest;
    Image small;
    small.width = (image.width + step - 1) / step;
    small.height = (image.height + step - 1) / step;
    small.rgba.reserve(4 * static_cast<std::size_t>(small.width) *
                       static_cast<std::size_t>(small.height));
    for (int row = 0; row < image.height; row += step) {
        for (int column = 0; column < image.width; column += step) {
            const auto pixel =
                image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(row) * image.width + column);
            small.rgba.insert(small.rgba.end(), pixel, pixel + 4);
        }
    }
    return small;
}

void set_filter(GLint filter) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void set_pixels(int width, int height, const void* rgba) {
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
}

/// Puts new glyphs into the texture that the draw lists already name.
void renew_font_texture() {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    if (atlas.TexID == ImTextureID{}) {
        renderer::make_font_texture();
        return;
    }
    unsigned char* rgba = nullptr;
    int width = 0, height = 0;
    atlas.GetTexDataAsRGBA32(&rgba, &width, &height);
    glBindTexture(GL_TEXTURE_2D, as_name(atlas.TexID));
    set_pixels(width, height, rgba);
    // The atlas may be kept: it makes them again from one byte a pixel when they are needed.
    ImGui::MemFree(atlas.TexPixelsRGBA32);
    atlas.TexPixelsRGBA32 = nullptr;
}

} // namespace

int largest_gl2_side() {
    GLint side = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
    GLint viewport[2] = {0, 0};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    return std::min({side, viewport[0], viewport[1]});
}

ImTextureID Gl2Textures::upload(ImTextureID old, const Image& image) {
    if (image.width <= 0 || image.height <= 0) return old;
    static const GLint largest = [] { // once: a browser answers when all before it is drawn
        GLint side = 64;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
        return side;
    }();
    if (std::max(image.width, image.height) > largest) {
        return upload(old, thinned_out(image, largest));
    }
    auto found = std::find_if(textures_.begin(), textures_.end(),
                              [&](const Texture& t) { return t.name == as_name(old); });
    if (old == ImTextureID{} || found == textures_.end()) {
        GLuint name = 0;
        glGenTextures(1, &name);
        textures_.push_back({name, 0, 0});
        found = textures_.end() - 1;
    }
    glBindTexture(GL_TEXTURE_2D, found->name);
    if (found->width == image.width && found->height == image.height) {
        glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGBA,
                        GL_UNSIGNED_BYTE, image.rgba.data());
    } else {
        set_filter(GL_NEAREST);
        set_pixels(image.width, image.height, image.rgba.data());
        found->width = image.width;
        found->height = image.height;
    }
    return as_id(found->name);
}

void Gl2Textures::release() {
    for (const Texture& texture : textures_)
        glDeleteTextures(1, &texture.name);
    textures_.clear();
}

void Gl2Textures::forget_contents() {
    for (Texture& texture : textures_)
        texture.width = texture.height = 0;
}

void open_gl2() {
    renderer::init();
}

void close_gl2() {
    renderer::shut_down();
}

void begin_gl2_frame() {
    renderer::begin_frame();
}

void draw_gl2(Ui& ui, int width, int height) {
    if (ui.host.fonts_changed) {
        renew_font_texture();
        ui.host.fonts_changed = false;
    }
    const ImVec4& ground = palette(ui.options.theme).ground;
    glViewport(0, 0, width, height);
    glClearColor(ground.x, ground.y, ground.z, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    drop_empty_lists(*ImGui::GetDrawData());
    renderer::render(ImGui::GetDrawData());
}

Image read_gl2(int width, int height) {
    Image image;
    image.width = width;
    image.height = height;
    const std::size_t line = 4 * static_cast<std::size_t>(width);
    const auto lines = static_cast<std::size_t>(height);
    std::vector<std::uint8_t> read(line * lines);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
    image.rgba.resize(read.size());
    std::uint8_t* const rgba = image.rgba.data();
    // OpenGL counts rows from below.
    for (std::size_t row = 0; row < lines; ++row)
        std::copy_n(read.data() + line * (lines - 1 - row), line, rgba + line * row);
    for (std::size_t i = 3; i < read.size(); i += 4)
        rgba[i] = 255;
    return image;
}

} // namespace rasterwalk
