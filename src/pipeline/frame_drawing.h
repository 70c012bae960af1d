#pragma once

#include <cstdint>
#include <optional>

#include "pipeline/frame.h"
#include "pipeline/frame_preparation.h"
#include "pipeline/framebuffer.h"
#include "pipeline/replay.h"
#include "pipeline/work.h"

namespace rasterwalk {

/// A whole frame drawn in parts: prepared, its work estimated, and drawn to its end. Frames drawn
/// one after another use the same memory.
class FrameDrawing {
  public:
    FrameDrawing() = default;
    FrameDrawing(const FrameDrawing&) = delete; // its parts refer to each other
    FrameDrawing& operator=(const FrameDrawing&) = delete;

    /// Begins a frame, replacing the last one. The scene must outlive the drawing.
    void begin(const Scene& scene, const Settings& settings);

    /// Does the next part.
    /// @param most about how much work that can be
    /// @return about how much it was
    double advance(double most);

    bool is_done() const { return stage_ == DrawingStage::done; }

    /// About how much work the whole frame is; known once it is done.
    double work() const { return work_; }

    /// A frame that is done, and what was counted while it was drawn; valid until the next one is
    /// begun.
    const Frame& frame() const { return frame_; }
    const DrawTally& tally() const { return replay_.tally(); }

    /// The picture of a frame that is done; valid until the next one is begun.
    const Framebuffer& picture() const { return *picture_; }

  private:
    enum class DrawingStage : std::uint8_t { prepared, estimated, drawn, done };

    Frame frame_;
    Occluders occluders_; ///< a shadow map is reused as long as it fits
    std::optional<FramePreparation> preparation_;
    FrameWork estimate_;
    Replay replay_{0}; ///< without copies of earlier moments
    const Framebuffer* picture_ = nullptr;
    DrawingStage stage_ = DrawingStage::done;
    double work_ = 0.0;
};

} // namespace rasterwalk
