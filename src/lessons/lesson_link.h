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
        set,      ///< `set:interpolation=affine` sets settings, several with &
        cursor,   ///< `cursor:t0/e1/s4` goes to a moment
        show,     ///< `show:tab.rows` points at a widget of the window
        compare,  ///< `compare:interpolation=affine`: run B is A and these; `compare:off`
        pixel,    ///< `pixel:250,131` picks a pixel
        triangle, ///< `triangle:21` selects; `triangle:none`
        row,      ///< `row:131`, of the picture; `row:none`
        vertex,   ///< `vertex:1` of the selected triangle; `vertex:none`
        tab,      ///< `tab:graph` opens a tab of the inspector
        view,     ///< `view:depth` shows another plane
        overlay,  ///< `overlay:wireframe` lays it over the picture; `overlay:none`
        preset,   ///< `preset:exact` applies a preset
        bug,      ///< `bug:B9` opens a mistake on its own scene, the correct run beside it
        term,     ///< `term:1/z` opens the glossary there
        lesson,   ///< `10-per-pixel.md` opens another lesson
    };
    Kind kind = Kind::show;
    std::string argument; ///< what stands after the colon; of a lesson its id
};

/// Reads the target of a link: its kind, and whether what it names can exist. Throws UsageError
/// with a sentence.
LessonLink parse_lesson_link(std::string_view target);

/// Carries out what concerns the session; for `show`, `term` and `lesson` that is nothing. A
/// followed cursor drops the selected triangle, so that the panels show the one that is being
/// drawn. Throws UsageError with a sentence about what there is not; the session is then as before.
/// @param frame what is on show: the moment must exist in it
void follow_lesson_link(Session& session, const Frame& frame, const LessonLink& link);

} // namespace rasterwalk
