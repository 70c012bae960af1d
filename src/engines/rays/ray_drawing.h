#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "engines/rays/ray_tracer.h"
#include "pipeline/framebuffer.h"
#include "pipeline/work.h"

namespace rasterwalk {

/// Follows the rays of all pixels of a frame, some at a time. The boxes are kept from frame to
/// frame while the triangles stay where they are.
class RayDrawing {
  public:
    /// @param frame must live as long as it is drawn
    void begin(const Frame& frame);

    /// The frame is gone: nothing is drawn until begin().
    void end();

    /// Goes on from the top as far as the limit allows, in planes that are cleared for the frame.
    /// @return true if all pixels are drawn
    bool advance(const WorkLimit& limit, Framebuffer& planes);

    /// Pixels whose ray has been followed.
    std::size_t pixels() const { return pixels_; }
    /// What it took for them.
    RayCount count() const { return tracer_ ? tracer_->count() : RayCount{}; }

  private:
    const Frame* frame_ = nullptr;
    std::shared_ptr<const TriangleTree> tree_;
    TreeBoxes boxes_ = TreeBoxes::nested; ///< of the tree
    std::optional<RayTracer> tracer_;
    std::size_t pixels_ = 0;
};

/// The work of following the ray of one pixel, relative to a fragment.
double ray_work(const Settings& settings, int triangles);

} // namespace rasterwalk
