#pragma once

#include <algorithm>
#include <cstddef>
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
        const Framebuffer before = std::exchange(framebuffer_, {});
        clear(framebuffer_, frame_);
        draw(frame_, {cursor_begin, cursor, std::nullopt}, framebuffer_);
        const Image picture = std::exchange(picture_, view_image(framebuffer_, View::colour));
        picture_before_ = before.size == framebuffer_.size ? picture_number_ : 0;
        if (picture_before_ != 0) changed_ = difference(before, picture);
        ++picture_number_;
    }
    /// Another picture, about which nothing is known.
    void forget_before() {
        picture_before_ = 0;
        ++picture_number_;
    }

    OutsideSubject subject() const {
        return {scene_,   frame_,          number_,      cursor_,         triangle,
                picture_, picture_number_, framebuffer_, picture_before_, changed_};
    }
    const Scene& scene() const { return *scene_; }
    const Frame& frame() const { return frame_; }
    const Image& picture() const { return picture_; }

    std::optional<int> triangle; ///< at work

  private:
    /// Around all pixels that differ in colour or owner.
    Rectangle difference(const Framebuffer& before, const Image& picture) const {
        const Viewport size = framebuffer_.size;
        Rectangle box{size.width, size.height, 0, 0};
        for (int row = 0; row < size.height; ++row) {
            for (int column = 0; column < size.width; ++column) {
                const std::size_t at = framebuffer_.at(column, row);
                const bool is_same =
                    before.owner[at] == framebuffer_.owner[at] &&
                    std::equal(picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * at),
                               picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * at + 4),
                               picture_.rgba.begin() + static_cast<std::ptrdiff_t>(4 * at));
                if (is_same) continue;
                box = {std::min(box.left, column), std::min(box.top, row),
                       std::max(box.right, column + 1), std::max(box.bottom, row + 1)};
            }
        }
        return is_empty(box) ? Rectangle{} : box;
    }

    std::shared_ptr<const Scene> scene_;
    Cursor cursor_;
    Frame frame_;
    Framebuffer framebuffer_;
    Image picture_;
    std::uint64_t number_ = 0, picture_number_ = 0, picture_before_ = 0;
    Rectangle changed_;
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
