#pragma once

// A mistake on the scene that comes with it, drawn with and without.

#include <string_view>

#include "laboratory/bug.h"
#include "pipeline/draw.h"
#include "session/content.h"

namespace rasterwalk::test {

/// Both runs of a mistake.
struct DrawnBug {
    Session session;
    Frame wrong, right;
    Framebuffer wrong_picture, right_picture;

    explicit DrawnBug(std::string_view id) {
        session = open_session(lessons_folder() + "/scenes/lab-room.toml");
        open_bug(find_bug(read_bugs(), id), session);
        wrong = frame_of(session.a.settings);
        right = frame_of(session.b->settings);
        wrong_picture = draw_frame(wrong);
        right_picture = draw_frame(right);
    }
    DrawnBug(const DrawnBug&) = delete;
    DrawnBug& operator=(const DrawnBug&) = delete;

    /// A frame of the same scene.
    Frame frame_of(const Settings& settings) const {
        return prepare_frame(*session.scene, settings);
    }
};

/// The same fragments with the same fate and the same colours fall in both.
inline bool has_same_planes(const Framebuffer& a, const Framebuffer& b) {
    return a.colour == b.colour && a.depth == b.depth && a.owner == b.owner &&
           a.overdraw == b.overdraw;
}

} // namespace rasterwalk::test
