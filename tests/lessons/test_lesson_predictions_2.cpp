// The predictions of lessons 8 to 13: each answer that the program computes from its facts is found
// here a second time, by arithmetic from the handout's numbers, by rays, or from the planes of a
// drawn frame.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "lessons/lesson_run.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/prediction_checks.h"
#include "support/ray_caster.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr double pi = 3.14159265358979;
constexpr double room_lamp_x = 0.0, room_lamp_y = -0.5, room_lamp_z = -0.7;
constexpr double eye_z = -3.001;

/// A lesson and a session to ask it in.
struct Asked {
    Lesson lesson;
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");

    explicit Asked(const std::string& id)
        : lesson(read_lesson(lessons_folder() + "/" + id + ".md")) {}

    const LessonPrediction& prediction(const std::string& id) const {
        note_asked(lesson.id, id);
        const LessonPrediction* found = find_prediction(lesson, id);
        INFO(id);
        REQUIRE(found != nullptr);
        return *found;
    }
    Judgement judge_number(const std::string& id, double number) const {
        return judge(lesson, prediction(id), {number}, session);
    }
    /// The program's own number.
    double number(const std::string& id) const {
        const Judgement judgement = judge_number(id, 0.0);
        INFO(judgement.fault);
        CHECK(judgement.fault.empty());
        return judgement.number;
    }
    /// The program's own choice.
    int choice(const std::string& id) const {
        const Judgement judgement = judge(lesson, prediction(id), {0}, session);
        INFO(judgement.fault);
        CHECK(judgement.fault.empty());
        return judgement.choice;
    }
    bool accepts(const std::string& id, double number) const {
        return judge_number(id, number).is_right;
    }
    bool accepts_pixel(const std::string& id, glm::ivec2 pixel) const {
        return judge(lesson, prediction(id), {pixel}, session).is_right;
    }
};

Framebuffer drawn(const std::string& scene_name, const std::vector<std::string>& assignments) {
    const Scene scene = read_scene(lessons_folder() + "/scenes/" + scene_name + ".toml");
    Settings settings = default_settings(scene);
    for (const std::string& assignment : assignments)
        set_from_text(settings, assignment);
    return draw_frame(prepare_frame(scene, settings));
}

Framebuffer drawn_room(const std::vector<std::string>& assignments) {
    return drawn("lab-room", assignments);
}

/// Two pictures beside each other.
struct Difference {
    int pixels = 0;
    double largest = 0.0;
    std::size_t worst = 0; ///< pixel with the largest
};
Difference difference(const Framebuffer& a, const Framebuffer& b) {
    Difference result;
    for (std::size_t i = 0; i < a.colour.size(); ++i) {
        if (a.colour[i] == b.colour[i]) continue;
        ++result.pixels;
        for (int c = 0; c < 3; ++c) {
            const double d = std::abs(static_cast<double>(a.colour[i][c]) - b.colour[i][c]);
            if (d > result.largest) {
                result.largest = d;
                result.worst = i;
            }
        }
    }
    return result;
}

/// The direct light of a lamp of power 14 at a point, by the lab's formula.
double direct_light(const glm::dvec3& point, const glm::dvec3& normal) {
    const glm::dvec3 r = glm::dvec3(room_lamp_x, room_lamp_y, room_lamp_z) - point;
    const double r2 = glm::dot(r, r);
    return 14.0 * std::max(0.0, glm::dot(r, normal) / std::sqrt(r2)) / (4.0 * pi * r2);
}

/// A place of the room, in pixels.
glm::dvec2 projected(const glm::dvec3& point) {
    return {250.0 + 500.0 * point.x / (point.z - eye_z),
            250.0 + 500.0 * point.y / (point.z - eye_z)};
}

/// The brightest green of the ceiling.
glm::ivec2 brightest_of_ceiling(const Framebuffer& picture) {
    glm::ivec2 best{-1, -1};
    float green = -1.0f;
    for (int row = 0; row < picture.size.height; ++row) {
        for (int column = 0; column < picture.size.width; ++column) {
            const std::size_t i = picture.at(column, row);
            const bool is_ceiling = picture.owner[i] == 6 || picture.owner[i] == 7;
            if (is_ceiling && picture.colour[i].g > green) {
                green = picture.colour[i].g;
                best = {column, row};
            }
        }
    }
    return best;
}

} // namespace

PREDICTIONS_TEST("Lesson 8: the depth of the back wall, and of the middle of the gate",
                 "08-depth-buffer", "back-wall", "middle-of-the-gate") {
    const Asked asked("08-depth-buffer");
    CHECK(asked.number("back-wall") == Approx(1.0 / 4.001).epsilon(1e-5));
    CHECK(asked.accepts("back-wall", 0.25));
    CHECK_FALSE(asked.accepts("back-wall", 4.001));
    // The gate runs from z = 2.5 to z = 30; half-way on the screen is the mean of 1/z.
    CHECK(asked.number("middle-of-the-gate") ==
          Approx(2.0 / (1.0 / 2.5 + 1.0 / 30.0)).margin(0.02));
    CHECK_FALSE(asked.accepts("middle-of-the-gate", (2.5 + 30.0) / 2));
    CHECK_FALSE(asked.accepts("middle-of-the-gate", 10.0));
}

PREDICTIONS_TEST("Lesson 8: the depth test played by rays", "08-depth-buffer", "how-many-pass") {
    const Asked asked("08-depth-buffer");
    const Scene& room = *asked.session.scene;
    const RayCaster rays(room, room.camera, room.light);
    std::vector<RayHit> hits = rays.hits({6.0, 78.0}); // pixel (256, 328)
    REQUIRE(hits.size() == 5);
    std::sort(hits.begin(), hits.end(),
              [](const RayHit& a, const RayHit& b) { return a.triangle < b.triangle; });
    double stored = 0.0;
    int passed = 0;
    for (const RayHit& hit : hits) {
        if (hit.zinv <= stored) continue;
        stored = hit.zinv;
        ++passed;
    }
    CHECK(asked.number("how-many-pass") == passed);
    CHECK(passed == 3);
}

PREDICTIONS_TEST("Lesson 8: how well the room hides linear z", "08-depth-buffer",
                 "pixels-that-change") {
    const Asked asked("08-depth-buffer");
    const int pixels =
        difference(drawn_room({"stage=depth"}), drawn_room({"stage=depth", "depth_test=linear_z"}))
            .pixels;
    CHECK(pixels == 550);
    CHECK(asked.choice("pixels-that-change") == 1);
}

PREDICTIONS_TEST("Lesson 9: three walls in one corner", "09-light-per-vertex", "three-walls",
                 "twice-the-power") {
    const Asked asked("09-light-per-vertex");
    const glm::dvec3 corner(-1, -1, 1);
    const std::array<double, 3> direct = {direct_light(corner, {0, 1, 0}),
                                          direct_light(corner, {1, 0, 0}),
                                          direct_light(corner, {0, 0, -1})};
    const auto most = std::max_element(direct.begin(), direct.end());
    CHECK(asked.choice("three-walls") == most - direct.begin());
    // As the lesson works it out, and with twice the power.
    CHECK(direct[2] == Approx(0.225).margin(5e-4));
    CHECK(0.75 * (direct[2] + 0.5) == Approx(0.544).margin(5e-4));
    CHECK(0.75 * (2.0 * direct[2] + 0.5) == Approx(0.71).margin(5e-3));
    CHECK(asked.choice("twice-the-power") == 1);
}

PREDICTIONS_TEST("Lesson 9: the handout's lamp hardly shows", "09-light-per-vertex",
                 "the-lab-lamp") {
    const Asked asked("09-light-per-vertex");
    const Difference off = difference(drawn_room({"stage=vertex_light", "light.power=1.1"}),
                                      drawn_room({"stage=vertex_light", "light.power=0"}));
    CHECK(off.largest < 0.1);
    CHECK(off.largest > 0.05);
    CHECK(asked.choice("the-lab-lamp") == 0);
}

PREDICTIONS_TEST("Lesson 9: light per vertex is brightest at the corners", "09-light-per-vertex",
                 "brightest-ceiling") {
    const Asked asked("09-light-per-vertex");
    const glm::ivec2 best =
        brightest_of_ceiling(drawn_room({"stage=vertex_light", "light.power=14"}));
    CHECK(best.y <= 3);
    CHECK(asked.accepts_pixel("brightest-ceiling", best));
    const glm::dvec2 above_lamp = projected({room_lamp_x, -1.0, room_lamp_z});
    CHECK_FALSE(asked.accepts_pixel("brightest-ceiling", glm::ivec2(above_lamp)));
}

PREDICTIONS_TEST("Lesson 10: the spots of the lamp", "10-light-per-pixel", "where-is-the-spot",
                 "left-wall-spot") {
    const Asked asked("10-light-per-pixel");
    const glm::ivec2 best =
        brightest_of_ceiling(drawn_room({"stage=pixel_light", "light.power=14"}));
    const glm::dvec2 above_lamp = projected({room_lamp_x, -1.0, room_lamp_z});
    CHECK(glm::distance(glm::dvec2(best), above_lamp) < 3.0);
    CHECK(asked.accepts_pixel("where-is-the-spot", best));
    CHECK(asked.accepts_pixel("where-is-the-spot", glm::ivec2(above_lamp)));
    CHECK_FALSE(asked.accepts_pixel("where-is-the-spot", {250, 2}));
    CHECK_FALSE(asked.accepts_pixel("where-is-the-spot", {250, 110}));

    CHECK(asked.number("left-wall-spot") == Approx(0.75 * (14.0 / (4.0 * pi) + 0.5)).margin(0.002));
    // As if the light fell with the distance: half of the ceiling's, not a quarter.
    CHECK_FALSE(asked.accepts("left-wall-spot", 0.75 * (14.0 / (2.0 * pi) + 0.5)));
}

PREDICTIONS_TEST(
    "Lesson 10: where light per vertex is most wrong, and how often light is worked out",
    "10-light-per-pixel", "worst-difference") {
    const Asked asked("10-light-per-pixel");
    const Framebuffer pixel = drawn_room({"stage=pixel_light", "light.power=14"});
    const Difference worst =
        difference(pixel, drawn_room({"stage=vertex_light", "light.power=14"}));
    CHECK((pixel.owner[worst.worst] == 6 || pixel.owner[worst.worst] == 7));
    CHECK(worst.largest > 2.0);
    CHECK(asked.choice("worst-difference") == 0);

    struct Count : Observer {
        int passed = 0, failed = 0;
        void fragment(const FragmentEvent& event) override {
            ++(event.fate == Fate::written ? passed : failed);
        }
    } count;
    const Frame frame = prepare_frame(*asked.session.scene, default_settings(*asked.session.scene));
    Framebuffer framebuffer;
    clear(framebuffer, frame.settings.viewport);
    draw(frame, {}, framebuffer, &count);
    CHECK(count.passed == 293357); // as the lesson says
    CHECK(count.failed == 35432);
}

PREDICTIONS_TEST("Lesson 11: half-way on the screen", "11-perspective", "half-way",
                 "colour-half-way") {
    const Asked asked("11-perspective");
    const double near = 2.001, far = 4.001;
    const double half_way = 2.0 / (1.0 / near + 1.0 / far);
    CHECK(asked.number("half-way") == Approx(half_way + eye_z).margin(0.01));
    CHECK_FALSE(asked.accepts("half-way", 0.0));

    // The lower edge of the left wall, from (-1, 1, -1) to (-1, 1, 1).
    const double front = 0.75 * (direct_light({-1, 1, -1}, {1, 0, 0}) + 0.5);
    const double back = 0.75 * (direct_light({-1, 1, 1}, {1, 0, 0}) + 0.5);
    const double colour = (front / near + back / far) / (1.0 / near + 1.0 / far);
    CHECK(asked.number("colour-half-way") == Approx(colour).margin(0.003));
    CHECK_FALSE(asked.accepts("colour-half-way", (front + back) / 2));
}

PREDICTIONS_TEST("Lesson 11: the affine place from far away", "11-perspective", "from-far-away") {
    const Asked asked("11-perspective");
    Camera camera;
    camera.position.z = -20.001f;
    camera.focal_length = 4750.0f;
    const Scene& room = *asked.session.scene;
    const RayCaster rays(room, camera, room.light);
    const glm::dvec2 place(160.0 - 250.0, 12.0 - 250.0);
    const glm::dvec3 truth = rays.on_plane(6, place).position_world;
    // The triangle (-1,-1,-1) (1,-1,-1) (-1,-1,1) as it is seen, blended over the picture.
    const double near = 4750.0 / 19.001, far = 4750.0 / 21.001;
    const double back = (place.y + near) / (near - far);
    const double left = -near + back * (near - far);
    const double right = near - back * (near + far);
    const double across = (1.0 - back) * (place.x - left) / (right - left);
    const glm::dvec3 affine(-1.0 + 2.0 * across, -1.0, -1.0 + 2.0 * back);
    CHECK(glm::distance(truth, affine) < 0.1);
    CHECK(asked.choice("from-far-away") == 2);
}

PREDICTIONS_TEST("Lesson 11: divided once too often, the ceiling hangs below the lamp",
                 "11-perspective", "once-too-often") {
    const Asked asked("11-perspective");
    const double z = room_lamp_z - eye_z;
    const double light = direct_light({0.0, -1.0 / z, room_lamp_z / z}, {0, 1, 0});
    CHECK(light == 0.0);
    CHECK(asked.choice("once-too-often") == 2);
}

PREDICTIONS_TEST("Lesson 12: without error one pixel more is uncovered", "12-float-traps",
                 "uncovered-exact") {
    const Asked asked("12-float-traps");
    // A row and a column, which share a pixel.
    CHECK(asked.number("uncovered-exact") == 500 + 500 - 1);
    const Framebuffer picture = drawn_room({"stage=fill", "line_walk=exact"});
    CHECK(std::count(picture.overdraw.begin(), picture.overdraw.end(), 0u) == 999);
    const Framebuffer handout = drawn_room({"stage=fill"});
    CHECK(std::count(handout.overdraw.begin(), handout.overdraw.end(), 0u) == 998);
    CHECK(handout.owner[handout.at(0, 1)] == 3);
}

PREDICTIONS_TEST("Lesson 12: samples outside, counted by a loop of its own", "12-float-traps",
                 "floor-outside") {
    const Asked asked("12-float-traps");
    const auto whole = [](double value, bool down) {
        return static_cast<int>(down ? std::floor(value) : value);
    };
    const auto count_outside = [&](bool vertices_down, bool samples_down) {
        int outside = 0;
        const Scene& room = *asked.session.scene;
        for (int t = 0; t < room.triangle_count(); ++t) {
            std::array<glm::ivec2, 3> pixels;
            for (std::size_t v = 0; v < 3; ++v) {
                const glm::dvec2 place =
                    projected(room.corner(t, static_cast<int>(v)).position) - 250.0;
                pixels[v] = {whole(place.x, vertices_down) + 250,
                             whole(place.y, vertices_down) + 250};
            }
            const auto [top, bottom] = std::minmax({pixels[0].y, pixels[1].y, pixels[2].y});
            for (std::size_t e = 0; e < 3; ++e) {
                const glm::ivec2 a = pixels[e], b = pixels[(e + 1) % 3];
                const int steps = std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), 1});
                const float step = static_cast<float>(b.y - a.y) / static_cast<float>(steps);
                float y = static_cast<float>(a.y);
                for (int i = 0; i <= steps; ++i, y += step) {
                    const int row = whole(y, samples_down);
                    if (row < top || row > bottom) ++outside;
                }
            }
        }
        return outside;
    };
    CHECK(count_outside(false, false) == 4);
    CHECK(count_outside(false, true) == 4);
    CHECK(asked.choice("floor-outside") == 2);
    // With floor for the vertices as well: fewer, as the lesson tells.
    const int with_floor = count_outside(true, true);
    CHECK(with_floor > 0);
    CHECK(with_floor < 4);
}

PREDICTIONS_TEST("Lesson 12: a triangle just in front of the camera", "12-float-traps",
                 "without-end") {
    const Asked asked("12-float-traps");
    // The ceiling's triangle (-1, -1, -1) (1, -1, -1) (-1, -1, 1), its rows summed up without
    // walking them: at the height y of the picture it reaches from x = -y to x = y at the near
    // edge, and to a single point at the far corner.
    const double near = 500.0 / (-1.0 + 1.05), far = 500.0 / (1.0 + 1.05);
    CHECK(2.0 * near + 1.0 == Approx(20'001.0).margin(2.0)); // as the lesson tells
    double fragments = 0.0;
    for (double y = std::ceil(far); y <= near; ++y)
        fragments += 2.0 * near * (y - far) / (near - far) + 1.0;
    CHECK(fragments == Approx(97.6e6).epsilon(0.005));
    CHECK(asked.choice("without-end") == 2);
}

PREDICTIONS_TEST("Lesson 13: the causes of four pictures", "13-reading-a-bug", "why-black",
                 "too-few", "which-factor", "looks-right") {
    const Asked asked("13-reading-a-bug");
    // A buffer that starts at 0.35 hides the back wall, where a fragment did fall.
    const Scene& room = *asked.session.scene;
    const std::vector<RayHit> hits = RayCaster(room, room.camera, room.light).hits({0.0, -70.0});
    REQUIRE(hits.size() == 1);
    CHECK(hits[0].zinv < 0.35);
    CHECK(asked.choice("why-black") == 1);

    CHECK(asked.number("too-few") == std::max(std::abs(1 - 126 + 1), std::abs(1 - 374 + 1)));
    CHECK_FALSE(asked.accepts("too-few", 374));

    // The side of the tall block at pixel (155, 300) faces away from the lamp.
    const RayHit side = RayCaster(room, room.camera, room.light).hits({155 - 250, 300 - 250})[0];
    const glm::dvec3 normal = room.corner(side.triangle, 0).normal;
    CHECK(glm::dot(glm::dvec3(room_lamp_x, room_lamp_y, room_lamp_z) - side.position_world,
                   normal) < 0.0);
    CHECK(asked.choice("which-factor") == 1);

    const int pixels =
        difference(drawn_room({"stage=depth"}), drawn_room({"stage=depth", "edge_samples=rows"}))
            .pixels;
    CHECK(pixels > 0);
    CHECK(pixels < 2500);
    CHECK(asked.choice("looks-right") == 1);
}
