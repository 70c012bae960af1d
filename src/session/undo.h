#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "picture/overlay.h"
#include "picture/view_image.h"
#include "pipeline/framebuffer.h"
#include "pipeline/run.h"
#include "session/second_run.h"

namespace rasterwalk {

struct Session;

/// What undo takes back: everything that the student sets, but not where they look. A member is
/// remembered as soon as it stands here.
struct Choices {
    std::shared_ptr<const Scene> scene; ///< never null once opened
    Run a;
    std::optional<Run> b;                ///< is compared with A; none: no comparison
    std::optional<ReplacedRun> replaced; ///< while a pair or a mistake is compared
    View view = View::colour;
    OverlaySet overlays; ///< laid over the view
    std::optional<DepthInterval>
        depth_range; ///< that the depth view colours; none: from the smallest to the largest

    friend bool operator==(const Choices&, const Choices&) = default;
};

/// Memory of the scenes that undo keeps besides the open one, bytes.
inline constexpr std::size_t most_undo_bytes = std::size_t{256} << 20;

/// The choices made one after the other. Changes are not reported: note_choices() notices them.
struct UndoStack {
    Choices now;
    std::vector<Choices> past;
    std::vector<Choices> future; ///< the next one to redo is the last
    /// When the scenes of the past take more, the oldest steps are forgotten; never the newest one.
    std::size_t most_bytes = most_undo_bytes;
};

/// To be called when the input has come to rest (no button or key is held): a change since the last
/// call becomes one step, however many values a drag went through.
void note_choices(Session& session);

/// Takes back the last step, or does it again. False if there is none.
bool undo(Session& session);
bool redo(Session& session);

/// Steps that are remembered; older ones are forgotten.
inline constexpr std::size_t most_undo_steps = 200;

} // namespace rasterwalk
