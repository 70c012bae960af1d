#include "outside/outside_drawing.h"

#include <cmath>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

#include "support/outside_subject.h"
#include "support/texture_oracle.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

/// Where a ray meets a triangle: by Cramer's rule, from + t direction = a + v ab + w ac.
struct Met {
    bool is_inside = false;
    glm::dvec2 texcoord{0.0};
};

Met met_texture(const Scene& scene, int triangle, const glm::dvec3& from,
                const glm::dvec3& direction) {
    const glm::dvec3 a = scene.corner(triangle, 0).position;
    const glm::dvec3 ab = glm::dvec3(scene.corner(triangle, 1).position) - a;
    const glm::dvec3 ac = glm::dvec3(scene.corner(triangle, 2).position) - a;
    const double whole = glm::dot(glm::cross(ab, ac), -direction);
    const double v = glm::dot(glm::cross(from - a, ac), -direction) / whole;
    const double w = glm::dot(glm::cross(ab, from - a), -direction) / whole;
    const glm::dvec2 uv = glm::dvec2(scene.corner(triangle, 0).texcoord) * (1.0 - v - w) +
                          glm::dvec2(scene.corner(triangle, 1).texcoord) * v +
                          glm::dvec2(scene.corner(triangle, 2).texcoord) * w;
    return {v > 0.01 && w > 0.01 && v + w < 0.99, uv};
}

} // namespace

TEST_CASE("From outside every place of a surface shows the texel that a ray meets there") {
    constexpr int columns = 6, rows = 5;
    const Image image = test::many_colours(columns, rows);
    test::Moment moment(test::receding_wall(image), cursor_begin);
    OutsideLook look;
    look.view.yaw = 0.2f;
    look.view.pitch = 0.1f;
    look.size = {300, 220};
    look.margin = 10.0;
    for (const bool has_begun : {false, true}) {
        if (has_begun) moment.go_to(Cursor{1, Phase::rows, 0, 0});
        OutsideDrawing drawing;
        drawing.update(moment.subject(), look);
        const OutsideEye& eye = drawing.eye();
        // All places of one texel have the same colour, and those of other texels a different one.
        std::map<std::tuple<int, int, int>, std::tuple<int, int, int>> colours;
        int places = 0, wrong = 0;
        for (int y = 0; y < look.size.y; ++y) {
            for (int x = 0; x < look.size.x; ++x) {
                const OutsidePick pick = drawing.at(glm::vec2(x, y) + 0.5f);
                if (!pick.triangle) continue;
                const auto met = [&](double dx, double dy) {
                    const glm::dvec2 from_middle =
                        (glm::dvec2(x + dx, y + dy) - eye.middle) / eye.focal_length;
                    return met_texture(moment.scene(), *pick.triangle, eye.position,
                                       eye.rotation * glm::dvec3(from_middle, 1.0));
                };
                const auto texel = [&](const Met& place) {
                    return std::pair{
                        test::oracle_texel(static_cast<int>(std::floor(place.texcoord.x * columns)),
                                           columns, TextureWrap::repeat),
                        test::oracle_texel(static_cast<int>(std::floor(place.texcoord.y * rows)),
                                           rows, TextureWrap::repeat)};
                };
                // A pixel and all around it in the same texel: no border runs through it.
                const Met middle = met(0.5, 0.5);
                bool is_clear = middle.is_inside;
                for (const double dx : {-0.5, 1.5}) {
                    for (const double dy : {-0.5, 1.5}) {
                        const Met corner = met(dx, dy);
                        is_clear = is_clear && corner.is_inside && texel(corner) == texel(middle);
                    }
                }
                if (!is_clear) continue;
                const std::size_t at =
                    4 * (static_cast<std::size_t>(y) * drawing.image().width + x);
                const auto& rgba = drawing.image().rgba;
                const std::tuple<int, int, int> seen{rgba[at], rgba[at + 1], rgba[at + 2]};
                const auto [column, row] = texel(middle);
                ++places;
                wrong +=
                    colours.try_emplace({*pick.triangle, column, row}, seen).first->second != seen
                        ? 1
                        : 0;
            }
        }
        CHECK(places > 3000);
        // Lines of the outline may run through a pixel.
        CHECK(wrong < places / 100);
        CHECK(colours.size() > 20);
        // More red in the texel is more red on the screen.
        for (const auto& [one, seen_one] : colours) {
            for (const auto& [other, seen_other] : colours) {
                if (std::get<0>(one) != std::get<0>(other)) continue;
                const auto red = [&](const auto& key) {
                    return int{image.rgba[static_cast<std::size_t>(
                        4 * (std::get<2>(key) * columns + std::get<1>(key)))]};
                };
                if (red(one) > red(other) + 4 && std::get<0>(seen_one) < std::get<0>(seen_other))
                    FAIL("texel " << std::get<1>(one) << "," << std::get<2>(one)
                                  << " is less red than " << std::get<1>(other) << ","
                                  << std::get<2>(other));
            }
        }
    }
}
