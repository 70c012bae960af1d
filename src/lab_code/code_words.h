#pragma once

// The words of the conditions in the lab's code, and what they mean for a frame.

#include <string>
#include <string_view>

#include "pipeline/frame.h"

namespace rasterwalk {

/// Does a word hold for a frame? A setting and its value, "interpolation_affine"; how far the
/// picture is drawn, "stage_vertex_light"; what the scene has, "scene_textures"; or the name of a
/// stage function that is in use, "no_depth_test".
bool code_word_holds(std::string_view word, const Frame& frame);

/// Does a word name a mistake of the registry?
bool is_mistake_word(std::string_view word);

/// How far a frame is drawn: the word after "stage_".
std::string_view stage_word(const Settings& settings);
/// A setting and a value as a word: "light_falloff_linear".
std::string word_of_value(std::string_view setting, std::string_view value);

// What some of the words say.

/// Do the corners of some triangle have different normals or colours, and does the frame show it?
bool has_own_corners(const Frame& frame);
/// Does some surface shine, and does the frame show it?
bool shows_highlights(const Frame& frame);
/// Is something half transparent?
bool shows_transparency(const Frame& frame);
/// Are textures, normal maps or height maps read?
bool reads_maps(const Frame& frame);
/// Are smaller copies of them read too?
bool uses_mip_levels(const Frame& frame);
/// Are polygons rejected or cut before the division?
bool cuts_polygons(const Frame& frame);
/// Can clipping leave polygons with more corners than triangles have?
bool leaves_more_corners(const Frame& frame);
/// Is each fragment asked whether it shows a back?
bool culls_fragments(const Frame& frame);
/// Bits of a whole number in the depth buffer; 0: it holds floats.
int depth_bits(const Frame& frame);

} // namespace rasterwalk
