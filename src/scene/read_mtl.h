#pragma once

// Materials of models (MTL).
//
// Source: Wavefront Technologies, Advanced Visualizer manual, appendix B2, MTL material format.

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/obj_report.h"
#include "scene/reading.h"

namespace rasterwalk {

/// A material as its file gives it.
struct ObjMaterial {
    std::string name; ///< the bytes of the file, which need not be UTF-8; cut if it is too long
    glm::vec3 diffuse{1.0f};     ///< Kd: share of light given back in all directions, 0..1
    glm::vec3 specular{0.0f};    ///< Ks: share of light mirrored, 0..1
    float shininess = 0.0f;      ///< Ns: exponent of the highlight, from 0
    float alpha = 1.0f;          ///< d, or 1 - Tr: 0 (clear) to 1 (opaque)
    int alpha_line = 0;          ///< of d or Tr there, whichever counts; 0: none
    bool has_dissolve = false;   ///< d is given; Tr is then ignored
    std::string diffuse_map;     ///< map_Kd: path of a file that exists; empty: none
    std::string file;            ///< that it is in
    int diffuse_line = 0;        ///< of Kd there, from 1; 0: none
    int diffuse_map_line = 0;    ///< of map_Kd, whether or not the image exists; 0: none
    glm::vec2 map_scale{1.0f};   ///< -s and -o of map_Kd: a corner is at scale * vt + offset,
    glm::vec2 map_offset{0.0f};  ///< as in Blender and three.js
    std::string alpha_map;       ///< map_d: the same
    int alpha_map_line = 0;      ///< its line
    std::string bump_map;        ///< bump, map_Bump or norm: the same
    int bump_map_line = 0;       ///< its line
    float bump_strength = 1.0f;  ///< -bm of that map
    bool bump_is_normal = false; ///< given by norm: a map of normals, not of heights

    std::string height_map;        ///< disp: the same
    int height_map_line = 0;       ///< its line
    bool has_height_range = false; ///< the two numbers below are given, by -mm of that map
    /// A texel h is h * gain + base above the surface, units of the model.
    float height_base = 0.0f, height_gain = 1.0f;

    friend bool operator==(const ObjMaterial&, const ObjMaterial&) = default;
};

/// Adds the materials of a text to a list. What is wrong in it becomes a fault and is left out.
/// Throws ReadingStopped.
/// @param path       of the text, for messages and to find images next to it
/// @param model_path of the model that names it: images may be next to that, too
void parse_mtl(std::string_view text, const std::string& path, const std::string& model_path,
               WatchedSteps& watched, ObjReporter& reporter, std::vector<ObjMaterial>& materials);

} // namespace rasterwalk
