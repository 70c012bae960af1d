// The mistakes of shadows, each in the lab's room, with its described symptom.

#include "laboratory/bug.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "explain/fragment_report.h"
#include "inspect/shadow_count.h"
#include "mistakes/shadow.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace shadow_bug_tests {

/// Both runs of a mistake in a smaller picture.
struct ShadowRuns {
    Session session;
    Frame wrong, right;

    explicit ShadowRuns(std::string_view id) {
        session = open_session(lessons_folder() + "/scenes/lab-room.toml");
        open_bug(find_bug(read_bugs(), id), session);
        wrong = frame_of(session.a.settings);
        right = frame_of(session.b->settings);
    }
    Frame frame_of(Settings settings) const {
        settings.viewport = {120, 120};
        settings.camera.focal_length = 120.0f;
        return prepare_frame(*session.scene, settings);
    }
};

/// Does light fall on the middle of a pixel?
std::optional<ShadowTerms> shadow_at(const Frame& frame, glm::ivec2 pixel) {
    const std::optional<Cursor> cursor = fragment_on_pixel(frame, pixel, cursor_end);
    REQUIRE(cursor);
    const std::optional<FragmentReport> report = fragment_report(frame, *cursor);
    REQUIRE(report);
    if (!report->light.shadow.is_tested) return std::nullopt;
    return report->light.shadow;
}

TEST_CASE("B58: without a bias lit surfaces are striped, and the two depths are nearly the same") {
    const ShadowRuns runs("B58");
    const ShadowCount wrong = count_shadows(runs.wrong).all, right = count_shadows(runs.right).all;
    CHECK(wrong.acne > wrong.facing / 8);
    CHECK(right.acne < right.facing / 500);
    int near = 0, stripes = 0;
    for (int column = 2; column < 118; column += 2) {
        const std::optional<ShadowTerms> shadow = shadow_at(runs.wrong, {column, 14});
        if (!shadow || !shadow->is_dark()) continue;
        ++stripes;
        near += std::abs(1.0f / shadow->texels[0].inv_depth - shadow->from_face.z) < 0.05f ? 1 : 0;
    }
    CHECK(stripes > 5);
    CHECK(near == stripes);
}

TEST_CASE("B59: with far too much bias shadows begin away from what casts them") {
    const ShadowRuns runs("B59");
    const ShadowCount wrong = count_shadows(runs.wrong).all, right = count_shadows(runs.right).all;
    CHECK(wrong.acne < 20);
    CHECK(wrong.leaks > right.in_shadow / 20);
    CHECK(right.leaks < right.in_shadow / 50);
    CHECK(wrong.in_shadow < right.in_shadow);
    // Places lit by mistake are within half a unit of the surface that shades them, seen from the
    // lamp.
    const Framebuffer dark = draw_frame(runs.right), lit = draw_frame(runs.wrong);
    int seen = 0;
    for (int row = 0; row < 120; ++row) {
        for (int column = 0; column < 120; ++column) {
            const std::size_t i = dark.at(column, row);
            if (dark.colour[i] == lit.colour[i]) continue;
            const std::optional<ShadowTerms> shadow = shadow_at(runs.right, {column, row});
            REQUIRE(shadow);
            const float behind = shadow->from_face.z - 1.0f / shadow->texels[0].inv_depth;
            CHECK(behind > 0.05f);
            CHECK(behind <= 0.5f);
            ++seen;
        }
    }
    CHECK(seen > 20);
}

TEST_CASE(
    "B60: past the lamp the walls behind it cast shadows, and only the open side lets light in") {
    const ShadowRuns runs("B60");
    const Framebuffer wrong = draw_frame(runs.wrong), right = draw_frame(runs.right);
    const glm::dvec3 lamp(runs.wrong.settings.light.position);
    int by_mistake = 0, lit = 0;
    for (int row = 1; row < 120; row += 3) {
        for (int column = 1; column < 120; column += 3) {
            const std::optional<ShadowTerms> shadow = shadow_at(runs.wrong, {column, row});
            if (!shadow || wrong.owner[wrong.at(column, row)] < 0) continue;
            if (shadow->is_dark()) {
                const std::size_t i = wrong.at(column, row);
                const bool is_mistaken = wrong.colour[i] != right.colour[i];
                CHECK(is_mistaken == (shadow->hit.t > 1.0f));
                by_mistake += is_mistaken ? 1 : 0;
                continue;
            }
            ++lit;
            // Extended, the ray leaves the room by the open side, z = −1, within x and y from −1 to
            // 1.
            const glm::dvec3 from(shadow->ray.from), way(shadow->ray.direction);
            CHECK(way.z < 0.0);
            const glm::dvec3 out = from + way * ((-1.0 - from.z) / way.z);
            CHECK(std::abs(out.x) < 1.0 + 1e-3);
            CHECK(std::abs(out.y) < 1.0 + 1e-3);
        }
    }
    CHECK(by_mistake > 300);
    CHECK(lit > 100);
    CHECK(count_shadows(runs.right).all.in_shadow * 4 < count_shadows(runs.wrong).all.in_shadow);
}

} // namespace shadow_bug_tests
} // namespace
