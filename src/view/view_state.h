#pragma once

// What is shown, as given by a lesson, a saved view or a command line.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "base/faults.h"
#include "picture/overlay.h"
#include "picture/view_image.h"
#include "pipeline/cursor.h"
#include "session/bench.h"
#include "session/second_run.h"
#include "session/session.h"

namespace rasterwalk {

/// What is on the screen, as far as it is given. The rest is as in a fresh session. For how each
/// member is written, shown and read from a session, see view_table().
struct ViewState {
    std::optional<std::string> scene; ///< path from the folder of the lessons; none: the room
    std::vector<std::string> set;     ///< name=value, on top of the scene's default settings
    std::optional<std::vector<PlacedTriangle>> vertices; ///< of a bench scene, that were moved
    std::optional<Cursor> cursor;                        ///< none: the end
    std::optional<glm::ivec2> pixel;
    std::optional<int> triangle, row, vertex;
    std::optional<std::string> tab; ///< of the inspector; none: the one that suits the stage
    std::optional<std::vector<std::string>> panels; ///< tabs that are not hidden; none: all
    std::optional<SidePage> page;                   ///< next to the picture; none: the lesson
    std::optional<View> view;
    std::optional<OverlaySet> overlays;
    std::optional<float> zoom; ///< screen pixels per picture pixel; 0, and none: it fits
    std::optional<glm::vec2> centre;
    std::optional<CanvasShows> canvas;       ///< what the canvas shows; none: the picture
    std::optional<OutsideView> outside;      ///< from where; none: from the initial place
    std::optional<bool> grid;                ///< of pixels; none: as it was
    std::optional<bool> row_table;           ///< next to its rows; none: as it was
    std::optional<bool> fates;               ///< pass and fail in the cells; none: as it was
    std::optional<CellNumbers> cell_numbers; ///< none: no numbers
    std::optional<int> field_edge;           ///< of the edge field; none: the one at work, or 0
    std::optional<std::vector<std::string>> compare; ///< run B: A with these; none: no second run
    std::optional<CompareView> compare_view;         ///< of two runs; none: as it was
    std::optional<float> wipe;                       ///< position of the divider; none: as it was
    std::optional<DepthInterval> depth_range;        ///< of the depth view; none: all present
    std::optional<std::string> point_at;             ///< widget that is outlined

    int line = 0;                                  ///< of the block that gives all this
    std::map<std::string, int, std::less<>> lines; ///< of each key

    /// The line of a key, or of the block.
    int line_of(std::string_view key) const;
};

/// `base` with `over` on top: settings are added to the base's, all else replaces the base's.
ViewState combined(const ViewState& base, const ViewState& over);

/// Shows this state in the session: scene, settings, cursor, selection, view, overlays, tab, second
/// run. Never throws: what cannot be done is left out and reported.
/// @param folder of the lesson: scenes are looked for there, then in lessons_folder()
std::vector<Fault> show_state(Session& session, const ViewState& state, const std::string& folder);

/// The same with the session's present scene and settings, whatever the state says about them.
std::vector<Fault> show_on_scene(Session& session, const ViewState& state);

/// What the session shows, as a state that makes a fresh session on the same scene show it too. The
/// scene itself is left out, because it is a path; so is a selection outside the picture. The
/// cursor is the first existing moment at or after the session's.
/// @param original the scene as in its file: vertices that have moved go into the state
ViewState state_of(const Session& session, const Scene& original);

/// The session's scene as in its file; the session's own if nothing in it can be moved. Throws
/// Error: UsageError for a scene that was not read from a file.
Scene scene_in_file(const Session& session);

/// These settings with the assignments, name=value, on top. Throws UsageError.
Settings settings_with(const Settings& settings, const std::vector<std::string>& assignments);

} // namespace rasterwalk
