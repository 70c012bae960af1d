#pragma once

// Models in Wavefront's format (OBJ), as many programs write them.
//
// The reader goes on after whatever is wrong: a statement that cannot be read is left out and told
// in the report, with file and line.
//
// Source: Wavefront Technologies, Advanced Visualizer manual, appendix B1, object files.

#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh.h"
#include "scene/obj_report.h"
#include "scene/read_mtl.h"
#include "scene/reading.h"
#include "scene/texture.h"

namespace rasterwalk {

/// What a model file leaves to its reader.
struct ObjOptions {
    /// Where normals are missing: faces that lean from each other by no more than this, radians,
    /// are smoothed; 0: each face has its own normal. 40 degrees make a pipe of ten sides
    /// round, and leave a box its edges.
    float crease_angle = 0.7f;
};

/// Faces that follow each other in one object or group and have one material, with a texture or
/// without.
struct ObjPart {
    std::string name; ///< of o or g, whichever came last, as it can be shown
    int first_triangle = 0;
    int triangle_count = 0; ///< at least 1
    int material = -1;      ///< index in ObjModel::materials; -1: none
    int texture = -1;       ///< index in ObjModel::textures; -1: none
    int normal_map = -1;    ///< also there

    friend bool operator==(const ObjPart&, const ObjPart&) = default;
};

/// A model as its file has it: in its own axes and units, fronts counterclockwise, v of texcoords
/// running up. What a corner names and is not there costs only itself: a normal is computed, and
/// without texture coordinates a face has no texture.
struct ObjModel {
    std::string path;
    glm::dvec3 origin{0.0};     ///< subtracted from all positions of a model that lies far away
    Mesh mesh;                  ///< reflectance: Kd times the point's colour; shine: Ks and Ns
    std::vector<ObjPart> parts; ///< every triangle belongs to one of them, in order
    std::vector<ObjMaterial> materials;
    std::vector<SharedTexture> textures; ///< each once, however many materials name it
    ObjReport report;
};

/// Is this the name of a model file?
bool is_model_file(std::string_view path);

/// Reads a model, and the materials and images beside it. Throws AccessError if it cannot be read,
/// InputError with file:line if nothing of it can be drawn, or if it is larger than limits.h
/// allows: the file, its points, its triangles; ReadingStopped if the watch wants no more of it.
ObjModel read_obj(const std::string& path, const ObjOptions& options = {},
                  const ReadingWatch& watch = {});

/// The same from text; `path` is for messages, and to find materials beside it.
ObjModel parse_obj(std::string_view text, const std::string& path, const ObjOptions& options = {},
                   const ReadingWatch& watch = {});

} // namespace rasterwalk
