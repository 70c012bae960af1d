#pragma once

// Models that deserve a hint, because they mostly face away, or are black or transparent.

#include <string>

#include "scene/scene.h"

namespace rasterwalk::test {

/// A closed box; its fronts point inward or outward.
Scene box(bool is_inward);

/// One triangle that faces away from the camera or toward it.
Scene sheet(bool shows_back);

/// Its front, with a material: lines of a .mtl file, next to which an image `clear.png` has only
/// texels with an alpha below 1/2, and `black.png` only black ones.
Scene sheet_of(const std::string& material);

/// Two of them side by side.
Scene two_sheets(const std::string& left, const std::string& right);

} // namespace rasterwalk::test
