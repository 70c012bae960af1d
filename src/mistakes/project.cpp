#include "mistakes/project.h"

#include <glm/common.hpp>

namespace rasterwalk {

ProjectedVertex project_marking_column(const ClipVertex& vertex, const VertexRules& rules,
                                       const Stages& stages, VertexSpaces* spaces) {
    ProjectedVertex result = project(vertex, rules, stages, spaces);
    constexpr int mark = -1;
    if (result.has_pixel && result.pixel.column == mark) {
        result.rejection = Rejection::taken_for_behind;
    }
    return result;
}

glm::ivec2 snap_into_picture(const glm::vec2& projected, glm::ivec2 middle,
                             const VertexRules& rules) {
    const glm::ivec2 last(rules.viewport.width - 1, rules.viewport.height - 1);
    return glm::clamp(snap_to_pixel(projected, middle, rules), glm::ivec2(0), last);
}

} // namespace rasterwalk
