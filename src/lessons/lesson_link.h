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
        bug,    ///< `bug:B9` opens a mistake on its own scene, the correct run beside it
        term,   ///< `term:1/z` opens the glossary there
        lesson, ///< `10-per-pixel.md` opens another lesson
    };
    Kind kind = Kind::show;
    const ViewField* field = nullptr; ///< of a link of that kind
    std::string argument;             ///< what stands after the colon; of a lesson its id

    /// Is it the link of this field?
    bool is_of(std::string_view field_key) const;
    /// Does it set what a quiz hides: a setting, or the second run?
    bool changes_settings() const;
};

/// Reads the target of a link: its kind, and whether what it names can exist. Throws UsageError
/// with a sentence.
LessonLink parse_lesson_link(std::string_view target);

/// Carries out what concerns the session; for `show`, `term` and `lesson` that is nothing. A
/// followed cursor drops the selected triangle, so that the panels show the one that is being
/// drawn. Throws UsageError with a sentence about what there is not; the session is then as before.
/// @param frame what is shown: the moment must exist in it
void follow_lesson_link(Session& session, const Frame& frame, const LessonLink& link);

} // namespace rasterwalk
