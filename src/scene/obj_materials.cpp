#include "scene/obj_materials.h"

#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/limits.h"
#include "base/quoted.h"
#include "scene/beside_file.h"
#include "scene/obj_words.h"

namespace rasterwalk {

void ObjLibraries::read(std::string_view names, int line) {
    line_ = line;
    // Some programs say the same before each object.
    if (lists_.contains(names)) return;
    if (lists_.size() >= most_material_files) return refuse_library();
    lists_.emplace(names);
    std::string_view rest = names;
    const std::string_view first = take_word(rest);
    if (trimmed(rest).empty() || find_beside({model_}, names).trouble.empty())
        return read_library(names);
    for (std::string_view name = first; !name.empty(); name = take_word(rest))
        read_library(name);
}

void ObjLibraries::refuse_library() {
    fault([] {
        return fmt::format("more than {} files of materials are named; this one is left out.",
                           most_material_files);
    });
}

void ObjLibraries::read_library(std::string_view name) {
    if (names_.contains(name)) return;
    if (names_.size() >= most_material_files) return refuse_library();
    names_.emplace(name);
    const BesideFile file = find_beside({model_}, name);
    if (!file.trouble.empty()) {
        return fault([&] { return fmt::format("'mtllib': {}; it is left out.", file.trouble); });
    }
    try {
        parse_mtl(read_file(file.path, largest_material_file), file.path, model_, reporter_,
                  materials_);
    } catch (const Error& trouble) {
        fault([&] {
            return fmt::format("'mtllib': {} It is left out.", visible_line(trouble.what()));
        });
    }
}

int ObjTextures::of_material(int material) {
    if (material < 0) return -1;
    const ObjMaterial& of = materials_[static_cast<std::size_t>(material)];
    if (of.diffuse_map.empty()) return -1;
    const auto [known, is_new] = known_.try_emplace(material, -1);
    if (!is_new) return known->second;
    const ReadTexture texture = files_.read(
        of.diffuse_map, visible_line(std::filesystem::path(of.diffuse_map).filename().string()));
    known->second = texture.index;
    if (texture.index >= 0) return texture.index;
    reporter_.fault(of.file, of.diffuse_map_line, [&] {
        return fmt::format("'map_Kd': {} The image is left out.", visible_line(texture.trouble));
    });
    return -1;
}

} // namespace rasterwalk
