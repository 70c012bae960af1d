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

ScreenPlace snap_into_picture(const glm::vec2& projected, glm::ivec2 middle,
                              const VertexRules& rules) {
    const glm::ivec2 last(rules.viewport.width - 1, rules.viewport.height - 1);
    const ScreenPlace place = snap_to_pixel(projected, middle, rules);
    return {glm::clamp(place.position, glm::vec2(0.5f), glm::vec2(last) + 0.5f),
            glm::clamp(place.pixel, glm::ivec2(0), last)};
}

} // namespace rasterwalk
