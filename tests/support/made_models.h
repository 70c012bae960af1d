#pragma once

// The models that come with the program, in lessons/models: made here, from formulas.

#include <string>
#include <vector>

namespace rasterwalk::test {

struct MadeFile {
    std::string name; ///< in lessons/models
    std::string text;
};

/// All of them: cube, sphere, torus, knot, and a teapot with its materials.
std::vector<MadeFile> made_models();

} // namespace rasterwalk::test
