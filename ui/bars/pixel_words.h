#pragma once

#include <string>

namespace rasterwalk {

struct Ui;

/// What is known about the pixel under the pointer, or else the picked one: as many facts as have
/// room in the current font, but at least where it is; the first facts matter most.
/// @param room screen pixels
std::string pixel_words(const Ui& ui, float room);

} // namespace rasterwalk
