#include "scene/obj_building.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "base/limits.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "scene/obj_normals.h"
#include "scene/obj_statements.h"
#include "scene/polygon_cutter.h"

namespace rasterwalk {

namespace {

/// The points of a model as floats. A model in map coordinates may be millions of times its own
/// size away from the origin, where floats are as far apart as its points. It is brought near in
/// double.
struct ObjPlaces {
    std::vector<glm::vec3> places; ///< of all positions, `origin` subtracted; a NaN stays one
    glm::dvec3 origin{0.0};        ///< in the file's units; 0 where the model is near enough
};
double longest(const glm::dvec3& way) {
    return std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
}

glm::dvec3 origin_of(const ObjStatements& file) {
    if (file.faces.empty()) return glm::dvec3(0.0);
    const auto position = [&](const ObjCorner& corner) {
        return file.positions[static_cast<std::size_t>(corner.position)];
    };
    glm::dvec3 least = position(file.corner(file.faces.front(), 0)), most = least;
    for (const ObjFace& face : file.faces) {
        for (int i = 0; i < face.corner_count; ++i) {
            const glm::dvec3 place = position(file.corner(face, i));
            least = glm::min(least, place);
            most = glm::max(most, place);
        }
    }
    glm::dvec3 middle = 0.5 * (least + most);
    const double half = 0.5 * longest(most - least);
    constexpr double far = 16.0;
    if (half == 0.0 || longest(middle) <= far * half) return glm::dvec3(0.0);
    // A power of two, so that subtracting the middle rounds nothing again.
    const double unit = std::ldexp(1.0, std::ilogb(half) - 7);
    for (int i = 0; i < 3; ++i) {
        const double units = middle[i] / unit;
        constexpr double most_whole = 1e15; // of a double
        if (std::abs(units) < most_whole) middle[i] = std::round(units) * unit;
    }
    return middle;
}

/// The positions of a model as floats. A model is far away if the middle of its box (of the points
/// that its faces name) is farther from the origin along an axis than 16 times the box's longest
/// half side; the origin is then that middle, to a hundredth of that half side or better.
/// @param file all its faces name positions that exist
ObjPlaces obj_places(const ObjStatements& file) {
    ObjPlaces made;
    made.origin = origin_of(file);
    made.places.reserve(file.positions.size());
    for (const glm::dvec3& position : file.positions)
        made.places.emplace_back(position - made.origin);
    return made;
}

class ModelBuilder {
  public:
    ModelBuilder(ObjStatements& file, const ObjOptions& options, WatchedSteps& watched,
                 ObjReporter& reporter, ObjModel& model, std::vector<TriangleOrigin>& origins)
        : file_(file), options_(options), watched_(watched), reporter_(reporter), model_(model),
          origins_(origins) {}

    void find_materials() {
        std::map<std::string_view, int> known;
        for (std::size_t i = 0; i < model_.materials.size(); ++i)
            known.emplace(model_.materials[i].name, static_cast<int>(i));
        std::set<std::string_view> missing;
        for (const NamedPart& part : file_.parts) {
            const auto found = known.find(part.material);
            material_of_.push_back(found != known.end() ? found->second : -1);
            const bool is_missing = found == known.end() && !part.material.empty();
            if (!is_missing || !missing.insert(part.material).second) continue;
            reporter_.fault(model_.path, part.material_line, [&] {
                return fmt::format("there is no material {}, so its faces are white.",
                                   in_quotes(part.material));
            });
        }
    }

    /// Leaves out the faces that name a point that does not exist. In the others, removes texture
    /// coordinates and normals that do not exist.
    void keep_sound_faces() {
        const auto is_wrong = [&](const ObjFace& face) {
            const std::string problem = problem_of(face);
            if (problem.empty()) return false;
            reporter_.fault(model_.path, face.line, [&] { return problem; });
            return true;
        };
        // In order, since only the first faults are kept.
        std::vector<ObjFace> sound;
        std::copy_if(file_.faces.begin(), file_.faces.end(), std::back_inserter(sound),
                     [&](const ObjFace& face) { return !is_wrong(face); });
        file_.faces = std::move(sound);
        for (const ObjFace& face : file_.faces)
            drop_what_is_missing(face);
    }

    void place_points() {
        ObjPlaces made = obj_places(file_);
        file_.positions = {};
        points_ = std::move(made.places);
        model_.origin = made.origin;
        if (made.origin == glm::dvec3(0.0)) return;
        reporter_.note(model_.path, file_.faces.front().line,
                       fmt::format("the model is far from the origin, so ({}, {}, {}) is "
                                   "subtracted from all its points.",
                                   shortest(made.origin.x), shortest(made.origin.y),
                                   shortest(made.origin.z)));
    }

    void build() {
        watched_.ask(triangles_made());
        const std::vector<glm::vec3> computed = missing_normals();
        VertexJoin join(model_.mesh);
        std::size_t first_computed = 0;
        for (const ObjFace& face : file_.faces) {
            watched_.step([&] { return triangles_made(); });
            const std::size_t first = first_computed;
            first_computed += static_cast<std::size_t>(face.corner_count);
            if (!cut(face)) continue;
            const int material = material_of_[static_cast<std::size_t>(face.part)];
            begin_drawn_part(face, material, maps_of_face(face, material));
            add_face(face, material, computed, first, join);
            ObjPart& made = model_.parts.back();
            made.triangle_count = model_.mesh.triangle_count() - made.first_triangle;
        }
        counts().triangles = model_.mesh.triangle_count();
        counts().vertices = static_cast<std::int64_t>(model_.mesh.vertices().size());
        counts().parts = static_cast<std::int64_t>(model_.parts.size());
        counts().textures = static_cast<std::int64_t>(model_.textures.size());
    }

  private:
    ObjCounts& counts() { return model_.report.counts; }

    ReadingState triangles_made() const {
        return {ReadingPart::triangles, model_.mesh.triangle_count(), file_.triangles};
    }

    static std::string is_not_there(std::size_t kind, int index, std::size_t count) {
        return fmt::format("'f' names {} {}, but the file has {}; {}", indexed_kinds[kind].one,
                           index + 1, count, indexed_kinds[kind].outcome);
    }

    /// What is wrong with the points of a face now that all are known; empty: nothing.
    std::string problem_of(const ObjFace& face) const {
        for (int i = 0; i < face.corner_count; ++i) {
            const int position = file_.corner(face, i).position;
            if (static_cast<std::size_t>(position) >= file_.positions.size())
                return is_not_there(0, position, file_.positions.size());
            if (std::isnan(file_.positions[static_cast<std::size_t>(position)].x)) {
                return fmt::format("'f' names point {}, which could not be read; {}", position + 1,
                                   face_left_out);
            }
        }
        return {};
    }

    void drop_what_is_missing(const ObjFace& face) {
        const auto drop = [&](int& index, std::size_t kind, std::size_t count, ObjFaultKind fault) {
            if (index < 0 || static_cast<std::size_t>(index) < count) return;
            reporter_.fault(fault, model_.path, face.line,
                            [&] { return is_not_there(kind, index, count); });
            index = -1;
        };
        for (int i = 0; i < face.corner_count; ++i) {
            ObjCorner& corner = file_.corners[static_cast<std::size_t>(face.first_corner + i)];
            drop(corner.texcoord, 1, file_.texcoords.size(), ObjFaultKind::missing_texcoord);
            drop(corner.normal, 2, file_.normals.size(), ObjFaultKind::missing_normal);
            // It could not be read, and that has been reported.
            if (corner.texcoord >= 0 &&
                std::isnan(file_.texcoords[static_cast<std::size_t>(corner.texcoord)].x))
                corner.texcoord = -1;
        }
    }

    bool needs_normal(const ObjCorner& corner) const {
        return corner.normal < 0 ||
               file_.normals[static_cast<std::size_t>(corner.normal)] == glm::vec3(0.0f);
    }

    /// Normals for all corners of all faces, face by face; none if the file has them all.
    std::vector<glm::vec3> missing_normals() const {
        FaceCorners all;
        bool is_one_missing = false;
        for (const ObjFace& face : file_.faces) {
            all.first_corner.push_back(static_cast<int>(all.positions.size()));
            for (int i = 0; i < face.corner_count; ++i) {
                const ObjCorner& corner = file_.corner(face, i);
                all.positions.push_back(corner.position);
                is_one_missing = is_one_missing || needs_normal(corner);
            }
        }
        all.first_corner.push_back(static_cast<int>(all.positions.size()));
        if (!is_one_missing) return {};
        return corner_normals(all, points_, options_.crease_angle);
    }

    /// False if the face cannot be cut; that is reported.
    bool cut(const ObjFace& face) {
        places_.clear();
        for (int i = 0; i < face.corner_count; ++i) {
            const ObjCorner& corner = file_.corner(face, i);
            places_.push_back(points_[static_cast<std::size_t>(corner.position)]);
        }
        const PolygonCut how = cutter_.cut(places_);
        if (how == PolygonCut::refused) {
            reporter_.fault(model_.path, face.line, [&] {
                return fmt::format("cutting a face of {} corners that no fan covers is too much "
                                   "work (ear clipping is limited to {} corners); {}",
                                   face.corner_count, most_ear_corners, face_left_out);
            });
            return false;
        }
        if (how == PolygonCut::crossed) {
            reporter_.fault(model_.path, face.line, [] {
                return "the edges of this face cross each other, so its triangles overlap.";
            });
        }
        return true;
    }

    /// The share of light that the faces of a material reflect. If an image or the points have
    /// colours, some programs write Kd 0 and mean 1.
    glm::vec3 reflectance_of(const ObjMaterial& of) {
        if (!is_invisible(of.diffuse)) return of.diffuse;
        const bool has_map = of.diffuse_map_line > 0;
        if (!has_map && file_.colours.empty()) {
            reporter_.note(of.file, of.diffuse_line,
                           fmt::format("the material {} is black because its Kd is 0 and it has no "
                                       "map_Kd.",
                                       in_quotes(of.name)));
            return of.diffuse;
        }
        reporter_.fault(of.file, of.diffuse_line, [&] {
            return fmt::format("'Kd' 0 would make {} invisible, so it counts as 1.",
                               has_map ? "map_Kd" : "the colours of the points");
        });
        return glm::vec3(1.0f);
    }

    /// A corner with the look of a material and nothing else, made when its first face is drawn.
    /// White and dull without a material.
    const Vertex& look_of(int material) {
        const auto [known, is_new] = looks_.try_emplace(material);
        Vertex& look = known->second;
        if (!is_new || material < 0) return look;
        const ObjMaterial& of = model_.materials[static_cast<std::size_t>(material)];
        if (is_invisible(glm::vec3(of.alpha))) {
            reporter_.note(of.file, of.alpha_line,
                           fmt::format("the material {} is fully transparent because its alpha is "
                                       "0.",
                                       in_quotes(of.name)));
        }
        look.reflectance = reflectance_of(of);
        look.shine = {of.specular, std::min(of.shininess, largest_exponent)};
        return look;
    }

    bool has_texcoords(const ObjFace& face) const {
        const auto first = file_.corners.begin() + face.first_corner;
        return std::all_of(first, first + face.corner_count,
                           [](const ObjCorner& corner) { return corner.texcoord >= 0; });
    }

    /// The images that a face shows.
    ObjMaps maps_of_face(const ObjFace& face, int material) {
        const ObjMaps maps = images_.of_material(material);
        if (!maps.has_any() || has_texcoords(face)) return maps;
        if (bare_.insert(material).second) {
            reporter_.fault(model_.path, face.line, [&] {
                return fmt::format(
                    "not every corner of 'f' has a texture coordinate, although the material {} "
                    "has an image; such faces keep their colour.",
                    in_quotes(model_.materials[static_cast<std::size_t>(material)].name));
            });
        }
        return {};
    }

    /// Begins another part if the face needs one. A part has at most one picture of each kind.
    void begin_drawn_part(const ObjFace& face, int material, const ObjMaps& maps) {
        const auto part = static_cast<std::size_t>(face.part);
        const bool is_other = drawn_part_ != face.part;
        drawn_part_ = face.part;
        if (!is_other) {
            const ObjPart& last = model_.parts.back();
            const ObjMaps shown{last.texture, last.normal_map, last.height_map};
            if (shown == maps || model_.parts.size() >= most_model_parts) return;
        }
        model_.parts.push_back({file_.parts[part].name, model_.mesh.triangle_count(), 0, material,
                                maps.texture, maps.normal_map, maps.height_map});
    }

    /// The position in the texture that a corner has.
    glm::vec2 place_in_texture(const ObjCorner& corner, int material) const {
        const glm::vec2 given = file_.texcoords[static_cast<std::size_t>(corner.texcoord)];
        if (material < 0) return given;
        const ObjMaterial& of = model_.materials[static_cast<std::size_t>(material)];
        constexpr auto largest = static_cast<float>(largest_model_coordinate);
        return glm::clamp(of.map_scale * given + of.map_offset, -largest, largest);
    }

    /// Puts the face into the mesh.
    /// @param material of the face: an index, or -1
    void add_face(const ObjFace& face, int material, const std::vector<glm::vec3>& computed,
                  std::size_t first_computed, VertexJoin& join) {
        const Vertex& look = look_of(material);
        indices_.clear();
        const bool is_painted = has_texcoords(face);
        for (int i = 0; i < face.corner_count; ++i) {
            const ObjCorner& corner = file_.corner(face, i);
            Vertex vertex = look;
            vertex.position = places_[static_cast<std::size_t>(i)];
            if (!file_.colours.empty())
                vertex.reflectance *= file_.colours[static_cast<std::size_t>(corner.position)];
            if (is_painted) vertex.texcoord = place_in_texture(corner, material);
            if (needs_normal(corner)) {
                vertex.normal = computed[first_computed + static_cast<std::size_t>(i)];
                ++counts().computed_normals;
            } else {
                vertex.normal = file_.normals[static_cast<std::size_t>(corner.normal)];
            }
            indices_.push_back(join.index_of(vertex));
        }
        for (const std::array<int, 3>& triangle : cutter_.triangles()) {
            model_.mesh.add_triangle({indices_[static_cast<std::size_t>(triangle[0])],
                                      indices_[static_cast<std::size_t>(triangle[1])],
                                      indices_[static_cast<std::size_t>(triangle[2])]});
            origins_.push_back({face.line,
                                {face.first_corner + triangle[0], face.first_corner + triangle[1],
                                 face.first_corner + triangle[2]}});
        }
        ++counts().faces;
        counts().corners += face.corner_count;
    }

    ObjStatements& file_;
    const ObjOptions& options_;
    WatchedSteps& watched_;
    ObjReporter& reporter_;
    ObjModel& model_;
    std::vector<TriangleOrigin>& origins_;
    ObjImages images_{model_.materials, model_.textures, watched_, reporter_};

    std::vector<glm::vec3> points_; ///< the positions of the file
    std::vector<int> material_of_;  ///< each part of the file: index, or -1
    std::set<int> bare_;            ///< materials whose image some faces cannot show
    std::map<int, Vertex> looks_;   ///< of the materials that are drawn
    int drawn_part_ = -1;           ///< of the previous face

    PolygonCutter cutter_;
    std::vector<glm::vec3> places_; ///< of the face being cut
    std::vector<int> indices_;      ///< its vertices
};

} // namespace

void build_model(ObjStatements& file, const ObjOptions& options, WatchedSteps& watched,
                 ObjReporter& reporter, ObjModel& model, std::vector<TriangleOrigin>& origins) {
    ModelBuilder builder(file, options, watched, reporter, model, origins);
    builder.find_materials();
    builder.keep_sound_faces();
    builder.place_points();
    builder.build();
}

} // namespace rasterwalk
