// The predictions and the figures of lesson 35, found a second time: rays in double precision,
// boxes of this file's own, and where the pictures of two engines differ.

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engines/engine_planes.h"
#include "scene/read_scene.h"
#include "scene/tessellation.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/questions.h"
#include "support/ray_caster.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace ray_lesson {

constexpr int side = 500;      ///< of the picture
constexpr int first_tall = 20; ///< triangle of the tall block
const std::vector<std::string> centres{"coverage=edge_functions", "fill_rule=top_left",
                                       "snap=subpixel"};

Scene scene_named(const std::string& name) {
    return read_scene(lessons_folder() + "/scenes/" + name + ".toml");
}

Framebuffer picture_by(const std::string& engine, const Scene& scene,
                       const std::vector<std::string>& assignments) {
    Settings settings = default_settings(scene);
    settings.stage = Stage::shade;
    set_from_text(settings, "engine=" + engine);
    for (const std::string& assignment : assignments)
        set_from_text(settings, assignment);
    const Frame frame = prepare_frame(scene, settings);
    Framebuffer planes;
    draw_by_engine(frame, cursor_end, planes);
    return planes;
}

/// The centre of a pixel, from the middle of the picture.
glm::dvec2 centre_of(int column, int row) {
    return {column + 0.5 - side / 2.0, row + 0.5 - side / 2.0};
}

glm::dvec3 direction_of(int column, int row) {
    return glm::dvec3(centre_of(column, row) / 500.0, 1.0);
}

/// Where both pictures show a triangle, but not the same one, or only one shows any.
std::vector<glm::ivec2> other_triangles(const Framebuffer& a, const Framebuffer& b) {
    std::vector<glm::ivec2> places;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            if (a.owner[a.at(column, row)] != b.owner[b.at(column, row)])
                places.emplace_back(column, row);
        }
    }
    return places;
}

/// Does a pixel or one that touches it show something else than its neighbour?
bool is_on_outline(const Framebuffer& planes, glm::ivec2 place) {
    const int here = planes.owner[planes.at(place.x, place.y)];
    for (int y = place.y - 1; y <= place.y + 1; ++y) {
        for (int x = place.x - 1; x <= place.x + 1; ++x) {
            if (planes.contains(x, y) && planes.owner[planes.at(x, y)] != here) return true;
        }
    }
    return false;
}

/// The nearest that a ray meets.
struct Meeting {
    int triangle = -1;
    double t = 1e9;
};

struct Ray {
    glm::dvec3 from, way;
};

using Corners = std::array<glm::dvec3, 3>;

std::vector<Corners> corners_of(const Scene& scene) {
    std::vector<Corners> all;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        Corners& corners = all.emplace_back();
        for (int i = 0; i < 3; ++i)
            corners[static_cast<std::size_t>(i)] = glm::dvec3(scene.corner(t, i).position);
    }
    return all;
}

glm::dvec3 normal_of(const Corners& c) {
    return glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0]));
}

/// By the plane of the triangle, and the side of each edge on which the ray passes.
void meet(const Ray& ray, const Corners& c, int triangle, Meeting& nearest) {
    const glm::dvec3 normal = normal_of(c);
    const double rise = glm::dot(normal, ray.way);
    if (rise == 0.0) return;
    const double t = glm::dot(normal, c[0] - ray.from) / rise;
    if (t <= 1e-9 || t >= nearest.t) return;
    const glm::dvec3 place = ray.from + t * ray.way;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 inward = glm::cross(normal, c[(i + 1) % 3] - c[i]);
        if (glm::dot(inward, place - c[i]) < 0.0) return;
    }
    nearest = {triangle, t};
}

Meeting first_of(const Ray& ray, const std::vector<Corners>& all) {
    Meeting nearest;
    for (std::size_t t = 0; t < all.size(); ++t)
        meet(ray, all[t], static_cast<int>(t), nearest);
    return nearest;
}

/// Boxes in boxes, divided at the middle of the list that is sorted along their longest side.
class Boxes {
  public:
    explicit Boxes(std::vector<Corners> triangles) : triangles_(std::move(triangles)) {
        std::vector<int> list(triangles_.size());
        std::iota(list.begin(), list.end(), 0);
        root_ = divide(list);
    }

    /// Counts the tests of one ray.
    void follow(const Ray& ray) {
        Meeting nearest;
        follow(ray, root_, nearest);
    }

    double of_triangles = 0, of_boxes = 0; ///< tests
    int levels = 0;                        ///< of boxes in boxes

  private:
    struct Box {
        glm::dvec3 low{1e9}, high{-1e9};
        std::vector<int> triangles; ///< if it is not divided
        std::size_t halves[2]{};
    };

    std::size_t divide(std::vector<int> list, int level = 0) {
        levels = std::max(levels, level);
        Box box;
        for (const int t : list) {
            for (const glm::dvec3& corner : triangles_[static_cast<std::size_t>(t)]) {
                box.low = glm::min(box.low, corner);
                box.high = glm::max(box.high, corner);
            }
        }
        const std::size_t here = boxes_.size();
        boxes_.push_back(box);
        if (list.size() <= 4) {
            boxes_[here].triangles = list;
            return here;
        }
        const glm::dvec3 size = box.high - box.low;
        int axis = 0;
        for (int i = 1; i < 3; ++i) {
            if (size[i] > size[axis] + 1e-6) axis = i;
        }
        const auto middle = [&](int t) {
            const Corners& c = triangles_[static_cast<std::size_t>(t)];
            return std::round(1e6 * (c[0] + c[1] + c[2])[axis]);
        };
        std::stable_sort(list.begin(), list.end(),
                         [&](int a, int b) { return middle(a) < middle(b); });
        const auto half = list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2);
        const std::size_t first = divide({list.begin(), half}, level + 1);
        const std::size_t second = divide({half, list.end()}, level + 1);
        boxes_[here].halves[0] = first;
        boxes_[here].halves[1] = second;
        return here;
    }

    void follow(const Ray& ray, std::size_t which, Meeting& nearest) {
        const Box& box = boxes_[which];
        ++of_boxes;
        double enters = 0.0, leaves = nearest.t;
        for (int i = 0; i < 3; ++i) {
            const double a = (box.low[i] - 1e-5 - ray.from[i]) / ray.way[i];
            const double b = (box.high[i] + 1e-5 - ray.from[i]) / ray.way[i];
            enters = std::max(enters, std::min(a, b));
            leaves = std::min(leaves, std::max(a, b));
        }
        if (enters > leaves) return;
        for (const int t : box.triangles) {
            ++of_triangles;
            meet(ray, triangles_[static_cast<std::size_t>(t)], t, nearest);
        }
        if (!box.triangles.empty()) return;
        follow(ray, box.halves[0], nearest);
        follow(ray, box.halves[1], nearest);
    }

    std::vector<Corners> triangles_;
    std::vector<Box> boxes_;
    std::size_t root_ = 0;
};

PREDICTIONS_TEST("Lesson 35: t of a ray, and 1/z along a row", "35-rays", "t-of-the-wall",
                 "next-step", "all-tests") {
    const Scene room = scene_named("lab-room");
    const RayCaster rays(room, room.camera, room.light);
    const double t = 1.0 / rays.hits(centre_of(130, 130)).front().zinv;
    CHECK(t == Approx(1.0 + 3.001));
    CHECK(t * glm::length(direction_of(130, 130)) == Approx(4.225).margin(0.002));
    // The right wall is at x = 1.
    for (const int column : {400, 410, 490}) {
        const RayHit hit = rays.hits(centre_of(column, 250)).front();
        CHECK(hit.zinv == Approx((column + 0.5 - 250.0) / 500.0));
        CHECK(hit.position_world.x == Approx(1.0));
    }
    CHECK(rays.hits(centre_of(400, 250)).front().zinv == Approx(0.301));
    CHECK(rays.hits(centre_of(410, 250)).front().zinv == Approx(0.321));
    const Questions lesson("35-rays");
    lesson.require_number("t-of-the-wall", t, 0.001, 4.225);
    lesson.require_number("next-step", rays.hits(centre_of(490, 250)).front().zinv, 0.0005, 0.685);
    lesson.require_number("all-tests", 500.0 * 500.0 * 30.0, 0.5, 328'789);
    CHECK(lesson.answered("all-tests", {7'500'000.0}).because.find("about 23 for each") !=
          std::string::npos);
}

PREDICTIONS_TEST("Lesson 35: where rays and edge functions differ, and cracks", "35-rays",
                 "same-picture", "rays-that-miss") {
    const Scene room = scene_named("lab-room");
    const RayCaster caster(room, room.camera, room.light);
    const Framebuffer rays = picture_by("rays", room, {}),
                      steps = picture_by("steps", room, centres),
                      rows = picture_by("steps", room, {});
    // The lab's rows: along outlines.
    const std::vector<glm::ivec2> of_rows = other_triangles(rays, rows);
    CHECK(of_rows.size() > 5'000);
    CHECK(std::all_of(of_rows.begin(), of_rows.end(), [&](const glm::ivec2& place) {
        return is_on_outline(rays, place) || is_on_outline(rows, place);
    }));
    // Centres: only where they are on a seam, mostly of two walls, on one diagonal.
    std::int64_t different = 0, within_side = 0, off_diagonal = 0;
    for (const glm::ivec2& place : other_triangles(rays, steps)) {
        const std::size_t at = rays.at(place.x, place.y);
        if (rays.colour[at] == steps.colour[at]) continue;
        ++different;
        within_side += rays.owner[at] / 2 == steps.owner[at] / 2 ? 1 : 0;
        CAPTURE(place.x, place.y);
        const double distance = caster.distance_to_edges(centre_of(place.x, place.y));
        if (place.x == place.y) {
            CHECK(distance < 1e-4);
            continue;
        }
        ++off_diagonal;
        CHECK(distance < 1.0 / 256.0);
        CHECK(rays.owner[at] / 2 == steps.owner[at] / 2); // the same side
        CHECK(part_of(room, rays.owner[at]) == 5);        // of the red block
        CHECK(glm::distance(rays.colour[at], steps.colour[at]) < 0.5f / 255.0f);
    }
    CHECK(off_diagonal == 2);
    CHECK(within_side < different / 10);
    std::vector<glm::ivec2> missed;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            if (rays.owner[rays.at(column, row)] < 0) missed.emplace_back(column, row);
        }
    }
    // Between floor and right wall: on the diagonal, below the back wall.
    REQUIRE(missed.size() > 1);
    CHECK(missed.size() < 100);
    for (const glm::ivec2& place : missed) {
        CHECK(place.x == place.y);
        CHECK(place.y > 375);
        // The floor is below it, the right wall above.
        CHECK(rays.owner[rays.at(place.x, place.y + 1)] / 2 == 0);
        CHECK(rays.owner[rays.at(place.x, place.y - 1)] / 2 == 2);
    }
    CHECK(std::none_of(steps.owner.begin(), steps.owner.end(), [](int t) { return t < 0; }));
    // The task: one of them is farther away than row 440.
    CHECK(missed[0].y < 440);
    CHECK(missed[1].y >= 440);

    const Questions lesson("35-rays");
    lesson.require_choice("same-picture", 1);
    const std::string said = lesson.answered("same-picture", {1}).because;
    CHECK(said.starts_with("Only " + std::to_string(different) + " pixels"));
    lesson.require_choice("rays-that-miss", 1);
    CHECK(lesson.answered("rays-that-miss", {1})
              .because.starts_with(std::to_string(missed.size()) + " rays"));
}

PREDICTIONS_TEST("Lesson 35: what a mirror shows, and what it takes", "35-rays", "mirror-rays") {
    const Scene room = scene_named("mirror-room");
    const std::vector<Corners> all = corners_of(room);
    const glm::dvec3 eye(room.camera.position);
    // What the mirrored ray of a pixel meets.
    const auto in_mirror = [&](int column, int row) {
        const Ray ray{eye, direction_of(column, row)};
        const Meeting metal = first_of(ray, all);
        REQUIRE(metal.triangle >= first_tall);
        const glm::dvec3 normal = normal_of(all[static_cast<std::size_t>(metal.triangle)]);
        const glm::dvec3 way = ray.way - 2.0 * glm::dot(ray.way, normal) * normal;
        return first_of({ray.from + metal.t * ray.way + 1e-6 * way, way}, all);
    };
    const Meeting back = in_mirror(220, 350);
    CHECK(back.triangle >= 10);
    CHECK(back.triangle < first_tall);
    const Corners& seen = all[static_cast<std::size_t>(back.triangle)];
    // Its front is away from the camera. Outside is where the middle of the block is not.
    glm::dvec3 middle(0.0);
    for (int t = 10; t < first_tall; ++t)
        middle += (all[static_cast<std::size_t>(t)][0] + all[static_cast<std::size_t>(t)][1] +
                   all[static_cast<std::size_t>(t)][2]) /
                  30.0;
    glm::dvec3 outward = normal_of(seen);
    if (glm::dot(outward, middle - seen[0]) > 0.0) outward = -outward;
    CHECK(glm::dot(outward, seen[0] - eye) > 0.0);
    CHECK(in_mirror(200, 260).triangle == -1); // black
    int metal = 0;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column)
            metal += first_of({eye, direction_of(column, row)}, all).triangle >= first_tall ? 1 : 0;
    }
    CHECK(metal == Approx(20'123).margin(20));

    const Questions lesson("35-rays");
    lesson.require_choice("mirror-rays", 0);
    CHECK(lesson.answered("mirror-rays", {0}).because.find("at 20123 of 250 000") !=
          std::string::npos);
}

PREDICTIONS_TEST("Lesson 35: boxes of small triangles", "35-rays", "smaller-triangles") {
    const Scene room = scene_named("lab-room");
    const glm::dvec3 eye(room.camera.position);
    constexpr int stride = 5; // of the pixels that are followed
    const auto counted = [&](const Scene& scene) {
        Boxes boxes(corners_of(scene));
        for (int row = 2; row < side; row += stride) {
            for (int column = 2; column < side; column += stride)
                boxes.follow({eye, direction_of(column, row)});
        }
        boxes.of_boxes *= stride * stride;
        boxes.of_triangles *= stride * stride;
        return boxes;
    };
    const Boxes whole = counted(room), cut = counted(tessellate(room, 4));
    CHECK(whole.of_triangles == Approx(4'195'337).epsilon(0.03));
    CHECK(whole.of_boxes == Approx(3'511'000).epsilon(0.03));
    CHECK(cut.of_triangles == Approx(2'868'271).epsilon(0.1));
    CHECK(cut.of_boxes == Approx(6'687'116).epsilon(0.1));
    CHECK(cut.levels == whole.levels + 4);
    const Questions lesson("35-rays");
    lesson.require_choice("smaller-triangles", 2);
}

} // namespace ray_lesson
} // namespace
