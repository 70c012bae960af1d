#pragma once

#include <string>

namespace rasterwalk {

struct Ui;

/// What is known of the pixel under the pointer, or else of the one picked: as many facts as have
/// room in the font in use, but at least where it is; what matters most comes first.
/// @param room screen pixels
std::string pixel_words(const Ui& ui, float room);

} // namespace rasterwalk
