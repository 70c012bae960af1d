#pragma once

#include <cstddef>
#include <set>

#include "scene/scene.h"

namespace rasterwalk {

/// Memory that scenes take, bytes. What several of them share counts once.
class SceneBytes {
  public:
    /// Counts this scene too; null counts nothing.
    void add(const Scene* scene);

    std::size_t total() const { return total_; }

  private:
    std::set<const void*> counted_; ///< scenes and textures
    std::size_t total_ = 0;
};

} // namespace rasterwalk
