#pragma once

// How large things may be. Files, settings and the command line are all bound by these limits, so
// that no input can make the program hang or run out of memory.

#include <cstddef>

namespace rasterwalk {

/// The largest side of a picture that may be asked for, pixels.
inline constexpr int largest_viewport = 4096;

/// The largest triangle count of a scene.
inline constexpr int max_triangles = 1'000'000;

/// The most parts that tessellation divides each edge into, and the most triangles it makes of a
/// scene: that many can still be drawn and turned without a pause.
inline constexpr int largest_tessellation = 64;
inline constexpr int most_tessellated_triangles = 200'000;

/// The most triangles that the painter's algorithm sorts, and the most pieces of a BSP tree and
/// comparisons of a piece with a plane: what takes a few tenths of a second at most.
inline constexpr int most_sorted_triangles = 200'000;
inline constexpr std::size_t most_bsp_pieces = 100'000;
inline constexpr long long most_bsp_tests = 20'000'000;

/// The most rows of all triangles whose picture is divided into squares, the most squares, and the
/// most rows that may be looked at to divide it.
inline constexpr long long most_warnock_rows = 100'000;
inline constexpr std::size_t most_warnock_squares = 500'000;
inline constexpr long long most_warnock_steps = 100'000'000;

/// The most corners of a polygon of a scene.
inline constexpr std::size_t most_scene_corners = 100;

/// The largest text file that is read, bytes.
inline constexpr std::size_t largest_text_file = std::size_t{64} << 20;

/// The largest coordinate of a point in the world, world units, either sign.
inline constexpr float largest_coordinate = 1e6f;

/// The most steps of an object's model transformation.
inline constexpr std::size_t most_model_steps = 64;

/// The largest coordinate of a point given in pixels, either sign.
inline constexpr float largest_pixel_coordinate = 16384.0f;

/// The smallest depth of such a point.
inline constexpr float smallest_pixel_depth = 1e-3f;

/// The largest side of a texture, texels.
inline constexpr int largest_texture_side = 4096;

/// The most textures of a scene.
inline constexpr std::size_t most_textures = 256;

/// The most texels of all textures of a scene, without their mip chains, and of the images unpacked
/// for them in vain or only for their alpha.
inline constexpr std::size_t most_texels = std::size_t{1} << 24;

/// The largest coordinate in a texture, either sign: how often it can repeat.
inline constexpr float largest_texcoord = 1000.0f;

/// Camera and lamp stay within this many world units of the origin along every axis.
inline constexpr float largest_place = 1000.0f;

/// Turns of the camera, radians, either sign.
inline constexpr float largest_yaw = 100.0f;
inline constexpr float largest_pitch = 1.5707964f;

/// Focal length of the camera, pixels.
inline constexpr float smallest_focal_length = 1.0f;
inline constexpr float largest_focal_length = 100000.0f;

/// Power and indirect part of the light, each channel; the smallest is 0.
inline constexpr float largest_power = 10000.0f;
inline constexpr float largest_indirect = 100.0f;

/// Texels along a side of a face of a shadow map; and the most that slant may add to its bias,
/// texels.
inline constexpr int smallest_shadow_resolution = 2;
inline constexpr int largest_shadow_resolution = 2048;
inline constexpr float largest_slope_bias = 100.0f;

/// The exponent of a highlight: at 0 it is as large as the surface, at the largest as small as a
/// pixel.
inline constexpr float smallest_exponent = 0.0f;
inline constexpr float largest_exponent = 10000.0f;

/// The largest model file (.obj), and the largest file of materials (.mtl), bytes.
inline constexpr std::size_t largest_model_file = std::size_t{256} << 20;
inline constexpr std::size_t largest_material_file = std::size_t{4} << 20;

/// The most bytes of all files of materials of a model, and of all images of a scene or model; a
/// file under two names counts twice.
inline constexpr std::size_t most_material_bytes = std::size_t{16} << 20;
inline constexpr std::size_t most_image_bytes = std::size_t{256} << 20;

/// The largest model file whose text is kept after reading, so that it can be shown, bytes.
inline constexpr std::size_t most_kept_model_text = std::size_t{64} << 20;

/// The most points of a model, and as many texture coordinates and normals.
inline constexpr std::size_t most_model_points = 4'000'000;

/// The largest coordinate in a model file, either sign.
inline constexpr double largest_model_coordinate = 1e9;

/// The most parts, materials and files of materials of a model.
inline constexpr std::size_t most_model_parts = 4096;
inline constexpr std::size_t most_materials = 4096;
inline constexpr std::size_t most_material_files = 64;

/// The longest name of a material, bytes; names that differ only beyond it count as the same.
inline constexpr std::size_t longest_material_name = 1024;

/// The most corners of a face that a fan cannot cut into triangles, and the most questions about
/// such corners that a whole model may cost.
inline constexpr std::size_t most_ear_corners = 2048;
inline constexpr long long most_ear_tests = 24'000'000;

/// The most faces around a point that its normal is smoothed over.
inline constexpr int most_smoothed_faces = 256;

/// The most kinds of statement that the report on a model tells apart.
inline constexpr std::size_t most_skipped_kinds = 64;

/// The number of the last step that a lesson can have.
inline constexpr int most_lesson_steps = 64;

} // namespace rasterwalk
