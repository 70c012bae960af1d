#pragma once

// Where the events of a drawing come from. What has happened to a pixel, in a triangle, or in one
// run and not in the other is asked of a source: draw() is one, and so is a recording of a program
// that is not ours.

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "pipeline/draw.h"
#include "pipeline/timeline.h"

namespace rasterwalk {

/// draw() as a stream: goes on from where the last window ended, and draws again only to go back.
/// Keeps one picture and no events.
class DrawnEvents {
  public:
    /// @param frame   must outlive this
    /// @param cleared the picture to draw into, clear; without pixels, one is made once it is
    /// needed
    explicit DrawnEvents(const Frame& frame, Framebuffer cleared = {});

    /// See EventSource. What comes before the window is drawn only for observers of pixels.
    void play(const DrawWindow& window, const Observer& observer);

    /// The picture, or the scissor's part of it, up to the end of the last window.
    const Framebuffer& picture() const { return picture_; }
    /// Hands it out, so that its memory can be used again; no other call may follow.
    Framebuffer take_picture() { return std::move(picture_); }

  private:
    const Frame* frame_;
    Framebuffer picture_;
    std::optional<Rectangle> part_; ///< scissor of the picture; none: it is whole
    Cursor drawn_ = cursor_begin;
};

/// Events in order of time, as often as they are asked for.
struct EventSource {
    /// What draw() does with a frame, which must outlive the source. Meant to be implicit.
    EventSource(const Frame& of); // NOLINT(google-explicit-constructor)
    /// The same with the caller's drawing, which must outlive the source too.
    EventSource(const Frame& of, DrawnEvents& drawing);
    /// A recording of whatever drew the frame's scene. Moments without an event are not in it.
    /// Throws InputError if it cannot be of this frame.
    /// @param recorded in order of time
    EventSource(const Frame& of, std::vector<Event> recorded);

    const Frame* frame; ///< the scene and the rules: what the numbers mean
    /// Calls the observer with the events of a window. With a scissor, of pixels only those inside,
    /// and of triangles outside perhaps none.
    std::function<void(const DrawWindow&, const Observer&)> play;
    /// The moments of a triangle; none if it is left out.
    std::function<TriangleMoments(int triangle)> moments;
};

} // namespace rasterwalk
