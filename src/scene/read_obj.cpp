#include "scene/read_obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/files.h"
#include "base/limits.h"
#include "base/quoted.h"
#include "scene/beside_file.h"
#include "scene/obj_normals.h"
#include "scene/obj_words.h"
#include "scene/polygon_cutter.h"
#include "scene/texture_files.h"

namespace rasterwalk {

namespace {

constexpr std::string_view face_left_out = "the face is left out.";

/// Statements that have no effect here, and why.
struct UnusedStatement {
    std::string_view word, why;
};

constexpr std::string_view no_lines = "points and lines are not drawn, only faces are";
constexpr std::string_view no_curves = "curves and curved surfaces are not drawn";
constexpr std::string_view no_display = "how it is shown elsewhere means nothing here";
constexpr UnusedStatement unused_statements[] = {
    {"s", "smoothing groups are not used: normals are given, or smoothed by angle"},
    {"p", no_lines},
    {"l", no_lines},
    {"vp", no_curves},
    {"cstype", no_curves},
    {"deg", no_curves},
    {"bmat", no_curves},
    {"step", no_curves},
    {"curv", no_curves},
    {"curv2", no_curves},
    {"surf", no_curves},
    {"parm", no_curves},
    {"trim", no_curves},
    {"hole", no_curves},
    {"scrv", no_curves},
    {"sp", no_curves},
    {"end", no_curves},
    {"con", no_curves},
    {"mg", no_display},
    {"bevel", no_display},
    {"c_interp", no_display},
    {"d_interp", no_display},
    {"lod", no_display},
    {"shadow_obj", no_display},
    {"trace_obj", no_display},
    {"usemap", no_display},
    {"maplib", no_display},
};
constexpr std::string_view unknown_statement = "it is no statement of a model";
constexpr std::string_view more_than_a_place =
    "what follows the three numbers of a point is not used";

/// Indices of a corner, from 0; -1: not given.
struct ObjCorner {
    int position = 0, texcoord = -1, normal = -1;
};

struct ObjFace {
    int line = 0;
    int first_corner = 0, corner_count = 0;
    int part = 0;
};

/// A part before its material is known.
struct NamedPart {
    std::string name, material;
    int material_line = 0;
};

/// What a corner names, for sentences.
struct IndexedKind {
    std::string_view one, many;
};
constexpr std::array indexed_kinds{IndexedKind{"point", "points"},
                                   IndexedKind{"texture coordinate", "texture coordinates"},
                                   IndexedKind{"normal", "normals"}};

class ObjReader {
  public:
    ObjReader(std::string_view text, const std::string& path, const ObjOptions& options,
              const ReadingWatch& watch)
        : lines_(text), bytes_(text.size()), options_(options), watched_(watch),
          reporter_(model_.report) {
        model_.path = path;
        name_ = visible_line(std::filesystem::path(path).stem().string());
    }

    ObjModel read() {
        while (lines_.next()) {
            std::string_view rest = lines_.text();
            const std::string_view word = take_word(rest);
            if (!word.empty() && word.front() != '#') read_statement(word, rest);
            watched_.step([&] { return bytes_read(); });
        }
        watched_.ask(bytes_read());
        counts().lines = lines_.line_count();
        counts().positions = static_cast<std::int64_t>(positions_.size());
        counts().texcoords = static_cast<std::int64_t>(texcoords_.size());
        counts().normals = static_cast<std::int64_t>(normals_.size());
        find_materials();
        keep_sound_faces();
        build();
        if (model_.mesh.triangle_count() == 0) refuse_empty();
        return std::move(model_);
    }

  private:
    ObjCounts& counts() { return model_.report.counts; }

    ReadingState bytes_read() const {
        return {ReadingPart::bytes, static_cast<std::int64_t>(bytes_ - lines_.bytes_left()),
                static_cast<std::int64_t>(bytes_)};
    }
    ReadingState triangles_made() const {
        return {ReadingPart::triangles, model_.mesh.triangle_count(), triangles_so_far_};
    }

    template <class Say>
    void fault(Say say) {
        reporter_.fault(model_.path, lines_.line(), say);
    }
    [[noreturn]] void refuse(const std::string& sentence) const {
        throw InputError(visible_line(model_.path), lines_.line(), sentence);
    }

    void read_statement(std::string_view word, std::string_view rest) {
        if (word == "v") return read_position(rest);
        if (word == "vt") return read_texcoord(rest);
        if (word == "vn") return read_normal(rest);
        if (word == "f" || word == "fo") return read_face(rest);
        if (word == "o" || word == "g") return begin_group(word, rest);
        if (word == "usemtl") return use_material(rest);
        if (word == "mtllib") return read_libraries(trimmed(rest));
        const auto known =
            std::find_if(std::begin(unused_statements), std::end(unused_statements),
                         [&](const UnusedStatement& unused) { return unused.word == word; });
        reporter_.skip(model_.path, lines_.line(), word,
                       known != std::end(unused_statements) ? known->why : unknown_statement);
    }

    /// Reads as many numbers as there is room for.
    /// @return how many there are; nothing, and a fault is told, if a word is no number or there
    /// are fewer than `fewest`
    std::optional<int> read_numbers(std::string_view what, std::string_view& rest, int fewest,
                                    std::span<double> numbers) {
        int count = 0;
        for (double& number : numbers) {
            const std::string_view word = take_number_word(rest);
            if (word.empty()) break;
            const std::optional<double> read = parse_model_number(word);
            if (!read) {
                fault([&] {
                    return fmt::format("{} is no number that '{}' can have; it is left out.",
                                       in_quotes(word), what);
                });
                return std::nullopt;
            }
            number = *read;
            ++count;
        }
        if (count >= fewest) return count;
        fault([&] {
            return fmt::format("'{}' needs {} numbers, and has {}; it is left out.", what, fewest,
                               count);
        });
        return std::nullopt;
    }

    template <class List>
    void check_room(const List& list, std::string_view many) const {
        if (list.size() >= most_model_points)
            refuse(fmt::format("the model has more than {} {}.", most_model_points, many));
    }

    // What cannot be read keeps its number, or all after it would have another one.

    void read_position(std::string_view rest) {
        check_room(positions_, indexed_kinds[0].many);
        std::array<double, 3> place{};
        if (read_numbers("v", rest, 3, place)) {
            positions_.emplace_back(place[0], place[1], place[2]);
            if (!take_number_word(rest).empty())
                reporter_.skip(model_.path, lines_.line(), "v", more_than_a_place);
        } else {
            positions_.emplace_back(std::numeric_limits<float>::quiet_NaN());
        }
    }

    void read_texcoord(std::string_view rest) {
        check_room(texcoords_, indexed_kinds[1].many);
        std::array<double, 2> place{};
        if (read_numbers("vt", rest, 1, place)) {
            texcoords_.emplace_back(place[0], place[1]);
        } else {
            texcoords_.emplace_back(0.0f);
        }
    }

    void read_normal(std::string_view rest) {
        check_room(normals_, indexed_kinds[2].many);
        std::array<double, 3> way{};
        normals_.emplace_back(0.0f);
        if (!read_numbers("vn", rest, 3, way)) return;
        const glm::dvec3 normal(way[0], way[1], way[2]);
        const double length = glm::length(normal);
        if (length > 0.0) {
            normals_.back() = glm::vec3(normal / length);
            return;
        }
        fault([] {
            return "a normal of length 0 points nowhere; where it is named, it is computed.";
        });
    }

    /// A part of a corner: "7", "-1", or nothing.
    /// @return the index from 0, -1 if there is none; nothing, and a fault is told, if it is wrong
    std::optional<int> read_index(std::string_view word, std::size_t kind, std::size_t count) {
        if (word.empty()) return -1;
        std::int64_t number = 0;
        const std::from_chars_result read =
            std::from_chars(word.data(), word.data() + word.size(), number);
        const bool is_number = read.ptr == word.data() + word.size();
        const bool is_in_range = read.ec == std::errc{};
        if (!is_number || read.ec == std::errc::invalid_argument) {
            fault([&] {
                return fmt::format("{} is no number of a {}; {}", in_quotes(word),
                                   indexed_kinds[kind].one, face_left_out);
            });
            return std::nullopt;
        }
        const auto known = static_cast<std::int64_t>(count);
        if (is_in_range && number > 0 && number <= static_cast<std::int64_t>(most_model_points))
            return static_cast<int>(number - 1);
        if (is_in_range && number < 0 && -known <= number) return static_cast<int>(known + number);
        fault([&] {
            if (is_in_range && number == 0) {
                return fmt::format("{} are counted from 1, and 'f' names 0; {}",
                                   indexed_kinds[kind].many, face_left_out);
            }
            return fmt::format("'f' names the {} {}, and {} stand before it; {}",
                               indexed_kinds[kind].one, word.substr(0, 24), count, face_left_out);
        });
        return std::nullopt;
    }

    /// A corner: a, a/b, a//c or a/b/c.
    bool read_corner(std::string_view word) {
        const std::array counts_before{positions_.size(), texcoords_.size(), normals_.size()};
        std::array<int, 3> indices{-1, -1, -1};
        std::string_view rest = word;
        for (std::size_t kind = 0; kind < indices.size(); ++kind) {
            const std::size_t slash = std::min(rest.find('/'), rest.size());
            const std::optional<int> index =
                read_index(rest.substr(0, slash), kind, counts_before[kind]);
            if (!index) return false;
            indices[kind] = *index;
            rest.remove_prefix(std::min(slash + 1, rest.size()));
        }
        if (indices[0] < 0 || !rest.empty()) {
            fault([&] {
                return fmt::format("{} is no corner: a, a/b, a//c or a/b/c; {}", in_quotes(word),
                                   face_left_out);
            });
            return false;
        }
        corners_.push_back({indices[0], indices[1], indices[2]});
        return true;
    }

    void read_face(std::string_view rest) {
        const std::size_t first = corners_.size();
        bool is_sound = true;
        for (std::string_view word = take_number_word(rest); is_sound && !word.empty();
             word = take_number_word(rest)) {
            is_sound = read_corner(word);
            if (triangles_so_far_ + static_cast<std::int64_t>(corners_.size() - first) - 2 >
                max_triangles)
                refuse(fmt::format("the model has more than {} triangles.", max_triangles));
        }
        const std::size_t count = corners_.size() - first;
        if (is_sound && count < 3) {
            is_sound = false;
            fault([&] {
                return fmt::format("'f' has {} {}, and a face has at least three; {}", count,
                                   count == 1 ? "corner" : "corners", face_left_out);
            });
        }
        if (!is_sound) {
            corners_.resize(first);
            return;
        }
        triangles_so_far_ += static_cast<std::int64_t>(count) - 2;
        if (is_part_over_) begin_part();
        faces_.push_back({lines_.line(), static_cast<int>(first), static_cast<int>(count),
                          static_cast<int>(parts_.size()) - 1});
    }

    void begin_group(std::string_view word, std::string_view rest) {
        const std::string_view name = trimmed(rest);
        constexpr std::size_t longest_name = 200;
        name_ = name.empty() ? std::string(word == "g" ? "default" : "object")
                             : visible_line(name.substr(0, longest_name));
        is_part_over_ = true;
    }

    void use_material(std::string_view rest) {
        // Each part keeps it: a name of megabytes would fill the memory.
        material_ = trimmed(rest).substr(0, longest_material_name);
        material_line_ = lines_.line();
        is_part_over_ = true;
    }

    void begin_part() {
        is_part_over_ = false;
        if (!parts_.empty() && parts_.back().name == name_ && parts_.back().material == material_)
            return;
        if (parts_.size() < most_model_parts) {
            parts_.push_back({name_, material_, material_line_});
            return;
        }
        if (std::exchange(has_too_many_parts_, true)) return;
        fault([] {
            return fmt::format("the model has more than {} parts; the faces from here on belong to "
                               "the last one.",
                               most_model_parts);
        });
    }

    /// The names may have blanks in them, or there may be several.
    void read_libraries(std::string_view names) {
        // Some programs say the same before each object.
        if (library_lists_.contains(names)) return;
        if (library_lists_.size() >= most_material_files) return refuse_library();
        library_lists_.emplace(names);
        std::string_view rest = names;
        const std::string_view first = take_word(rest);
        if (trimmed(rest).empty() || find_beside({model_.path}, names).trouble.empty())
            return read_library(names);
        for (std::string_view name = first; !name.empty(); name = take_word(rest))
            read_library(name);
    }

    void refuse_library() {
        fault([] {
            return fmt::format("more than {} files of materials are named; this one is left out.",
                               most_material_files);
        });
    }

    void read_library(std::string_view name) {
        if (libraries_.contains(name)) return;
        if (libraries_.size() >= most_material_files) return refuse_library();
        libraries_.emplace(name);
        const BesideFile file = find_beside({model_.path}, name);
        if (!file.trouble.empty()) {
            return fault(
                [&] { return fmt::format("'mtllib': {}; it is left out.", file.trouble); });
        }
        try {
            parse_mtl(read_file(file.path, largest_material_file), file.path, model_.path,
                      reporter_, model_.materials);
        } catch (const Error& trouble) {
            fault([&] {
                return fmt::format("'mtllib': {} It is left out.", visible_line(trouble.what()));
            });
        }
    }

    void find_materials() {
        std::map<std::string_view, int> known;
        for (std::size_t i = 0; i < model_.materials.size(); ++i)
            known.emplace(model_.materials[i].name, static_cast<int>(i));
        std::set<std::string_view> missing;
        for (const NamedPart& part : parts_) {
            const auto found = known.find(part.material);
            material_of_.push_back(found != known.end() ? found->second : -1);
            const bool is_missing = found == known.end() && !part.material.empty();
            if (!is_missing || !missing.insert(part.material).second) continue;
            reporter_.fault(model_.path, part.material_line, [&] {
                return fmt::format("there is no material {}; its faces are white.",
                                   in_quotes(part.material));
            });
        }
    }

    /// What is wrong with a face now that everything has been read; empty: nothing.
    std::string trouble_of(const ObjFace& face) const {
        const std::array counts{positions_.size(), texcoords_.size(), normals_.size()};
        for (int i = 0; i < face.corner_count; ++i) {
            const ObjCorner& corner = corners_[static_cast<std::size_t>(face.first_corner + i)];
            const std::array indices{corner.position, corner.texcoord, corner.normal};
            for (std::size_t kind = 0; kind < indices.size(); ++kind) {
                if (indices[kind] < 0 || static_cast<std::size_t>(indices[kind]) < counts[kind])
                    continue;
                return fmt::format("'f' names the {} {}, and there are {}; {}",
                                   indexed_kinds[kind].one, indices[kind] + 1, counts[kind],
                                   face_left_out);
            }
            if (std::isnan(positions_[static_cast<std::size_t>(corner.position)].x)) {
                return fmt::format("'f' names the point {}, which could not be read; {}",
                                   corner.position + 1, face_left_out);
            }
        }
        return {};
    }

    void keep_sound_faces() {
        const auto is_wrong = [&](const ObjFace& face) {
            const std::string trouble = trouble_of(face);
            if (trouble.empty()) return false;
            reporter_.fault(model_.path, face.line, [&] { return trouble; });
            return true;
        };
        // In their order, since the first faults are those that are kept.
        std::vector<ObjFace> sound;
        std::copy_if(faces_.begin(), faces_.end(), std::back_inserter(sound),
                     [&](const ObjFace& face) { return !is_wrong(face); });
        faces_ = std::move(sound);
    }

    bool needs_normal(const ObjCorner& corner) const {
        return corner.normal < 0 ||
               normals_[static_cast<std::size_t>(corner.normal)] == glm::vec3(0.0f);
    }

    /// Normals for all corners of all faces, one face after another; none if the file has them all.
    std::vector<glm::vec3> missing_normals() const {
        FaceCorners all;
        bool is_one_missing = false;
        for (const ObjFace& face : faces_) {
            all.first_corner.push_back(static_cast<int>(all.positions.size()));
            for (int i = 0; i < face.corner_count; ++i) {
                const ObjCorner& corner = corners_[static_cast<std::size_t>(face.first_corner + i)];
                all.positions.push_back(corner.position);
                is_one_missing = is_one_missing || needs_normal(corner);
            }
        }
        all.first_corner.push_back(static_cast<int>(all.positions.size()));
        if (!is_one_missing) return {};
        return corner_normals(all, positions_, options_.crease_angle);
    }

    /// False if the face cannot be cut; that is told.
    bool cut(const ObjFace& face) {
        places_.clear();
        for (int i = 0; i < face.corner_count; ++i) {
            const ObjCorner& corner = corners_[static_cast<std::size_t>(face.first_corner + i)];
            places_.push_back(positions_[static_cast<std::size_t>(corner.position)]);
        }
        const PolygonCut how = cutter_.cut(places_);
        if (how == PolygonCut::refused) {
            reporter_.fault(model_.path, face.line, [&] {
                return fmt::format("a face of {} corners that no fan can cut is too much work: up "
                                   "to {} corners are cut; {}",
                                   face.corner_count, most_ear_corners, face_left_out);
            });
            return false;
        }
        if (how == PolygonCut::crossed) {
            reporter_.fault(model_.path, face.line, [] {
                return "the edges of this face cross each other; its triangles overlap.";
            });
        }
        return true;
    }

    /// White and dull where there is no material.
    Vertex look_of(int material) const {
        Vertex look;
        if (material < 0) return look;
        const ObjMaterial& of = model_.materials[static_cast<std::size_t>(material)];
        look.reflectance = of.diffuse;
        look.shine = {of.specular, std::min(of.shininess, largest_exponent)};
        return look;
    }

    /// The pictures of a surface, as indices of textures; -1: none.
    struct Maps {
        int texture = -1, normal_map = -1;
    };

    /// The index of an image that was read; -1 if it cannot be used, which is told as a fault.
    int index_of(const ReadTexture& image, const ObjMaterial& of, std::string_view word, int line) {
        if (image.index >= 0) return image.index;
        reporter_.fault(of.file, line, [&] {
            return fmt::format("'{}': {} The image is left out.", word,
                               visible_line(image.trouble));
        });
        return -1;
    }

    static std::string image_name(const std::string& path) {
        return visible_line(std::filesystem::path(path).filename().string());
    }

    /// The images of a material, which are read when its first face is drawn.
    Maps maps_of(int material) {
        if (material < 0) return {};
        const ObjMaterial& of = model_.materials[static_cast<std::size_t>(material)];
        if (of.diffuse_map.empty() && of.bump_map.empty()) return {};
        const auto [known, is_new] = maps_.try_emplace(material);
        if (!is_new) return known->second;
        Maps maps;
        if (!of.diffuse_map.empty()) {
            maps.texture = index_of(texture_files_.read(of.diffuse_map, image_name(of.diffuse_map)),
                                    of, "map_Kd", of.diffuse_map_line);
        }
        if (!of.bump_map.empty()) {
            const std::string name = image_name(of.bump_map);
            maps.normal_map =
                index_of(of.bump_is_normal
                             ? texture_files_.read(of.bump_map, name)
                             : texture_files_.read_heights(of.bump_map, name, of.bump_strength),
                         of, of.bump_is_normal ? "norm" : "bump", of.bump_map_line);
        }
        return known->second = maps;
    }

    bool has_texcoords(const ObjFace& face) const {
        const auto first = corners_.begin() + face.first_corner;
        return std::all_of(first, first + face.corner_count,
                           [](const ObjCorner& corner) { return corner.texcoord >= 0; });
    }

    /// The images that a face shows.
    Maps maps_of_face(const ObjFace& face, int material) {
        const Maps maps = maps_of(material);
        if ((maps.texture < 0 && maps.normal_map < 0) || has_texcoords(face)) return maps;
        if (bare_.insert(material).second) {
            reporter_.fault(model_.path, face.line, [&] {
                return fmt::format(
                    "'f' names no texture coordinates, and the material {} has an "
                    "image; such faces keep their colour.",
                    in_quotes(model_.materials[static_cast<std::size_t>(material)].name));
            });
        }
        return {};
    }

    /// Begins another part where the face needs one. A part has one texture or none, and one
    /// normal map or none.
    void begin_drawn_part(const ObjFace& face, int material, const Maps& maps) {
        const auto part = static_cast<std::size_t>(face.part);
        const bool is_other = drawn_part_ != face.part;
        drawn_part_ = face.part;
        if (!is_other && ((model_.parts.back().texture == maps.texture &&
                           model_.parts.back().normal_map == maps.normal_map) ||
                          model_.parts.size() >= most_model_parts))
            return;
        model_.parts.push_back({parts_[part].name, model_.mesh.triangle_count(), 0, material,
                                maps.texture, maps.normal_map});
    }

    /// Puts the face into the mesh.
    /// @param look a corner with the colours of the face's material, and nothing else
    void add_face(const ObjFace& face, const Vertex& look, const std::vector<glm::vec3>& computed,
                  std::size_t first_computed, VertexJoin& join) {
        indices_.clear();
        for (int i = 0; i < face.corner_count; ++i) {
            const ObjCorner& corner = corners_[static_cast<std::size_t>(face.first_corner + i)];
            Vertex vertex = look;
            vertex.position = places_[static_cast<std::size_t>(i)];
            if (corner.texcoord >= 0)
                vertex.texcoord = texcoords_[static_cast<std::size_t>(corner.texcoord)];
            if (needs_normal(corner)) {
                vertex.normal = computed[first_computed + static_cast<std::size_t>(i)];
                ++counts().computed_normals;
            } else {
                vertex.normal = normals_[static_cast<std::size_t>(corner.normal)];
            }
            indices_.push_back(join.index_of(vertex));
        }
        for (const std::array<int, 3>& triangle : cutter_.triangles()) {
            model_.mesh.add_triangle({indices_[static_cast<std::size_t>(triangle[0])],
                                      indices_[static_cast<std::size_t>(triangle[1])],
                                      indices_[static_cast<std::size_t>(triangle[2])]});
        }
        ++counts().faces;
        counts().corners += face.corner_count;
    }

    void build() {
        watched_.ask(triangles_made());
        const std::vector<glm::vec3> computed = missing_normals();
        VertexJoin join(model_.mesh);
        std::size_t first_computed = 0;
        for (const ObjFace& face : faces_) {
            watched_.step([&] { return triangles_made(); });
            const std::size_t first = first_computed;
            first_computed += static_cast<std::size_t>(face.corner_count);
            if (!cut(face)) continue;
            const int material = material_of_[static_cast<std::size_t>(face.part)];
            begin_drawn_part(face, material, maps_of_face(face, material));
            add_face(face, look_of(material), computed, first, join);
            ObjPart& made = model_.parts.back();
            made.triangle_count = model_.mesh.triangle_count() - made.first_triangle;
        }
        counts().triangles = model_.mesh.triangle_count();
        counts().vertices = static_cast<std::int64_t>(model_.mesh.vertices().size());
        counts().parts = static_cast<std::int64_t>(model_.parts.size());
        counts().textures = static_cast<std::int64_t>(model_.textures.size());
    }

    [[noreturn]] void refuse_empty() const {
        const std::string none = "there is no face in it that can be drawn.";
        if (model_.report.faults.empty()) throw InputError(visible_line(model_.path), 1, none);
        const ObjFault& first = model_.report.faults.front();
        throw InputError(fault_line(first) + " In the whole file " + none);
    }

    ObjLines lines_;
    std::size_t bytes_; ///< of the whole text
    ObjOptions options_;
    WatchedSteps watched_;
    ObjModel model_;
    ObjReporter reporter_;

    std::vector<glm::vec3> positions_; ///< not a number where one could not be read
    std::vector<glm::vec2> texcoords_;
    std::vector<glm::vec3> normals_; ///< unit length; zero where one is not to be used
    std::vector<ObjCorner> corners_;
    std::vector<ObjFace> faces_;
    std::vector<NamedPart> parts_;
    std::vector<int> material_of_;                     ///< each of `parts_`: index, or -1
    std::set<std::string, std::less<>> library_lists_; ///< what mtllib has said so far
    std::set<std::string, std::less<>> libraries_;     ///< names that were looked for
    std::int64_t triangles_so_far_ = 0;

    std::string name_, material_; ///< of the faces to come
    int material_line_ = 0;
    bool is_part_over_ = true;
    bool has_too_many_parts_ = false;

    TextureFiles texture_files_{model_.textures};
    std::map<int, Maps> maps_; ///< of the materials that are drawn
    std::set<int> bare_;       ///< materials with an image, of faces that cannot show it
    int drawn_part_ = -1;      ///< of the face before

    PolygonCutter cutter_;
    std::vector<glm::vec3> places_; ///< of the face that is cut
    std::vector<int> indices_;      ///< its vertices
};

} // namespace

bool is_model_file(std::string_view path) {
    constexpr std::string_view ending = ".obj";
    if (path.size() <= ending.size()) return false;
    const std::string_view end = path.substr(path.size() - ending.size());
    return std::equal(end.begin(), end.end(), ending.begin(),
                      [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
}

ObjModel parse_obj(std::string_view text, const std::string& path, const ObjOptions& options,
                   const ReadingWatch& watch) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw InputError(visible_line(path), 1, "the file is UTF-16; a model is plain text.");
    return ObjReader(text, path, options, watch).read();
}

ObjModel read_obj(const std::string& path, const ObjOptions& options, const ReadingWatch& watch) {
    return parse_obj(read_file(path, largest_model_file), path, options, watch);
}

} // namespace rasterwalk
