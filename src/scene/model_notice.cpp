#include "scene/model_notice.h"

#include "scene/inside_out.h"

namespace rasterwalk {

std::string model_notice(const Scene& scene) {
    if (!scene.model_report) return {};
    std::string notice = fault_notice(*scene.model_report);
    if (!is_inside_out(scene.mesh)) return notice;
    return notice.append(notice.empty() ? "" : " ")
        .append("The normals of this model point inward, so the lamp lights only its inside: turn "
                "the order of the corners in its faces round, or its normals. Culling of backs "
                "would leave out what you see.");
}

} // namespace rasterwalk
