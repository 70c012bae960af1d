#pragma once

// What OpenGL is given to draw a picture: numbers in the order in which its buffers hold them. The
// file needs no OpenGL, so that a program without it can send a task to one that has it.

#include <cstdint>
#include <string>
#include <vector>

#include "engines/fast/fast_data.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// A corner of a triangle: an attribute for each member. No triangle shares its corners, because
/// each carries the triangle's number.
struct OpenGlCorner {
    float place[3];       ///< world
    float lit_place[3];   ///< where a corner is lit: at `place`, or in the middle of the triangle
    float normal[3];      ///< world
    float reflectance[3]; ///< red green blue
    float texcoord[2];    ///< u, and v from the top
    float specular[3];    ///< of the triangle; 0: no highlight
    float exponent;       ///< of the highlight
    std::int32_t owner;   ///< number of the triangle in the scene
};

/// Consecutive triangles with one texture.
struct OpenGlRun {
    std::int32_t first_triangle, triangle_count;
    std::int32_t texture; ///< -1: none
};

/// A texture with 8 bits per channel.
struct OpenGlTexture {
    std::int32_t width, height;
    std::vector<std::uint32_t> texels; ///< 0xffBBGGRR, row by row from the top
};

/// What a picture is made of, besides the view.
enum class OpenGlSurface : std::int32_t {
    lines,    ///< white outlines; the last one drawn is seen
    unsorted, ///< filled, without a depth test: the last triangle drawn is seen
    nearest,  ///< filled, with a depth test
};

struct OpenGlTask {
    fast::View view{};
    OpenGlSurface surface = OpenGlSurface::nearest;
    std::vector<OpenGlCorner> corners; ///< three for each triangle
    std::vector<OpenGlRun> runs;
    std::vector<OpenGlTexture> textures; ///< only those that a run shows have texels

    std::int32_t triangle_count() const { return static_cast<std::int32_t>(corners.size() / 3); }
};

/// The task of drawing a scene. Triangles with a corner that fails is_place() are left out.
OpenGlTask opengl_task(const Scene& scene, const Settings& settings);

/// A task as bytes, for a program on the same machine, and back. Throws InputError if the bytes are
/// no task that can be drawn.
std::string bytes_of(const OpenGlTask& task);
OpenGlTask opengl_task_from(const std::string& bytes);

} // namespace rasterwalk
