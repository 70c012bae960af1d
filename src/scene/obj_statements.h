#pragma once

// The statements of a model file, before anything is built from them (read_obj.h).

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/model_source.h"
#include "scene/obj_materials.h"
#include "scene/obj_report.h"
#include "scene/reading.h"

namespace rasterwalk {

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

/// The end of a sentence about a face that is not drawn.
inline constexpr std::string_view face_left_out = "the face is left out.";

/// What a corner names, for sentences, and what becomes of a face that names a wrong one.
struct IndexedKind {
    std::string_view one, many, outcome;
};
inline constexpr std::array indexed_kinds{
    IndexedKind{"point", "points", face_left_out},
    IndexedKind{"texture coordinate", "texture coordinates",
                "the face is drawn without texture coordinates."},
    IndexedKind{"normal", "normals", "the normal is computed."}};

struct ObjStatements {
    std::vector<glm::dvec3> positions; ///< NaN if one could not be read
    std::vector<glm::vec2> texcoords;  ///< the same
    std::vector<glm::vec3> normals;    ///< unit length; zero if one must not be used
    std::vector<glm::vec3> colours;    ///< of positions, 0..1; empty: none has one
    std::vector<ObjCorner> corners;    ///< of all faces; may name what does not exist
    std::vector<ObjFace> faces;
    std::vector<NamedPart> parts;
    /// The lines of the statements v, vt and vn.
    std::vector<int> position_lines, texcoord_lines, normal_lines;
    std::vector<std::uint32_t> line_marks; ///< see ModelSource
    int lines = 0;                         ///< of the file
    std::int64_t triangles = 0;            ///< into which the faces are cut

    const ObjCorner& corner(const ObjFace& face, int i) const {
        return corners[static_cast<std::size_t>(face.first_corner + i)];
    }
};

/// Reads the statements of a model. Faults go into the report.
/// @param path for messages
/// @param libraries reads the material files that are named
/// Throws InputError if the model is too large, ReadingStopped if the watch stops it.
ObjStatements read_statements(std::string_view text, const std::string& path, WatchedSteps& watched,
                              ObjLibraries& libraries, ObjReporter& reporter);

} // namespace rasterwalk
