// Model transformations, compared with the same steps carried out one by one on the point, by sine
// and cosine; and scene files that hold them.

#include "scene/model.h"

#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/error.h"
#include "pipeline/frame.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A step on a point, without a matrix.
glm::dvec3 carried_out(const ModelStep& step, const glm::dvec3& p) {
    const double c = std::cos(static_cast<double>(step.amount.x));
    const double s = std::sin(static_cast<double>(step.amount.x));
    switch (step.kind) {
    case ModelStepKind::translate:
        return p + glm::dvec3(step.amount);
    case ModelStepKind::scale:
        return p * glm::dvec3(step.amount);
    case ModelStepKind::rotate_x:
        return {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
    case ModelStepKind::rotate_y:
        return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
    case ModelStepKind::rotate_z:
        return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
    }
    return p;
}

std::vector<ModelStep> random_steps(Random& random) {
    std::vector<ModelStep> steps(static_cast<std::size_t>(random.integer(0, 5)));
    for (ModelStep& step : steps) {
        step.kind = static_cast<ModelStepKind>(random.integer(0, 4));
        for (int i = 0; i < 3; ++i) {
            const float size = random.number(0.3, 2.0);
            step.amount[i] = random.integer(0, 1) == 0 ? size : -size;
        }
    }
    return steps;
}

glm::dvec3 random_place(Random& random) {
    return {random.number(-2, 2), random.number(-2, 2), random.number(-2, 2)};
}

std::string scene_with(const std::string& model) {
    return "name = \"s\"\n"
           "[points.p]\n"
           "A = [1, 2, 3]\n"
           "B = [0.5, -1, 2]\n"
           "C = [0, 0, 1]\n"
           "[[part]]\n"
           "name = \"q\"\n"
           "points = \"p\"\n"
           "triangles = [\"A B C\"]\n"
           "model = " +
           model + "\n";
}

std::string refusal_of_model(const std::string& model) {
    try {
        parse_scene(scene_with(model), "s.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST_CASE("A model's matrix does what its steps do one after the other") {
    Random random(121);
    for (int i = 0; i < rounds(2000, 200); ++i) {
        const std::vector<ModelStep> steps = random_steps(random);
        const glm::dvec3 start = random_place(random);
        glm::dvec3 place = start;
        for (const ModelStep& step : steps)
            place = carried_out(step, place);
        CHECK(glm::distance(transform_point(model_matrix(steps), start), place) <
              1e-12 * (1.0 + glm::length(place)));
    }
    // The order counts: turned and then moved is not moved and then turned.
    const ModelStep turn{ModelStepKind::rotate_z, {1.5707963f, 0.0f, 0.0f}};
    const ModelStep move{ModelStepKind::translate, {2.0f, 0.0f, 0.0f}};
    const glm::dvec3 x(1.0, 0.0, 0.0);
    CHECK(glm::distance(transform_point(model_matrix({turn, move}), x), {2.0, 1.0, 0.0}) < 1e-6);
    CHECK(glm::distance(transform_point(model_matrix({move, turn}), x), {0.0, 3.0, 0.0}) < 1e-6);
}

TEST_CASE("A direction is turned and scaled but not moved") {
    const ModelStep move{ModelStepKind::translate, {5.0f, 6.0f, 7.0f}};
    const ModelStep scale{ModelStepKind::scale, {1.0f, 2.0f, 1.0f}};
    CHECK(transform_direction(model_matrix({move, scale}), {1.0, 1.0, 0.0}) ==
          glm::dvec3(1.0, 2.0, 0.0));
}

TEST_CASE("The inverse transpose keeps a normal perpendicular to its surface, the matrix not") {
    const glm::dmat4 scale = step_matrix({ModelStepKind::scale, {1.0f, 2.0f, 1.0f}});
    const glm::dvec3 n(1.0, 1.0, 0.0), t(1.0, -1.0, 0.0);
    CHECK(glm::dot(n, t) == 0.0);
    CHECK(glm::dot(transform_direction(scale, n), transform_direction(scale, t)) == -3.0);
    CHECK(glm::dot(normal_matrix(scale) * n, transform_direction(scale, t)) == 0.0);

    Random random(122);
    for (int i = 0; i < rounds(1000, 100); ++i) {
        const glm::dmat4 model = model_matrix(random_steps(random));
        const glm::dvec3 normal = glm::normalize(random_place(random));
        const glm::dvec3 by_inverse =
            glm::normalize(glm::transpose(glm::inverse(glm::dmat3(model))) * normal);
        CHECK(glm::distance(glm::normalize(normal_matrix(model) * normal), by_inverse) < 1e-9);
    }
}

TEST_CASE("The corners of a mirrored object change places, and the normal still points out") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/turned-block.toml");
    REQUIRE(scene.parts.size() == 4);
    int mirrored = 0;
    for (const Part& part : scene.parts) {
        const bool is_turned_round = is_mirrored(model_matrix(part.model.steps));
        mirrored += is_turned_round ? 1 : 0;
        for (int t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
            const auto corners = corners_of(scene, t);
            const glm::vec3 by_corners =
                face_normal(corners[0].position, corners[1].position, corners[2].position);
            INFO(part.name << ", triangle " << t);
            CHECK(glm::distance(by_corners, corners[0].normal) < 1e-5f);
            // The object's own points are in the same order as the transformed ones.
            for (int i = 0; !part.model.positions.empty() && i < triangle_corners; ++i) {
                const auto place =
                    static_cast<std::size_t>(triangle_corners * (t - part.first_triangle) + i);
                const glm::dvec3 made = transform_point(model_matrix(part.model.steps),
                                                        glm::dvec3(part.model.positions[place]));
                CHECK(glm::vec3(made) == corners[static_cast<std::size_t>(i)].position);
            }
        }
    }
    CHECK(mirrored == 1);
    // Out of the block: away from its middle.
    const Part& block = scene.parts.back();
    glm::vec3 middle(0.0f);
    for (int t = 0; t < block.triangle_count; ++t)
        middle += scene.corner(block.first_triangle + t, 0).position /
                  static_cast<float>(block.triangle_count);
    for (int t = block.first_triangle; t < block.first_triangle + block.triangle_count; ++t)
        CHECK(glm::dot(scene.corner(t, 0).normal, scene.corner(t, 0).position - middle) > 0.0f);
}

TEST_CASE("From every side a mirrored object shows the fronts that its normals give") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/turned-block.toml");
    Random random(124);
    int fronts = 0, backs = 0;
    for (int i = 0; i < rounds(100, 20); ++i) {
        Settings settings = default_settings(scene);
        settings.camera.aim = CameraAim::look_at;
        settings.camera.target = {0.0f, 0.3f, 0.4f};
        settings.camera.position = {random.number(-4, 4), random.number(-4, 4),
                                    random.number(-6, 6)};
        settings.cull = Cull::face_normal;
        const Frame by_normal = prepare_frame(scene, settings);
        settings.cull = Cull::screen_area;
        const Frame by_area = prepare_frame(scene, settings);
        for (int t = 0; t < scene.triangle_count(); ++t) {
            const Vertex& v = scene.corner(t, 0);
            const float away = glm::dot(v.normal, v.position - settings.camera.position);
            const Rejection normal = by_normal.rejection(t), area = by_area.rejection(t);
            const auto is_answer = [](Rejection r) {
                return r == Rejection::none || r == Rejection::back_facing;
            };
            if (std::abs(away) < 1e-3f || !is_answer(normal) || !is_answer(area)) continue;
            INFO("camera " << i << ", " << part_name(scene, t) << ", triangle " << t);
            CHECK(normal == area);
            (area == Rejection::none ? fronts : backs) += 1;
        }
    }
    CHECK(fronts > 100);
    CHECK(backs > 100);
}

TEST_CASE("A part with a model is where its steps put it, and keeps what it was made from") {
    const Scene scene = parse_scene(
        scene_with("[{ scale = [2, 1, -1] }, { rotate_y = 0.5 }, { translate = [1, 2, 3] }]"),
        "s.toml");
    const Model& model = scene.parts.front().model;
    REQUIRE(model.steps.size() == 3);
    REQUIRE(model.positions.size() == 3);
    CHECK(model.positions[0] == glm::vec3(1.0f, 2.0f, 3.0f));
    const double c = std::cos(0.5), s = std::sin(0.5);
    const glm::dvec3 expected(c * 2.0 + s * -3.0 + 1.0, 4.0, c * -3.0 - s * 2.0 + 3.0);
    CHECK(glm::distance(glm::dvec3(scene.corner(0, 0).position), expected) < 1e-6);
    CHECK(parse_scene(scene_with("[]"), "s.toml").parts.front().model == Model{});
}

TEST_CASE("A broken model is refused with its file, line and what is wrong") {
    CHECK(refusal_of_model("[{ turn = 1 }]") ==
          "s.toml:10: there is no step 'turn'; the steps are: translate, scale, rotate_x, "
          "rotate_y, rotate_z.");
    CHECK_THAT(refusal_of_model("[{ rotate_y = 1, scale = [1, 1, 1] }]"),
               ContainsSubstring("s.toml:10: ") && ContainsSubstring("must have one key"));
    CHECK_THAT(refusal_of_model("[{ scale = [1, 0, 1] }]"),
               ContainsSubstring("s.toml:10: ") &&
                   ContainsSubstring("leaves nothing of the object"));
    CHECK_THAT(refusal_of_model("[{ translate = [1e6, 0, 0] }, { translate = [1e6, 0, 0] }]"),
               ContainsSubstring("s.toml:9: ") && ContainsSubstring("is too far out"));
    std::string many = "[";
    for (int i = 0; i < 70; ++i)
        many += "{ scale = [1e6, 1e6, 1e6] },";
    CHECK_THAT(refusal_of_model(many + "]"), ContainsSubstring("more than 64 steps"));
    many = "[";
    for (int i = 0; i < 60; ++i)
        many += "{ scale = [1e6, 1e6, 1e6] },";
    CHECK_THAT(refusal_of_model(many + "]"), ContainsSubstring("enlarge the object too much"));
    many = "[";
    for (int i = 0; i < 60; ++i)
        many += "{ scale = [1e-6, 1e-6, 1e-6] },";
    CHECK_THAT(refusal_of_model(many + "]"), ContainsSubstring("leave nothing of the object"));
    // Too small for floats, and too small for its place.
    many = "[";
    for (int i = 0; i < 8; ++i)
        many += "{ scale = [1e-6, 1e-6, 1e-6] },";
    CHECK_THAT(refusal_of_model(many + "]"),
               ContainsSubstring("s.toml:9: ") && ContainsSubstring("shrinks to nothing"));
    CHECK_THAT(
        refusal_of_model("[{ scale = [1e-6, 1e-6, 1e-6] }, { translate = [900, 900, 900] }]"),
        ContainsSubstring("s.toml:9: ") && ContainsSubstring("shrinks to nothing"));
    CHECK(refusal_of_model("[{ scale = [1e-6, 1e-6, 1e-6] }, { scale = [1e6, 1e6, 1e6] }, "
                           "{ translate = [900, 900, 900] }]") == "accepted");
    for (const char* model : {"3", "[3]", "[{}]", "[{ rotate_x = [1] }]", "[{ rotate_x = nan }]",
                              "[{ rotate_x = 1e9 }]", "[{ translate = [1, 2] }]",
                              "[{ translate = [inf, 0, 0] }]", "[{ scale = 2 }]", "{}"}) {
        INFO(model);
        CHECK_THAT(refusal_of_model(model), ContainsSubstring("s.toml:"));
    }
    const std::string pixels = "name = \"s\"\nspace = \"pixels\"\n[points.p]\nA = [1, 2]\n"
                               "B = [5, 2]\nC = [3, 9]\n[[part]]\nname = \"q\"\npoints = \"p\"\n"
                               "triangles = [\"A B C\"]\nmodel = [{ rotate_z = 1 }]\n";
    CHECK_THROWS_WITH(parse_scene(pixels, "s.toml"),
                      ContainsSubstring("s.toml:11: points in pixels cannot have a model."));
}

TEST_CASE("A camera of a scene looks at a target, or is turned, not both") {
    const std::string text = scene_with("[]");
    const std::string looks = text + "[camera]\nposition = [3, -1, -2]\ntarget = [0, 0.5, 1]\n";
    const Scene scene = parse_scene(looks, "s.toml");
    CHECK(scene.camera.aim == CameraAim::look_at);
    CHECK(scene.camera.target == glm::vec3(0.0f, 0.5f, 1.0f));
    CHECK_THROWS_WITH(parse_scene(looks + "yaw = 1\n", "s.toml"),
                      ContainsSubstring("s.toml:") && ContainsSubstring("not both"));
}

TEST_CASE("A camera of a scene that has no direction is refused with its file and line") {
    const auto refusal = [](const std::string& camera) -> std::string {
        try {
            parse_scene(scene_with("[]") + "[camera]\n" + camera, "s.toml");
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    CHECK(refusal("position = [1, 2, 3]\ntarget = [1, 2, 3]\n") ==
          "s.toml:13: the camera is at its own target, which gives it no direction to look in.");
    CHECK(refusal("target = [0, 0, 9]\nposition = [0, 0, 1]\nup = [0, 0, -1]\n") ==
          "s.toml:14: the camera's up points along its view, or nowhere.");
    CHECK(refusal("target = [0, 0, 9]\nposition = [0, 0, 1]\nup = [0, 0, 0]\n") ==
          "s.toml:14: the camera's up points along its view, or nowhere.");
    // Straight down, and no up is given.
    CHECK(refusal("position = [0, -3, 0]\ntarget = [0, 2, 0]\n") ==
          "s.toml:13: the camera's up points along its view, or nowhere.");
    CHECK(refusal("position = [0, -3, 0]\ntarget = [0, 2, 0]\nup = [0, 0, 1]\n") == "accepted");
}
