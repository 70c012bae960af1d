#pragma once

// Models in Wavefront's format (OBJ), as many programs write them.
//
// The reader goes on after faults: a statement that cannot be read is left out and reported, with
// file and line.
//
// Source: Wavefront Technologies, Advanced Visualizer manual, appendix B1, object files.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh.h"
#include "scene/model_source.h"
#include "scene/obj_report.h"
#include "scene/read_mtl.h"
#include "scene/reading.h"
#include "scene/texture.h"

namespace rasterwalk {

/// What a model file leaves to its reader.
struct ObjOptions {
    /// Where normals are missing, faces whose normals differ by no more than this, radians, are
    /// smoothed; 0: each face has its own normal. 40 degrees make a pipe of ten sides round, and
    /// leave a box its edges.
    float crease_angle = 0.7f;
};

/// Consecutive faces of one object or group that have the same material, with or without a
/// texture.
struct ObjPart {
    std::string name; ///< of o or g, whichever came last, in printable form
    int first_triangle = 0;
    int triangle_count = 0; ///< at least 1
    int material = -1;      ///< index in ObjModel::materials; -1: none
    int texture = -1;       ///< index in ObjModel::textures; -1: none
    int normal_map = -1;    ///< also there
    int height_map = -1;    ///< also there

    friend bool operator==(const ObjPart&, const ObjPart&) = default;
};

/// A model as in its file: in its own axes and units, fronts counterclockwise, v of texcoords
/// running up. If a corner names something that does not exist, only that is lost: a normal is
/// computed, and without texture coordinates a face has no texture.
struct ObjModel {
    std::string path;
    glm::dvec3 origin{0.0};     ///< subtracted from all positions of a model that lies far away
    Mesh mesh;                  ///< reflectance: Kd times the point's colour; shine: Ks and Ns
    std::vector<ObjPart> parts; ///< every triangle belongs to one of them, in order
    std::vector<ObjMaterial> materials;
    std::vector<SharedTexture> textures; ///< each once, however many materials name it
    ObjReport report;
    std::shared_ptr<const ModelSource> source; ///< never null in a model that was read
};

/// Is this the name of a model file?
bool is_model_file(std::string_view path);

/// Reads a model with its materials and images. Throws AccessError if it cannot be read, InputError
/// with file:line if nothing of it can be drawn, or if its file, points or triangles exceed
/// limits.h; ReadingStopped if the watch stops it.
ObjModel read_obj(const std::string& path, const ObjOptions& options = {},
                  const ReadingWatch& watch = {});

/// The same from text; `path` is for messages, and to find materials next to it.
ObjModel parse_obj(std::string_view text, const std::string& path, const ObjOptions& options = {},
                   const ReadingWatch& watch = {});

} // namespace rasterwalk
