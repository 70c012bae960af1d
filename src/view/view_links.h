#pragma once

// Links in lessons, each of which shows one thing: `pixel:250,131`. Each is the link of a row of
// view_table().

#include <span>
#include <string_view>

#include "view/view_table.h"

namespace rasterwalk {

/// `set:interpolation=affine` sets settings, several with &.
ViewLink settings_link();

/// `compare:interpolation=affine`: run B is A with these settings; `compare:off`.
ViewLink compare_link();

/// `cursor:t0/e1/s4` goes to a moment. It drops the selected triangle, so that the panels show the
/// one that is being drawn.
ViewLink cursor_link();

/// `pixel:250,131` picks a pixel; `pixel:none`.
ViewLink pixel_link();

/// `triangle:21` selects by number, from 0; `triangle:none`.
/// @param count how many there are
ViewLink number_link(std::string_view name, int (*count)(const Session&),
                     std::optional<int> Selection::*selected);

/// `tab:graph` shows something that has a word.
/// @param what  its name in messages
/// @param words the existing words
ViewLink word_link(std::string_view name, std::string_view what,
                   std::vector<std::string_view> words,
                   std::function<void(Session&, const std::string&)> show);

} // namespace rasterwalk
