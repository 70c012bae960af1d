#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "outside/outside_drawing.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"

namespace rasterwalk::test {

/// A moment of a scene with all that the view from outside shows of it.
class Moment {
  public:
    explicit Moment(Scene scene, const Cursor& cursor = cursor_end)
        : Moment(scene, default_settings(scene), cursor) {}
    Moment(Scene scene, const Settings& settings, const Cursor& cursor)
        : scene_(std::make_shared<const Scene>(std::move(scene))), cursor_(cursor) {
        take(settings);
    }

    /// Other settings, another frame.
    void take(const Settings& settings) {
        frame_ = prepare_frame(*scene_, settings);
        ++number_;
        go_to(cursor_);
    }
    void go_to(const Cursor& cursor) {
        cursor_ = cursor;
        framebuffer_ = {};
        clear(framebuffer_, frame_);
        draw(frame_, {cursor_begin, cursor, std::nullopt}, framebuffer_);
        picture_ = view_image(framebuffer_, View::colour);
        ++picture_number_;
    }

    OutsideSubject subject() const {
        return {scene_,   frame_,   number_,         cursor_,
                triangle, picture_, picture_number_, framebuffer_};
    }
    const Scene& scene() const { return *scene_; }
    const Frame& frame() const { return frame_; }
    const Image& picture() const { return picture_; }

    std::optional<int> triangle; ///< at work

  private:
    std::shared_ptr<const Scene> scene_;
    Cursor cursor_;
    Frame frame_;
    Framebuffer framebuffer_;
    Image picture_;
    std::uint64_t number_ = 0, picture_number_ = 0;
};

/// Draws all of it.
/// @return how many updates it took
inline int draw_all(OutsideDrawing& drawing, const Moment& moment, const OutsideLook& look) {
    int updates = 0;
    do {
        drawing.update(moment.subject(), look);
        ++updates;
    } while (drawing.is_working());
    return updates;
}

} // namespace rasterwalk::test
