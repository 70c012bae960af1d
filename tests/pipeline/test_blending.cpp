// Half-transparent surfaces, compared with a second computation in double precision that knows the
// scenes only as rectangles.

#include <cmath>
#include <string>
#include <vector>

#include "mistakes/blend.h"
#include "pipeline/draw.h"
#include "pipeline/replay.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "stages/blend.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace blending {

Scene scene_of(const std::string& name) {
    return read_scene(lessons_folder() + "/scenes/" + name);
}

Framebuffer drawn(const Scene& scene, const std::string& more) {
    Settings settings = default_settings(scene);
    set_from_text(settings, "coverage=edge_functions");
    set_from_text(settings, "fill_rule=top_left");
    if (!more.empty()) set_from_text(settings, more);
    return draw_frame(prepare_frame(scene, settings));
}

/// A pane covered by the top-left rule, from its upper left corner to just past its last pixel.
struct Pane {
    int left, top, right, bottom;
    double z, alpha;
    glm::dvec3 colour;
    bool holds(int x, int y) const { return x >= left && x < right && y >= top && y < bottom; }
};

/// Blends in drawing order, on black; each drawn pane writes its depth.
glm::dvec3 composed(const std::vector<Pane>& panes, int x, int y, bool tests_depth) {
    glm::dvec3 colour(0.0);
    double nearest = 1e30;
    for (const Pane& pane : panes) {
        if (!pane.holds(x, y) || (tests_depth && pane.z >= nearest)) continue;
        nearest = pane.z;
        colour = pane.alpha * pane.colour + (1.0 - pane.alpha) * colour;
    }
    return colour;
}

void require_same(const Framebuffer& picture, const std::vector<Pane>& panes, bool tests_depth) {
    for (int y = 0; y < picture.size.height; ++y) {
        for (int x = 0; x < picture.size.width; ++x) {
            const glm::dvec3 right = composed(panes, x, y, tests_depth);
            const glm::vec3 got = picture.colour[picture.at(x, y)];
            INFO("pixel " << x << ", " << y);
            for (int i = 0; i < 3; ++i)
                REQUIRE(std::abs(static_cast<double>(got[i]) - right[i]) < 1e-6);
        }
    }
}

const glm::dvec3 white(1.0), black(0.0), red(1.0, 0.0, 0.0), blue(0.0, 0.0, 1.0);

std::vector<Pane> pane_pairs(double alpha) {
    return {{0, 0, 32, 16, 8, 1, white},
            {2, 2, 10, 10, 4, alpha, red},
            {6, 5, 14, 13, 2, alpha, blue},
            {21, 5, 29, 13, 2, alpha, blue},
            {17, 2, 25, 10, 4, alpha, red}};
}

} // namespace blending
} // namespace

TEST_CASE("A pane lets light through by its alpha: all pixels of two halves") {
    using namespace blending;
    const std::vector<Pane> pane{{0, 0, 16, 12, 4, 1, white}, {3, 1, 11, 9, 2, 0.5, black}};
    require_same(drawn(scene_of("glass-halves.toml"), ""), pane, false);
}

TEST_CASE("An edge that both halves draw has three quarters of the glass") {
    using namespace blending;
    const Framebuffer picture = drawn(scene_of("glass-halves.toml"), "fill_rule=inclusive");
    int twice = 0;
    for (int y = 1; y <= 9; ++y) {
        for (int x = 3; x <= 11; ++x) {
            INFO("pixel " << x << ", " << y);
            const bool is_on_edge = x - 3 == y - 1;
            CHECK(picture.colour[picture.at(x, y)].r == (is_on_edge ? 0.25f : 0.5f));
            twice += is_on_edge ? 1 : 0;
        }
    }
    CHECK(twice == 9);
}

TEST_CASE("Order matters: all pixels of two pairs of panes, with and without the depth test") {
    using namespace blending;
    const Scene scene = scene_of("two-panes.toml");
    require_same(drawn(scene, ""), pane_pairs(0.25), true);
    require_same(drawn(scene, "stage=fill"), pane_pairs(0.25), false);
    require_same(drawn(scene, "blend=off"), pane_pairs(1.0), true);
    require_same(drawn(scene, "blend=swapped"), pane_pairs(0.75), true);
}

TEST_CASE("Mistake B63 is not visible at one half") {
    const glm::vec3 glass(0.2f, 0.4f, 0.6f), wall(1.0f, 0.5f, 0.0f);
    CHECK(blend_swapped(glass, 0.5f, wall) == blend_over(glass, 0.5f, wall));
    CHECK(blend_swapped(glass, 0.25f, wall) == blend_over(glass, 0.75f, wall));
    CHECK(blend_over(glass, 1.0f, wall) == glass);
    CHECK(blend_over(glass, 0.0f, wall) == wall);
}

TEST_CASE("Half-transparent pictures are the same forward, backward and by leaps") {
    using namespace blending;
    const Scene scene = scene_of("two-panes.toml");
    const Frame frame = prepare_frame(scene, default_settings(scene));
    const Cursor middle{5, Phase::rows, 4, 3};
    Framebuffer right;
    clear(right, frame);
    draw(frame, {cursor_begin, middle, {}}, right);
    Replay replay;
    replay.begin(frame);
    replay.at(cursor_end);
    CHECK(replay.at(middle) == right);
}

TEST_CASE("The room does not use blend, and a scene with a pane does") {
    using namespace blending;
    const Setting& blend = *find_setting("blend");
    CHECK_FALSE(is_of_use(blend, scene_of("lab-room.toml")));
    CHECK(is_of_use(blend, scene_of("two-panes.toml")));
}
