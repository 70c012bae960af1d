#include "inspect/depth_prepass.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/draw.h"

namespace rasterwalk {

namespace {

/// Makes room for what is equally near, see the top of the header.
void move_away(Framebuffer& framebuffer) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float away = is_smaller_nearer(framebuffer.rules.depth_kind) ? infinity : -infinity;
    for (float& depth : framebuffer.depth) {
        if (depth != framebuffer.rules.depth_clear) depth = std::nextafter(depth, away);
    }
}

} // namespace

bool can_have_prepass(const Frame& frame) {
    // Height maps move what is cut out, and only light per pixel looks at them.
    if (frame.shifts && has_texture_alpha(*frame.scene)) return false;
    const auto test = frame.stages.depth_test;
    const bool is_right = test == depth_test || test == depth_test_in_buffer;
    return is_right && has_fragments(frame.settings.stage) && !frame.has_samples() &&
           frame.stages.depth_cell == depth_cell && !frame.blends;
}

PrepassFrames prepare_prepass(const Scene& scene, const Settings& settings,
                              const ReplaceStages& replace) {
    Settings of_depth = settings;
    of_depth.stage = std::min(settings.stage, Stage::depth);
    of_depth.shadows = Shadows::off;
    // A texture matters only if it cuts fragments out.
    const bool cuts = settings.texture_alpha == TextureAlpha::cut_out && has_texture_alpha(scene);
    if (!cuts) of_depth.texture = TextureUse::off;
    return {prepare_frame(scene, of_depth, replace), prepare_frame(scene, settings, replace)};
}

PrepassTally draw_with_prepass(const PrepassFrames& frames, const Cursor& to,
                               Framebuffer& framebuffer) {
    const DrawWindow window{.from = cursor_begin, .to = to, .scissor = {}};
    PrepassTally tally;
    clear(framebuffer, frames.depth);
    tally.depth = draw(frames.depth, window, framebuffer);
    move_away(framebuffer);
    std::fill(framebuffer.colour.begin(), framebuffer.colour.end(), glm::vec3(0.0f));
    std::fill(framebuffer.owner.begin(), framebuffer.owner.end(), -1);
    std::fill(framebuffer.overdraw.begin(), framebuffer.overdraw.end(), 0u);
    tally.picture = draw(frames.picture, window, framebuffer);
    return tally;
}

} // namespace rasterwalk
