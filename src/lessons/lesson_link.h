#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "pipeline/frame.h"
#include "session/session.h"

namespace rasterwalk {

struct ViewField;

/// What a link in a lesson does when it is followed.
struct LessonLink {
    enum class Kind : std::uint8_t {
        field,  ///< `pixel:250,131` shows it: a link of view_table()
        show,   ///< `show:tab.rows` points at a widget of the window
        preset, ///< `preset:exact` applies a preset
        bug,    ///< `bug:B9` opens a mistake on its own scene, compared with the correct run
        term,   ///< `term:1/z` opens the glossary there
        lesson, ///< `10-per-pixel.md` opens another lesson
    };
    Kind kind = Kind::show;
    const ViewField* field = nullptr; ///< of a link of that kind
    std::string argument;             ///< the text after the colon; for a lesson, its id

    /// Is it the link of this field?
    bool is_of(std::string_view field_key) const;
    /// Does it set what a quiz hides: a setting, or the second run?
    bool changes_settings() const;
};

/// Reads the target of a link, and checks that what it names can exist. Throws UsageError with a
/// sentence.
LessonLink parse_lesson_link(std::string_view target);

/// Carries out what concerns the session; for `show`, `term` and `lesson` that is nothing.
/// Following a cursor drops the selected triangle, so that the panels show the one being drawn.
/// Throws UsageError with a sentence about what does not exist; the session is then unchanged.
/// @param frame what is shown: the moment must exist in it
void follow_lesson_link(Session& session, const Frame& frame, const LessonLink& link);

} // namespace rasterwalk
