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
        record_question(lesson.id, id);
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

/// Two pictures side by side.
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
    // z itself, z in the room, the middle of the room, and the camera's z with the wrong sign.
    for (const double wrong : {4.001, 1.0, 1.0 / 3.001, 1.0 / 2.001})
        CHECK_FALSE(asked.accepts("back-wall", wrong));
    // The gate runs from z = 2.5 to z = 30; halfway on the screen is the mean of 1/z.
    CHECK(asked.number("middle-of-the-gate") ==
          Approx(2.0 / (1.0 / 2.5 + 1.0 / 30.0)).margin(0.02));
    CHECK_FALSE(asked.accepts("middle-of-the-gate", (2.5 + 30.0) / 2));
    CHECK_FALSE(asked.accepts("middle-of-the-gate", 10.0));
    // Where the task wants a click, z in a straight line has just passed the screen's 10, and the
    // gate is about 3.4 away.
    const auto along = [](double column) { return (column - 20.0) / (441.0 - 20.0); };
    CHECK(2.5 + 27.5 * along(134.0) < 10.0);
    CHECK(2.5 + 27.5 * along(135.0) > 10.0);
    for (const double column : {134.0, 146.0}) {
        const double zinv = 0.4 + (1.0 / 30.0 - 0.4) * along(column);
        CHECK(1.0 / zinv == Approx(3.4).margin(0.1));
    }
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
    // All but the first are nearer than the back wall: a plausible wrong answer.
    CHECK(std::count_if(hits.begin(), hits.end(),
                        [&](const RayHit& hit) { return hit.zinv > hits[0].zinv + 0.01; }) == 4);
    CHECK_FALSE(asked.accepts("how-many-pass", 4));
}

TEST_CASE("Lesson 8: on the diagonal of a wall rounding decides which triangle stays") {
    // Of two triangles of a wall, the first keeps these pixels on the floor and loses them on the
    // left wall, although both have the same depth there.
    std::array<int, 30> won{}, lost{};
    std::map<std::array<int, 2>, int> owner; // of each pixel
    const Observer count_second{.fragment = [&](const FragmentEvent& event) {
        const int t = event.cursor.triangle;
        int& last =
            owner.try_emplace({event.fragment.column, event.fragment.row}, -1).first->second;
        if (t % 2 == 1 && last == t - 1)
            ++(event.fate == Fate::written ? won : lost)[static_cast<std::size_t>(t)];
        if (event.fate == Fate::written) last = t;
    }};
    const Scene room = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    Settings settings = default_settings(room);
    set_from_text(settings, "stage=depth");
    const Frame frame = prepare_frame(room, settings);
    Framebuffer framebuffer;
    clear(framebuffer, frame.settings.viewport);
    draw(frame, {}, framebuffer, &count_second);
    CAPTURE(lost[1], won[1], lost[3], won[3]);
    CHECK(lost[1] > 10 * won[1]);
    CHECK(won[3] > lost[3]);
}

PREDICTIONS_TEST("Lesson 8: how well the room hides linear z", "08-depth-buffer",
                 "pixels-that-change") {
    const Asked asked("08-depth-buffer");
    const Framebuffer inverse = drawn_room({"stage=depth"});
    const Framebuffer linear = drawn_room({"stage=depth", "depth_test=linear_z"});
    CHECK(difference(inverse, linear).pixels == 550);
    CHECK(asked.choice("pixels-that-change") == 1);
    // Floor and walls are pushed back, so they alone lose pixels, never a block.
    for (std::size_t i = 0; i < inverse.colour.size(); ++i) {
        if (inverse.colour[i] != linear.colour[i]) CHECK(inverse.owner[i] < 10);
    }
    // The chord of 1/z is above it: between depths of 2 and 4 by about a third of a unit.
    double largest = 0.0;
    for (int i = 0; i <= 100; ++i) {
        const double t = i / 100.0;
        const double straight = 2.001 + 2.0 * t;
        const double z = 1.0 / ((1.0 - t) / 2.001 + t / 4.001);
        CHECK(straight >= z - 1e-12);
        largest = std::max(largest, straight - z);
    }
    CHECK(largest == Approx(0.34).margin(0.01));
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
    // What is said about the other choices: the lamp's share at one unit, and the same with 14.
    CHECK(0.75 * 1.1 / (4.0 * pi) < 0.1);
    CHECK(off.largest * 14.0 / 1.1 > 0.6);
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
    // As if the light fell with the distance, to half of the ceiling's and not to a quarter; a
    // quarter of all; without the indirect light; without the reflectance; D alone.
    const double ceiling = 14.0 / pi, wall = ceiling / 4.0;
    for (const double wrong : {0.75 * (ceiling / 2.0 + 0.5), 0.75 * (ceiling + 0.5) / 4.0,
                               0.75 * wall, wall + 0.5, wall})
        CHECK_FALSE(asked.accepts("left-wall-spot", wrong));
}

PREDICTIONS_TEST("Lesson 10: where light per vertex is most wrong, and how often light is computed",
                 "10-light-per-pixel", "worst-difference") {
    const Asked asked("10-light-per-pixel");
    const Framebuffer pixel = drawn_room({"stage=pixel_light", "light.power=14"});
    const Difference worst =
        difference(pixel, drawn_room({"stage=vertex_light", "light.power=14"}));
    CHECK((pixel.owner[worst.worst] == 6 || pixel.owner[worst.worst] == 7));
    CHECK(worst.largest > 2.0);
    CHECK(asked.choice("worst-difference") == 0);
    const Framebuffer vertex = drawn_room({"stage=vertex_light", "light.power=14"});
    std::array<double, 30> apart{};
    for (std::size_t i = 0; i < pixel.colour.size(); ++i) {
        if (pixel.owner[i] < 0 || pixel.owner[i] != vertex.owner[i]) continue;
        double& of_triangle = apart[static_cast<std::size_t>(pixel.owner[i])];
        for (int c = 0; c < 3; ++c) {
            const double d = static_cast<double>(pixel.colour[i][c]) - vertex.colour[i][c];
            of_triangle = std::max(of_triangle, std::abs(d));
        }
    }
    CHECK(std::max(apart[8], apart[9]) < 0.15); // as the lesson says: the back wall, the floor
    CHECK(std::max(apart[0], apart[1]) < 0.2);

    int passed = 0, failed = 0;
    const Observer count{.fragment = [&](const FragmentEvent& event) {
        ++(event.fate == Fate::written ? passed : failed);
    }};
    const Frame frame = prepare_frame(*asked.session.scene, default_settings(*asked.session.scene));
    Framebuffer framebuffer;
    clear(framebuffer, frame.settings.viewport);
    draw(frame, {}, framebuffer, &count);
    CHECK(passed == 293357); // as the lesson says
    CHECK(failed == 35432);
}

PREDICTIONS_TEST("Lesson 11: halfway on the screen", "11-perspective", "half-way",
                 "colour-half-way") {
    const Asked asked("11-perspective");
    const double near = 2.001, far = 4.001;
    const double half_way = 2.0 / (1.0 / near + 1.0 / far);
    CHECK(asked.number("half-way") == Approx(half_way + eye_z).margin(0.01));
    // Column 63 of 1 to 126 comes half a column before that.
    const double share = (63.0 - 1.0) / (126.0 - 1.0);
    const double there = 1.0 / ((1.0 - share) / near + share / far);
    CHECK(there < half_way);
    CHECK(asked.number("half-way") == Approx(there + eye_z).margin(0.001));
    // The plain blend, the depth, the other sign, 1/z.
    for (const double wrong : {0.0, half_way, -(half_way + eye_z), 1.0 / half_way})
        CHECK_FALSE(asked.accepts("half-way", wrong));
    // What the graph shows of the plain blend in column 63 of 1 to 126.
    CHECK(near + (far - near) * 62.0 / 125.0 == Approx(2.99).margin(0.005));

    // The lower edge of the left wall, from (-1, 1, -1) to (-1, 1, 1).
    const double front = 0.75 * (direct_light({-1, 1, -1}, {1, 0, 0}) + 0.5);
    const double back = 0.75 * (direct_light({-1, 1, 1}, {1, 0, 0}) + 0.5);
    const double colour = (front / near + back / far) / (1.0 / near + 1.0 / far);
    CHECK(asked.number("colour-half-way") == Approx(colour).margin(0.003));
    // The pixel in question is one row above the edge from (1, 499) to (126, 374): there the upper
    // corner, which is brighter, counts as well.
    CHECK(499 - (63 - 1) == 436 + 1);
    const double upper = 0.75 * (direct_light({-1, -1, -1}, {1, 0, 0}) + 0.5);
    CHECK(upper > front);
    CHECK(asked.number("colour-half-way") > colour);
    // The plain mean, not divided by 1/z, and weighted the wrong way round.
    for (const double wrong : {(front + back) / 2, (front / near + back / far) / 2,
                               (front * near + back * far) / (near + far)})
        CHECK_FALSE(asked.accepts("colour-half-way", wrong));
}

TEST_CASE("Lesson 11: only the back wall faces you squarely, and its brightest part is small") {
    const Scene room = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    for (int t = 0; t < room.triangle_count(); ++t) {
        const float z = room.corner(t, 0).position.z;
        const bool is_square =
            room.corner(t, 1).position.z == z && room.corner(t, 2).position.z == z;
        CHECK(is_square == (t == 8 || t == 9));
    }
    // The task wants R above 0.63: the circle about the point nearest to the lamp where that is so.
    const auto light = [](double aside) {
        return 0.75 * (direct_light({aside, room_lamp_y, 1.0}, {0, 0, -1}) + 0.5);
    };
    CHECK(light(0.0) > 0.66);
    CHECK(light(0.48) > 0.63);
    CHECK(light(0.52) < 0.63);
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
    CHECK(std::abs(truth.z) < 0.05); // halfway between the near and the far edge
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
    for (const double wrong : {998.0, 997.0, 1000.0, 0.0})
        CHECK_FALSE(asked.accepts("uncovered-exact", wrong));
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
    // With floor for the vertices as well: fewer, as the lesson says.
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
    CHECK(2.0 * near + 1.0 == Approx(20'001.0).margin(2.0)); // as the lesson says
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
    // As it should be, its steps, the steps taken, and the shorter axis.
    for (const double wrong : {374.0, 373.0, 371.0, std::abs(1.0 - 126.0 + 1.0)})
        CHECK_FALSE(asked.accepts("too-few", wrong));

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
