#pragma once

// What drawing a frame takes, counted stage by stage: of a whole frame, of one triangle, and of
// each pixel. The frame is drawn again under an observer, and what its shader does is done once
// more to be counted; so drawing itself counts nothing and loses no time.
//
// Source: that the cost of a picture is the sum over its stages, and that overdraw, lights and
// texture reads are where it goes: T. Akenine-Moeller, E. Haines, N. Hoffman, "Real-Time
// Rendering", 4th edition, 2018, chapter 18.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"

namespace rasterwalk {

/// The work of the stages. The picture has only what falls inside it.
///
/// Bytes are those of the planes and textures as this program has them: 4 for a depth, 12 for a
/// colour in the picture or in a texture, which is three floats. The planes that only explain,
/// owner and overdraw, do not count, and neither does clearing.
struct DrawCost {
    std::int64_t vertices = 0;      ///< taken through the vertex shader, each once
    std::int64_t vertex_lights = 0; ///< vertices, or whole triangles, whose light is worked out
    std::int64_t edge_samples = 0;  ///< entered in row tables, by coverage that walks edges
    std::int64_t pixels_tested = 0; ///< by edge functions
    std::int64_t fragments = 0;     ///< inside the picture; before the fill stage, none
    std::int64_t depth_tests = 0;   ///< of fragments, or of their samples, with the depth buffer
    std::int64_t shaded = 0;        ///< fragments, or samples, whose colour is worked out
    std::int64_t pixel_lights = 0;  ///< those of them whose light is worked out
    std::int64_t shadow_tests = 0;  ///< rays to the lamp, or texels of a shadow map looked at
    std::int64_t texels = 0;        ///< read from textures, normal maps and height maps
    std::int64_t written = 0;       ///< fragments that passed everything: put into the picture
    std::int64_t depth_bytes = 0;   ///< read by depth tests, and written where they passed
    std::int64_t colour_bytes = 0;  ///< written to the picture, and read from it for blending
    std::int64_t texture_bytes = 0; ///< of the texels

    friend bool operator==(const DrawCost&, const DrawCost&) = default;
};

/// One of these counts in words.
struct CostInfo {
    std::string_view name;  ///< in facts and JSON
    std::string_view title; ///< in panels
    std::string_view help;  ///< for "Counts ...", without a full stop
    std::int64_t DrawCost::*count;
    bool is_of_triangle = true; ///< false: vertices are shared, so no triangle has its own
};

/// All of them, in the order of the pipeline.
inline constexpr std::size_t cost_count = 14;
const std::array<CostInfo, cost_count>& cost_list();

/// The part of it that belongs to one pixel.
struct PixelCost {
    std::uint32_t fragments = 0, depth_tests = 0, shaded = 0, lights = 0, shadow_tests = 0,
                  texels = 0, written = 0;

    /// All of it, each thing counted as one, however long it takes: fragments, depth tests, lights,
    /// shadow tests and texels.
    std::uint32_t total() const { return fragments + depth_tests + lights + shadow_tests + texels; }
    friend bool operator==(const PixelCost&, const PixelCost&) = default;
};

/// Adds what is done before anything is drawn: the vertices of the frame, here those from `first`
/// up to `end`.
void add_vertex_cost(const Frame& frame, std::size_t first, std::size_t end, DrawCost& cost);

/// Draws the part of a frame between two moments, and adds what that takes. Edge samples and tested
/// pixels are those of triangles that begin in the part, so the costs of consecutive parts can be
/// added.
/// @param framebuffer has everything before the part
/// @param pixels      receives the cost of each pixel of the picture, row by row from the top; or
///                    null
void add_cost(const Frame& frame, const Cursor& from, const Cursor& to, Framebuffer& framebuffer,
              DrawCost& cost, std::vector<PixelCost>* pixels);

/// What it takes to draw everything before `to`, vertices included.
DrawCost draw_cost(const Frame& frame, const Cursor& to = cursor_end,
                   std::vector<PixelCost>* pixels = nullptr);

/// What one triangle takes, drawn into the picture as it is when its turn comes.
DrawCost triangle_cost(const Frame& frame, int triangle);

} // namespace rasterwalk
