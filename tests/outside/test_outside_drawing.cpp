// The picture from outside, compared with rays cast into the scene one by one.

#include "outside/outside_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>

#include <glm/geometric.hpp>

#include "pipeline/timeline.h"
#include "support/effort.h"
#include "support/made_scene.h"
#include "support/outside_subject.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

OutsideLook look_at(float yaw, float pitch, glm::ivec2 size) {
    OutsideLook look;
    look.view.yaw = yaw;
    look.view.pitch = pitch;
    look.size = size;
    look.margin = 10.0;
    return look;
}

OutsideLook camera_look(glm::ivec2 size) {
    OutsideLook look;
    look.view.is_camera = true;
    look.size = size;
    return look;
}

/// Where a ray from the eye meets a triangle, in lengths of its direction; none if it misses.
std::optional<double> intersection(const Scene& scene, int triangle, const glm::dvec3& from,
                                   const glm::dvec3& direction, double inset) {
    const glm::dvec3 a = scene.corner(triangle, 0).position;
    const glm::dvec3 ab = glm::dvec3(scene.corner(triangle, 1).position) - a;
    const glm::dvec3 ac = glm::dvec3(scene.corner(triangle, 2).position) - a;
    const glm::dvec3 p = glm::cross(direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0.0) return std::nullopt;
    const glm::dvec3 offset = from - a;
    const double u = glm::dot(offset, p) / determinant;
    const glm::dvec3 q = glm::cross(offset, ab);
    const double v = glm::dot(direction, q) / determinant;
    if (u < inset || v < inset || u + v > 1.0 - inset) return std::nullopt;
    const double t = glm::dot(ac, q) / determinant;
    return t > 0.0 ? std::optional(t) : std::nullopt;
}

/// Is a wall between the eye and the room? By the angle between its front and the eyes.
bool is_wall_between(const Scene& scene, int triangle, const glm::dvec3& eye) {
    const glm::dvec3 front =
        face_normal(scene.corner(triangle, 0).position, scene.corner(triangle, 1).position,
                    scene.corner(triangle, 2).position);
    const glm::dvec3 place = scene.corner(triangle, 2).position;
    const glm::dvec3 camera = scene.camera.position;
    return glm::dot(front, glm::normalize(eye - place)) <= 0.0 &&
           glm::dot(front, glm::normalize(camera - place)) > 0.0;
}

/// The triangle that the ray through a place of the view meets first. None if it is too close to
/// call: along an edge, or between two surfaces that are equally far away.
std::optional<int> met_by_one_ray(const Scene& scene, const OutsideDrawing& drawing,
                                  glm::vec2 place) {
    const OutsideEye& eye = drawing.eye();
    const glm::dvec2 from_middle = (glm::dvec2(place) - eye.middle) / eye.focal_length;
    const glm::dvec3 direction = eye.rotation * glm::dvec3(from_middle, 1.0);
    constexpr double hair = 0.01;
    int met = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (int t = 0; t < scene.triangle_count(); ++t) {
        if (is_wall_between(scene, t, eye.position)) continue;
        const auto inside = intersection(scene, t, eye.position, direction, hair);
        const auto about = intersection(scene, t, eye.position, direction, -hair);
        if (about && !inside) return std::nullopt;
        if (!inside) continue;
        if (std::abs(*inside - nearest) < 1e-3 * nearest) return std::nullopt;
        if (*inside < nearest) {
            nearest = *inside;
            met = t;
        }
    }
    return met;
}

/// The same, and none if a ray through the same pixel or a neighbour meets something else: a
/// triangle seen edge-on or from afar can be narrower than a pixel.
std::optional<int> met_by_ray(const Scene& scene, const OutsideDrawing& drawing, glm::vec2 place) {
    const std::optional<int> met = met_by_one_ray(scene, drawing, place);
    for (const glm::vec2 aside :
         {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(-1, 1), glm::vec2(1, 1)}) {
        if (!met || met_by_one_ray(scene, drawing, place + aside) != met) return std::nullopt;
    }
    return met;
}

glm::vec3 pixel_of(const Image& image, int column, int row) {
    const std::size_t at = 4 * (static_cast<std::size_t>(row) * image.width + column);
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

/// Do all channels differ by at most this many of 255?
bool is_near(const glm::vec3& a, const glm::vec3& b, float distance) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}) <= distance;
}

/// How many places of the view have this colour.
int count_of(const Image& image, const glm::vec3& colour) {
    int count = 0;
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column)
            count += is_near(pixel_of(image, column, row), colour, 1.5f) ? 1 : 0;
    }
    return count;
}

/// The colour of a lit triangle, which is its own.
glm::vec3 lit_colour(const Scene& scene, int triangle) {
    return 255.0f * scene.corner(triangle, 0).reflectance;
}

} // namespace

TEST_CASE("Every place of the view shows the triangle that a ray meets first") {
    Random random(61);
    const Moment moment(lab_room());
    OutsideDrawing drawing;
    int compared = 0, background = 0;
    for (int i = 0; i < rounds(40, 8); ++i) {
        const glm::ivec2 size(random.integer(200, 700), random.integer(200, 700));
        draw_all(drawing, moment, look_at(random.number(-4, 4), random.number(-1.5, 1.5), size));
        for (int k = 0; k < 200; ++k) {
            const glm::vec2 place(random.number(0, size.x - 1), random.number(0, size.y - 1));
            const OutsidePick pick = drawing.at(place);
            if (pick.pixel) continue; // the picture is in front of it
            const std::optional<int> met = met_by_ray(moment.scene(), drawing, place);
            if (!met) continue;
            INFO("view " << i << ", place " << place.x << ", " << place.y);
            REQUIRE(pick.triangle.value_or(-1) == *met);
            ++compared;
            background += *met < 0 ? 1 : 0;
        }
    }
    CHECK(compared > 20 * rounds(40, 8));
    CHECK(background > 0);
    CHECK(background < compared);
}

TEST_CASE("Through the camera no wall is culled, and the picture lies exactly over the scene") {
    const Moment moment(lab_room());
    OutsideDrawing drawing;
    draw_all(drawing, moment, camera_look({1100, 1100}));
    const OutsideEye& eye = drawing.eye();
    const double scale = eye.focal_length / static_cast<double>(moment.scene().camera.focal_length);
    REQUIRE(scale > 2.0);
    Random random(62);
    for (int i = 0; i < 500; ++i) {
        const glm::ivec2 pixel(random.integer(0, 499), random.integer(0, 499));
        const glm::vec2 place = eye.middle + scale * (glm::dvec2(pixel) + 0.5 - 250.0);
        INFO("pixel " << pixel.x << ", " << pixel.y);
        REQUIRE(drawing.at(place).pixel == pixel);
        // Where nothing is drawn the picture is transparent.
        if (pixel_of(moment.picture(), pixel.x, pixel.y) == glm::vec3(0.0f)) continue;
        REQUIRE(
            is_near(pixel_of(drawing.image(), static_cast<int>(place.x), static_cast<int>(place.y)),
                    pixel_of(moment.picture(), pixel.x, pixel.y), 1.0f));
    }
}

TEST_CASE("From outside a click on the picture finds the pixel whose ray goes through it") {
    const Moment moment(lab_room());
    OutsideDrawing drawing;
    draw_all(drawing, moment, look_at(-0.75f, -0.4f, {900, 700}));
    const PicturePlane& plane = drawing.outside_scene().plane;
    int found = 0;
    for (int row = 5; row < 500; row += 35) {
        for (int column = 5; column < 500; column += 35) {
            const auto at = drawing.eye().pixel_of(plane.place_of({column + 0.5, row + 0.5}));
            REQUIRE(at);
            const OutsidePick pick = drawing.at(*at);
            REQUIRE(pick.pixel);
            // A pixel of the view covers a few of the picture.
            CHECK(std::abs(pick.pixel->x - column) <= 4);
            CHECK(std::abs(pick.pixel->y - row) <= 4);
            ++found;
        }
    }
    CHECK(found == 15 * 15);
}

TEST_CASE("The triangle at work is filled as far as the cursor is") {
    const Scene room = lab_room();
    constexpr int triangle = 1; // of the floor
    Moment moment(room);
    moment.triangle = triangle;
    const Timeline timeline(moment.frame());
    const glm::vec3 lit = lit_colour(room, triangle);
    OutsideDrawing drawing;
    const OutsideLook look = look_at(-0.75f, -0.4f, {900, 700});
    const auto lit_at = [&](const Cursor& cursor) {
        moment.go_to(cursor);
        draw_all(drawing, moment, look);
        return count_of(drawing.image(), lit);
    };
    const int rows = timeline.moments(triangle).rows.size();
    REQUIRE(rows > 20);
    CHECK(lit_at({triangle, Phase::vertices, 0, 0}) == 0);
    CHECK(lit_at({triangle, Phase::edges, 2, 0}) == 0);
    CHECK(lit_at({triangle, Phase::rows, 0, 0}) == 0);
    int before = 0;
    for (int row = 5; row < rows; row += rows / 5) {
        const int now = lit_at({triangle, Phase::rows, row, 0});
        INFO("row " << row);
        CHECK(now > before);
        before = now;
    }
    const int whole = lit_at({triangle + 1, Phase::vertices, 0, 0});
    CHECK(whole > before);
    CHECK(lit_at(cursor_end) == whole);
}

TEST_CASE("The filled part of the triangle at work is the rows above the cursor") {
    Random random(63);
    const Scene room = lab_room();
    constexpr int triangle = 1;
    Moment moment(room);
    moment.triangle = triangle;
    const PolygonRows rows = Timeline(moment.frame()).moments(triangle).rows;
    OutsideDrawing drawing;
    const glm::ivec2 size(900, 700);
    for (int i = 0; i < 5; ++i) {
        const int row = random.integer(1, rows.size() - 1);
        moment.go_to({triangle, Phase::rows, row, 0});
        draw_all(drawing, moment, look_at(-0.75f, -0.4f, size));
        const OutsideEye& eye = drawing.eye();
        int compared = 0;
        for (int k = 0; k < 3000; ++k) {
            const glm::ivec2 place(random.integer(0, size.x - 1), random.integer(0, size.y - 1));
            bool is_inside = true;
            for (const glm::vec2 aside : {glm::vec2(-2, 0), {2, 0}, {0, -2}, {0, 2}})
                is_inside &= drawing.at(glm::vec2(place) + 0.5f + aside).triangle == triangle;
            if (!is_inside) continue;
            // Along the ray to the floor, which is at y = 1, and from there to the camera.
            const glm::dvec2 across = (glm::dvec2(place) + 0.5 - eye.middle) / eye.focal_length;
            const glm::dvec3 direction = eye.rotation * glm::dvec3(across, 1.0);
            const glm::dvec3 floor =
                eye.position + (1.0 - eye.position.y) / direction.y * direction;
            const glm::dvec3 from_camera = floor - glm::dvec3(room.camera.position);
            const double picture_row = 500.0 * from_camera.y / from_camera.z + 250.0;
            const double rows_done = picture_row - rows.first_row - row;
            if (std::abs(rows_done) < 3.0 || floor.z > 0.98) continue;
            const glm::vec3 lit = lit_colour(room, triangle);
            INFO("row " << row << ", place " << place.x << ", " << place.y);
            CHECK(is_near(pixel_of(drawing.image(), place.x, place.y), lit, 1.5f) ==
                  (rows_done < 0.0));
            ++compared;
        }
        CHECK(compared > 20);
    }
}

TEST_CASE("Where nothing is drawn yet the picture is like a pane of glass") {
    Moment moment(lab_room(), cursor_begin);
    OutsideDrawing drawing;
    const OutsideLook look = look_at(-0.75f, -0.4f, {900, 700});
    draw_all(drawing, moment, look);
    const auto at = drawing.eye().pixel_of(drawing.outside_scene().plane.place_of({250.0, 250.0}));
    REQUIRE(at);
    const glm::ivec2 place(*at);
    const glm::vec3 through = pixel_of(drawing.image(), place.x, place.y);
    moment.go_to(cursor_end);
    draw_all(drawing, moment, look);
    const glm::vec3 drawn = pixel_of(drawing.image(), place.x, place.y);
    CHECK_FALSE(is_near(through, drawn, 30.0f));
    // Nearly black, but not the picture's own black.
    CHECK(std::max({through.x, through.y, through.z}) < 80.0f);
}

TEST_CASE("Nothing is drawn again if nothing has changed") {
    Moment moment(lab_room());
    OutsideDrawing drawing;
    OutsideLook look = look_at(0.3f, -0.2f, {300, 300});
    CHECK(drawing.update(moment.subject(), look));
    const std::uint64_t number = drawing.number();
    CHECK_FALSE(drawing.update(moment.subject(), look));
    CHECK(drawing.number() == number);
    const auto redraws = [&] { return drawing.update(moment.subject(), look); };
    moment.go_to({3, Phase::vertices, 0, 0});
    CHECK(redraws());
    look.view.yaw += 0.1f;
    CHECK(redraws());
    look.style.ground = glm::vec3(0.9f);
    CHECK(redraws());
    moment.triangle = 7;
    CHECK(redraws());
    look.size = {301, 300};
    CHECK(redraws());
    Settings settings = default_settings(moment.scene());
    settings.camera.yaw = 0.2f;
    moment.take(settings);
    CHECK(redraws());
    CHECK_FALSE(redraws());
}

namespace {

/// The same picture as one drawn from scratch, and the same things under every fifth place.
void require_same_as_redrawn(const OutsideDrawing& drawing, const Moment& moment,
                             const OutsideLook& look) {
    OutsideDrawing redrawn;
    draw_all(redrawn, moment, look);
    REQUIRE(drawing.image() == redrawn.image());
    for (int y = 0; y < look.size.y; y += 5) {
        for (int x = 0; x < look.size.x; x += 5) {
            const OutsidePick a = drawing.at({x, y}), b = redrawn.at({x, y});
            REQUIRE((a.triangle == b.triangle && a.pixel == b.pixel));
        }
    }
}

/// The room, and two triangles so large that they go far beyond every view.
Scene room_with_large_triangles() {
    Scene scene = lab_room();
    const float far = 400.0f;
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        std::array<Vertex, triangle_corners> corners;
        corners[0].position = a;
        corners[1].position = b;
        corners[2].position = c;
        scene.mesh.add_triangle_of(corners);
        ++scene.parts.back().triangle_count;
    };
    add({-far, 3.0f, -far}, {far, 3.0f, -far}, {0.0f, 3.0f, far});
    add({-far, 4.0f, far}, {0.0f, 4.0f, -far}, {far, 4.0f, far});
    return scene;
}

} // namespace

TEST_CASE("After any walk the view from outside is, bit for bit, as if drawn from scratch") {
    Random random(66);
    const Scene scene = room_with_large_triangles();
    const int triangles = scene.triangle_count();
    for (const int side : {60, 500, 800}) {
        Settings settings = default_settings(scene);
        settings.viewport = {side, side + 3};
        settings.camera.focal_length = static_cast<float>(side);
        Moment moment(scene, settings, cursor_begin);
        OutsideDrawing drawing;
        OutsideLook look = look_at(-0.75f, -0.4f, {320, 240});
        int walked = 0;
        for (int i = 0; i < rounds(60, 15); ++i) {
            const int way = random.integer(0, 9);
            if (way == 0) {
                look = random.integer(0, 2) == 0
                           ? camera_look({320, 240})
                           : look_at(random.number(-4, 4), random.number(-1.5, 1.5), {320, 240});
            } else if (way == 1) {
                moment.triangle = random.integer(-1, triangles);
            } else if (way == 2) {
                settings.stage = static_cast<Stage>(random.integer(0, 3));
                moment.take(settings);
            } else if (way == 3) {
                moment.forget_before();
            } else if (way == 4) {
                // Several moments pass while the view is not shown.
                moment.go_to({random.integer(0, triangles), Phase::rows, 3, 1});
                moment.go_to({random.integer(0, triangles), Phase::rows, 5, 0});
            } else {
                const Timeline timeline(moment.frame());
                moment.go_to(random.integer(0, 1) == 0
                                 ? timeline.at_place(random.number(0, 1))
                                 : timeline.next(moment.subject().cursor, Granularity::moment));
                if (random.integer(0, 1) == 0) moment.triangle = moment.subject().cursor.triangle;
            }
            // Sometimes the view is still being drawn when the next moment comes.
            drawing.update(moment.subject(), look, way == 5 ? 20'000 : 2'500'000);
            if (drawing.is_working()) continue;
            INFO("side " << side << ", round " << i << ", way " << way);
            require_same_as_redrawn(drawing, moment, look);
            ++walked;
        }
        CHECK(walked > rounds(60, 15) / 4);
    }
}

TEST_CASE("Moving on to a later triangle does not restart the view") {
    Moment moment(lab_room(), cursor_begin);
    OutsideDrawing drawing;
    const OutsideLook look = look_at(-0.75f, -0.4f, {320, 240});
    draw_all(drawing, moment, look);
    // So little work per call that a restarted view would not be done after one.
    moment.go_to({17, Phase::vertices, 0, 0});
    CHECK(drawing.update(moment.subject(), look, 1));
    CHECK_FALSE(drawing.is_working());
    require_same_as_redrawn(drawing, moment, look);
}

TEST_CASE("A large scene is drawn in parts, the first of which shows all of it") {
    const Moment moment(made_scene(60'000));
    OutsideDrawing drawing;
    const OutsideLook look = look_at(0.5f, -0.3f, {500, 400});
    constexpr std::int64_t work = 300'000;
    CHECK(drawing.update(moment.subject(), look, work));
    CHECK(drawing.is_working());
    const auto seen = [&] {
        int count = 0;
        for (int y = 0; y < look.size.y; y += 4) {
            for (int x = 0; x < look.size.x; x += 4)
                count += drawing.at({x, y}).triangle ? 1 : 0;
        }
        return count;
    };
    const int first = seen();
    int updates = 1;
    while (drawing.is_working() && updates < 100) {
        CHECK(drawing.update(moment.subject(), look, work));
        ++updates;
    }
    CHECK_FALSE(drawing.is_working());
    CHECK(updates < 20);
    CHECK(4 * first > seen());
    CHECK_FALSE(drawing.update(moment.subject(), look));
    // The order of drawing is not visible.
    Random random(64);
    int compared = 0;
    for (int i = 0; i < rounds(40, 15); ++i) {
        const glm::vec2 place(random.number(0, 499), random.number(0, 399));
        const std::optional<int> met = met_by_ray(moment.scene(), drawing, place);
        if (!met || drawing.at(place).pixel) continue;
        CHECK(drawing.at(place).triangle.value_or(-1) == *met);
        ++compared;
    }
    CHECK(compared > 1);
}

TEST_CASE("No camera, view, scene or size is too much for the view from outside") {
    Random random(65);
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    Scene odd = lab_room();
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        std::array<Vertex, triangle_corners> corners;
        corners[0].position = a;
        corners[1].position = b;
        corners[2].position = c;
        odd.mesh.add_triangle_of(corners);
        ++odd.parts.back().triangle_count;
    };
    add({nan, 0, 0}, {0, 1, 0}, {1, 0, 0});
    add({1e6f, -1e6f, 1e6f}, {-1e6f, 1e6f, 0}, {0, 0, -1e6f});
    add(glm::vec3(0.5f), glm::vec3(0.5f), glm::vec3(0.5f));
    Scene empty;
    OutsideDrawing drawing;
    for (int i = 0; i < rounds(300, 60); ++i) {
        const bool is_empty = random.integer(0, 9) == 0;
        Scene scene = is_empty ? empty : random.integer(0, 1) == 0 ? odd : lab_room();
        Settings settings = default_settings(scene);
        settings.viewport = {random.integer(1, 40), random.integer(1, 40)};
        Camera& camera = settings.camera;
        camera.position =
            std::pow(10.0f, random.number(-3, 3)) *
            glm::vec3(random.number(-1, 1), random.number(-1, 1), random.number(-1, 1));
        camera.yaw = random.number(-100, 100);
        camera.pitch = random.number(-1.6, 1.6);
        camera.focal_length = std::pow(10.0f, random.number(0, 5));
        settings.light.position = std::pow(10.0f, random.number(0, 3)) * glm::vec3(1.0f);
        Moment moment(scene, settings, {random.integer(0, 40), Phase::rows, 3, 2});
        if (random.integer(0, 3) > 0) moment.triangle = random.integer(-1, 40);
        OutsideLook look;
        look.size = {random.integer(0, 200), random.integer(0, 200)};
        look.margin = random.number(0, 90);
        look.view.is_camera = random.integer(0, 3) == 0;
        look.view.yaw = random.integer(0, 9) == 0 ? nan : random.number(-9, 9);
        look.view.pitch = random.number(-2, 2);
        if (random.integer(0, 1) == 0) {
            look.view.distance = std::pow(10.0f, random.number(-4, 8));
            look.view.target = {random.number(-9, 9), random.number(-9, 9), random.number(-9, 9)};
        }
        INFO("round " << i);
        CHECK(draw_all(drawing, moment, look) < 10);
        CHECK(drawing.image().rgba.size() ==
              4 * static_cast<std::size_t>(drawing.image().width * drawing.image().height));
        for (const glm::vec2 place : {glm::vec2(0.0f), {1e9f, 0.0f}, {-1.0f, 5.0f}, {nan, nan}})
            static_cast<void>(drawing.at(place));
    }
}

TEST_CASE("The view in a very large window has larger pixels, and is picked at the same places") {
    const Moment moment(lab_room());
    OutsideDrawing small, large;
    draw_all(small, moment, look_at(-0.75f, -0.4f, {700, 500}));
    OutsideLook look = look_at(-0.75f, -0.4f, {5600, 4000});
    look.margin = 80.0;
    draw_all(large, moment, look);
    CHECK(large.pixel_size() > 1);
    CHECK(static_cast<std::int64_t>(large.image().width) * large.image().height < 4'000'000);
    int same = 0, all = 0;
    for (int y = 3; y < 500; y += 20) {
        for (int x = 3; x < 700; x += 20) {
            const OutsidePick a = small.at({x, y}), b = large.at({8 * x, 8 * y});
            same += a.triangle == b.triangle && a.pixel.has_value() == b.pixel.has_value() ? 1 : 0;
            ++all;
        }
    }
    CHECK(same > all - all / 50);
}
