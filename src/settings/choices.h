#pragma once

// The settings that choose a function for a slot of the table of stages, the right one or a
// mistake, each with its words. stage_functions.cpp says which function a word means.

#include <array>
#include <cstdint>

#include "base/enum_words.h"

namespace rasterwalk {

/// What draws the whole picture.
enum class Engine : std::uint8_t {
    steps,  ///< this pipeline: you can walk through all its moments
    fast,   ///< src/engines/fast: no moments, but the same picture in a fraction of the time
    rays,   ///< src/engines/rays: for each pixel, the triangle that its ray meets first
    opengl, ///< the machine's own OpenGL, where the program has one
};

/// Do surfaces mirror what is around them? Only rays can tell.
enum class Mirrors : std::uint8_t {
    off,
    on, ///< as much as the material's highlight: its specular share
};

/// What happens to triangles that reach out of the view volume.
enum class Clip : std::uint8_t {
    leave_out,  ///< not drawn if a vertex is on or behind the camera plane: the lab
    none,       ///< nothing: what is behind the camera is divided by z too, which mirrors it: B13
    near,       ///< cut by the near plane
    all,        ///< cut by all six planes
    guard_band, ///< cut by near, far and four sides far outside the picture
    whole_only, ///< left out if one vertex is outside the view: mistake B16
    wrong_t,    ///< cut by the near plane, in a wrong place: mistake B31
    after_division, ///< cut by the picture's sides on the screen: mistake B32
    clamped,        ///< vertices behind the near plane are moved onto it: mistake B33
    uncut_varyings, ///< cut by the near plane, but not what travels with the position: mistake B82
};

/// Which triangles are rejected as outside before they are clipped.
enum class Reject : std::uint8_t {
    none,     ///< none: the lab
    outcodes, ///< those whose vertices are all beyond the same plane of the view volume
    cheap,    ///< the same, and of the rest all that is outside the picture: cheap clipping
};

/// What is left out because it faces away: triangles, or single fragments.
enum class Cull : std::uint8_t {
    none,            ///< none: the lab
    face_normal,     ///< triangles whose normal points away from the camera
    screen_area,     ///< triangles whose corners go round the other way on the screen
    vertex_normals,  ///< triangles whose vertex normals all point away from the camera
    fragment_normal, ///< fragments whose interpolated normal points away from the camera
    view_axis,       ///< triangles whose normal points the way the camera looks: mistake B34
    lamp,            ///< triangles whose normal points away from the lamp: mistake B81
};

/// How a vertex behind the camera is marked.
enum class BehindMark : std::uint8_t {
    none,      ///< it has no pixel
    minus_one, ///< by column -1, which other vertices can have too: mistake B14
};

/// What happens to a vertex whose pixel is outside the picture.
enum class OutsidePicture : std::uint8_t {
    kept,    ///< it stays where it is
    clamped, ///< it is moved to the picture's border: mistake B15
};

/// How a vertex gets from the world to clip space.
enum class Transform : std::uint8_t {
    lab,      ///< (v - C) R, then times f, in float
    matrices, ///< by a matrix for each space, in double
};

/// Where the view matrix has the translation, written for column vectors.
enum class Translation : std::uint8_t {
    last_column, ///< where w = 1 adds it to x, y and z
    bottom_row,  ///< where it spoils w and moves nothing: mistake B35
};

/// The w that a normal is given on its way to camera space.
enum class NormalW : std::uint8_t {
    zero, ///< as a direction, which is only turned
    one,  ///< as a position, which is moved as well: mistake B36
};

/// The two ends of `projection_mix`.
enum class ProjectionKind : std::uint8_t {
    perspective,  ///< divided by z: the lab
    orthographic, ///< not divided: parallel rays
};

/// What the depth buffer holds: a float of 32 bits, or a whole number of 24 or 16.
enum class DepthFormat : std::uint8_t {
    inv_z,    ///< 1/z, larger is nearer, as a float: the lab
    inv_z_24, ///< the same in equal steps from 0 to 1/near
    inv_z_16,
    ndc_32, ///< ndc z, 0 at the near plane and 1 at the far one, smaller is nearer
    ndc_24,
    ndc_16,
    reversed_32, ///< 1 less ndc z, 1 at the near plane and 0 at the far one, larger is nearer
    reversed_24,
    reversed_16,
};

/// Which side of a matrix the vector is on.
enum class MatrixOrder : std::uint8_t {
    row_vectors,    ///< v M, from left to right: the lab
    column_vectors, ///< M v, from right to left: most books, and glm
};

/// How the camera's rotation is applied.
enum class Rotation : std::uint8_t {
    row_vector, ///< v R
    transposed, ///< R v, which turns the other way: mistake B24
};

/// How the world is moved to the camera, by the lab's lines.
enum class CameraMove : std::uint8_t {
    subtracted,    ///< (v - C) R
    added,         ///< (v + C) R: mistake B70
    rotated_first, ///< v R - C: mistake B71
};

/// How the axes of the picture run.
enum class ImageAxes : std::uint8_t {
    right_way, ///< x right, y down, counted from the middle
    mirrored,  ///< -f for f, which gives the picture half a turn: mistake B25
    exchanged, ///< x down, y right: mistake B73
    uncentred, ///< counted from the upper left corner, without + W/2 and + H/2: mistake B74
};

/// What the w of clip space is, under perspective and with the lab's lines of code.
enum class DividedBy : std::uint8_t {
    z,        ///< how far in front of the camera
    distance, ///< the distance from the camera: mistake B75
};

/// How the pixels of a polygon are found.
enum class Coverage : std::uint8_t {
    rows,            ///< by a row table that the samples of the edges fill: the lab
    edge_functions,  ///< each pixel of the box is tested for its side of every edge
    scan_conversion, ///< row by row between a left and a right side
    active_edges,    ///< row by row between the edges that reach it, of any polygon
};

/// Who gets a pixel whose centre is exactly on an edge.
enum class FillRule : std::uint8_t {
    inclusive, ///< every polygon that has the edge
    exclusive, ///< none
    top_left,  ///< the polygon whose top or left edge it is: exactly one
    left_only, ///< the polygon whose left edge it is; top edges are forgotten: mistake B40c
};

/// The grid that the corners of a polygon are on.
enum class Snap : std::uint8_t {
    pixel,     ///< centres of whole pixels
    sixteenth, ///< 16ths of a pixel
    subpixel,  ///< 256ths of a pixel
};

/// The point at which a pixel is tested for coverage.
enum class PixelSample : std::uint8_t {
    centre, ///< at its centre
    corner, ///< at its upper left corner: mistake B41, the picture moves by half a pixel
};

/// Which pixels of a triangle's box edge functions test. The picture is the same, the work is not.
enum class BoxWalk : std::uint8_t {
    all,      ///< every pixel of the box
    interval, ///< in each row only those between the points where the edges cross it
};

/// The edge whose function gives the weight of a corner.
enum class WeightEdge : std::uint8_t {
    opposite, ///< the edge that does not touch it
    own,      ///< the edge that begins at it: mistake B42
};

/// How the samples of an edge are found.
enum class LineAlgorithm : std::uint8_t {
    interpolate, ///< Interpolate, by line_walk and line_rounding: the lab
    bresenham,   ///< with whole numbers only
    midpoint,    ///< the sign of the implicit line at the middle between two pixels
    dda,         ///< one float addition per step, rounded to the nearest
};

/// How Bresenham's line is written.
enum class BresenhamRule : std::uint8_t {
    right,        ///< for all octants, with the right terms
    first_octant, ///< only for lines that go right and gently down: mistake B38
    wrong_term,   ///< a diagonal step adds -2 l to the decision, not 2 s - 2 l: mistake B39
};

/// How the value of sample i of a line is computed from the two ends.
enum class LineWalk : std::uint8_t {
    accumulate,   ///< current += step, in float: the lab
    multiply,     ///< a + i * step: one rounding error instead of i of them
    exact,        ///< position by integer fractions, without error; the rest by a (1 - t) + b t
    integer_step, ///< the position's step divided as int by int; the rest accumulated: mistake B11
    short_step,   ///< each step divided by the number of samples, not of steps: mistake B92
    zinv_falls,   ///< along rows 1/z falls where it should rise: mistake B89
};

/// How many samples an edge has.
enum class EdgeSamples : std::uint8_t {
    longest_axis, ///< max(|dx|, |dy|) + 1: the lab
    rows,         ///< |dy| + 1: mistake B5, shallow edges get one sample per row
    shifted,      ///< max(|ax - bx + 1|, |ay - by + 1|): mistake B12
    without_last, ///< like the lab, but the last sample is not entered: mistake B91
    no_last_edge, ///< like the lab, but no sample of the last edge is entered: mistake B94
};

/// The initial row table: the two ends of a row without samples, and the number of rows.
enum class RowStart : std::uint8_t {
    extreme,   ///< left at +INT_MAX, right at -INT_MAX: the lab
    window,    ///< left at the picture's width, right at 0: mistake B6, phantom pixels outside it
    row_short, ///< like the lab, but without the last row: mistake B95
};

/// How an edge sample finds its row in the table, and what the row takes from it.
enum class RowSearch : std::uint8_t {
    indexed,     ///< by its own number: row - first_row
    all_rows,    ///< by searching every row of the table, which finds the same one: mistake B27
    clamped,     ///< by its number; beyond the table the nearest row is taken: mistake B93
    column_only, ///< by its number; the row takes the column and no other value: mistake B90
};

/// What happens to a row of the table that no edge sample has reached.
enum class EmptyRows : std::uint8_t {
    skipped,  ///< nothing
    overflow, ///< it is drawn like any other: mistake B7
};

/// Which fragments of a row are drawn.
enum class Spans : std::uint8_t {
    inclusive,      ///< from the left to the right end, both included: the lab
    single_skipped, ///< none if both ends are the same pixel: mistake B8
    last_dropped,   ///< all but the last: mistake B9
};

/// How varyings are carried between vertices.
enum class Interpolation : std::uint8_t {
    perspective, ///< q/z is interpolated and divided by 1/z at the pixel: right
    affine,      ///< q itself is interpolated: wrong except at the vertices; mistake B3
    mixed,       ///< q w is interpolated and divided by w, between affine's 1 and d/z
    zinv_twice,  ///< q/z is multiplied by 1/z again at the ends of a row, divided once: mistake B4
    undivided,   ///< q/z is interpolated and used as q at the pixel: mistake B86
    divided_twice, ///< q/z is interpolated and divided by 1/z twice at the pixel: mistake B87
};

inline constexpr std::size_t interpolation_count = enum_words<Interpolation>.size();

/// All of them, in order.
inline constexpr auto all_interpolations = [] {
    std::array<Interpolation, interpolation_count> all{};
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = static_cast<Interpolation>(i);
    return all;
}();

/// How a position in a texture becomes the number of a texel, and of a mip level.
enum class TexelRule : std::uint8_t {
    right,         ///< v from the top, centres at i + 1/2, numbers from 0
    upside_down,   ///< v from the bottom: mistake B65
    whole_centres, ///< centres at i: mistake B66
    remainder,     ///< texel % count if the texture is repeated: mistake B67
    level_along_x, ///< the mip level only from the side of the footprint along x: mistake B97
};

/// How a colour of a normal map becomes a normal.
enum class NormalMapRule : std::uint8_t {
    right,         ///< 2 c - 1, green up, and mirrored where the texture is
    green_turned,  ///< green down: mistake B55
    mirror_missed, ///< the same side even where the texture is mirrored: mistake B56
    undecoded,     ///< the colour itself: mistake B57
};

/// The space in which light meets the normals of a normal map. The picture is the same except for
/// rounding.
enum class NormalMapSpace : std::uint8_t {
    world,   ///< the normal is taken from tangent space to the world
    tangent, ///< the lamp and the eye are taken to tangent space
};

/// Which way a height map shifts the place in the texture.
enum class ParallaxRule : std::uint8_t {
    right,      ///< toward the eye where the surface is high
    subtracted, ///< away from it: mistake B99
};

/// Which comes first, the depth test or the colour of a fragment. The picture is the same, the work
/// is not.
enum class DepthOrder : std::uint8_t {
    after_depth_test,  ///< a colour is computed only for fragments that are drawn
    before_depth_test, ///< for every fragment: mistake B18
};

/// The vector whose cosine with the normal is taken.
enum class LightDirection : std::uint8_t {
    to_light,       ///< from the point to the lamp, at unit length
    from_light,     ///< from the lamp to the point: mistake B20
    not_normalized, ///< to the lamp, but not made unit length: mistake B20
    with_w,         ///< to the lamp, with w = 1 counted in its length: mistake B76
};

/// The area over which the lamp's power is spread.
enum class LightFalloff : std::uint8_t {
    sphere,     ///< 4 pi r^2
    no_4pi,     ///< r^2: mistake B20 if the power is meant as in the lab
    linear,     ///< r
    none,       ///< 1: the light is equally bright at every distance
    cubed,      ///< 4 pi r^3: mistake B20
    pi_of_atan, ///< 4 pi r^2 with pi = atan(1) / 4, a sixteenth of pi: mistake B77
    pi_three,   ///< 4 pi r^2 with pi = 3: mistake B77
};

/// How direct light D, indirect light N and reflectance are combined.
enum class LightSum : std::uint8_t {
    reflectance_times, ///< reflectance * (D + N)
    reflectance_plus,  ///< D + reflectance: mistake B21
    reflectance_twice, ///< reflectance * reflectance * (D + N): mistake B78
};

/// What happens to an interpolated normal.
enum class Renormalize : std::uint8_t {
    on,  ///< it is made unit length again
    off, ///< it stays short: mistake B23
};

/// How the highlight is computed.
enum class HighlightRule : std::uint8_t {
    right,     ///< where n . l > 0, with h of unit length
    unasked,   ///< without testing n . l: mistake B50
    long_half, ///< with h = l + v, up to 2 long: mistake B51
};

/// Which sides of a surface are lit.
enum class LightSides : std::uint8_t {
    one, ///< the one to which the normal points: the lab
    two, ///< the one that the camera sees
};

/// The rules for computing light; the defaults are the lab's.
struct LightRules {
    LightDirection direction = LightDirection::to_light;
    LightFalloff falloff = LightFalloff::sphere;
    LightSum sum = LightSum::reflectance_times;
    Renormalize renormalize = Renormalize::on;
    HighlightRule highlight = HighlightRule::right;
    LightSides sides = LightSides::one;

    friend bool operator==(const LightRules&, const LightRules&) = default;
};

/// How to find out whether something is between a point and the lamp.
enum class Shadows : std::uint8_t {
    off,  ///< nothing casts a shadow: the lab
    rays, ///< a ray from the point to the lamp
    map,  ///< the depths that the lamp sees
};

/// How far the ray to the lamp goes.
enum class ShadowRay : std::uint8_t {
    to_lamp,   ///< as far as the lamp
    past_lamp, ///< without end: mistake B60
};

/// How many texels of the map a point is compared with.
enum class ShadowFilter : std::uint8_t {
    nearest, ///< the one it falls in
    four,    ///< the four around it: percentage closer filtering, PCF
};

/// What decides which fragment is nearer.
enum class DepthTest : std::uint8_t {
    inverse_z, ///< compares the interpolated 1/z: the lab
    linear_z,  ///< compares z interpolated as if it were linear: wrong
    off,       ///< the last one drawn wins
    reversed,  ///< smaller 1/z wins: mistake B17a
    or_equal,  ///< larger 1/z wins, and of two equal ones the later: mistake B88a
    raced,     ///< larger 1/z wins, but two threads share the buffer: mistake B102
};

/// How hidden surfaces are removed, from stage `depth` on.
enum class Hidden : std::uint8_t {
    depth_buffer, ///< every pixel remembers how near what it shows is: the lab
    painter,      ///< triangles sorted by depth, the farthest drawn first
    bsp,          ///< a tree of planes that cut the triangles, walked from back to front
    warnock,      ///< the picture divided into squares until each is simple
};

/// In which order triangles are drawn into a depth buffer, from stage `depth` on.
enum class DrawOrder : std::uint8_t {
    scene,      ///< as the scene lists them: the lab
    near_first, ///< sorted by mean depth, the nearest first: most of what is hidden fails the test
    far_first, ///< the farthest first, as the painter does: everything that is drawn over is shaded
};

/// By which rule the painter sorts.
enum class PainterRule : std::uint8_t {
    right,          ///< by the mean depth of the corners, the farthest first
    nearest_corner, ///< by the depth of the nearest corner: mistake B98a
    near_first,     ///< the nearest first: mistake B98b
};

/// Which side of a plane is drawn first.
enum class BspRule : std::uint8_t {
    right,     ///< the one on which the camera is not
    exchanged, ///< the one on which the camera is: mistake B98c
};

/// How a half-transparent fragment is laid over what its pixel shows.
enum class Blend : std::uint8_t {
    over,    ///< alpha times its colour, plus 1 - alpha times what is there
    off,     ///< not at all: it is drawn as if it were opaque
    swapped, ///< the shares the wrong way round: mistake B63
};

/// How the samples of a pixel are tested, and become its colour.
enum class SampleRule : std::uint8_t {
    right,        ///< each by its own depth; the mean of the clamped colours
    late_clamp,   ///< the mean first, and only that is clamped: mistake B100
    centre_depth, ///< all of them by the depth at the pixel's centre: mistake B101
};

/// How many points of a pixel are tested for coverage and depth, and how many are shaded.
enum class Sampling : std::uint8_t {
    centre,      ///< one, at its centre
    multisample, ///< four are tested; one is shaded, at the centre
    supersample, ///< four are tested and shaded
};

/// Which cell of the depth buffer belongs to the pixel (x, y).
enum class DepthIndex : std::uint8_t {
    row_major,  ///< [y][x]: row y, column x
    transposed, ///< [x][y]: mistake B17c; if the picture is not square, some pixels have no cell
};

/// Which positions are in the picture.
enum class Bounds : std::uint8_t {
    inside,        ///< 0 <= x < W and 0 <= y < H
    excludes_zero, ///< 0 < x < W and 0 < y < H: mistake B10
};

/// The number that is sent to the screen for an amount of light.
enum class Encoding : std::uint8_t {
    linear, ///< the amount of light itself: the lab
    srgb,   ///< by the sRGB transfer function, which a screen undoes
    gamma,  ///< to the power of 1/2.2, although linear numbers are wanted: mistake B80
};

/// The order in which the channels go to the screen.
enum class ChannelOrder : std::uint8_t {
    rgb, ///< red first
    bgr, ///< blue first, so that red and blue change places: mistake B79
};

/// What a channel above 1 is shown as.
enum class ColourOverOne : std::uint8_t {
    clamp, ///< as 1
    wrap,  ///< as the lowest 8 bits of 255 c: mistake B22
};

} // namespace rasterwalk
