#pragma once

// The materials of a model: the files that it names (read_mtl.h), and the images that they name.

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/obj_report.h"
#include "scene/read_mtl.h"
#include "scene/texture_files.h"

namespace rasterwalk {

/// Reads the files of materials that a model names, each once.
class ObjLibraries {
  public:
    /// @param model     path of the model, beside which they lie
    /// @param materials receives theirs; all must live as long
    ObjLibraries(const std::string& model, std::vector<ObjMaterial>& materials,
                 ObjReporter& reporter)
        : model_(model), materials_(materials), reporter_(reporter) {}

    /// Reads what a statement names. What cannot be read is told as a fault.
    /// @param names may have blanks in them, or may be several
    /// @param line  of the statement, from 1
    void read(std::string_view names, int line);

  private:
    void read_library(std::string_view name);
    void refuse_library();
    template <class Say>
    void fault(Say say) {
        reporter_.fault(model_, line_, say);
    }

    const std::string& model_;
    std::vector<ObjMaterial>& materials_;
    ObjReporter& reporter_;
    int line_ = 0;
    std::set<std::string, std::less<>> lists_; ///< what has been named so far
    std::set<std::string, std::less<>> names_; ///< that were looked for
};

/// The textures of materials. Each is read when a face that shows it is drawn.
class ObjTextures {
  public:
    /// @param textures receives them; all must live as long
    ObjTextures(const std::vector<ObjMaterial>& materials, std::vector<SharedTexture>& textures,
                ObjReporter& reporter)
        : materials_(materials), reporter_(reporter), files_(textures) {}

    /// The texture of a material, an index or -1: none, or it cannot be read, which is told once.
    int of_material(int material);

  private:
    const std::vector<ObjMaterial>& materials_;
    ObjReporter& reporter_;
    TextureFiles files_;
    std::map<int, int> known_; ///< by material: index, or -1
};

} // namespace rasterwalk
