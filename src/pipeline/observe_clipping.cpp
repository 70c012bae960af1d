#include "pipeline/observe_clipping.h"

#include <array>

namespace rasterwalk {

namespace {

bool is_in_window(const DrawWindow& window, const Cursor& cursor) {
    return cursor >= window.from && cursor < window.to;
}

/// Gives each step its moment. If a function gets to a plane twice, the count goes on there.
class ClipNotifier : public ClipSink {
  public:
    ClipNotifier(const Drawing& d, int triangle) : d_(d), triangle_(triangle) {}

    void clip_step(const ClipStep& step) override {
        const auto plane = static_cast<std::size_t>(step.plane);
        const Cursor cursor{triangle_, Phase::clip, static_cast<int>(plane), counts_[plane]++};
        if (is_in_window(d_.window, cursor)) d_.observer->clip_step({cursor, step});
    }

  private:
    const Drawing& d_;
    int triangle_;
    std::array<int, clip_plane_count> counts_{};
};

} // namespace

void notify_clip_and_cull(const Drawing& d, int triangle) {
    if (d.observer == nullptr) return;
    const Cursor cull{triangle, Phase::cull, 0, 0};
    if (d.observer->clip_step && d.window.to > Cursor{triangle, Phase::clip, 0, 0} &&
        d.window.from < cull) {
        ClipNotifier notifier(d, triangle);
        replay_clipping(d.frame, triangle, notifier);
    }
    if (d.observer->cull && d.frame.is_cull_tested(triangle) && is_in_window(d.window, cull))
        d.observer->cull({cull, cull_test(d.frame, triangle)});
}

} // namespace rasterwalk
