#include "scene/obj_materials.h"

#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/limits.h"
#include "base/quoted.h"
#include "base/text_parts.h"
#include "scene/companion_file.h"
#include "scene/obj_words.h"

namespace rasterwalk {

void ObjLibraries::read(std::string_view names, int line) {
    line_ = line;
    // Some programs repeat the statement before each object.
    if (lists_.contains(names)) return;
    if (lists_.size() >= most_material_files) return refuse_library();
    lists_.emplace(names);
    // A single name may have blanks without quotes, or contain a quote.
    if (companions_.find(names).problem.empty()) return read_library(names);
    std::string_view rest = names;
    do {
        read_library(take_name(rest));
        rest = trimmed(rest);
    } while (!rest.empty() && rest.front() != '#');
}

void ObjLibraries::refuse_library() {
    fault([] {
        return fmt::format("more than {} material files are named; this one is left out.",
                           most_material_files);
    });
}

void ObjLibraries::read_library(std::string_view name) {
    if (names_.contains(name)) return;
    if (names_.size() >= most_material_files) return refuse_library();
    names_.emplace(name);
    const CompanionFile file = companions_.find(name);
    if (!file.problem.empty()) {
        return fault([&] { return fmt::format("'mtllib': {}; it is left out.", file.problem); });
    }
    if (!file.remark.empty())
        reporter_.note(model_, line_, fmt::format("'mtllib': {}.", file.remark));
    try {
        watched_.ask();
        bytes_.add(file.path);
        const std::string text = read_file(file.path, largest_material_file);
        if (is_utf16(text)) {
            throw InputError(visible_line(file.path), 1,
                             "the file is UTF-16; a material file must be plain text.");
        }
        parse_mtl(text, file.path, model_, watched_, reporter_, materials_);
    } catch (const Error& problem) {
        fault([&] {
            return fmt::format("'mtllib': {} It is left out.", visible_line(problem.what()));
        });
    }
}

namespace {

std::string image_name(const std::string& path) {
    return visible_line(std::filesystem::path(path).filename().string());
}

} // namespace

/// The index of an image that was read; -1 if it cannot be used. The reason is reported once, as a
/// fault, however many materials name it.
int ObjImages::index_of(const ReadTexture& image, const ObjMaterial& of, std::string_view word,
                        int line) {
    if (image.problem.empty() || !reported_.insert(image.problem).second) return image.index;
    reporter_.fault(of.file, line, [&] {
        return fmt::format("'{}': {} The image is left out.", word, visible_line(image.problem));
    });
    return image.index;
}

/// The index of the texture made from a material's colour and alpha.
int ObjImages::texture_of(const ObjMaterial& of) {
    const std::string name = image_name(of.diffuse_map.empty() ? of.alpha_map : of.diffuse_map);
    if (of.alpha_map.empty())
        return index_of(files_.read(of.diffuse_map, name), of, "map_Kd", of.diffuse_map_line);
    return index_of(files_.read_with_alpha(of.diffuse_map, of.alpha_map, name), of, "map_d",
                    of.alpha_map_line);
}

ObjMaps ObjImages::of_material(int material) {
    if (material < 0) return {};
    const ObjMaterial& of = materials_[static_cast<std::size_t>(material)];
    if (of.diffuse_map.empty() && of.alpha_map.empty() && of.bump_map.empty() &&
        of.height_map.empty())
        return {};
    const auto [known, is_new] = known_.try_emplace(material);
    if (!is_new) return known->second;
    ObjMaps maps;
    if (!of.diffuse_map.empty() || !of.alpha_map.empty()) maps.texture = texture_of(of);
    if (!of.bump_map.empty()) {
        const std::string name = image_name(of.bump_map);
        maps.normal_map =
            index_of(of.bump_is_normal ? files_.read(of.bump_map, name)
                                       : files_.read_heights(of.bump_map, name, of.bump_strength),
                     of, of.bump_is_normal ? "norm" : "bump", of.bump_map_line);
    }
    if (!of.height_map.empty()) {
        maps.height_map = index_of(files_.read(of.height_map, image_name(of.height_map)), of,
                                   "disp", of.height_map_line);
    }
    return known->second = maps;
}

} // namespace rasterwalk
