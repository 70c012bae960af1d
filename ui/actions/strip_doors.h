#pragma once

#include <string_view>

namespace rasterwalk {

struct Ui;

/// Goes to where the work of a door of the strip (session/strip.h) is seen: a moment, a tab and,
/// for what happens before the picture, the outside view. No setting changes.
/// @param name of the strip's entry
void open_door(Ui& ui, std::string_view name);

} // namespace rasterwalk
