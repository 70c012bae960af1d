#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "engines/fast_planes.h"
#include "inspect/row_history.h"
#include "picture/view_image.h"
#include "pipeline/frame.h"
#include "pipeline/frame_preparation.h"
#include "pipeline/replay.h"
#include "pipeline/run.h"
#include "session/inspected.h"
#include "session/preview.h"
#include "session/session.h"

namespace rasterwalk {

/// What is out of order in a frame.
struct Trouble {
    std::string sentence;
    std::string in_short;    ///< the same where there is little room
    bool is_of_rows = false; ///< it is about row tables, which not everyone has met yet
    int triangle = -1;       ///< one that shows it; -1: none does
    int lesson = 0;          ///< the number of the one that explains why it happens; 0: none does

    friend bool operator==(const Trouble&, const Trouble&) = default;
};

/// The frame that will replace the one shown, prepared in parts if that is much work.
struct NextFrame {
    std::shared_ptr<const Scene> scene;
    std::optional<Run> run; ///< none: nothing is begun
    Frame frame;            ///< before anything is begun, the previous run's: its memory is used
    std::optional<FramePreparation> preparation;
    FrameWork work; ///< of the frame, when that is prepared
    bool is_done = false;
};

/// What is shown of one run. Written by update() alone; not to be copied or moved, because its
/// parts refer to each other.
struct RunResults {
    RunResults() = default;
    RunResults(const RunResults&) = delete;
    RunResults& operator=(const RunResults&) = delete;

    /// What is drawn: the scene, or what tessellation makes of it.
    std::shared_ptr<const Scene> drawn_scene() const {
        if (frame.tessellated == nullptr) return scene;
        return {frame.tessellated, frame.scene};
    }

    Frame frame;                    ///< the scene, projected
    std::uint64_t frame_number = 0; ///< another one whenever `frame` is another
    Cursor cursor;              ///< the session's cursor, moved to a moment that exists in this run
    std::optional<Cursor> done; ///< the previous moment: what was just drawn; none at the start
    const Framebuffer* framebuffer = nullptr; ///< at the cursor, or as far as it is drawn
    Image picture;                            ///< the view of the framebuffer
    std::uint64_t picture_number = 0;         ///< another one whenever `picture` is another
    std::uint64_t picture_before = 0;         ///< the picture with this number differs from it only
                                              ///< in these pixels; 0: nothing is known
    Rectangle picture_changed;
    Rectangle unpainted; ///< in it lie all pixels of `picture` that are still those of another
                         ///< moment: of a large picture not all are painted in one update
    std::optional<int> triangle; ///< that the inspector shows: selected, or of the picked pixel in
                                 ///< a whole picture, or being drawn, or first
    RowHistory rows;             ///< row table of that triangle, as far as it is made at the cursor
    PolygonRows whole_rows;      ///< the same when it is whole; empty if the triangle is not drawn
    Inspected inspected; ///< the vertices, the fragment and the row shown, with their formulas
    std::vector<Trouble> troubles; ///< see describe_troubles()
    bool has_all_troubles = false; ///< false: only of what has been drawn so far
    bool is_frame_late = false;    ///< the session asks for another frame, which is being prepared
    bool is_held =
        false; ///< more is left to draw than the limit of the last update allows to begin
    bool is_fast = false; ///< the fast engine draws this moment, not the steps: the settings ask
                          ///< for it, and it is the whole picture
    Preview preview;      ///< while it is shown, in the place of `picture`

    // Of what this was made.
    std::shared_ptr<const Scene> scene; ///< keeps the given scene of the frame alive; null before
                                        ///< the first update
    std::optional<Run> run;
    NextFrame next;
    std::optional<View> view;                 ///< that `picture` shows
    std::optional<DepthInterval> depth_range; ///< that it colours
    PictureRules rules;                       ///< by which it is coloured
    Replay replay;
    FastPlanes fast; ///< of the frame while `is_fast`

    /// Is everything before the cursor drawn? What is too much work for one update is not.
    bool is_drawn() const { return is_fast ? fast.is_whole : replay.is_at(cursor); }
    /// Is it being drawn, by further updates?
    bool is_drawing() const {
        if (is_fast) return !fast.is_whole;
        return !replay.is_clear() || (!is_drawn() && !is_held);
    }
    /// Is it drawn and painted as far as it is to be?
    bool is_complete() const { return !is_drawing() && is_empty(unpainted); }
};

/// What of a run's results is new.
struct RunChanges {
    bool frame = false;
    bool moment = false;  ///< the cursor has moved, or the frame is new
    bool picture = false; ///< it shows another moment, view or range of depths, or has been drawn
                          ///< further
};

/// What is out of order in a frame: settings that contradict each other, triangles left out,
/// samples outside.
/// @param tally what its row tables come to
std::vector<Trouble> describe_troubles(const Frame& frame, const DrawTally& tally);

/// Is this what is shown?
bool is_on_show(const std::shared_ptr<const Scene>& scene, const Run& run,
                const RunResults& results);

/// The row table of a triangle, as far as it is made at the cursor; empty if it is not drawn.
RowHistory rows_at_cursor(const Frame& frame, int triangle, const Cursor& cursor);

/// What run A prescribes for run B, so that the same thing is seen of both.
struct SharedView {
    const Frame* frame = nullptr;        ///< of run A: to it belong cursor and `triangle`
    std::optional<int> triangle;         ///< the one shown
    std::optional<DepthInterval> depths; ///< that the depth view colours
};

/// Goes on preparing the frame that is asked for, if it is not the one shown. If it has the same
/// scene and size, it is prepared in parts where the limit asks for it, and what is begun is
/// finished even if another is asked for meanwhile: so something is seen while a camera keeps
/// turning. Next to a preview it is not finished. To be called by update() alone.
/// @param is_aside none of these results is shown yet, so even the first frame may be prepared in
///                 parts
/// @return is the frame ready to be shown, or shown already?
bool prepare_run(const std::shared_ptr<const Scene>& scene, const Run& run, bool is_aside,
                 const WorkLimit& limit, RunResults& results);

/// Brings the results of one run up to date; does nothing where they are what is asked for already.
/// To be called by update() alone, after prepare_run().
/// @param takes_frame the frame that is ready is shown now; otherwise the previous one stays
/// @param shared  for run B; null for run A, which decides for itself
/// @param limit   how much it may draw
/// @param numbers the last number given to a frame or a picture; counts on
RunChanges update_run(const Session& session, const Run& run, bool takes_frame,
                      const SharedView* shared, const WorkLimit& limit, std::uint64_t& numbers,
                      RunResults& results);

} // namespace rasterwalk
