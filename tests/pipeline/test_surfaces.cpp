#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "stages/surface_shader.h"
#include "support/bits.h"
#include "support/small_cylinder.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

/// Two triangles at a bent edge, whose corners have their own colours and normals.
const std::string folded = R"(
name = "A fold"
stage = "pixel_light"
[viewport]
width = 40
height = 36
[camera]
position = [0.2, -0.3, -3]
focal_length = 50
[light]
position = [0.6, -0.9, -2]
power = 20
indirect = [0.1, 0.2, 0.15]
[points.fold]
A = [-1, -0.8, 0.5]
B = [0, -1, 0]
C = [0.1, 0.9, -0.1]
D = [1, 0.7, 0.6]
[normals.fold]
A = [-0.9, 0, -1]
B = [0, -0.6, -2]
C = [0.1, 0.3, -1]
D = [5, 1, -4]
[colours.fold]
A = [0.9, 0.1, 0.1]
C = [0.1, 0.8, 0.2]
D = [0.2, 0.2, 1]
[materials.wax]
diffuse = [0.7, 0.7, 0.3]
specular = [0.4, 0.3, 0.5]
exponent = 12
[[part]]
name = "fold"
points = "fold"
material = "wax"
normals = "fold"
colours = "fold"
triangles = ["A B C", "B D C"]
)";

/// The picture of a scene in double, by rays, without using the pipeline.
class Rays {
  public:
    Rays(const Scene& scene, const Settings& settings) : scene_(scene), settings_(settings) {
        eye_ = glm::dvec3(settings.camera.position);
        if (settings.camera.aim == CameraAim::look_at) {
            forward_ = glm::normalize(glm::dvec3(settings.camera.target) - eye_);
            right_ = glm::normalize(glm::cross(forward_, glm::dvec3(settings.camera.up)));
            down_ = glm::cross(forward_, right_);
        }
        lamp_ =
            settings.light.place == LampPlace::camera ? eye_ : glm::dvec3(settings.light.position);
    }

    struct Seen {
        int triangle = -1;
        glm::dvec3 colour{0.0};
        double slant = 1.0; ///< n . l, by which a highlight is switched on and off
    };

    Seen at(int column, int row) const {
        const double f = settings_.camera.focal_length;
        const glm::dvec3 ray = forward_ +
                               right_ * ((column + 0.5 - settings_.viewport.width / 2) / f) +
                               down_ * ((row + 0.5 - settings_.viewport.height / 2) / f);
        Seen seen;
        double nearest = 1e30;
        for (int t = 0; t < scene_.triangle_count(); ++t) {
            const glm::dvec3 a = place(t, 0), u = place(t, 1) - a, v = place(t, 2) - a;
            const glm::dvec3 p = glm::cross(ray, v);
            const double whole = glm::dot(u, p);
            const glm::dvec3 s = eye_ - a, q = glm::cross(s, u);
            const double b = glm::dot(s, p) / whole, c = glm::dot(ray, q) / whole;
            const double way = glm::dot(v, q) / whole;
            if (!(b >= 0.0 && c >= 0.0 && b + c <= 1.0 && way > 0.0 && way < nearest)) continue;
            nearest = way;
            seen = shade(t, {1.0 - b - c, b, c}, eye_ + ray * way);
        }
        return seen;
    }

  private:
    const Vertex& corner(int t, int i) const { return scene_.corner(t, i); }
    glm::dvec3 place(int t, int i) const { return glm::dvec3(corner(t, i).position); }

    glm::dvec3 mixed(int t, const glm::dvec3& weights, glm::vec3 Vertex::*member) const {
        glm::dvec3 sum(0.0);
        for (int i = 0; i < 3; ++i)
            sum += weights[i] * glm::dvec3(corner(t, i).*member);
        return sum;
    }

    Seen shade(int t, const glm::dvec3& weights, const glm::dvec3& at) const {
        Seen seen{t, glm::dvec3(0.0)};
        switch (settings_.shading) {
        case Shading::unlit:
            seen.colour = mixed(t, weights, &Vertex::reflectance);
            break;
        case Shading::flat: {
            const glm::dvec3 thirds(1.0 / 3.0);
            // Normals point to the side from which the corners go round clockwise.
            const glm::dvec3 across =
                glm::cross(place(t, 2) - place(t, 0), place(t, 1) - place(t, 0));
            seen.colour =
                light(t, (place(t, 0) + place(t, 1) + place(t, 2)) / 3.0, glm::normalize(across),
                      mixed(t, thirds, &Vertex::reflectance), seen.slant);
            break;
        }
        case Shading::gouraud:
            for (int i = 0; i < 3; ++i) {
                double slant = 0.0;
                seen.colour += weights[i] * light(t, place(t, i), glm::dvec3(corner(t, i).normal),
                                                  glm::dvec3(corner(t, i).reflectance), slant);
            }
            break;
        case Shading::phong: {
            glm::dvec3 normal = mixed(t, weights, &Vertex::normal);
            if (settings_.light_rules.renormalize == Renormalize::on)
                normal = glm::normalize(normal);
            seen.colour = light(t, at, normal, mixed(t, weights, &Vertex::reflectance), seen.slant);
        }
        }
        return seen;
    }

    glm::dvec3 light(int t, const glm::dvec3& at, const glm::dvec3& given, const glm::dvec3& rho,
                     double& slant) const {
        const Light& lamp = settings_.light;
        const LightRules& rules = settings_.light_rules;
        const bool is_turned =
            rules.sides == LightSides::two && glm::dot(given, at) > glm::dot(given, eye_);
        const glm::dvec3 n = is_turned ? -given : given;
        const glm::dvec3 l = glm::normalize(lamp_ - at);
        const double r = glm::distance(lamp_, at);
        slant = glm::dot(n, l);
        double spread = 4.0 * 3.14159265358979323846 * r * r;
        if (rules.falloff == LightFalloff::no_4pi) spread = r * r;
        if (rules.falloff == LightFalloff::linear) spread = r;
        if (rules.falloff == LightFalloff::none) spread = 1.0;
        const glm::dvec3 arrives = glm::dvec3(lamp.power) / spread;
        glm::dvec3 sum = rho * (arrives * std::max(slant, 0.0) + glm::dvec3(lamp.indirect));
        const bool shines = slant > 0.0 || rules.highlight == HighlightRule::unasked;
        if (lamp.model == LightModel::lambert || !shines) return sum;
        glm::dvec3 h = l + glm::normalize(eye_ - at);
        if (rules.highlight != HighlightRule::long_half) h = glm::normalize(h);
        const Shine& shine = corner(t, 0).shine;
        sum += glm::dvec3(shine.specular) * arrives *
               std::pow(std::max(glm::dot(n, h), 0.0), double(shine.exponent));
        return sum;
    }

    const Scene& scene_;
    const Settings& settings_;
    glm::dvec3 eye_, lamp_, forward_{0, 0, 1}, right_{1, 0, 0}, down_{0, 1, 0};
};

Settings settings_of(const Scene& scene, std::initializer_list<const char*> assignments) {
    Settings settings = default_settings(scene);
    // Pixels at their centres, with corners that are hardly moved.
    for (const char* usual : {"coverage=edge_functions", "snap=subpixel", "fill_rule=top_left"})
        set_from_text(settings, usual);
    for (const char* assignment : assignments)
        set_from_text(settings, assignment);
    return settings;
}

/// Fails at the first pixel that is off by more than 1/255 of the screen's range.
/// @return pixels whose rays see something, without ties
int compare_with_rays(const Scene& scene, const Settings& settings, const std::string& where) {
    const Framebuffer picture = draw_frame(prepare_frame(scene, settings));
    const Rays rays(scene, settings);
    int compared = 0, ties = 0;
    for (int row = 0; row < settings.viewport.height; ++row) {
        for (int column = 0; column < settings.viewport.width; ++column) {
            const std::size_t i = picture.at(column, row);
            const Rays::Seen seen = rays.at(column, row);
            // Corners on 256ths of a pixel can give a pixel on an edge to another triangle, and the
            // highlight begins abruptly where n . l is 0.
            if (seen.triangle != picture.owner[i] || std::abs(seen.slant) < 1e-3) {
                ++ties;
                continue;
            }
            if (seen.triangle < 0) continue;
            ++compared;
            for (int c = 0; c < 3; ++c) {
                const double right = std::clamp(seen.colour[c], 0.0, 1.0);
                const double drawn = std::clamp(double(picture.colour[i][c]), 0.0, 1.0);
                if (!(std::abs(drawn - right) <= 1.0 / 255.0)) {
                    FAIL(where << " pixel (" << column << ", " << row << ") channel " << c
                               << " of triangle " << seen.triangle << " is " << drawn
                               << ", by rays " << right);
                }
            }
        }
    }
    INFO(where);
    CHECK(ties * 100 <= 2 * compared);
    return compared;
}

} // namespace

TEST_CASE("Each shading, fall-off, highlight and its mistakes are what rays in double see") {
    const std::vector<Scene> scenes{test::small_cylinder({32, 29}, 38.0f),
                                    parse_scene(folded, "folded.toml")};
    for (const Scene& scene : scenes) {
        const bool is_cylinder = scene.triangle_count() > 2;
        for (const char* shading :
             {"shading=unlit", "shading=flat", "shading=gouraud", "shading=phong"}) {
            for (const char* rule :
                 {"light.model=lambert", "light.falloff=no_4pi", "light.falloff=linear",
                  "light.falloff=none", "light.place=camera", "light.highlight=unasked",
                  "light.highlight=long_half", "light.renormalize=off"}) {
                // Light that spreads less gets less power, so that not everything is white.
                const std::string law = rule;
                // Near 2, the cylinder's exponent of 50 amplifies 1/256 of a pixel.
                if (is_cylinder && law == "light.highlight=long_half") continue;
                const char* power = law == "light.falloff=none"     ? "light.power=0.6"
                                    : law == "light.falloff=linear" ? "light.power=1.2"
                                    : law == "light.falloff=no_4pi" ? "light.power=2"
                                                                    : "light.power=20";
                const Settings settings =
                    settings_of(scene, {"light.model=blinn_phong", shading, power, rule});
                const int seen = compare_with_rays(scene, settings,
                                                   scene.name + ", " + shading + ", " + rule + ":");
                CHECK(seen > (is_cylinder ? 240 : 250));
            }
        }
    }
}

TEST_CASE(
    "With both sides lit a back is as bright as its flipped normal makes it, by rays in double") {
    const Scene scene = parse_scene(folded, "folded.toml");
    const auto brightness = [&](const Settings& settings) {
        double sum = 0.0;
        for (const glm::vec3& colour : draw_frame(prepare_frame(scene, settings)).colour)
            sum += double(colour.r) + double(colour.g) + double(colour.b);
        return sum;
    };
    for (const char* shading : {"shading=flat", "shading=gouraud", "shading=phong"}) {
        for (const char* model : {"light.model=lambert", "light.model=blinn_phong"}) {
            for (const char* eye : {"camera.position=0.2,-0.3,-3", "camera.position=-0.4,0.3,3"}) {
                CAPTURE(shading, model, eye);
                Settings settings = settings_of(scene, {"camera.aim=look_at", "camera.target=0,0,0",
                                                        "light.place=camera", shading, model, eye});
                const double of_one = brightness(settings);
                set_from_text(settings, "light.sides=two");
                const int seen =
                    compare_with_rays(scene, settings, std::string(shading) + ", " + eye + ":");
                CHECK(seen > 250);
                const bool sees_backs = settings.camera.position.z > 0.0f;
                if (sees_backs) {
                    CHECK(brightness(settings) > 2.0 * of_one);
                } else {
                    CHECK(brightness(settings) == of_one);
                }
            }
        }
    }
}

TEST_CASE(
    "The lab's features are drawn by the lab's own shader, and the other agrees in each bit") {
    const Scene room = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    CHECK(room.mesh.differences() == CornerDifferences{});
    for (const StageInfo& info : stage_list()) {
        Settings settings = default_settings(room);
        settings.viewport = {60, 60};
        settings.camera.focal_length = 60.0f;
        set_step(settings, info.step);
        const Frame frame = prepare_frame(room, settings);
        INFO(info.name);
        CHECK(frame.stages.pixel_shader == pixel_shader);
        CHECK(frame.stages.varyings_read == varyings_read);
        const Frame other = prepare_frame(
            room, settings, [](Stages& stages) { stages.pixel_shader = surface_shader; });
        const std::string difference = test::first_difference(draw_frame(frame), draw_frame(other));
        CHECK(difference.empty());
        // Highlights of a surface without any change nothing either.
        settings.light.model = LightModel::blinn_phong;
        const std::string shine =
            test::first_difference(draw_frame(frame), draw_frame(prepare_frame(room, settings)));
        CHECK(shine.empty());
    }
}

TEST_CASE("Normals and colours are carried only if corners differ and they are read") {
    const Scene scene = test::small_cylinder({32, 29}, 38.0f);
    const auto read = [&](std::initializer_list<const char*> assignments) {
        const Settings settings = settings_of(scene, assignments);
        return carried_varyings(prepare_frame(scene, settings).stages, shading_rule(settings));
    };
    const VaryingSet place = VaryingSet::of(&Varyings::position_world);
    CHECK(read({"shading=phong"}) == (place | VaryingSet::of(&Varyings::normal)));
    CHECK(read({"shading=gouraud"}) == VaryingSet::of(&Varyings::illumination));
    CHECK(read({"shading=flat"}) == VaryingSet{});
    CHECK(read({"stage=fill"}) == VaryingSet{});
}

TEST_CASE("A smooth body is culled by its triangles, not by the normals of their corners") {
    const Scene scene = test::small_cylinder({32, 29}, 38.0f);
    Settings settings = settings_of(scene, {"cull=face_normal"});
    const Frame by_normal = prepare_frame(scene, settings);
    set_from_text(settings, "cull=screen_area");
    const Frame by_area = prepare_frame(scene, settings);
    int backs = 0;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        CAPTURE(t);
        CHECK(by_normal.rejection(t) == by_area.rejection(t));
        backs += by_area.is_drawn(t) ? 0 : 1;
    }
    CHECK(backs > 20);
}

TEST_CASE("Scenes in pixels are already projected, and their highlights keep their eye") {
    const Scene scene = parse_scene(R"(
name = "A shining triangle"
space = "pixels"
stage = "pixel_light"
[viewport]
width = 24
height = 20
[camera]
position = [10, 8, -6]
[light]
position = [14, 5, -9]
power = 900
model = "blinn_phong"
[points.p]
A = [2, 2, 1]
B = [20, 4, 2]
C = [7, 17, 1]
[materials.m]
diffuse = 0.2
specular = 0.8
exponent = 9
[[part]]
name = "t"
points = "p"
material = "m"
triangles = ["A B C"]
)",
                                    "pixels.toml");
    for (const char* const shading : {"shading=flat", "shading=gouraud", "shading=phong"}) {
        INFO(shading);
        const auto drawn = [&](const char* model, const char* mix) {
            return draw_frame(prepare_frame(scene, settings_of(scene, {shading, model, mix})));
        };
        const Framebuffer shining = drawn("light.model=blinn_phong", "projection_mix=0");
        CHECK(drawn("light.model=blinn_phong", "projection_mix=0.7") == shining);
        CHECK_FALSE(drawn("light.model=lambert", "projection_mix=0") == shining);
    }
}
