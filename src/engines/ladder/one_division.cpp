// The lab's loop with one division and one root for the light of a pixel.
//
// With everything divided by z, r / z = lamp / z - position / z needs no division, and
//
//     power (n . r) / (4 pi r^3)  =  power (n . r/z) (1/z)^2 / (4 pi (r/z)^3)

#include "engines/ladder/depth_first.h"
#include "engines/ladder/rungs.h"

namespace rasterwalk::rungs::one_division {

namespace {

/// @param i of the pixel in its row, from 0
glm::vec3 short_colour(int i, float zinv, const RowSteps& row, const Surface& surface,
                       const Lab& lab) {
    const float steps = static_cast<float>(i);
    if (lab.is_light_per_vertex)
        return (row.left.illumination + steps * row.step_illumination) * (1.0f / zinv);
    const glm::vec3 to_light =
        lab.light.position * zinv - (row.left.position + steps * row.step_position);
    float distance2 = glm::dot(to_light, to_light), share = 0.0f;
    if (surface.is_bent) {
        const glm::vec3 normal = row.left.normal + steps * row.step_normal;
        share = glm::dot(to_light, normal) /
                (4.0f * pi * distance2 * std::sqrt(distance2 * glm::dot(normal, normal)));
    } else {
        share = glm::dot(to_light, surface.normal) / (4.0f * pi * distance2 * std::sqrt(distance2));
    }
    share = std::max(0.0f, share) * zinv * zinv;
    return surface.reflectance * (lab.light.power * share + lab.light.indirect);
}

} // namespace

void draw(const Scene& scene, const Settings& settings, LadderPicture& picture) {
    const Lab lab = begin_picture(settings, picture);
    for_each_row_table(scene, lab, [&](int rows, const RowTable& table, const Surface& surface) {
        draw_rows_depth_first(rows, table, surface, lab, short_colour);
    });
}

} // namespace rasterwalk::rungs::one_division
