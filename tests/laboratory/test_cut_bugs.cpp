// The mistakes in culling and clipping, checked against the triangles of the scene.

#include <cmath>

#include <glm/geometric.hpp>

#include "compare/compare.h"
#include "laboratory/drawn_bug.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace cut_bug_tests {

/// dot(n, p - from), with n from the order of the corners in the world.
double away_from(const Frame& frame, int triangle, const glm::dvec3& from) {
    const auto corner = [&](int v) {
        return glm::dvec3(frame.scene->corner(triangle, v).position);
    };
    const glm::dvec3 across = glm::cross(corner(2) - corner(0), corner(1) - corner(0));
    return glm::dot(glm::normalize(across), corner(0) - from);
}

int culled_count(const Frame& frame) {
    int count = 0;
    for (int t = 0; t < frame.triangle_count(); ++t)
        count += frame.rejection(t) == Rejection::back_facing ? 1 : 0;
    return count;
}

TEST_CASE("B81: triangles facing away from the lamp are missing, whichever side the camera sees") {
    const DrawnBug bug("B81");
    const glm::dvec3 lamp(bug.wrong.settings.light.position),
        camera(bug.wrong.settings.camera.position);
    int missing = 0, drawn_backs = 0;
    for (int t = 0; t < bug.wrong.triangle_count(); ++t) {
        const bool is_wrong_back = bug.wrong.rejection(t) == Rejection::back_facing;
        const bool is_back = bug.right.rejection(t) == Rejection::back_facing;
        INFO("triangle " << t);
        CHECK(is_wrong_back == (away_from(bug.wrong, t, lamp) > 0.0));
        CHECK(is_back == (away_from(bug.right, t, camera) > 0.0));
        missing += is_wrong_back && !is_back ? 1 : 0;
        drawn_backs += is_back && !is_wrong_back ? 1 : 0;
    }
    CHECK(missing > 0);
    CHECK(drawn_backs > 0);
    CHECK(pixel_difference(bug.wrong_picture, bug.right_picture).different > 1000);
    // As the lamp moves their number changes, only because of the mistake.
    const auto culled_with_lamp_at = [&](Settings settings, const glm::vec3& place) {
        settings.light.position = place;
        return culled_count(bug.frame_of(settings));
    };
    const glm::vec3 elsewhere(0.0f, 0.9f, -3.0f);
    CHECK(culled_with_lamp_at(bug.wrong.settings, elsewhere) != culled_count(bug.wrong));
    CHECK(culled_with_lamp_at(bug.right.settings, elsewhere) == culled_count(bug.right));
}

TEST_CASE("B82: a cut corner is in the right place, with the values of the one cut off") {
    const DrawnBug bug("B82");
    const float near = bug.wrong.settings.near;
    const float camera_z = bug.wrong.settings.camera.position.z;
    int cut_corners = 0;
    for (int t = 0; t < bug.wrong.triangle_count(); ++t) {
        const PolygonCorners wrong = bug.wrong.triangle_vertices(t),
                             right = bug.right.triangle_vertices(t);
        REQUIRE(wrong.size() == right.size());
        for (std::size_t v = 0; v < wrong.size(); ++v) {
            CHECK(wrong[v].position == right[v].position);
            CHECK(wrong[v].depth == right[v].depth);
            const glm::dvec2 carried =
                glm::dvec2(wrong[v].varyings.texcoord) / double{wrong[v].inv_w};
            const glm::dvec2 expected =
                glm::dvec2(right[v].varyings.texcoord) / double{right[v].inv_w};
            if (std::abs(wrong[v].z - near) > 1e-4f) {
                CHECK(glm::distance(carried, expected) < 1e-4);
                continue;
            }
            ++cut_corners;
            CHECK(glm::distance(carried, expected) > 0.5);
            // For one of the corners behind the plane.
            int alike = 0;
            for (int c = 0; c < triangle_corners; ++c) {
                const Vertex& corner = bug.wrong.scene->corner(t, c);
                const bool is_behind = corner.position.z - camera_z < near;
                const double distance = glm::distance(carried, glm::dvec2(corner.texcoord));
                alike += is_behind && distance < 1e-3 ? 1 : 0;
            }
            CHECK(alike == 1);
        }
    }
    CHECK(cut_corners == 4);
    CHECK(bug.wrong_picture.owner == bug.right_picture.owner);
    CHECK(bug.wrong_picture.depth == bug.right_picture.depth);
    CHECK(pixel_difference(bug.wrong_picture, bug.right_picture).different > 3000);
    // Uncut triangles are unchanged.
    Settings far_back = bug.wrong.settings;
    far_back.camera.position.z = 0.0f;
    const Framebuffer wrong = draw_frame(bug.frame_of(far_back));
    far_back.clip = Clip::near;
    CHECK(has_same_planes(wrong, draw_frame(bug.frame_of(far_back))));
}

} // namespace cut_bug_tests
} // namespace
