#pragma once

// Where surfaces are, not how they look: depth and owners from the fast engine, for views that
// colour surfaces by their own rules.

#include <cstdint>
#include <span>
#include <vector>

#include "engines/fast/fast_data.h"
#include "engines/fast/fast_engine.h"
#include "engines/fast/fast_view.h"
#include "scene/mesh.h"

namespace rasterwalk {

class FastShape {
  public:
    /// Copies the positions of the mesh, which need not live on.
    explicit FastShape(const Mesh& mesh);

    /// Draws some of the triangles, both sides of each; those with a corner that fails is_place()
    /// are left out.
    /// @param numbers of triangles of the mesh
    /// @param picture receives inv_z and owner; its colour means nothing
    void draw(const FastEye& eye, std::span<const std::int32_t> numbers, FastPicture& picture);

  private:
    std::vector<fast::Corners> triangles_; ///< of the mesh
    FastEngine engine_;
};

} // namespace rasterwalk
