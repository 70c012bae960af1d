#pragma once

// What a step of a lesson puts on the screen.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "base/faults.h"
#include "picture/view_image.h"
#include "pipeline/cursor.h"
#include "session/bench.h"
#include "session/session.h"

namespace rasterwalk {

/// What is on the screen, as far as a lesson says. What it leaves open is as in a fresh session.
struct Situation {
    std::optional<std::string> scene; ///< path from the folder of the lessons; none: the room
    std::vector<std::string> set;     ///< name=value, on top of the handout's settings of the scene
    std::optional<Cursor> cursor;     ///< none: the end
    std::optional<glm::ivec2> pixel;
    std::optional<int> triangle, row, vertex;
    std::optional<std::string> tab; ///< of the inspector; none: rows
    std::optional<View> view;
    std::optional<OverlaySet> overlays;
    std::optional<float> zoom; ///< screen pixels a picture pixel; 0, and none: it fits
    std::optional<glm::vec2> centre;
    std::optional<std::vector<std::string>> compare; ///< run B: A, and these; none: no second run
    std::optional<CompareView> compare_view;         ///< of two runs; none: as it was
    std::optional<float> wipe;                       ///< place of the divider; none: as it was
    std::optional<bool> grid;                        ///< of pixels; none: as it was
    std::optional<DepthRange> depth_range;           ///< of the depth view; none: all that is there
    std::vector<PlacedTriangle> vertices; ///< of a bench scene, that lie elsewhere than in it
    std::string point_at;                 ///< widget that is outlined; empty: none
    int line = 0;                         ///< of the block that says so
    std::map<std::string, int, std::less<>> lines; ///< of each key

    /// The line of a key, or of the block.
    int line_of(std::string_view key) const;
};

/// What `base` says, and on top of it what `over` says: settings are added to the base's, all else
/// takes the place of the base's.
Situation combined(const Situation& base, const Situation& over);

/// Brings the session into this situation: scene, settings, cursor, selection, view, overlays, tab,
/// second run. Never throws: what cannot be done is left out and reported.
/// @param folder of the lesson: scenes are looked for there, and in lessons_folder() after that
std::vector<Fault> apply_situation(Session& session, const Situation& situation,
                                   const std::string& folder);

/// The same on the scene and the settings that the session has already, whatever the situation says
/// of them.
std::vector<Fault> apply_on_scene(Session& session, const Situation& situation);

/// The file a lesson names by a relative path: within `folder`, or else within lessons_folder().
/// Throws UsageError for a path that is absolute or leads out of the folder, or a file that is not
/// there.
std::string find_lesson_file(const std::string& folder, std::string_view relative);

/// The settings of a scene's handout with these on top. Throws UsageError.
Settings settings_with(const Settings& settings, const std::vector<std::string>& assignments);

inline constexpr float smallest_zoom = 0.25f; ///< screen pixels a picture pixel
inline constexpr float largest_zoom = 64.0f;
inline constexpr float farthest_centre = 1e6f; ///< picture pixels, either sign

/// The scene of a situation that names none, in lessons_folder().
inline constexpr std::string_view usual_scene = "scenes/lab-room.toml";

} // namespace rasterwalk
