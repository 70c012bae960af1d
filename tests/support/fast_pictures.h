#pragma once

// Pictures of the fast engine, and how they are compared with those of the steps.

#include <cstddef>
#include <string>
#include <vector>

#include "engines/fast/fast_engine.h"
#include "pipeline/framebuffer.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk::test {

/// The picture of an engine that has drawn nothing before.
FastPicture fast_picture(const Scene& scene, const Settings& settings,
                         const FastOptions& options = {});

/// Settings under which the steps find pixels and edges by the rules of the fast engine.
Settings by_fast_rules(Settings settings);

/// Where two pictures of one size differ.
struct FastDifference {
    std::size_t pixels = 0;      ///< of the picture
    std::size_t colours = 0;     ///< of which a channel differs by more than 1/255
    std::size_t owners = 0;      ///< that show a different triangle
    std::string first_of_colour; ///< in words; empty: there is none
    std::string first_of_owner;

    /// Is it as small as rounding makes it: 0.02 % of the pixels, or a few of a small picture?
    bool is_small() const;
    std::string words() const;
};
/// @param steps a whole picture
/// @param met   what cast_rays() says about its pixels: those near an outline are not compared; if
///              empty, all are
FastDifference difference(const FastPicture& fast, const Framebuffer& steps,
                          const std::vector<int>& met = {});

/// The first pixel at which colour, depth or owner are not the same bits, in words; empty if there
/// is none. What its rows hold beyond the picture is not looked at.
std::string first_other_bits(const FastPicture& a, const FastPicture& b);

} // namespace rasterwalk::test
