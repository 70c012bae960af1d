#pragma once

// A view as the part of a web address behind its '#': "#lesson=05-row-table&step=3". It holds
// name=value pairs joined by '&', UTF-8 with percent escapes. The names are those of the view
// options of the command line without their dashes; what may be repeated there may be repeated
// here.

#include <cstddef>
#include <string>
#include <string_view>

#include "opening/opened_view.h"

namespace rasterwalk {

/// The longest link that is read or written, bytes, without its '#'.
inline constexpr std::size_t longest_view_link = 8192;

/// What a link asks for, as open_view() takes it; nothing if it is empty. It may begin with its
/// '#'. A link may come from anyone: scene and lesson are names from lessons_folder(),
/// and nothing outside it is opened, not even through a link of the file system. A lesson is
/// `05-row-table`, or in a subfolder `own/91-my-lesson`, with or without .md. Throws UsageError
/// for what is no such link, or names a file that is not there; AccessError if lessons_folder() is
/// not there. The values of other options are read by open_view().
ViewOptions parse_view_link(std::string_view fragment);

/// The link, from its '#', that opens exactly this view; only what differs is said, as in
/// command_line_words(). Throws UsageError where that cannot be said: in a quiz, on a scene or a
/// lesson that is not in lessons_folder(), or if it would be longer than longest_view_link.
std::string view_link(const Session& session);

/// The link to the current step of the open lesson, and to nothing else in the view. Empty if
/// no lesson is open, or if it is not in lessons_folder().
std::string step_link(const Session& session);

} // namespace rasterwalk
