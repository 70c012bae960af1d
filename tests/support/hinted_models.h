#pragma once

// Models of which there is something to say: most of them is backs, black or transparent.

#include <string>

#include "scene/scene.h"

namespace rasterwalk::test {

/// A closed box; its fronts point inward or outward.
Scene box(bool is_inward);

/// One triangle that shows its back or its front.
Scene sheet(bool shows_back);

/// Its front, of a material: lines of a .mtl file, beside which an image `clear.png` has nothing
/// but texels of an alpha below 1/2, and `black.png` nothing but black ones.
Scene sheet_of(const std::string& material);

/// Two of them side by side.
Scene two_sheets(const std::string& left, const std::string& right);

} // namespace rasterwalk::test
