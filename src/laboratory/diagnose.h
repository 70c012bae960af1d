#pragma once

// A result that a student brings, a picture or a printed row table, held against the reference: the
// mistakes that may have made it are carried out, one by one, and it is measured how near each
// comes.

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "base/image.h"
#include "laboratory/bug.h"
#include "laboratory/candidate.h"
#include "laboratory/printed_rows.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Settings whose picture has the same size as this one and shows the same view: the focal length
/// follows the height. Throws UsageError if that makes it too long or too short.
Settings fitted_to(const Settings& settings, const Image& picture, SceneSpace space);

/// What may be wrong with a picture. The reference draws the scene by the settings, whose viewport
/// must have the picture's size. Tried are the stages, all orientations, shifts by a pixel, the
/// lamp's power as it fits best, every bug, and every other word of every choice.
Diagnosis diagnose_picture(const Image& picture, const Scene& scene, const Settings& reference,
                           const std::vector<Bug>& bugs);

/// What may be wrong with a printed row table. It is held against that of the polygon; without one
/// against that of the lab's test polygon and of every triangle of the scene, whichever is nearest.
/// @param polygon vertices, pixels
/// @param about   receives what it was held against: "the polygon (10,5) (5,10) (15,15)"
Diagnosis diagnose_rows(const std::vector<PrintedRow>& rows, const std::vector<glm::ivec2>& polygon,
                        const Scene& scene, Settings reference, const std::vector<Bug>& bugs,
                        std::string& about);

/// The largest side of a picture that is diagnosed, pixels: it is drawn some hundred times.
inline constexpr int largest_diagnosed = 2048;

} // namespace rasterwalk
