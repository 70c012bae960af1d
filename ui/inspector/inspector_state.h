#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "base/image.h"
#include "explain/map_reading.h"
#include "explain/space_chain.h"
#include "inspect/coverage_comparison.h"
#include "inspect/microscope.h"
#include "inspect/model_lines.h"
#include "inspect/shared_edge.h"
#include "picture/shadow_faces.h"
#include "pipeline/cursor.h"
#include "stages/clip.h"
#include "ui/app/options_state.h"
#include "ui/widgets/picture_state.h"

namespace rasterwalk {

/// What the float microscope looks at.
struct MicroscopeView {
    int edge = 0;                    ///< of the triangle that the inspector shows
    std::optional<Cursor> picked_at; ///< where the cursor was when the edge was picked by hand
    bool shows_x = false;            ///< x instead of y
    /// The triangle and edge for which x or y was last chosen; another edge gets a new choice.
    std::pair<int, int> axis_chosen_for{-1, -1};
    EdgeMicroscope shown; ///< of the last edge looked at, here or on the canvas
};

/// What is asked about in the Clip tab, for one triangle.
struct ClipLook {
    int triangle = -1;
    std::optional<Cursor> picked_at; ///< where the cursor was when it was last examined
    std::string number;              ///< id of a formula, see clip_report.h; empty: the usual one
    std::array<bool, clip_plane_count> is_turned{}; ///< opened or closed, contrary to the default
    std::optional<ClipPlane> plane; ///< the one examined, on the canvas too; none: the usual one
};

/// What the row table shows.
struct RowsPlace {
    int triangle = -1;
    std::optional<int> row; ///< selected
    int jumps = 0;          ///< Session::jumps: a lesson's step or a link may lead elsewhere
    float height = 0.0f;    ///< of the table, screen pixels

    friend bool operator==(const RowsPlace&, const RowsPlace&) = default;
};

/// What the small pictures of the Rows tab can be about.
enum class CoverageSubject : std::uint8_t { none, rules, methods };

/// One of them, and the signs on its pixels.
struct CoverageImage {
    Image image;
    std::vector<SmallMark> marks;
};

/// The small pictures of the Rows tab: fill rules at a shared edge, or ways to cover a polygon.
struct CoveragePictures {
    // What the next three were found for.
    std::uint64_t frame_number = 0;   ///< of the frame, see RunResults
    int triangle = -1;                ///< the one shown
    std::optional<glm::ivec2> picked; ///< pixel
    Theme theme{};
    std::optional<SharedEdge> shared;
    std::optional<EdgePicture> edge; ///< none before it is shown
    std::optional<PolygonPicture> polygon;

    bool wants_rules = false; ///< shows the rules for a polygon, whose edges are shared too
    CoverageSubject images_of = CoverageSubject::none;
    std::array<CoverageImage, 3> images;
    std::array<PictureTexture, 3> textures;
    std::uint64_t number = 0; ///< of the images
};

/// The faces of the shadow map as they are shown.
struct ShadowFacesView {
    std::weak_ptr<const ShadowMap> map; ///< that they were made of; does not keep it
    int side = 0;                       ///< asked for, screen pixels
    ShadowFacePictures pictures;
    std::array<PictureTexture, shadow_face_count> textures;
    std::uint64_t number = 0; ///< of the pictures
};

/// What is asked about in the Vertices, Inside, Fragment, Texture and Graph tabs.
struct InspectView {
    std::string vertex_number = "pixel.column";   ///< id of a formula, see vertex_report.h
    std::string fragment_number = "zinv";         ///< id of a formula, see fragment_report.h
    std::string texture_number = "texture.level"; ///< also an id, in the Texture tab
    SurfaceMap surface_map = SurfaceMap::texture; ///< in the Texture tab, if it acts there
    bool shows_other_light = false;               ///< per vertex where it is per pixel, and back
    std::string graph_quantity = "z";             ///< id of a quantity, see carried_row.h
    std::string test_number; ///< id of a formula, see test_formulas.h; empty: none
};

/// What the File tab shows of one file.
struct FileLook {
    std::weak_ptr<const ModelSource> source; ///< the file; does not keep it
    /// What the next three were found for: a vertex of the model, and whether the triangle shown
    /// has it from the file.
    std::optional<ModelVertex> of;
    bool was_from_file = false;
    std::optional<FileCorner> corner;
    std::string words;           ///< about the corner
    std::vector<FileLine> named; ///< the line of its face, and those that it names
    int first = 0, count = 0;    ///< of the next
    std::vector<FileLine> lines; ///< those in view
    std::optional<ModelVertex> scrolled_to;
    int jumps = -1;           ///< Session::jumps when it last scrolled
    double asked_at = -1e9;   ///< when the state of the file was last read, seconds of ImGui
    bool has_changed = false; ///< it is not the file that was read
};

/// The figure of the chain of matrices.
struct ChainLook {
    double at = 0.0; ///< from 0, object space, to 5, the window
    bool is_whole_scene = false;
    // What the chain was made for:
    std::uint64_t frame_number = 0;
    int triangle = -1;
    bool was_whole_scene = false;
    SpaceChain chain;
};

/// What the sheet of settings was opened for, and what was changed by then.
struct SettingsSheet {
    int frame = -2; ///< the frame of ImGui in which it was last drawn
    std::string lesson;
    int step = 0;
    std::vector<std::string_view> changed; ///< they come first
};

/// What the inspector keeps from one frame to the next.
struct InspectorState {
    bool is_low = false;    ///< the page has few lines: panels are brief
    bool is_narrow = false; ///< and few letters a line
    /// It has lines enough for a part that scrolls, and below it a card that stays. If not, both
    /// are in one scroll: two would each show next to nothing.
    bool has_card = true;
    MicroscopeView microscope;
    ClipLook clip;
    FileLook file;
    ChainLook chain;
    CoveragePictures coverage;
    ShadowFacesView shadow_faces;
    InspectView chosen;
    std::string setting_search; ///< what the sheet of settings is filtered by
    SettingsSheet settings_sheet;
    /// ImGui's frame in which a number was clicked: its formula is shown after it.
    int formula_frame = -2;
    bool settings_over_drawer = false; ///< they were opened over the lesson's whole text
    std::optional<int> hovered_row;    ///< row of the picture pointed at in the row table
    bool shows_end_values = false;     ///< further columns in the row table
    bool scroll_to_row = false;        ///< the row table brings a row into view
    RowsPlace rows_place;              ///< where it last did so
};

} // namespace rasterwalk
