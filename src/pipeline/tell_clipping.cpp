#include "pipeline/tell_clipping.h"

#include <array>

namespace rasterwalk {

namespace {

bool is_in_window(const DrawWindow& window, const Cursor& cursor) {
    return cursor >= window.from && cursor < window.to;
}

/// Gives each step its moment. If a function gets to a plane twice, the count goes on there.
class ClipTelling : public ClipSink {
  public:
    ClipTelling(const Drawing& d, int triangle) : d_(d), triangle_(triangle) {}

    void clip_step(const ClipStep& step) override {
        const auto plane = static_cast<std::size_t>(step.plane);
        const Cursor cursor{triangle_, Phase::clip, static_cast<int>(plane), told_[plane]++};
        if (is_in_window(d_.window, cursor)) d_.observer->clip_step({cursor, step});
    }

  private:
    const Drawing& d_;
    int triangle_;
    std::array<int, clip_plane_count> told_{};
};

} // namespace

void tell_clip_and_cull(const Drawing& d, int triangle) {
    if (d.observer == nullptr) return;
    const Cursor cull{triangle, Phase::cull, 0, 0};
    if (d.observer->clip_step && d.window.to > Cursor{triangle, Phase::clip, 0, 0} &&
        d.window.from < cull) {
        ClipTelling telling(d, triangle);
        tell_clipping(d.frame, triangle, telling);
    }
    if (d.observer->cull && d.frame.is_cull_asked(triangle) && is_in_window(d.window, cull))
        d.observer->cull({cull, cull_test(d.frame, triangle)});
}

} // namespace rasterwalk
