#include "pipeline/frame_drawing.h"

#include <algorithm>

namespace rasterwalk {

namespace {

/// The cost of an empty pixel, relative to a fragment.
constexpr double pixel_work = 0.5;

} // namespace

void FrameDrawing::begin(const Scene& scene, const Settings& settings) {
    stage_ = DrawingStage::prepared;
    work_ = 0.0;
    picture_ = nullptr;
    frame_.occluders = occluders_;
    preparation_ = begin_frame(scene, settings, nullptr, frame_);
    if (frame_.occluders.map != nullptr) occluders_ = frame_.occluders;
}

double FrameDrawing::advance(double most) {
    const WorkLimit part{.at_once = most, .slice = most};
    double done = 0.0;
    switch (stage_) {
    case DrawingStage::prepared:
        done = std::min(most, preparation_->work());
        preparation_->advance(part);
        if (!preparation_->is_done()) break;
        estimate_.start(frame_);
        stage_ = DrawingStage::estimated;
        break;
    case DrawingStage::estimated: {
        // Estimating a triangle is less work than preparing it.
        done = std::min(most, preparation_->work());
        estimate_.advance(part);
        if (!estimate_.is_done()) break;
        replay_.begin(frame_, estimate_);
        const Viewport size = frame_.settings.viewport;
        done += pixel_work * size.width * size.height;
        stage_ = DrawingStage::drawn;
        break;
    }
    case DrawingStage::drawn: {
        const double before = replay_.work().before(replay_.drawn());
        picture_ = &replay_.toward(cursor_end, part);
        done = replay_.work().before(replay_.drawn()) - before;
        if (replay_.drawn() == cursor_end) stage_ = DrawingStage::done;
        break;
    }
    case DrawingStage::done:
        break;
    }
    work_ += done;
    return done;
}

} // namespace rasterwalk
