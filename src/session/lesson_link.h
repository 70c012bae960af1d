#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "pipeline/frame.h"
#include "session/session.h"

namespace rasterwalk {

/// What a link in a lesson does when it is followed.
struct LessonLink {
    enum class Kind : std::uint8_t {
        set,    ///< `set:interpolation=affine` sets a setting
        cursor, ///< `cursor:t0/e1/s4` goes to a moment
        show,   ///< `show:tab.rows` points at a widget of the window
    };
    Kind kind = Kind::show;
    std::string argument; ///< what stands after the colon
};

/// Reads the target of a link. Throws UsageError with a sentence if it is none of these kinds.
LessonLink parse_lesson_link(std::string_view target);

/// Carries out what concerns the session; `show` does nothing here. A followed cursor drops the
/// selected triangle, so that the panels show the one that is being drawn. Throws UsageError with a
/// sentence about a setting, value or moment that there is not; the session is then as before.
/// @param frame what is on show: the moment must exist in it
void follow_lesson_link(Session& session, const Frame& frame, const LessonLink& link);

} // namespace rasterwalk
