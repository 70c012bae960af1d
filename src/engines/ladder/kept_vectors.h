#pragma once

// Vectors that stay, as rung kept_vectors has them, and the rungs after it for their row table.

#include <span>
#include <vector>

#include "engines/ladder/lab_loop.h"

namespace rasterwalk::rungs {

/// The first pixels of a vector, which grows if it has not so many.
inline std::span<Pixel> first(int count, std::vector<Pixel>& kept) {
    const auto size = static_cast<std::size_t>(count);
    if (kept.size() < size) kept.resize(size);
    return {kept.data(), size};
}

} // namespace rasterwalk::rungs
