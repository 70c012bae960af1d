#include "picture/thumbnail.h"

#include <algorithm>
#include <cmath>

#include "picture/resample.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "pipeline/work.h"

namespace rasterwalk {

/// What it costs to clear a pixel and to show it, in the work of a fragment.
constexpr double work_of_pixel = 0.5;

Settings scaled_to(const Scene& scene, const Settings& settings, int side) {
    Settings small = settings;
    if (scene.space == SceneSpace::pixels) return small;
    const Viewport whole = settings.viewport;
    const float scale =
        static_cast<float>(side) / static_cast<float>(std::max(whole.width, whole.height));
    const auto scaled = [&](int length) {
        return std::max(1, static_cast<int>(std::lround(static_cast<float>(length) * scale)));
    };
    small.viewport = {scaled(whole.width), scaled(whole.height)};
    small.camera.focal_length *= scale;
    return small;
}

Image thumbnail(const Scene& scene, const Settings& settings, int side) {
    const Frame frame = prepare_frame(scene, scaled_to(scene, settings, side));
    const Image drawn = view_image(draw_frame(frame), View::colour);
    const int longer = std::max(drawn.width, drawn.height);
    return longer <= side ? drawn
                          : resampled(drawn, static_cast<float>(side) / static_cast<float>(longer));
}

double thumbnail_work(const Scene& scene, const Settings& settings, int side) {
    const Frame frame = prepare_frame(scene, scaled_to(scene, settings, side));
    FrameWork work;
    work.begin(frame);
    const Viewport size = frame.settings.viewport;
    return work.total() + work_of_pixel * static_cast<double>(size.width) * size.height;
}

} // namespace rasterwalk
