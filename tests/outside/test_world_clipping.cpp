#include "outside/world_clipping.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <glm/geometric.hpp>

#include "outside/outside_marks.h"
#include "session/outside_reports.h"
#include "settings/setting_table.h"
#include "stages/orthographic.h"
#include "support/clipped_room.h"
#include "support/effort.h"
#include "support/outside_subject.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// The place in the lab's clip space, computed again: x and y times the focal length, 1, depth.
glm::dvec4 in_clip_space(const glm::dvec3& world, const PicturePlane& plane) {
    const glm::dvec3 p = plane.in_camera(world);
    return {plane.focal_length.x * p.x, plane.focal_length.y * p.y, 1.0, p.z};
}

/// Is a place in the plane of a convex polygon inside it?
bool is_within(const std::vector<glm::dvec3>& face, const glm::dvec3& place) {
    const glm::dvec3 normal = glm::cross(face[1] - face[0], face[2] - face[0]);
    bool is_left = true, is_right = true;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const glm::dvec3 along = face[(i + 1) % face.size()] - face[i];
        const double side = glm::dot(normal, glm::cross(along, place - face[i])) /
                            std::max(glm::length(normal) * glm::length(along), 1e-12);
        is_left = is_left && side > -1e-4;
        is_right = is_right && side < 1e-4;
    }
    return is_left || is_right;
}

/// The cut triangles of the room under random cameras.
template <class Visit>
void for_each_cut(Visit visit) {
    const Scene room = lab_room();
    Random random(41);
    for (int i = 0; i < rounds(20, 6); ++i) {
        const Frame frame = room_frame(room, random, i % 4 == 0 ? Clip::near : Clip::all);
        const PicturePlane plane =
            picture_plane(frame.settings.camera, frame.settings.viewport, box_of(room));
        for (int t = 0; t < frame.triangle_count(); ++t) {
            const ClipHistory history = clip_history(frame, t);
            CAPTURE(i, t);
            if (!history.planes.empty()) visit(frame, history, plane);
        }
    }
}

} // namespace

TEST_CASE("The face of a plane is in the plane and contains what the plane cuts") {
    int count = 0;
    for_each_cut([&](const Frame& frame, const ClipHistory& history, const PicturePlane& plane) {
        for (const PlaneHistory& work : history.planes) {
            const WorldClipping seen = clipping_outside(frame, history, std::nullopt, work.plane);
            REQUIRE(seen.plane);
            CHECK(seen.plane->plane == work.plane);
            const std::vector<glm::dvec3> face = plane_face(seen, plane);
            REQUIRE(face.size() >= 3);
            const glm::dvec4 coefficients(seen.plane->coefficients);
            for (const glm::dvec3& corner : face) {
                const glm::dvec4 clip = in_clip_space(corner, plane);
                CHECK(std::abs(glm::dot(coefficients, clip)) <
                      1e-5 * glm::length(coefficients) * (1.0 + glm::length(clip)));
            }
            for (const glm::dvec3& cut : seen.plane->cuts)
                CHECK(is_within(face, cut));
            ++count;
        }
    });
    CHECK(count > 50);
}

TEST_CASE("Under every projection and depth format the faces of planes are in the planes") {
    const Scene room = lab_room();
    Random random(42);
    for (const char* choice : {"projection=orthographic", "projection_mix=0.4",
                               "depth_format=ndc_32", "depth_format=reversed_16"}) {
        int ends = 0, sides = 0;
        for (int i = 0; i < rounds(20, 8); ++i) {
            Settings settings = room_frame(room, random, Clip::all).settings;
            set_from_text(settings, choice);
            settings.near = 0.4f;
            settings.far = 1.6f;
            const Frame frame = prepare_frame(room, settings);
            const VertexRules rules = vertex_rules(settings, SceneSpace::world);
            const PicturePlane plane =
                picture_plane(settings.camera, settings.viewport, box_of(room), rules.projection);
            for (int t = 0; t < frame.triangle_count(); ++t) {
                const ClipHistory history = clip_history(frame, t);
                for (const PlaneHistory& work : history.planes) {
                    const WorldClipping seen =
                        clipping_outside(frame, history, std::nullopt, work.plane);
                    CAPTURE(choice, i, t, std::string(word_of(work.plane)));
                    REQUIRE(seen.ends);
                    REQUIRE(seen.plane);
                    const std::vector<glm::dvec3> face = plane_face(seen, plane);
                    REQUIRE(face.size() >= 3);
                    // The projected corners are on the plane: at the depth of near or far, or on a
                    // border of the picture.
                    for (const glm::dvec3& corner : face) {
                        const glm::vec3 place(plane.in_camera(corner));
                        const glm::vec4 clip = to_clip_space_mixed(place, rules);
                        const glm::vec2 pixel = glm::vec2(clip) / clip.w + glm::vec2(plane.middle);
                        if (work.plane == ClipPlane::near) CHECK(place.z == Approx(0.4));
                        if (work.plane == ClipPlane::far) CHECK(place.z == Approx(1.6));
                        if (!(clip.w > 0.01f)) continue;
                        if (work.plane == ClipPlane::left) CHECK(pixel.x == Approx(0).margin(0.1));
                        if (work.plane == ClipPlane::right)
                            CHECK(pixel.x == Approx(settings.viewport.width).margin(0.1));
                        if (work.plane == ClipPlane::top) CHECK(pixel.y == Approx(0).margin(0.1));
                        if (work.plane == ClipPlane::bottom)
                            CHECK(pixel.y == Approx(settings.viewport.height).margin(0.1));
                    }
                    for (const glm::dvec3& cut : seen.plane->cuts)
                        CHECK(is_within(face, cut));
                    ++(work.plane <= ClipPlane::far ? ends : sides);
                }
            }
        }
        CAPTURE(choice);
        CHECK(ends > 20);
        CHECK(sides > 20);
    }
}

TEST_CASE("The planes of an off-centre box are seen at its sides") {
    const Scene room = lab_room();
    Random random(43);
    for (const char* choice : {"projection=perspective", "projection=orthographic",
                               "projection_mix=0.4", "depth_format=ndc_32"}) {
        std::set<ClipPlane> world_planes;
        for (int i = 0; i < rounds(40, 20); ++i) {
            Settings settings = room_frame(room, random, Clip::all).settings;
            for (const char* set : {choice, "transform=matrices", "near=0.4", "far=1.6"})
                set_from_text(settings, set);
            const ViewBox box{-random.number(0.05, 0.3), random.number(0.3, 0.6),
                              -random.number(0.3, 0.6), random.number(0.05, 0.3)};
            settings.view_box = box;
            const Frame frame = prepare_frame(room, settings);
            const PicturePlane plane =
                picture_plane(settings.camera, settings.viewport, box_of(room),
                              vertex_rules(settings, SceneSpace::world).projection);
            const double mix = settings.projection_mix;
            for (int t = 0; t < frame.triangle_count(); ++t) {
                const ClipHistory history = clip_history(frame, t);
                for (const PlaneHistory& work : history.planes) {
                    const WorldClipping seen =
                        clipping_outside(frame, history, std::nullopt, work.plane);
                    REQUIRE(seen.plane);
                    const std::vector<glm::dvec3> face = plane_face(seen, plane);
                    REQUIRE(face.size() >= 3);
                    world_planes.insert(work.plane);
                    CAPTURE(choice, i, t, std::string(word_of(work.plane)));
                    for (const glm::dvec3& corner : face) {
                        // Where the line to the eye meets the near plane, with y up.
                        const glm::dvec3 p = plane.in_camera(corner);
                        const double w = (1.0 - mix) * p.z + mix;
                        const double w_near = (1.0 - mix) * settings.near + mix;
                        if (!(w > 0.01)) continue;
                        const double x = p.x * w_near / w, y = -p.y * w_near / w;
                        // An odd number of pixels has its middle half a pixel off.
                        const double odd_x = (box.right - box.left) / settings.viewport.width;
                        const double odd_y = (box.top - box.bottom) / settings.viewport.height;
                        if (work.plane == ClipPlane::left)
                            CHECK(x == Approx(box.left).margin(odd_x));
                        if (work.plane == ClipPlane::right)
                            CHECK(x == Approx(box.right).margin(odd_x));
                        if (work.plane == ClipPlane::top) CHECK(y == Approx(box.top).margin(odd_y));
                        if (work.plane == ClipPlane::bottom)
                            CHECK(y == Approx(box.bottom).margin(odd_y));
                    }
                    for (const glm::dvec3& cut : seen.plane->cuts)
                        CHECK(is_within(face, cut));
                }
            }
            // The picture is where the box is, whatever its distance.
            const std::array<glm::dvec3, 4> corners = plane.corners();
            const double odd_x = (box.right - box.left) / settings.viewport.width;
            for (std::size_t c = 0; c < 4; ++c) {
                const glm::dvec3 p = plane.in_camera(corners[c]);
                const double share =
                    ((1.0 - mix) * settings.near + mix) / ((1.0 - mix) * p.z + mix);
                CHECK(p.x * share == Approx(c == 0 || c == 3 ? box.left : box.right).margin(odd_x));
            }
        }
        CAPTURE(choice);
        for (const ClipPlane plane :
             {ClipPlane::left, ClipPlane::right, ClipPlane::top, ClipPlane::bottom})
            CHECK(world_planes.count(plane) == 1);
    }
}

TEST_CASE("Under orthographic projection near and far plane and the frustum make a box") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    set_from_text(settings, "projection=orthographic");
    settings.clip = Clip::all;
    settings.near = 2.5f;
    settings.far = 3.5f;
    const Frame frame = prepare_frame(room, settings);
    const ClipHistory history = clip_history(frame, 1);
    const WorldClipping seen = clipping_outside(frame, history, std::nullopt, std::nullopt);
    REQUIRE(seen.ends);
    CHECK(*seen.ends == glm::dvec2(2.5, 3.5));
    const VertexRules rules = vertex_rules(settings, SceneSpace::world);
    OutsideScene outside_scene;
    outside_scene.box = box_of(room);
    outside_scene.plane =
        picture_plane(settings.camera, settings.viewport, outside_scene.box, rules.projection);
    const glm::ivec2 extent{900, 700};
    const OutsideEye eye = eye_of({}, outside_scene, extent, 40.0);
    const OutsideMarks marks = outside_marks(room, outside_scene, eye, {1, seen}, {}, extent);
    std::vector<OutsideLine> ends;
    for (const OutsideLine& line : marks.lines)
        if (line.kind == OutsideLineKind::end) ends.push_back(line);
    REQUIRE(ends.size() == 8);
    const PicturePlane& plane = outside_scene.plane;
    const double half = plane.middle.x / plane.scale.x;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const double z = i < 4 ? 2.5 : 3.5;
        const double x = i % 4 == 0 || i % 4 == 3 ? -half : half;
        const double y =
            i % 4 < 2 ? -plane.middle.y / plane.scale.y : plane.middle.y / plane.scale.y;
        const auto expected = eye.pixel_of(plane.in_world({x, y, z}));
        REQUIRE(expected);
        CAPTURE(i);
        CHECK(glm::distance(glm::dvec2(ends[i].from), *expected) < 0.1);
    }
}

TEST_CASE("Near and far plane are seen and named where the depth goes from one to the other") {
    const Scene room = lab_room();
    const auto ends_of = [&](const char* depth, const char* far) {
        Settings settings = default_settings(room);
        for (const char* const text : {depth, far, "near=1"})
            set_from_text(settings, text);
        const Frame frame = prepare_frame(room, settings);
        OutsideScene outside_scene;
        outside_scene.box = box_of(room);
        outside_scene.plane = picture_plane(settings.camera, settings.viewport, outside_scene.box,
                                            vertex_rules(settings, SceneSpace::world).projection);
        const glm::ivec2 extent{900, 700};
        // From so far away that all four corners of both are in sight.
        OutsideView view;
        view.distance = 20.0f;
        const OutsideEye eye = eye_of(view, outside_scene, extent, 40.0);
        const WorldClipping seen =
            clipping_outside(frame, clip_history(frame, 8), std::nullopt, std::nullopt);
        const OutsideMarks marks = outside_marks(room, outside_scene, eye, {8, seen}, {}, extent);
        std::vector<int> named;
        for (const OutsidePoint& point : marks.points) {
            if (point.kind != OutsidePointKind::end) continue;
            named.push_back(point.number);
            // Computed back: how far in front of the camera the named place is.
            const double z = point.number == static_cast<int>(ClipPlane::near) ? 1.0 : 7.0;
            bool is_at_corner = false;
            for (const glm::dvec2 corner :
                 {glm::dvec2(0, 0), glm::dvec2(500, 0), glm::dvec2(500, 500), glm::dvec2(0, 500)}) {
                const double w = settings.projection_mix == 1.0f ? 1.0 : z;
                const glm::dvec2 across = (corner - 250.0) * (w / outside_scene.plane.scale);
                const auto at = eye.pixel_of(glm::dvec3(across, z - 3.001));
                is_at_corner =
                    is_at_corner || (at && glm::distance(*at, glm::dvec2(point.at)) < 0.1);
            }
            CHECK(is_at_corner);
        }
        return named;
    };
    const int near = static_cast<int>(ClipPlane::near), far = static_cast<int>(ClipPlane::far);
    const std::vector<int> both{near, near, near, near, far, far, far, far};
    CHECK(ends_of("projection=orthographic", "far=7") == both);
    CHECK(ends_of("depth_format=ndc_32", "far=7") == both);
    // Far beyond the room, and where neither plane's distance matters.
    CHECK(ends_of("depth_format=reversed_16", "far=100") == std::vector<int>(4, near));
    CHECK(ends_of("depth_format=inv_z", "far=7").empty());
}

TEST_CASE("From outside a cut triangle shows what is left, and dashed what was cut off") {
    int count = 0;
    for_each_cut([&](const Frame& frame, const ClipHistory& history, const PicturePlane& plane) {
        OutsideScene outside_scene;
        outside_scene.box = box_of(*frame.scene);
        outside_scene.plane = plane;
        const glm::ivec2 extent{900, 700};
        const OutsideEye eye = eye_of({}, outside_scene, extent, 40.0);
        const WorldClipping seen = clipping_outside(frame, history, std::nullopt, std::nullopt);
        const bool is_left = !history.polygon.empty();
        CHECK(seen.corners.size() == history.polygon.size());
        const OutsideMarks marks =
            outside_marks(*frame.scene, outside_scene, eye, {history.triangle, seen}, {}, extent);
        const auto lines = [&](OutsideLineKind kind) {
            return std::count_if(marks.lines.begin(), marks.lines.end(),
                                 [kind](const OutsideLine& line) { return line.kind == kind; });
        };
        // All of the room is seen.
        const auto corners = static_cast<std::ptrdiff_t>(history.polygon.size());
        const auto fan = std::max<std::ptrdiff_t>(corners - 3, 0);
        CHECK(lines(OutsideLineKind::edge) + lines(OutsideLineKind::cut) == corners);
        CHECK(lines(OutsideLineKind::fan) == fan);
        CHECK(lines(OutsideLineKind::cut_off) >= 1);
        if (!is_left) CHECK(lines(OutsideLineKind::cut_off) == 3);
        CHECK(marks.face.size() >= 3);
        ++count;
    });
    CHECK(count > 30);
}

TEST_CASE("During clipping only the finished work is seen") {
    const Scene room = lab_room();
    const Frame frame = prepare_frame(room, near_clipped_room(room));
    const ClipHistory history = clip_history(frame, 1);
    REQUIRE(history.planes.size() == 1);
    const auto seen_after = [&](int step) {
        return clipping_outside(frame, history, Cursor{1, Phase::clip, 0, step}, std::nullopt);
    };
    std::size_t made = 0;
    for (int step = 0; step < 3; ++step) {
        made += history.planes[0].steps[static_cast<std::size_t>(step)].is_cut ? 1 : 0;
        CHECK(seen_after(step).made.size() == made);
        CHECK(seen_after(step).corners.size() == (step < 2 ? 3 : history.polygon.size()));
    }
    CHECK(made == 2);
    // Nothing is cut if no plane has work: the back wall is in front of the camera.
    const ClipHistory of_back_wall = clip_history(frame, 8);
    REQUIRE(of_back_wall.planes.empty());
    CHECK_FALSE(clipping_outside(frame, of_back_wall, {}, {}).is_cut);
}

TEST_CASE(
    "The part that clipping cuts off the triangle at work has a different colour from outside") {
    const Scene room = lab_room();
    const Settings settings = near_clipped_room(room);
    const Moment moment(room, settings, cursor_end);
    OutsideLook look;
    look.size = {500, 400};
    look.margin = 20.0;
    const auto draw = [&](const WorldClipping& clipping) {
        OutsideDrawing drawing;
        OutsideSubject subject = moment.subject();
        subject.triangle = 1;
        subject.clipping = clipping;
        do
            drawing.update(subject, look);
        while (drawing.is_working());
        return drawing;
    };
    const ClipHistory history = clip_history(moment.frame(), 1);
    const WorldClipping clipping = clipping_outside(moment.frame(), history, {}, {});
    REQUIRE(clipping.is_cut);
    const OutsideDrawing whole = draw({}), cut = draw(clipping);
    // Pixels of the triangle differ where, and only where, they are nearer than the near plane.
    int taken = 0, kept = 0;
    const PicturePlane& plane = cut.outside_scene().plane;
    const WorldTriangle world = world_triangles(room)[1];
    const OutsideEye& eye = cut.eye();
    for (int y = 0; y < look.size.y; ++y) {
        for (int x = 0; x < look.size.x; ++x) {
            const glm::vec2 middle(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            if (cut.at(middle).triangle != 1) continue;
            const glm::dvec3 ray =
                eye.rotation *
                glm::dvec3((glm::dvec2(middle) - eye.middle) / eye.focal_length, 1.0);
            const glm::dvec3 normal(world.normal), corner(world.corner);
            const double t = glm::dot(normal, corner - eye.position) / glm::dot(normal, ray);
            const double depth = plane.in_camera(eye.position + t * ray).z;
            if (std::abs(depth - 0.1) < 0.03) continue; // near the cut
            const std::size_t byte =
                4 * (static_cast<std::size_t>(y) * 500 + static_cast<std::size_t>(x));
            bool is_same = true;
            for (std::size_t k = 0; k < 3; ++k)
                is_same = is_same && whole.image().rgba[byte + k] == cut.image().rgba[byte + k];
            (depth < 0.1 ? taken : kept) += 1;
            // At its border a pixel is mixed with its neighbour.
            const bool is_deep =
                cut.at(middle + 2.0f).triangle == 1 && cut.at(middle - 2.0f).triangle == 1;
            if (is_deep) CHECK(is_same == (depth > 0.1));
        }
    }
    CHECK(taken > 100);
    CHECK(kept > 100);
}

TEST_CASE("A vertex behind the camera is mirrored through the eye where it is divided") {
    const Scene room = lab_room();
    const Settings settings = near_clipped_room(room);
    OutsideScene outside_scene;
    outside_scene.box = box_of(room);
    outside_scene.plane = picture_plane(settings.camera, settings.viewport, outside_scene.box);
    const glm::ivec2 extent{900, 700};
    const OutsideEye eye = eye_of({}, outside_scene, extent, 40.0);
    const auto mirrored = [&](bool is_mirrored) {
        const OutsideMarks marks =
            outside_marks(room, outside_scene, eye, {1, {}, is_mirrored}, {}, extent);
        return std::count_if(marks.lines.begin(), marks.lines.end(), [](const OutsideLine& line) {
            return line.kind == OutsideLineKind::mirrored;
        });
    };
    CHECK(mirrored(true) >= 1);
    CHECK(mirrored(false) == 0);
}
