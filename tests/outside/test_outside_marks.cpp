#include "outside/label_places.h"
#include "outside/outside_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "outside/eye_line.h"
#include "outside/outline.h"
#include "support/effort.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

struct Seen {
    OutsideScene outside_scene;
    OutsideEye eye;
    glm::ivec2 size{900, 700};

    Seen(const Scene& scene, const OutsideView& view) {
        outside_scene.box = box_of(scene);
        outside_scene.plane = picture_plane(scene.camera, scene.viewport, outside_scene.box);
        outside_scene.lamp = scene.light.position;
        eye = eye_of(view, outside_scene, size, 40.0);
    }
    OutsideMarks marks(const Scene& scene, int triangle) const {
        return outside_marks(scene, outside_scene, eye, {triangle}, glm::ivec2(250, 400), size);
    }
};

std::vector<OutsidePoint> points_of(const OutsideMarks& marks, OutsidePointKind kind) {
    std::vector<OutsidePoint> points;
    std::copy_if(marks.points.begin(), marks.points.end(), std::back_inserter(points),
                 [&](const OutsidePoint& point) { return point.kind == kind; });
    return points;
}

std::vector<OutsideLine> lines_of(const OutsideMarks& marks, OutsideLineKind kind) {
    std::vector<OutsideLine> lines;
    std::copy_if(marks.lines.begin(), marks.lines.end(), std::back_inserter(lines),
                 [&](const OutsideLine& line) { return line.kind == kind; });
    return lines;
}

/// Distance from a line through both ends, pixels.
float distance_to(const OutsideLine& line, const glm::vec2& point) {
    const glm::vec2 way = glm::normalize(line.to - line.from);
    const glm::vec2 from = point - line.from;
    return std::abs(way.x * from.y - way.y * from.x);
}

} // namespace

TEST_CASE("The rays of a triangle go from its vertices through the picture into the camera") {
    const Scene room = lab_room();
    const Seen seen(room, {});
    for (int triangle = 0; triangle < room.triangle_count(); ++triangle) {
        INFO("triangle " << triangle);
        const OutsideMarks marks = seen.marks(room, triangle);
        const auto rays = lines_of(marks, OutsideLineKind::ray);
        const auto crossings = points_of(marks, OutsidePointKind::crossing);
        const auto vertices = points_of(marks, OutsidePointKind::vertex);
        const auto camera = points_of(marks, OutsidePointKind::camera);
        REQUIRE(camera.size() == 1);
        REQUIRE(rays.size() == 3);
        REQUIRE(crossings.size() == 3);
        REQUIRE(vertices.size() == 3);
        for (std::size_t v = 0; v < 3; ++v) {
            CHECK(glm::length(rays[v].from - camera[0].at) < 0.01f);
            CHECK(glm::length(rays[v].to - vertices[v].at) < 0.01f);
            CHECK(distance_to(rays[v], crossings[v].at) < 0.05f);
            CHECK(crossings[v].number == static_cast<int>(v));
            // It goes through the pixel on which the vertex falls.
            const glm::dvec3 p = seen.outside_scene.plane.in_camera(
                room.corner(triangle, static_cast<int>(v)).position);
            const glm::dvec2 pixel(500.0 * p.x / p.z + 250.0, 500.0 * p.y / p.z + 250.0);
            const auto at = seen.eye.pixel_of(seen.outside_scene.plane.place_of(pixel));
            REQUIRE(at);
            CHECK(glm::length(glm::vec2(*at) - crossings[v].at) < 0.01f);
        }
        CHECK(lines_of(marks, OutsideLineKind::edge).size() == 3);
        CHECK(lines_of(marks, OutsideLineKind::behind).empty());
    }
}

TEST_CASE("The frustum goes through the corners of the picture") {
    const Scene room = lab_room();
    const Seen seen(room, {});
    const OutsideMarks marks = seen.marks(room, 3);
    const auto frustum = lines_of(marks, OutsideLineKind::frustum);
    const auto beyond = lines_of(marks, OutsideLineKind::beyond);
    const auto border = lines_of(marks, OutsideLineKind::border);
    REQUIRE(frustum.size() == 4);
    REQUIRE(beyond.size() == 4);
    REQUIRE(border.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(glm::length(frustum[i].to - border[i].from) < 0.01f);
        CHECK(glm::length(frustum[i].to - border[(i + 3) % 4].to) < 0.01f);
        CHECK(distance_to(frustum[i], beyond[i].from) < 0.01f);
    }
    CHECK(points_of(marks, OutsidePointKind::lamp).size() == 1);
    CHECK(points_of(marks, OutsidePointKind::picture).size() == 4);
    CHECK(points_of(marks, OutsidePointKind::pixel).size() == 1);
}

TEST_CASE("A vertex behind the camera has a ray of its own kind and no place in the picture") {
    Scene room = lab_room();
    room.camera.position.z = 0.0f; // in the middle of the room
    const Seen seen(room, {});
    int behind = 0;
    for (int triangle = 0; triangle < room.triangle_count(); ++triangle) {
        const OutsideMarks marks = seen.marks(room, triangle);
        int expected = 0;
        for (int v = 0; v < 3; ++v)
            expected += room.corner(triangle, v).position.z <= 0.0f ? 1 : 0;
        CHECK(points_of(marks, OutsidePointKind::behind).size() ==
              static_cast<std::size_t>(expected));
        CHECK(lines_of(marks, OutsideLineKind::behind).size() ==
              static_cast<std::size_t>(expected));
        CHECK(lines_of(marks, OutsideLineKind::ray).size() ==
              static_cast<std::size_t>(3 - expected));
        behind += expected;
    }
    CHECK(behind > 0);
}

TEST_CASE("Marks end where the view ends") {
    const Scene room = lab_room();
    Random random(71);
    for (int i = 0; i < 200; ++i) {
        OutsideView view;
        view.yaw = random.number(-4, 4);
        view.pitch = random.number(-1.5, 1.5);
        view.distance = random.number(0.01, 3);
        view.target = {random.number(-1, 1), random.number(-1, 1), random.number(-3, 1)};
        const Seen seen(room, view);
        const OutsideMarks marks = seen.marks(room, random.integer(-1, 30));
        for (const OutsideLine& line : marks.lines) {
            for (const glm::vec2& end : {line.from, line.to}) {
                REQUIRE(end.x > -50.0f);
                REQUIRE(end.y > -50.0f);
                REQUIRE(end.x < 950.0f);
                REQUIRE(end.y < 750.0f);
            }
        }
        for (const OutsidePoint& point : marks.points) {
            REQUIRE(point.at.x >= 0.0f);
            REQUIRE(point.at.x <= 900.0f);
        }
    }
}

TEST_CASE("Names are inside the view, next to their points, and cover nothing") {
    Random random(72);
    const glm::vec2 size(500.0f, 300.0f);
    int placed = 0;
    for (int i = 0; i < 200; ++i) {
        std::vector<OutsideLabel> labels;
        std::vector<OutsideBox> taken;
        for (int k = 0; k < 8; ++k) {
            const glm::vec2 at(random.number(0, 500), random.number(0, 300));
            taken.push_back({at - 6.0f, at + 6.0f});
            labels.push_back({at,
                              {random.number(20, 120), 16.0f},
                              8.0f,
                              k % 2 == 0 ? LabelSide::below : LabelSide::right});
        }
        const auto places = label_places(labels, taken, {}, size);
        REQUIRE(places.size() == labels.size());
        for (std::size_t a = 0; a < places.size(); ++a) {
            if (!places[a]) continue;
            ++placed;
            const glm::vec2 low = *places[a], high = low + labels[a].size;
            CHECK(low.x >= 0.0f);
            CHECK(low.y >= 0.0f);
            CHECK(high.x <= size.x);
            CHECK(high.y <= size.y);
            for (const OutsideBox& box : taken) {
                const bool is_over = low.x < box.high.x && box.low.x < high.x &&
                                     low.y < box.high.y && box.low.y < high.y;
                CHECK_FALSE(is_over);
            }
            for (std::size_t b = 0; b < a; ++b) {
                if (!places[b]) continue;
                const glm::vec2 other = *places[b], end = other + labels[b].size;
                const bool is_over =
                    low.x < end.x && other.x < high.x && low.y < end.y && other.y < high.y;
                CHECK_FALSE(is_over);
            }
        }
    }
    CHECK(placed > 1000);
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const OutsideLabel nowhere{{nan, nan}, {10.0f, 10.0f}, 1.0f};
    CHECK_FALSE(label_places(std::array{nowhere}, {}, {}, size)[0]);
}

TEST_CASE("A name that keeps off lines touches none of them") {
    const glm::vec2 size(500.0f, 300.0f);
    const OutsideLine across{OutsideLineKind::ray, 0, {250.0f, 150.0f}, {450.0f, 150.0f}};
    OutsideLabel name{{250.0f, 150.0f}, {60.0f, 16.0f}, 8.0f};
    const auto left_of = [&] {
        return label_places(std::array{name}, {}, std::array{across}, size).at(0)->x;
    };
    name.line_distance = 3.0f;
    CHECK(left_of() + name.size.x < 250.0f);
    CHECK(label_places(std::array{name}, {}, {}, size).at(0)->x == 258.0f);
    // If everything else is taken it can be on the line, unless it must keep its distance.
    const std::vector<OutsideBox> taken{{{0.0f, 0.0f}, {257.0f, 300.0f}},
                                        {{0.0f, 0.0f}, {500.0f, 141.0f}},
                                        {{0.0f, 159.0f}, {500.0f, 300.0f}}};
    const auto between = [&] {
        return label_places(std::array{name}, taken, std::array{across}, size).at(0);
    };
    REQUIRE(between());
    CHECK(between()->x == 258.0f);
    name.needs_distance = true;
    CHECK_FALSE(between());

    Random random(73);
    int placed = 0, left_out = 0;
    for (int i = 0; i < test::rounds(200, 40); ++i) {
        std::vector<OutsideLine> lines;
        for (int k = 0; k < 6; ++k) {
            lines.push_back({OutsideLineKind::ray,
                             k,
                             {random.number(0, 500), random.number(0, 300)},
                             {random.number(0, 500), random.number(0, 300)}});
        }
        name.point = {random.number(0, 500), random.number(0, 300)};
        const auto place = label_places(std::array{name}, {}, lines, size).at(0);
        if (!place) {
            ++left_out;
            continue;
        }
        ++placed;
        const glm::vec2 low = *place - 2.9f, high = *place + name.size + 2.9f;
        for (const OutsideLine& line : lines) {
            // Point by point, half a pixel apart.
            for (int step = 0; step <= 1200; ++step) {
                const glm::vec2 at =
                    line.from + static_cast<float>(step) / 1200.0f * (line.to - line.from);
                const bool is_over = at.x > low.x && at.x < high.x && at.y > low.y && at.y < high.y;
                REQUIRE_FALSE(is_over);
            }
        }
    }
    CHECK(placed > 10);
    CHECK(left_out > 0);
}

TEST_CASE("The most important names are placed first, and shifted if near the border") {
    const OutsideLabel first{{3.0f, 50.0f}, {40.0f, 16.0f}, 8.0f, LabelSide::below};
    const OutsideLabel second{{5.0f, 52.0f}, {40.0f, 16.0f}, 8.0f, LabelSide::below};
    // Everything next to and above both points is taken.
    const std::vector<OutsideBox> taken{{{0.0f, 0.0f}, {100.0f, 56.0f}}};
    const glm::vec2 size(44.0f, 80.0f);
    for (const bool is_swapped : {false, true}) {
        const std::array labels{is_swapped ? second : first, is_swapped ? first : second};
        const auto places = label_places(labels, taken, {}, size);
        REQUIRE(places[0]);
        CHECK_FALSE(places[1]);
        CHECK(places[0]->x >= 0.0f);
        CHECK(places[0]->x < 4.0f);
        CHECK(places[0]->y == labels[0].point.y + labels[0].distance);
    }
}

TEST_CASE("The outline of the room has the edges of its boxes and no diagonals") {
    const Scene room = lab_room();
    const std::vector<OutlineEdge> outline = outline_of(room);
    CHECK(outline.size() == 36); // three boxes, each open on one side
    for (const OutlineEdge& edge : outline) {
        // Edges of the room run along an axis, those of the blocks are level or upright.
        const glm::vec3 way = glm::abs(edge.to - edge.from);
        const bool is_upright = way.x < 1e-3f && way.z < 1e-3f;
        CHECK((is_upright || way.y < 1e-3f));
        CHECK(glm::length(way) < 2.01f);
    }
}

TEST_CASE("A line is cut at the near plane and at the border") {
    OutsideEye eye;
    eye.focal_length = 100.0;
    eye.middle = {50.0, 50.0};
    eye.near_distance = 0.5;
    const EyeLine cut = eye_line(eye, {1.0, 0.0, -1.5}, {1.0, 0.0, 2.5});
    REQUIRE(cut.is_seen);
    CHECK(cut.from.x == Approx(50.0 + 100.0 / 0.5));
    CHECK(cut.to.x == Approx(50.0 + 100.0 / 2.5));
    CHECK(cut.inv_z_from == Approx(2.0));
    CHECK_FALSE(eye_line(eye, {0.0, 0.0, 0.1}, {1.0, 1.0, -3.0}).is_seen);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(eye_line(eye, {nan, 0.0, 1.0}, {1.0, 1.0, 3.0}).is_seen);
    const EyeLine part = clipped_to(cut, {0.0, 0.0}, {100.0, 100.0});
    REQUIRE(part.is_seen);
    CHECK(part.from.x == Approx(100.0));
    CHECK(part.from.y == Approx(50.0));
    CHECK_FALSE(clipped_to(cut, {0.0, 60.0}, {100.0, 100.0}).is_seen);
    // 1/z is linear along it: where the line is at x = 100, z is 2.
    CHECK(part.inv_z_from == Approx(0.5));
}

TEST_CASE("A shifted texture shows the ray of sight, the texel and its height") {
    const Scene scene = test::lab_room();
    const Seen seen(scene, {});
    const SightShift shift{{0.4, 0.9, 0.3}, {0.3, 0.8, 0.3}, {0.3, 0.8, 0.1}};
    const OutsideMarks marks =
        outside_marks(scene, seen.outside_scene, seen.eye, {}, {}, seen.size, {.shift = shift});
    const auto is_at = [&](const glm::vec2& place, const glm::dvec3& world) {
        return glm::distance(glm::dvec2(place), *seen.eye.pixel_of(world)) < 0.01;
    };
    const std::array<std::pair<glm::dvec3, glm::dvec3>, 3> wanted{
        {{seen.outside_scene.plane.eye, shift.seen},
         {shift.texel, shift.top},
         {shift.seen, shift.texel}}};
    const std::array kinds{OutsideLineKind::sight_ray, OutsideLineKind::imagined,
                           OutsideLineKind::shift};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const auto lines = lines_of(marks, kinds[i]);
        REQUIRE(lines.size() == 1);
        CHECK(is_at(lines.front().from, wanted[i].first));
        CHECK(is_at(lines.front().to, wanted[i].second));
    }
    REQUIRE(points_of(marks, OutsidePointKind::texel).size() == 1);
    CHECK(is_at(points_of(marks, OutsidePointKind::texel).front().at, shift.texel));
}

TEST_CASE("A pixel's footprint is where its corners meet the plane of the triangle") {
    const Scene scene = test::lab_room();
    const Seen seen(scene, {});
    int drawn = 0;
    for (int triangle = 0; triangle < scene.triangle_count(); ++triangle) {
        for (const glm::ivec2 pixel : {glm::ivec2(250, 400), glm::ivec2(61, 262)}) {
            // The plane and the rays again, by Cramer's rule: a + s (b - a) + t (c - a) = z ray.
            using Vector = glm::tvec3<long double>;
            const Vector a(scene.corner(triangle, 0).position);
            const Vector ab = Vector(scene.corner(triangle, 1).position) - a;
            const Vector ac = Vector(scene.corner(triangle, 2).position) - a;
            const Vector eye(scene.camera.position);
            const auto determinant = [](const Vector& p, const Vector& q, const Vector& r) {
                return p.x * (q.y * r.z - q.z * r.y) - p.y * (q.x * r.z - q.z * r.x) +
                       p.z * (q.x * r.y - q.y * r.x);
            };
            std::vector<glm::dvec3> places;
            for (const glm::ivec2 corner : {pixel, pixel + glm::ivec2(1, 0),
                                            pixel + glm::ivec2(1, 1), pixel + glm::ivec2(0, 1)}) {
                const Vector ray((corner.x - 250) / 500.0L, (corner.y - 250) / 500.0L, 1.0L);
                const long double whole = determinant(ab, ac, -ray);
                if (whole == 0.0L) continue;
                const long double z = determinant(ab, ac, eye - a) / whole;
                if (z > 0.0L) places.emplace_back(eye + z * ray);
            }
            const OutsideMarks marks =
                outside_marks(scene, seen.outside_scene, seen.eye, {}, {}, seen.size,
                              {.textured = TexturedPixel{pixel, triangle}});
            const auto lines = lines_of(marks, OutsideLineKind::footprint);
            INFO("triangle " << triangle << " pixel " << pixel.x);
            if (places.size() < 4) {
                CHECK(lines.empty());
                continue;
            }
            for (const OutsideLine& line : lines) {
                const auto i = static_cast<std::size_t>(line.number);
                const auto from = seen.eye.pixel_of(places[i]);
                const auto to = seen.eye.pixel_of(places[(i + 1) % 4]);
                if (!from || !to) continue;
                const auto is_in_view = [](const glm::dvec2& at) {
                    return at.x > 0 && at.y > 0 && at.x < 900 && at.y < 700;
                };
                if (!is_in_view(*from) || !is_in_view(*to)) continue;
                CHECK(glm::distance(glm::dvec2(line.from), *from) < 0.01);
                CHECK(glm::distance(glm::dvec2(line.to), *to) < 0.01);
                ++drawn;
            }
        }
    }
    CHECK(drawn > 100);
    CHECK(lines_of(seen.marks(scene, 1), OutsideLineKind::footprint).empty());
    // A triangle that the scene does not have.
    CHECK(lines_of(outside_marks(scene, seen.outside_scene, seen.eye, {}, {}, seen.size,
                                 {.textured = TexturedPixel{{250, 400}, 9999}}),
                   OutsideLineKind::footprint)
              .empty());
}

TEST_CASE("The way to the lamp is light up to the blocker, and dashed beyond it") {
    const Scene scene = test::lab_room();
    const Seen seen(scene, {});
    const glm::dvec3 from(0.5, 1.0, 0.2), lamp(seen.outside_scene.lamp);
    const auto marks_of = [&](const std::optional<LampRay>& way) {
        return outside_marks(scene, seen.outside_scene, seen.eye, {}, {}, seen.size,
                             {.lamp_ray = way});
    };
    CHECK(lines_of(marks_of({}), OutsideLineKind::lamp_ray).empty());
    CHECK(points_of(marks_of({}), OutsidePointKind::shaded).empty());

    const OutsideMarks lit = marks_of(LampRay{from, {}});
    REQUIRE(lines_of(lit, OutsideLineKind::lamp_ray).size() == 1);
    CHECK(lines_of(lit, OutsideLineKind::blocked_ray).empty());
    CHECK(points_of(lit, OutsidePointKind::occluder).empty());
    const OutsideLine whole = lines_of(lit, OutsideLineKind::lamp_ray).front();
    const auto is_at = [&](const glm::vec2& place, const glm::dvec3& world) {
        return glm::distance(glm::dvec2(place), *seen.eye.pixel_of(world)) < 0.01;
    };
    CHECK(is_at(whole.from, from));
    CHECK(is_at(whole.to, lamp));

    const glm::dvec3 between = from + 0.3 * (lamp - from);
    const OutsideMarks dark = marks_of(LampRay{from, between});
    REQUIRE(lines_of(dark, OutsideLineKind::lamp_ray).size() == 1);
    REQUIRE(lines_of(dark, OutsideLineKind::blocked_ray).size() == 1);
    CHECK(is_at(lines_of(dark, OutsideLineKind::lamp_ray).front().to, between));
    CHECK(is_at(lines_of(dark, OutsideLineKind::blocked_ray).front().to, lamp));
    REQUIRE(points_of(dark, OutsidePointKind::occluder).size() == 1);
    CHECK(is_at(points_of(dark, OutsidePointKind::occluder).front().at, between));

    const glm::dvec3 behind = from + 1.2 * (lamp - from);
    const OutsideMarks beyond = marks_of(LampRay{from, behind});
    CHECK(lines_of(beyond, OutsideLineKind::lamp_ray).empty());
    REQUIRE(lines_of(beyond, OutsideLineKind::blocked_ray).size() == 1);
    CHECK(is_at(lines_of(beyond, OutsideLineKind::blocked_ray).front().to, behind));
}
