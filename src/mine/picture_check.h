#pragma once

// The picture of a student's program, compared with ours under the program's own rules.

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "laboratory/candidate.h"
#include "mine/recording.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

struct Bug;

/// What a picture tells.
struct PictureCheck {
    bool is_right = false;      ///< the same but for rounding
    bool is_judged = true;      ///< false: it differs, but too little is known about the program to
                                ///< call that wrong
    Settings reference;         ///< what ours was drawn with: the program's rules and step
    std::int64_t different = 0; ///< pixels
    std::int64_t pixels = 0;    ///< of the picture
    std::optional<glm::ivec2> first; ///< the first that differs, row by row from the top
    Diagnosis diagnosis;             ///< of a picture that is not right
    Image theirs, right;             ///< both pictures, of the same size

    /// Is one of the two black everywhere?
    bool has_black_picture() const;
};

/// A picture that was put as floats, as the lab's PutPixelSDL shows it.
Image image_of(const Recording& recording);

/// The step of the strip whose picture comes nearest to this one, among those the lab asks for:
/// points, edges, filled triangles, depth, light per vertex, light per pixel. A picture with at
/// most as many pixels as there are corners of triangles shows points. Strength of light does not
/// count, only whether there is any.
StripStep nearest_step(const Image& picture, const Scene& scene, const Settings& settings);

/// The equally right rules (rounding of vertices and lines, walk of lines) whose picture shows the
/// same surfaces in the same places, whatever the light.
/// @param known names of settings that are known already and stay as they are
Settings with_nearest_rules(const Image& picture, const Scene& scene, const Settings& settings,
                            const std::vector<std::string>& known);

/// Our picture with the other of two surfaces wherever both are equally near and the program shows
/// that one: which comes first depends on the order of the triangles.
Image with_their_ties(const PictureCheck& check, const Scene& scene);

/// Compares the picture with the scene's, and searches for what explains the difference.
/// @param settings   with the program's rules, its camera and light, and its picture's size
/// @param known      names of the settings that its functions have shown
/// @param patience   how long the search for mistakes may take
/// @param is_stopped asked between parts of the work; null: never. If it says so, what was found
///                   so far is returned
PictureCheck check_picture(const Recording& recording, const Scene& scene, const Settings& settings,
                           const std::vector<std::string>& known, const std::vector<Bug>& bugs,
                           std::chrono::milliseconds patience,
                           const std::function<bool()>& is_stopped);

} // namespace rasterwalk
