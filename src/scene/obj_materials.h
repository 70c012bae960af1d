#pragma once

// The materials of a model: the files that it names (read_mtl.h), and the images that they name.

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/limits.h"
#include "scene/companion_file.h"
#include "scene/obj_report.h"
#include "scene/read_mtl.h"
#include "scene/texture_files.h"

namespace rasterwalk {

/// Reads the files of materials that a model names, each once.
class ObjLibraries {
  public:
    /// @param model     path of the model, next to which they are
    /// @param materials receives them; all arguments must outlive this
    ObjLibraries(const std::string& model, std::vector<ObjMaterial>& materials,
                 WatchedSteps& watched, ObjReporter& reporter)
        : model_(model), materials_(materials), watched_(watched), reporter_(reporter),
          companions_({model}) {}

    /// Reads what a statement names. What cannot be read becomes a fault. Throws ReadingStopped.
    /// @param names one that may contain blanks, or several
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
    WatchedSteps& watched_;
    ObjReporter& reporter_;
    CompanionFiles companions_;
    int line_ = 0;
    std::set<std::string, std::less<>> lists_; ///< what has been named so far
    std::set<std::string, std::less<>> names_; ///< names that were looked for
    CompanionBytes bytes_{most_material_bytes, "all material files"};
};

/// The pictures of a surface, as indices of textures; -1: none.
struct ObjMaps {
    int texture = -1, normal_map = -1, height_map = -1;

    bool has_any() const { return texture >= 0 || normal_map >= 0 || height_map >= 0; }
    bool operator==(const ObjMaps&) const = default;
};

/// The images of materials, each read when the first face of its material is drawn.
class ObjImages {
  public:
    /// @param textures receives them; all arguments must outlive this
    ObjImages(const std::vector<ObjMaterial>& materials, std::vector<SharedTexture>& textures,
              WatchedSteps& watched, ObjReporter& reporter)
        : materials_(materials), reporter_(reporter), files_(textures, watched) {}

    /// The images of a material; what cannot be read is reported once. Throws ReadingStopped.
    /// @param material an index, or -1: none
    ObjMaps of_material(int material);

  private:
    int index_of(const ReadTexture& image, const ObjMaterial& of, std::string_view word, int line);
    int texture_of(const ObjMaterial& of);

    const std::vector<ObjMaterial>& materials_;
    ObjReporter& reporter_;
    TextureFiles files_;
    std::map<int, ObjMaps> known_;   ///< of the materials that are drawn
    std::set<std::string> reported_; ///< reported faults of images
};

} // namespace rasterwalk
