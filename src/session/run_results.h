#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "engines/engine_planes.h"
#include "engines/program_drawing.h"
#include "inspect/row_history.h"
#include "picture/view_image.h"
#include "pipeline/frame.h"
#include "pipeline/frame_preparation.h"
#include "pipeline/replay.h"
#include "session/inspected.h"
#include "session/preview.h"
#include "session/second_run.h"
#include "session/session.h"
#include "session/warnings.h"

namespace rasterwalk {

/// The frame that will replace the one shown; prepared in parts if that is a lot of work.
struct PendingFrame {
    std::shared_ptr<const Scene> scene;
    std::optional<Run> run; ///< none: nothing has begun
    Frame frame;            ///< before that, the previous run's, whose memory is reused
    std::optional<FramePreparation> preparation;
    FrameWork work; ///< of the frame, once that is prepared
    bool is_done = false;
};

/// What is shown of one run. Written only by update(); must not be copied or moved, because its
/// parts refer to each other.
struct RunResults {
    RunResults() = default;
    RunResults(const RunResults&) = delete;
    RunResults& operator=(const RunResults&) = delete;

    /// What is drawn: the scene, tessellated and in another order if the settings say so.
    std::shared_ptr<const Scene> drawn_scene() const {
        if (frame.list != nullptr) return {frame.list, frame.scene};
        if (frame.tessellated == nullptr) return scene;
        return {frame.tessellated, frame.scene};
    }

    Frame frame;                    ///< the scene, projected: the picture, or a pass before it
    std::uint64_t frame_number = 0; ///< changes whenever `frame` does
    Cursor cursor;              ///< the session's cursor, moved to a moment that exists in `frame`
    std::optional<Cursor> done; ///< the previous moment: what was just drawn; none at the start
    const Framebuffer* framebuffer = nullptr; ///< at the cursor, or as far as it is drawn
    Image picture;                            ///< the view of the framebuffer
    std::uint64_t picture_number = 0;         ///< changes whenever `picture` does
    std::uint64_t picture_before = 0;         ///< the picture with this number differs only in
                                              ///< these pixels; 0: not known
    Rectangle picture_changed;
    Rectangle unpainted; ///< contains all pixels of `picture` that still belong to another moment,
                         ///< because a large picture is not painted in one update
    std::optional<int> triangle; ///< that the inspector shows: selected, or of the picked pixel in
                                 ///< a whole picture, or being drawn, or first
    RowHistory rows;             ///< row table of that triangle, as far as it is at the cursor
    PolygonRows whole_rows;      ///< the whole table; empty if the triangle is not drawn
    Inspected inspected; ///< the vertices, the fragment and the row shown, with their formulas
    std::vector<Warning> warnings; ///< see describe_warnings()
    bool has_all_warnings = false; ///< false: only of what has been drawn so far
    bool is_frame_late = false;    ///< the session asks for another frame, which is being prepared
    bool is_deferred = false; ///< more is left to draw than the limit of the last update allows
    Engine engine = Engine::steps; ///< that draws this moment, see drawing_engine()
    Preview preview;               ///< while it is shown, in place of `picture`

    // The inputs this was made from.
    std::shared_ptr<const Scene> scene; ///< keeps the frame's scene alive; null before the
                                        ///< first update
    std::optional<Run> run;
    PendingFrame next;
    Occluders occluders; ///< of the last frame that had some: the frames of its passes have none
    std::optional<View> view;                 ///< that `picture` shows
    std::optional<DepthInterval> depth_range; ///< that it colours
    PictureRules rules;                       ///< that it is coloured by
    Replay replay;
    EnginePlanes planes;          ///< of the frame, unless the steps draw it
    ProgramPlanes program_planes; ///< if a student's program has drawn it

    /// Has a student's program drawn it? All that is shown of it besides the picture is ours.
    bool is_of_program() const { return run && run->program != nullptr; }
    /// Is everything before the cursor drawn? Not yet, if it takes more than one update.
    bool is_drawn() const {
        if (is_of_program()) return framebuffer == &program_planes.planes();
        return engine == Engine::steps ? replay.is_at(cursor) : planes.is_whole;
    }
    /// Is it being drawn, in further updates?
    bool is_drawing() const {
        if (is_of_program()) return !is_drawn();
        if (engine != Engine::steps) return !planes.is_whole;
        return !replay.is_clear() || (!is_drawn() && !is_deferred);
    }
    /// Is it drawn and painted as far as it should be?
    bool is_complete() const { return !is_drawing() && is_empty(unpainted); }
};

/// Which of a run's results are new.
struct RunChanges {
    bool frame = false;
    bool moment = false;  ///< the cursor has moved, or the frame is new
    bool picture = false; ///< it shows another moment, view or range of depths, or more is drawn
};

/// Is this what is shown?
bool is_shown(const std::shared_ptr<const Scene>& scene, const Run& run, const RunResults& results);

/// The row table of a triangle, as far as it is at the cursor; empty if it is not drawn.
RowHistory rows_at_cursor(const Frame& frame, int triangle, const Cursor& cursor);

/// What run A prescribes for run B, so that both show the same thing.
struct SharedView {
    const Frame* frame = nullptr;        ///< of run A: cursor and `triangle` belong to it
    std::optional<int> triangle;         ///< the one shown
    std::optional<DepthInterval> depths; ///< that the depth view colours
};

/// Continues preparing the frame that is asked for, if it is not the one shown. If it has the same
/// scene and size, it is prepared in parts where the limit requires that, and finished even if
/// another is asked for meanwhile, so that something shows while a camera keeps turning. Behind a
/// preview it is not finished. Only for update().
/// @param run     as shown, see shown_run()
/// @param pass    that it is drawn in
/// @param is_aside none of these results is shown yet, so even the first frame may be prepared in
///                 parts
/// @return is the frame ready to be shown, or already shown?
bool prepare_run(const std::shared_ptr<const Scene>& scene, const Run& run, int pass, bool is_aside,
                 const WorkLimit& limit, RunResults& results);

/// Brings the results of one run up to date; does nothing if they already are what is asked for.
/// Only for update(), after prepare_run().
/// @param run     as shown, see shown_run()
/// @param takes_frame the frame that is ready is shown now; otherwise the previous one stays
/// @param shared  for run B; null for run A, which decides for itself
/// @param limit   how much it may draw
/// @param numbers the last number given to a frame or a picture; is incremented
RunChanges update_run(const Session& session, const Run& run, bool takes_frame,
                      const SharedView* shared, const WorkLimit& limit, std::uint64_t& numbers,
                      RunResults& results);

} // namespace rasterwalk
