// The filled stages, compared with a ray caster.
//
// Which place in the picture does a pixel stand for? Not a single one. Vertices are cut to whole
// pixels, which moves each by less than one pixel along either axis; the samples of an edge are cut
// again, which moves them by less than another. Every number of a fragment is blended from its
// samples, like its place, so it is the number at some place of the true triangle less than two
// pixels away along either axis. That is proved, not observed; accumulated float steps add a
// little, measured below. So a fragment is right if its number is between the least and the largest
// that rays find in the square of two pixels around it. 1/z and light per vertex are extreme at the
// corners of any square; light per pixel is sampled within it too.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "pipeline/draw.h"
#include "support/effort.h"
#include "support/ray_caster.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// The farthest that a fragment's numbers can be from their place, pixels along either axis.
constexpr double reach = 2.0;

/// The error that accumulated float steps can add, relative to the number. Measured: 1e-5 at worst.
constexpr double float_error = 3e-5;

/// Pixels nearer than this to an edge of any triangle are left out: there two pixels along both
/// axes can lead into another triangle.
constexpr double edge_margin = 3.0;

struct Interval {
    double low = INFINITY, high = -INFINITY;
    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    /// How far the value is from the middle, 1 at either end.
    double strain(double value) const {
        const double middle = 0.5 * (low + high);
        const double half = 0.5 * (high - low) + float_error * std::abs(middle);
        return std::abs(value - middle) / half;
    }
};

/// The values that rays around the place find; `grid` steps of the square along each axis.
template <class Value>
Interval around(const RayCaster& rays, int triangle, glm::dvec2 place, int grid, Value value) {
    Interval interval;
    for (int i = 0; i <= grid; ++i) {
        for (int j = 0; j <= grid; ++j) {
            const glm::dvec2 offset(2.0 * i / grid - 1.0, 2.0 * j / grid - 1.0);
            interval.include(value(rays.on_plane(triangle, place + reach * offset)));
        }
    }
    return interval;
}

/// What the rays find at every pixel of a picture.
class RayPicture {
  public:
    static constexpr int left_out = -2, nothing = -1;

    /// Only every `every`-th pixel of each row is tested.
    RayPicture(const Scene& scene, const Settings& settings, int every = 1)
        : rays(scene, settings.camera, settings.light), size(settings.viewport) {
        for (int row = 0; row < size.height; ++row) {
            for (int column = 0; column < size.width; ++column)
                owners.push_back((column + row) % every == 0 ? owner_at(place(column, row))
                                                             : left_out);
        }
    }
    glm::dvec2 place(int column, int row) const {
        return {column - size.width / 2, row - size.height / 2};
    }

    RayCaster rays;
    Viewport size;
    std::vector<int> owners; ///< the nearest triangle, nothing, or left_out

  private:
    int owner_at(glm::dvec2 at) const {
        if (rays.distance_to_edges(at) < edge_margin) return left_out;
        const std::vector<RayHit> hits = rays.hits(at);
        if (hits.empty()) return nothing;
        const auto zinv = [](const RayHit& hit) { return hit.zinv; };
        const bool decided =
            hits.size() == 1 || around(rays, hits[1].triangle, at, 1, zinv).high <
                                    around(rays, hits[0].triangle, at, 1, zinv).low;
        return decided ? hits[0].triangle : left_out;
    }
};

/// The result of a comparison: how many numbers are outside what rays allow, and the worst.
struct Verdict {
    int pixels = 0, wrong = 0;
    double worst = 0.0;
    std::string text;

    void add(double strain, int column, int row, const char* what, double drawn, double low,
             double high) {
        wrong += strain <= 1.0 ? 0 : 1;
        if (strain <= worst) return;
        worst = strain;
        char line[160];
        std::snprintf(line, sizeof line, "column %d row %d, %s: drawn %.9g, rays %.9g to %.9g",
                      column, row, what, drawn, low, high);
        text = line;
    }
};

void compare_light(Verdict& verdict, const RayPicture& picture, const StripStep& stage,
                   int triangle, int column, int row, const glm::vec3& colour) {
    const RayCaster& rays = picture.rays;
    const glm::dvec2 place = picture.place(column, row);
    const bool at_vertices = stage == StripStep::vertex_light;
    for (int c = 0; c < 3; ++c) {
        const auto light = [&](const RayHit& hit) {
            return at_vertices ? rays.light_from_vertices(hit)[c] : rays.light_at_point(hit)[c];
        };
        Interval interval = around(rays, triangle, place, at_vertices ? 1 : 4, light);
        // Close to the lamp the brightest point can be between the samples.
        const double strain = interval.strain(colour[c]);
        if (!at_vertices && strain > 1.0 && strain < 1.5)
            interval = around(rays, triangle, place, 24, light);
        verdict.add(interval.strain(colour[c]), column, row, "light", colour[c], interval.low,
                    interval.high);
    }
}

Verdict compare(const Frame& frame, const RayPicture& picture) {
    const Framebuffer drawn = draw_frame(frame);
    const StripStep stage = step_of(frame.settings);
    Verdict verdict;
    for (int row = 0; row < drawn.size.height; ++row) {
        for (int column = 0; column < drawn.size.width; ++column) {
            const std::size_t pixel = drawn.at(column, row);
            const int expected = picture.owners[pixel];
            if (expected == RayPicture::left_out) continue;
            ++verdict.pixels;
            if (drawn.owner[pixel] != expected) {
                verdict.add(INFINITY, column, row, "triangle", drawn.owner[pixel], expected,
                            expected);
                continue;
            }
            if (expected == RayPicture::nothing) continue;
            const Interval depth = around(picture.rays, expected, picture.place(column, row), 1,
                                          [](const RayHit& hit) { return hit.zinv; });
            verdict.add(depth.strain(drawn.depth[pixel]), column, row, "1/z", drawn.depth[pixel],
                        depth.low, depth.high);
            if (stage.stage != Stage::depth)
                compare_light(verdict, picture, stage, expected, column, row, drawn.colour[pixel]);
        }
    }
    return verdict;
}

constexpr std::array<StripStep, 3> lit_stages = {
    {{Stage::depth}, StripStep::vertex_light, StripStep::pixel_light}};

Settings pose_settings(const Scene& scene, const Pose& pose) {
    Settings settings = default_settings(scene);
    settings.camera = pose.camera;
    settings.viewport = pose.viewport;
    return settings;
}

void require_agreement(const Scene& scene, const Settings& settings, const RayPicture& picture) {
    const Frame frame = prepare_frame(scene, settings);
    for (int t = 0; t < frame.triangle_count(); ++t)
        REQUIRE(frame.is_drawn(t));
    const Verdict verdict = compare(frame, picture);
    CAPTURE(strip_place(step_of(settings)), static_cast<int>(settings.line_walk), verdict.pixels,
            verdict.worst, verdict.wrong);
    if (verdict.wrong > 0) FAIL(verdict.text);
    // Most of the picture must be compared, or the test would say little.
    CHECK(verdict.pixels > settings.viewport.width * settings.viewport.height * 6 / 10);
}

} // namespace

TEST_CASE("Coverage, 1/z and light of the handout's picture are what rays find") {
    const Scene room = lab_room();
    for (const float power : some_of(std::vector{1.1f, 14.0f}, 1)) {
        Settings settings = pose_settings(room, room_poses().front());
        settings.light.power = glm::vec3(power);
        const RayPicture picture(room, settings);
        for (const StripStep& stage : lit_stages) {
            set_step(settings, stage);
            CAPTURE(power);
            require_agreement(room, settings, picture);
        }
    }
}

TEST_CASE("From other cameras and in other light, exact or not, the picture is what rays find") {
    const Scene room = lab_room();
    for (const Pose& pose : some_of(room_poses(), 2)) {
        Settings settings = pose_settings(room, pose);
        settings.light = {{-0.3f, 0.1f, -0.6f}, {14.0f, 9.0f, 5.0f}, {0.2f, 0.3f, 0.4f}};
        const RayPicture picture(room, settings);
        CAPTURE(pose.name);
        for (const StripStep& stage : some_of(lit_stages, 1)) {
            set_step(settings, stage);
            set_rounding(settings, Rounding::truncate);
            settings.line_walk = LineWalk::accumulate;
            require_agreement(room, settings, picture);
            set_rounding(settings, Rounding::floor);
            settings.line_walk = LineWalk::exact;
            require_agreement(room, settings, picture);
        }
    }
}

TEST_CASE("Affine interpolation does not agree with rays") {
    const Scene room = lab_room();
    Settings settings = pose_settings(room, room_poses().front());
    settings.light.power = glm::vec3(14.0f);
    settings.interpolation = Interpolation::affine;
    const RayPicture picture(room, settings, 7);
    for (const StripStep& stage : {StripStep::vertex_light, StripStep::pixel_light}) {
        set_step(settings, stage);
        const Verdict verdict = compare(prepare_frame(room, settings), picture);
        // Measured: two thirds of the light is wrong, the worst by 30 times what rays allow.
        CHECK(verdict.wrong > verdict.pixels);
        CHECK(verdict.worst > 20.0);
    }
    // 1/z is interpolated either way, and stays right.
    settings.stage = Stage::depth;
    CHECK(compare(prepare_frame(room, settings), picture).wrong == 0);
}

TEST_CASE("Rays notice a camera, lamp or depth test that is slightly off") {
    const Scene room = lab_room();
    Settings settings = pose_settings(room, room_poses()[1]);
    settings.light.power = glm::vec3(14.0f);
    const RayPicture picture(room, settings, 3);
    const auto notice = [&](auto change) {
        Settings off = settings;
        change(off);
        return compare(prepare_frame(room, off), picture).wrong;
    };
    REQUIRE(notice([](Settings&) {}) == 0);
    CHECK(notice([](Settings& s) { s.camera.yaw += 0.01f; }) > 0);
    CHECK(notice([](Settings& s) { s.camera.pitch -= 0.01f; }) > 0);
    CHECK(notice([](Settings& s) { s.camera.position.z += 0.03f; }) > 0);
    CHECK(notice([](Settings& s) { s.camera.focal_length *= 1.02f; }) > 0);
    CHECK(notice([](Settings& s) { s.light.position.x += 0.05f; }) > 0);
    CHECK(notice([](Settings& s) { s.light.power.g *= 1.05f; }) > 0);
    CHECK(notice([](Settings& s) { s.light.indirect.b += 0.03f; }) > 0);
    CHECK(notice([](Settings& s) { s.depth_test = DepthTest::off; }) > 0);
}
