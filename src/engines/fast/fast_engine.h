#pragma once

// The fast engine: the same picture as the steps, without steps. The row table, samples and
// fragments that a student walks through do not exist here; what remains is the picture, the depth
// of each pixel, and which triangle it shows.
//
// It draws a scene any number of times, with different cameras, lamps or sizes.

#include <cstdint>
#include <memory>

#include "engines/fast/aligned.h"
#include "engines/fast/fast_mesh.h"
#include "engines/fast/fast_view.h"
#include "engines/fast/simd_level.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

struct FastOptions {
    SimdLevel level = best_simd_level(); ///< one of simd_levels()
    int threads = 1;                     ///< at least 1
    bool keeps_planes = true;            ///< inv_z and owner are wanted, not just the picture
};

/// A picture in rows of `stride` pixels, of which the first `size.width` are the picture.
struct FastPicture {
    Viewport size{0, 0};
    std::size_t stride = 0;
    AlignedVector<std::uint32_t> colour; ///< 0x00RRGGBB; black where nothing is drawn
    AlignedVector<float> inv_z;          ///< 1/z of the camera's space; 0: nothing; empty: not kept
    AlignedVector<std::int32_t> owner;   ///< triangle of the scene; -1: nothing; empty: not kept

    std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(column);
    }
};

class FastEngine {
  public:
    /// Throws UsageError if the level is not one of this machine.
    explicit FastEngine(const Scene& scene, const FastOptions& options = {});
    explicit FastEngine(FastMesh mesh, const FastOptions& options = {});
    ~FastEngine();
    FastEngine(FastEngine&&) noexcept;
    FastEngine& operator=(FastEngine&&) noexcept;

    /// Draws the scene. Settings that fast_engine_refuses() names are ignored.
    /// @param picture its memory is reused
    void draw(const Settings& settings, FastPicture& picture);
    void draw(const fast::View& view, FastPicture& picture);

    /// The mesh that is drawn; it may be changed between two pictures.
    FastMesh& mesh();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace rasterwalk
