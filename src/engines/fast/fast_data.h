#pragma once

// The data that the loops of the fast engine read and write. The loops are compiled once for each
// level of instructions (fast_loops.h), so this header holds only plain data: an inline function
// here would be one function for all levels, compiled for any of them.

#include <cstdint>

namespace rasterwalk::fast {

/// The most lanes of any level. Arrays that loops go through in lanes have room for this many more.
inline constexpr int most_lanes = 16;

/// Screen coordinates are whole 256ths of a pixel, y down.
inline constexpr int subpixel_bits = 8;
inline constexpr int subpixels = 1 << subpixel_bits;

/// Vertices are drawn uncut up to this many pixels from the picture's corner; triangles that go
/// farther are cut.
inline constexpr float guard_band = 8192.0f;

/// Four adjacent numbers, so that one load takes all of them.
struct alignas(16) Record {
    float a, b, c, d;
};

/// A vertex on the screen.
struct alignas(16) ScreenVertex {
    std::int32_t x, y; ///< 256ths of a pixel
    float inv_z;       ///< 1/z of the camera's space; see the two marks
    float unused;
};
/// Marks in place of 1/z: the vertex is nearer than the near plane, or beyond the guard band.
inline constexpr float behind_near = 0.0f, beyond_guard = -1.0f;

/// A triangle: for each corner the offset in bytes of its records from the first, and its material.
/// All data of a vertex are in records of 16 bytes.
struct alignas(16) Corners {
    std::int32_t a, b, c, material;
};
inline constexpr int record_size = 16;
static_assert(sizeof(Record) == record_size && sizeof(Corners) == record_size);

/// The light a vertex gets, before power and reflectance: see light_vertices().
struct alignas(16) VertexLight {
    float diffuse, highlight;
    float unused[2];
};
static_assert(sizeof(ScreenVertex) == record_size && sizeof(VertexLight) == record_size);

/// A texture with 8 bits per channel, 0x00BBGGRR.
struct Texels {
    const std::uint32_t* texels;
    std::int32_t width, height;
};

struct Material {
    float reflectance[3];
    float specular[3];
    float exponent;
    std::int32_t has_highlight;
    std::int32_t has_colours; ///< the reflectance is that of the vertices
    std::int32_t texture;     ///< -1: none
};

/// What comes beyond the borders of a texture, in the order of TextureWrap.
enum class Wrap : std::int32_t { repeat, clamp, mirror };

/// Where light is worked out.
enum class LightAt : std::int32_t { nowhere, vertices, pixels };

/// The mesh in arrays, one for each number of the vertices. The triangles that cutting has made for
/// one picture start at triangle_count, and their vertices follow those of the scene.
struct Mesh {
    const float *x, *y, *z;  ///< world
    const Record* normals;   ///< world, unit length; d is 0
    const Record* colours;   ///< reflectance; null if no material has colours
    const Record* texcoords; ///< a = u, b = v; null without textures
    const float* exponents;  ///< of the highlight at each vertex; null without
    const Corners* triangles;
    const Material* materials;
    const Texels* textures;
    ScreenVertex* screen;
    VertexLight* light;          ///< only if LightAt is vertices
    std::int32_t triangle_count; ///< without those of cutting
};

/// Values that are the same for a whole picture.
struct View {
    std::int32_t width, height;
    float eye[3];       ///< world
    float axes[3][3];   ///< right, down and forward of the camera, in the world
    float focal_length; ///< pixels
    float middle[2];    ///< column and row of the middle of the picture, pixels
    float near;         ///< of the view volume
    float lamp[3];      ///< world
    float power[3], indirect[3];
    float exponent; ///< of all highlights; 0: each material's own
    std::int32_t has_highlights, shows_textures;
    std::int32_t culls_backs; ///< triangles whose corners go round counterclockwise on the screen
    LightAt light_at;
    Wrap wrap;
    std::int32_t is_bilinear;
};

/// Some triangles: their numbers in the mesh, and their corners as in Corners.
struct TriangleList {
    std::int32_t *number, *a, *b, *c; ///< room for all triangles and most_lanes more
    std::int32_t count;
};

/// The triangles that can reach a band of rows, by their size on the screen.
struct BandLists {
    std::int32_t first_row, end_row;
    TriangleList* tiny;   ///< up to tiny_size on both sides: lanes are triangles
    TriangleList* small;  ///< the same up to small_size
    TriangleList* medium; ///< up to medium_size: lanes are pixels, in whole numbers
    TriangleList* large;  ///< row by row
};
/// In pixels.
inline constexpr int tiny_size = 2, small_size = 4, medium_size = 64;

/// The edges of a large triangle, or of two that are drawn as one.
inline constexpr int large_edges = 4;

/// A large triangle, row by row between its edges; or two that form a convex quadrilateral in one
/// plane with one light.
struct LargeTriangle {
    std::int32_t number; ///< for two: the first's
    std::int32_t first_row, end_row;
    double edge_x[large_edges], edge_y[large_edges], edge_slope[large_edges];
    std::int32_t edge_is_left[large_edges];
    std::int32_t edge_count;
    /// 1/z is z_start + z_right x + z_down y, at the centre of the pixel (x, y).
    double z_start, z_right, z_down;
    double nearest; ///< 1/z of the nearest corner
    /// Light in closed form, see large_triangle.h.
    std::int32_t has_flat_light;
    float reach_start[3], reach_right[3], reach_down[3];
    float reach_square;        ///< of reach_right
    float gain[3], ambient[3]; ///< red green blue, of 255
    std::int32_t may_be_white; ///< can a channel exceed 255?
};

/// How many rows the large triangles are worked out for at a time.
inline constexpr int block_rows = 16;

/// A large triangle in each row of a block.
struct alignas(64) LargeRows {
    std::int32_t begin[block_rows], end[block_rows]; ///< columns; none if end <= begin
    float inv_z[block_rows];                         ///< at column 0
    float quadratic_0[block_rows], quadratic_1[block_rows];
    const LargeTriangle* triangle;
};

/// A pixel of the visibility buffer: 1/z in the upper half, as the bits of a float, and the
/// complement of a triangle's number in the lower. The largest number at a pixel is visible: the
/// nearest triangle, and the first one if two are equally near. 0: nothing.
using Visible = std::int64_t;

/// Where a picture is drawn.
struct Planes {
    std::int32_t stride;   ///< numbers from row to row, in all planes
    std::uint32_t* colour; ///< 0x00RRGGBB
    Visible* visible;      ///< of tiny, small and medium triangles; null if there are none
    /// 1/z and owner; one block of rows for all if they are not kept.
    float* inv_z;
    std::int32_t* owner; ///< while a row is drawn: a triangle of the mesh whose colour is not yet
                         ///< worked out, ~t for a triangle t of the scene whose colour is, or
                         ///< `no_owner`; at the end -1 or a triangle of the scene
    std::int32_t is_kept;
};
inline constexpr std::int32_t no_owner = INT32_MIN;

/// A band of rows, and the working memory for it.
struct Band {
    std::int32_t first_row, end_row;
    const LargeTriangle* large; ///< nearest first
    std::int32_t large_count;
    LargeRows* rows;              ///< room for large_count
    const std::int32_t* source;   ///< numbers of the mesh's triangles in the scene
    const std::int32_t* cut_from; ///< of the triangles made by cutting: the mesh's
};

/// The loops, as compiled for one level.
struct Loops {
    /// To the screen, by the pinhole camera; first and count are multiples of most_lanes.
    void (*project_vertices)(const Mesh&, const View&, std::int32_t first, std::int32_t count);
    /// Light per vertex of the same vertices.
    void (*light_vertices)(const Mesh&, const View&, std::int32_t first, std::int32_t count);
    /// Adds triangles to the lists of the bands that they can reach, and to `cut` those with a
    /// corner that has no position on the screen.
    void (*sort_triangles)(const Mesh&, const View&, std::int32_t first, std::int32_t end,
                           const BandLists* bands, std::int32_t band_count, TriangleList& cut);
    /// Triangles of each size into the visibility buffer.
    void (*draw_tiny)(const Mesh&, const View&, const TriangleList&, const Band&, const Planes&);
    void (*draw_small)(const Mesh&, const View&, const TriangleList&, const Band&, const Planes&);
    void (*draw_medium)(const Mesh&, const View&, const TriangleList&, const Band&, const Planes&);
    /// The large triangles, row by row, and then the colour of every pixel.
    void (*finish_rows)(const Mesh&, const View&, const Band&, const Planes&);
};

const Loops& scalar_loops();
// Defined by CMakeLists.txt, which then compiles each file for its instructions.
#if defined(RASTERWALK_X86_LOOPS)
const Loops& sse2_loops();
const Loops& clones_loops();
const Loops& avx2_loops();
const Loops& avx512_loops();
#endif

} // namespace rasterwalk::fast
