#pragma once

#include <vector>

#include <imgui.h>

#include "ui/hosts/host_state.h"

namespace rasterwalk {

struct Ui;

/// ImGui drawn with OpenGL 2, in a browser with WebGL 2, for all hosts: the window, the page and
/// the pictures share one path. All of this needs the host's context to be current and an ImGui
/// context to exist.
///
/// Pictures become textures with hard pixel edges. One that is larger than the graphics system can
/// hold is thinned out to fit.
class Gl2Textures : public TextureHost {
  public:
    ImTextureID upload(ImTextureID old, const Image& image) override;
    /// Deletes the textures; the context must still exist.
    void release();
    /// The graphics system has lost the textures' contents; their names stay valid.
    void forget_contents();

  private:
    struct Texture {
        unsigned name;
        int width, height;
    };
    std::vector<Texture> textures_;
};

/// Begins and ends ImGui's renderer.
void open_gl2();
void close_gl2();

/// To be called before build_ui, each frame.
void begin_gl2_frame();

/// Draws what build_ui built, over the theme's background. Takes up new fonts.
/// @param width,height of the framebuffer, pixels
void draw_gl2(Ui& ui, int width, int height);

/// The picture just drawn: upright and opaque.
Image read_gl2(int width, int height);

/// The widest or highest picture that can be drawn to, pixels.
int largest_gl2_side();

} // namespace rasterwalk
