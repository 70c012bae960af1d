#pragma once

#include <cstdint>
#include <vector>

#include <GL/osmesa.h>

#include "scene/scene.h"

namespace rasterwalk {

/// A context of OpenGL 3.0 through OSMesa, and the memory it draws to.
class OsmesaContext {
  public:
    /// Throws AccessError.
    OsmesaContext(Viewport size, int depth_bits);
    ~OsmesaContext();
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    /// Throws AccessError.
    void make_current();

    /// Row by row from the top, 0xffRRGGBB as a number of a little-endian processor.
    const std::vector<std::uint32_t>& pixels() const { return pixels_; }

  private:
    Viewport size_;
    OSMesaContext context_ = nullptr;
    std::vector<std::uint32_t> pixels_;
};

} // namespace rasterwalk
