#pragma once

// Makes the models that come with the program, in lessons/models, from formulas.

#include <string>
#include <vector>

#include "base/image.h"

namespace rasterwalk::test {

struct MadeFile {
    std::string name; ///< in lessons/models
    std::string text;
};

/// All of them: cube, sphere, torus, knot, a teapot with its materials, and a globe with its
/// materials.
std::vector<MadeFile> made_models();

struct MadeImage {
    std::string name; ///< in lessons/models
    Image image;
};

/// The images of the globe: the earth on it, and the wood of its foot.
std::vector<MadeImage> made_images();

} // namespace rasterwalk::test
