#include "tests/support/sound_model.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/limits.h"
#include "base/quoted.h"
#include "inspect/model_lines.h"
#include "scene/model_scene.h"
#include "scene/obj_words.h"

namespace rasterwalk::test {

const std::vector<std::string>& model_seeds() {
    static const std::vector<std::string> seeds{
        "# a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\ng a\n"
        "f 1/1/1 2/2/1 3/1/1 4/2/1\n",
        "\xef\xbb\xbfo caf\xe9\r\nv +.5 -1e-3 2\r\nv 1 2 3 \\\r\n\r\nv -1 0 1\r\n"
        "v .1 .2 .3\r\nv 9 8 7\r\nusemtl m\r\ns off\r\nf -5 -4 -3 -2 -1\r\n"
        "f -1//-1 1/ 2//\r\n",
        "mtllib . /dev/zero x.mtl\nv 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 2 0\nv 1 .5 0\nv 0 0 9\n"
        "f 1 2 3 4 5 6\nf 6 5 4 3 2 1 2 3\nl 1 2\ncurv 0 1 1 2\n",
        "v 9e8 0 0 255 0 0\n#MRGB ffff0000ff00ff00\nv 9e8 1 0 1 0 .5 1\n"
        "v 9e8 0 -1 0 300 -1\nvt nan\nvt .5\nvn nan 0 0\nf 1/1/1 2/9/9 3/0/0\n"
        "f 1/2/-1 2/x/ 3//1/1\n",
    };
    return seeds;
}

namespace {

std::string problem_of_counts(const ObjModel& model) {
    const ObjCounts& counts = model.report.counts;
    if (model.mesh.triangle_count() < 1) return "it has no triangle.";
    if (counts.triangles != model.mesh.triangle_count() ||
        counts.triangles != counts.corners - 2 * counts.faces || counts.vertices > counts.corners ||
        counts.faults < static_cast<std::int64_t>(model.report.faults.size()))
        return "its counts do not agree.";
    int next = 0;
    for (const ObjPart& part : model.parts) {
        if (part.first_triangle != next || part.triangle_count < 1)
            return "its parts do not follow each other.";
        next += part.triangle_count;
    }
    return next == model.mesh.triangle_count() ? "" : "its parts are not the whole model.";
}

std::string problem_of_report(const ObjReport& report, const std::string& path) {
    for (const ObjFault& fault : report.faults) {
        const bool is_beyond = fault.path == path && fault.line > report.counts.lines;
        if (fault.line < 1 || is_beyond || !fault.sentence.ends_with('.'))
            return "a fault has no line or no sentence: " + fault_line(fault);
    }
    return "";
}

std::string problem_of_source(const ModelSource& source, const Mesh& mesh) {
    if (source.triangles.size() != mesh.triangles().size()) return "not every triangle has a line.";
    for (const TriangleOrigin& origin : source.triangles) {
        std::string_view text = text_from_line(source, origin.line);
        std::string_view word = take_word(text);
        if (word.ends_with('\\')) word.remove_suffix(1); // the line goes on below
        if (word != "f" && word != "fo") return "a triangle is from a line without a face.";
        for (const int index : origin.corners) {
            if (index < 0 || static_cast<std::size_t>(index) >= source.corners.size())
                return "a triangle is from a corner that is not there.";
            const ObjCorner& corner = source.corners[static_cast<std::size_t>(index)];
            const auto is_there = [](int number, const std::vector<int>& lines) {
                return number < static_cast<int>(lines.size());
            };
            if (!is_there(corner.position, source.position_lines) ||
                !is_there(corner.texcoord, source.texcoord_lines) ||
                !is_there(corner.normal, source.normal_lines))
                return "a corner names a line that is not there.";
        }
    }
    return "";
}

/// The lines of the file as they are shown.
std::string problem_of_lines(const ObjModel& model) {
    const ModelSource& source = *model.source;
    const std::vector<FileLine> lines = file_lines(source, model.report, 1, source.lines + 1);
    if (lines.size() != static_cast<std::size_t>(source.lines)) return "a line is not shown.";
    for (const FileLine& line : lines) {
        for (const FilePiece& piece : line.pieces) {
            if (piece.text != visible_line(piece.text)) return "a line is not printable.";
            const bool leads = piece.corner < 0 || line.face > 0;
            if (!leads) return "a corner has no face.";
        }
        const std::optional<ModelVertex> vertex = vertex_of_line(source, line, -1, 0);
        if (vertex && vertex->triangle >= model.mesh.triangle_count())
            return "a line leads to a triangle that is not there.";
    }
    return "";
}

/// @param farthest from the origin along each axis
std::string problem_of_vertex(const Vertex& vertex, float farthest) {
    if (vertex.reflectance != glm::clamp(vertex.reflectance, 0.0f, 1.0f))
        return "a colour is beyond 0 to 1.";
    for (int i = 0; i < 3; ++i) {
        if (!(std::abs(vertex.position[i]) <= farthest))
            return "a place is too far out, or no number.";
    }
    const float length = glm::length(vertex.normal);
    if (length != 0.0f && !(std::abs(length - 1.0f) < 1e-5f)) return "a normal is no direction.";
    if (!std::isfinite(vertex.texcoord.x) || !std::isfinite(vertex.texcoord.y))
        return "a texture coordinate is no number.";
    return "";
}

std::string problem_of_vertices(const Scene& scene, float farthest) {
    for (const Vertex& vertex : scene.mesh.vertices()) {
        std::string problem = problem_of_vertex(vertex, farthest);
        if (!problem.empty()) return problem;
    }
    return "";
}

} // namespace

std::string problem_of_model(const ObjModel& model) {
    std::string problem = problem_of_counts(model);
    if (problem.empty()) problem = problem_of_report(model.report, model.path);
    if (problem.empty()) problem = problem_of_source(*model.source, model.mesh);
    if (problem.empty()) problem = problem_of_lines(model);
    if (!problem.empty()) return problem;
    const Scene scene = scene_of_model(model);
    constexpr float box_of_model = 1.001f;
    problem = problem_of_vertices(scene, box_of_model);
    if (!problem.empty()) return problem;
    if (!(std::abs(scene.camera.position.z) < largest_place)) return "its camera is nowhere.";
    return "";
}

std::string problem_of_scene(const Scene& scene) {
    if (scene.triangle_count() < 1) return "it has no triangle.";
    return problem_of_vertices(scene, largest_coordinate);
}

bool has_line(const std::string& sentence, const std::string& path) {
    return sentence.starts_with(path + ":") &&
           sentence.find(": ", path.size() + 1) != sentence.npos;
}

} // namespace rasterwalk::test
