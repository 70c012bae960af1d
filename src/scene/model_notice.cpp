#include "scene/model_notice.h"

#include <algorithm>

#include "scene/inside_out.h"

namespace rasterwalk {

namespace {

bool is_black(const Mesh& mesh) {
    return std::all_of(mesh.vertices().begin(), mesh.vertices().end(), [](const Vertex& vertex) {
        return is_invisible(vertex.reflectance) && is_invisible(vertex.shine.specular);
    });
}

} // namespace

std::string model_notice(const Scene& scene) {
    if (!scene.model_report) return {};
    std::string notice;
    const auto add = [&](std::string_view sentence) {
        notice.append(notice.empty() || sentence.empty() ? "" : " ").append(sentence);
    };
    if (is_black(scene.mesh))
        add("This whole model is black (Kd 0), so no light makes any of it visible.");
    add(fault_notice(*scene.model_report));
    if (is_inside_out(scene.mesh)) {
        add("The normals of this model point inward, so the lamp lights only its inside. Reverse "
            "the order of the corners in its faces, or negate its normals.");
    }
    return notice;
}

} // namespace rasterwalk
