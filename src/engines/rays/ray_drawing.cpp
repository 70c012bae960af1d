#include "engines/rays/ray_drawing.h"

#include <algorithm>
#include <cmath>

namespace rasterwalk {

double ray_work(const Settings& settings, int triangles) {
    constexpr double of_light = 4.0, of_triangle = 0.7, of_level = 4.0;
    const auto count = static_cast<double>(triangles);
    const double of_ray = settings.ray_boxes == TreeBoxes::one ? of_triangle * count
                                                               : of_level * std::log2(count + 2.0);
    // At most: not every surface is a mirror.
    const int points = settings.mirrors == Mirrors::on ? 1 + most_mirrors : 1;
    const int rays = settings.shadows == Shadows::rays ? 2 * points : points;
    return of_light * points + of_ray * rays;
}

void RayDrawing::end() {
    tracer_.reset();
    pixels_ = 0;
}

void RayDrawing::begin(const Frame& frame) {
    frame_ = &frame;
    const Mesh& mesh = frame.scene->mesh;
    const TreeBoxes boxes = frame.settings.ray_boxes;
    if (tree_ == nullptr || boxes_ != boxes || !tree_->is_of(mesh)) {
        // Shadows may have made the same one.
        const auto& of_shadows = frame.occluders.triangles;
        const bool is_made =
            boxes == TreeBoxes::nested && of_shadows != nullptr && of_shadows->is_of(mesh);
        tree_ = is_made ? of_shadows : std::make_shared<const TriangleTree>(mesh, boxes);
    }
    boxes_ = boxes;
    tracer_.emplace(frame, *tree_);
    pixels_ = 0;
}

bool RayDrawing::advance(const WorkLimit& limit, Framebuffer& planes) {
    const std::size_t all = planes.owner.size();
    const auto width = static_cast<std::size_t>(planes.size.width);
    const double of_ray = ray_work(frame_->settings, frame_->triangle_count());
    const double work = limit.of(of_ray * static_cast<double>(all - pixels_));
    const double rays = std::max(1.0, std::ceil(work / of_ray));
    const std::size_t end =
        rays < static_cast<double>(all - pixels_) ? pixels_ + static_cast<std::size_t>(rays) : all;
    for (; pixels_ < end; ++pixels_) {
        const RayPixel seen =
            tracer_->trace(static_cast<int>(pixels_ % width), static_cast<int>(pixels_ / width));
        if (seen.triangle < 0) continue;
        planes.colour[pixels_] = seen.colour;
        planes.depth[pixels_] = seen.depth;
        planes.owner[pixels_] = seen.triangle;
        planes.overdraw[pixels_] = 1;
    }
    return pixels_ == all;
}

} // namespace rasterwalk
