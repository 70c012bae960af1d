#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "picture/overlay.h"
#include "picture/view_image.h"
#include "pipeline/framebuffer.h"
#include "scene/scene.h"
#include "session/second_run.h"

namespace rasterwalk {

struct Session;

/// What undo takes back: everything that the student sets, but not where they look. Every member
/// added here is remembered.
struct Choices {
    std::shared_ptr<const Scene> scene; ///< never null once opened
    Run a;
    std::optional<Run> b;                ///< compared with A; none: no comparison
    std::optional<ReplacedRun> replaced; ///< while a pair or a mistake is compared
    View view = View::colour;
    OverlaySet overlays; ///< laid over the view
    std::optional<DepthInterval>
        depth_range; ///< that the depth view colours; none: from the smallest to the largest

    friend bool operator==(const Choices&, const Choices&) = default;
};

/// Memory of the scenes and of the programs' pictures that undo keeps besides the present ones,
/// bytes.
inline constexpr std::size_t most_undo_bytes = std::size_t{256} << 20;

/// The choices made, one after the other. Changes need not be reported: record_undo_step() notices
/// them.
struct UndoStack {
    Choices now;
    std::vector<Choices> past;
    std::vector<Choices> future; ///< the last is the next one to redo
    /// If what the past keeps takes more, the oldest steps are forgotten, but never the newest.
    std::size_t most_bytes = most_undo_bytes;
};

/// Call it when the input is at rest (no button or key is held): a change since the last call
/// becomes one step, however many values a drag went through.
void record_undo_step(Session& session);

/// Undoes the last step, or redoes it. False if there is none.
bool undo(Session& session);
bool redo(Session& session);

/// The most steps that are remembered; older ones are forgotten.
inline constexpr std::size_t most_undo_steps = 200;

/// Memory that scenes and programs' drawings take, bytes. What several of them share counts once.
class KeptBytes {
  public:
    /// Counts this one too; null counts nothing.
    void add(const Scene* scene);
    void add(const ProgramDrawing* drawing);

    std::size_t total() const { return total_; }

  private:
    std::set<const void*> counted_; ///< scenes, textures and drawings
    std::size_t total_ = 0;
};

} // namespace rasterwalk
