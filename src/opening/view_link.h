#pragma once

// A view as the part of a web address after its '#': "#lesson=05-row-table&step=3". It holds
// name=value pairs joined by '&', UTF-8 with percent escapes. The names are the command line's view
// options without their dashes; what may be repeated there may be repeated here.

#include <cstddef>
#include <string>
#include <string_view>

#include "opening/opened_view.h"

namespace rasterwalk {

/// The longest link to read or write, bytes, without its '#'.
inline constexpr std::size_t longest_view_link = 8192;

/// What a link asks for, for open_view(); nothing if it is empty. It may begin with its '#'. A link
/// may come from anyone: scene and lesson are names relative to lessons_folder(), and nothing
/// outside it is opened, not even through a symbolic link. A lesson is `05-row-table`, or in a
/// subfolder `own/91-my-lesson`, with or without .md. Throws UsageError for a link that is not
/// valid or names a file that does not exist; AccessError if lessons_folder() does not exist. The
/// values of other options are read by open_view().
ViewOptions parse_view_link(std::string_view fragment);

/// The link, with its '#', that opens exactly this view; only differences are given, as in
/// command_line_words(). Throws UsageError if that is impossible: in a quiz, for a scene or a
/// lesson that is not in lessons_folder(), or if it would be longer than longest_view_link.
std::string view_link(const Session& session);

/// The link to the current step of the open lesson, without the rest of the view. Empty if no
/// lesson is open, or if it is not in lessons_folder().
std::string step_link(const Session& session);

} // namespace rasterwalk
