// The predictions and the figures of lesson 31, found a second time: a ray from the eye through
// every second pixel, and from its end a ray to the lamp; for the map, a ray from the lamp through
// the centre of the texel. All in double.

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "inspect/shadow_count.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/questions.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace shadow_lesson {

/// A triangle as a plane and three borders that look inward.
struct Pane {
    glm::dvec3 normal, corner;
    std::array<glm::dvec3, 3> corners, inward;
};

struct Met {
    int triangle = -1;
    double t = 1e9; ///< of the way
};

class Room {
  public:
    Room() {
        for (int t = 0; t < scene.triangle_count(); ++t) {
            Pane pane;
            for (int i = 0; i < 3; ++i)
                pane.corners[static_cast<std::size_t>(i)] = glm::dvec3(scene.corner(t, i).position);
            const auto& c = pane.corners;
            pane.normal = glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0]));
            pane.corner = c[0];
            for (std::size_t i = 0; i < 3; ++i)
                pane.inward[i] = glm::cross(pane.normal, c[(i + 1) % 3] - c[i]);
            panes_.push_back(pane);
        }
    }

    /// What from + t way meets first with t in (0, last), but for one triangle.
    Met first(const glm::dvec3& from, const glm::dvec3& way, double last, int but_for) const {
        Met met;
        for (std::size_t t = 0; t < panes_.size(); ++t) {
            const Pane& pane = panes_[t];
            const double rise = glm::dot(pane.normal, way);
            if (static_cast<int>(t) == but_for || rise == 0.0) continue;
            const double at = glm::dot(pane.normal, pane.corner - from) / rise;
            if (at <= 1e-9 || at >= last || at >= met.t) continue;
            const glm::dvec3 place = from + at * way;
            bool is_inside = true;
            for (std::size_t i = 0; i < 3; ++i)
                is_inside = is_inside && glm::dot(pane.inward[i], place - pane.corners[i]) >= 0.0;
            if (is_inside) met = {static_cast<int>(t), at};
        }
        return met;
    }

    const glm::dvec3& normal(int triangle) const {
        return panes_[static_cast<std::size_t>(triangle)].normal;
    }

    Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");

  private:
    std::vector<Pane> panes_;
};

/// What a pixel shows, as far as the lamp's light needs it.
struct Place {
    int triangle = -1;
    glm::dvec3 position{0.0};
    double cosine = 0.0; ///< between normal and light
    bool is_dark = false;
};

constexpr int stride = 2; // of the pixels that are tested

class Places {
  public:
    Places() : settings_(default_settings(room_.scene)), lamp_(settings_.light.position) {
        const glm::dvec3 eye(settings_.camera.position);
        const double f = settings_.camera.focal_length;
        for (int row = 0; row < settings_.viewport.height; row += stride) {
            for (int column = 0; column < settings_.viewport.width; column += stride) {
                const glm::dvec3 ray((column - settings_.viewport.width / 2) / f,
                                     (row - settings_.viewport.height / 2) / f, 1.0);
                const Met met = room_.first(eye, ray, 1e9, -1);
                if (met.triangle < 0) continue;
                Place place{met.triangle, eye + met.t * ray, 0.0, false};
                const glm::dvec3 way = lamp_ - place.position;
                // The side that is seen.
                glm::dvec3 normal = room_.normal(met.triangle);
                if (glm::dot(normal, ray) > 0.0) normal = -normal;
                place.cosine = glm::dot(normal, glm::normalize(way));
                place.is_dark = place.cosine > 0.0 &&
                                room_.first(place.position, way, 1.0, met.triangle).triangle >= 0;
                places_.push_back(place);
            }
        }
    }

    /// The number of pixels that satisfy a condition, scaled to the whole picture.
    template <typename Condition>
    double count(const Condition& holds) const {
        return static_cast<double>(stride * stride *
                                   std::count_if(places_.begin(), places_.end(), holds));
    }

    /// How far a place is behind what the lamp sees in its texel, beyond the bias.
    double behind(const Place& place, double bias, int resolution = 512) {
        const glm::dvec3 from_lamp = place.position - lamp_;
        int axis = 0;
        for (int i = 1; i < 3; ++i) {
            if (std::abs(from_lamp[i]) > std::abs(from_lamp[axis])) axis = i;
        }
        const double z = std::abs(from_lamp[axis]);
        // The centre of the texel along both other axes; which way they run does not matter.
        glm::dvec3 centre = from_lamp / z;
        std::array<int, 4> key{resolution, from_lamp[axis] > 0.0 ? axis : axis + 3, 0, 0};
        for (int i = 0, k = 2; i < 3; ++i) {
            if (i == axis) continue;
            const double texel = std::floor((centre[i] + 1.0) / 2.0 * resolution);
            centre[i] = (2.0 * texel + 1.0) / resolution - 1.0;
            key[static_cast<std::size_t>(k++)] = static_cast<int>(texel);
        }
        auto known = depths_.find(key);
        if (known == depths_.end())
            known = depths_.emplace(key, room_.first(lamp_, centre, 1e9, -1).t).first;
        return z - bias - known->second;
    }

    /// Pixels that the map puts in shadow though nothing is in between; those no farther behind
    /// than `least` are left out. Across the way of the light rounding decides.
    double acne(double bias, double least, int resolution = 512) {
        return count([&](const Place& place) {
            return place.cosine > 0.0 && !place.is_dark && behind(place, bias, resolution) > least;
        });
    }

    /// Of the pixels that satisfy a condition and that no surface shades, the share that is dark
    /// without a bias.
    template <typename Condition>
    double share_of_acne(const Condition& holds) {
        const double asked = count([&](const Place& place) {
            return place.cosine > 0.0 && !place.is_dark && holds(place);
        });
        return count([&](const Place& place) {
                   return place.cosine > 0.0 && !place.is_dark && holds(place) &&
                          behind(place, 0.0) > 1e-4;
               }) /
               asked;
    }

    /// The axis of the face of the map that a place falls in, 0 to 2 for x, y, z.
    int axis_of(const Place& place) const {
        const glm::dvec3 from_lamp = place.position - lamp_;
        int axis = 0;
        for (int i = 1; i < 3; ++i) {
            if (std::abs(from_lamp[i]) > std::abs(from_lamp[axis])) axis = i;
        }
        return axis;
    }
    const glm::dvec3& normal(const Place& place) const { return room_.normal(place.triangle); }
    bool is_on_walls(const Place& place) const { return place.triangle < 10; }

    /// Of the pixels that face the lamp, the share at which a line on through the lamp meets
    /// something, on this side of the lamp or beyond it.
    double share_dark_past_lamp() const {
        const double facing = count([](const Place& place) { return place.cosine > 0.0; });
        return count([&](const Place& place) {
                   return place.cosine > 0.0 &&
                          room_.first(place.position, lamp_ - place.position, 1e9, place.triangle)
                                  .triangle >= 0;
               }) /
               facing;
    }

  private:
    Room room_;
    Settings settings_;
    glm::dvec3 lamp_;
    std::vector<Place> places_;
    std::map<std::array<int, 4>, double> depths_; ///< by resolution, face and texel
};

PREDICTIONS_TEST("Lesson 31: what is in shadow, and what a map puts there", "31-shadows",
                 "finer-map") {
    Places places;
    const double facing = places.count([](const Place& place) { return place.cosine > 0.0; });
    CHECK(places.count([](const Place& place) { return place.is_dark; }) ==
          Approx(12'338).epsilon(0.03));
    // The program's count is between what is surely dark and what may be.
    constexpr double rounding = 1e-4;
    const Room room;
    const auto acne_of_program = [&](std::initializer_list<const char*> changed) {
        Settings settings = default_settings(room.scene);
        for (const char* text : {"stage=pixel_light", "light.power=8", "shadows=map"})
            set_from_text(settings, text);
        for (const char* text : changed)
            set_from_text(settings, text);
        return static_cast<double>(count_shadows(prepare_frame(room.scene, settings)).all.acne);
    };
    const double bare = acne_of_program({"shadow_bias=0"});
    CHECK(bare > 0.97 * places.acne(0.0, rounding));
    CHECK(bare < 1.03 * places.acne(0.0, -rounding));
    // About one in four, with a finer map too.
    CHECK(bare == Approx(facing / 4.0).epsilon(0.15));
    CHECK(places.acne(0.0, 1e-5, 1024) > 33'000);
    CHECK(acne_of_program({"shadow_bias=0", "shadow_resolution=1024"}) ==
          Approx(facing / 4.0).epsilon(0.15));
    // Nearly half of the walls, unless they are at right angles to the axis of their face of the
    // map.
    const auto is_across = [&](const Place& place) {
        return std::abs(places.normal(place)[places.axis_of(place)]) > 0.999;
    };
    CHECK(places.share_of_acne([&](const Place& place) {
        return places.is_on_walls(place) && is_across(place);
    }) < 0.01);
    CHECK(places.share_of_acne([&](const Place& place) {
        return places.is_on_walls(place) && !is_across(place);
    }) == Approx(0.45).margin(0.1));
    CHECK(acne_of_program({"shadow_bias=0.02"}) ==
          Approx(places.acne(0.02, 0.0)).epsilon(0.1).margin(60));
    CHECK(places.acne(0.05, 0.0) < 100);
    // The last that need a bias are where the light grazes the front of the short block.
    CHECK(places.acne(0.03, 0.0) > 300);
    CHECK(places.count([&](const Place& place) {
        return place.cosine > 0.0 && !place.is_dark && places.behind(place, 0.03) > 0.0 &&
               place.triangle >= 10 && place.triangle < 20 && place.cosine < 0.2;
    }) > 0.9 * places.acne(0.03, 0.0));
    // On the slider, in steps of 0.005, 0.045 is the first to leave fewer than 100.
    CHECK(acne_of_program({"shadow_bias=0.04"}) >= 100.0);
    CHECK(acne_of_program({"shadow_bias=0.045"}) < 100.0);
    CHECK(places.acne(0.045, 0.0) < places.acne(0.04, 0.0));
    // Single pixels at the borders of shadows stay, for the most part whatever the bias is.
    CHECK(acne_of_program({"shadow_bias=0.5"}) > acne_of_program({"shadow_bias=0.1"}) / 2.0);
    // A map of 64 texels has stripes with the same bias, and hardly any with a texel of slant more.
    CHECK(places.acne(0.05, 0.0, 64) > 3'000);
    CHECK(acne_of_program({"shadow_resolution=64"}) ==
          Approx(places.acne(0.05, 0.0, 64)).epsilon(0.2));
    CHECK(acne_of_program({"shadow_resolution=64", "shadow_slope_bias=1"}) < 700);
    // A bias by slant needs a small constant part only.
    CHECK(acne_of_program({"shadow_bias=0.002", "shadow_slope_bias=1"}) <=
          acne_of_program({"shadow_bias=0.05"}));
    // Without the test for the lamp more than half of the room is dark.
    CHECK(places.share_dark_past_lamp() > 0.5);
    CHECK(places.share_dark_past_lamp() < 0.65);

    const Questions lesson("31-shadows");
    lesson.require_choice("finer-map", 2);
}

PREDICTIONS_TEST("Lesson 31: a shadow and a stronger lamp", "31-shadows", "stronger-lamp") {
    const Room room;
    const Settings settings = default_settings(room.scene);
    const glm::dvec3 eye(settings.camera.position), lamp(settings.light.position);
    const double f = settings.camera.focal_length;
    const glm::dvec3 ray((410 - 250) / f, (449 - 250) / f, 1.0);
    const Met met = room.first(eye, ray, 1e9, -1);
    REQUIRE(met.triangle >= 0);
    CHECK(met.triangle < 2); // the floor
    const glm::dvec3 place = eye + met.t * ray;
    CHECK(room.first(place, lamp - place, 1.0, met.triangle).triangle >= 10); // the short block
    const double green = static_cast<double>(room.scene.corner(met.triangle, 0).reflectance.g) *
                         static_cast<double>(settings.light.indirect.g);
    CHECK(green == Approx(0.375));
    const Questions lesson("31-shadows");
    lesson.require_choice("stronger-lamp", 2);
    const Judgement said = lesson.answered("stronger-lamp", {2});
    CHECK(said.because.find("0.375") != std::string::npos);
}

PREDICTIONS_TEST("Lesson 31: the foot of a gate, and too much bias", "31-shadows", "lost-foot") {
    // scenes/linear-z.toml: the plane of the ramp, and that of the gate, which opens from near on
    // the left to far on the right.
    const glm::dvec3 lamp(-1, -3, 8), ray((252 - 250) / 500.0, (270 - 250) / 500.0, 1.0);
    const glm::dvec3 ramp_corner(-0.9, 0.96, 2), gate_corner(-1.15, -1.05, 2.5);
    const glm::dvec3 ramp = glm::cross(glm::dvec3(1, 0, 0), glm::dvec3(0, -10.4 - 0.96, 40 - 2));
    const glm::dvec3 gate = glm::cross(glm::dvec3(0, 1, 0), glm::dvec3(11.5 + 1.15, 0, 30 - 2.5));
    const glm::dvec3 place = ray * (glm::dot(ramp, ramp_corner) / glm::dot(ramp, ray));
    const glm::dvec3 way = place - lamp;
    const double t = glm::dot(gate, gate_corner - lamp) / glm::dot(gate, way);
    CHECK(t > 0.0);
    CHECK(t < 1.0); // the gate is in between
    const glm::dvec3 on_gate = lamp + t * way;
    // Its upper and lower edge there, in proportion to z.
    const double along = (on_gate.z - 2.5) / (30.0 - 2.5);
    CHECK(on_gate.y > -1.05 - 11.55 * along);
    CHECK(on_gate.y < 0.45 + 4.95 * along);
    const glm::dvec3 behind = glm::abs(place - on_gate);
    const double deep = glm::abs(way.x) > glm::abs(way.y) && glm::abs(way.x) > glm::abs(way.z)
                            ? behind.x
                        : glm::abs(way.y) > glm::abs(way.z) ? behind.y
                                                            : behind.z;
    CHECK(deep > 0.1);
    CHECK(deep < 0.4); // less than half a unit
    const Questions lesson("31-shadows");
    lesson.require_choice("lost-foot", 0);
}

PREDICTIONS_TEST("Lesson 31: a ray that begins on its surface", "31-shadows", "own-surface") {
    const Room room;
    const auto drawn = [&](const char* offset) {
        Settings settings = default_settings(room.scene);
        for (const char* text : {"stage=pixel_light", "light.power=8", "shadows=rays", offset})
            set_from_text(settings, text);
        return draw_frame(prepare_frame(room.scene, settings)).colour;
    };
    const auto right = drawn("shadow_offset=0.001"), from_surface = drawn("shadow_offset=0");
    int darker = 0;
    for (std::size_t i = 0; i < right.size(); ++i) {
        const auto sum = [](const glm::vec3& c) { return c.r + c.g + c.b; };
        darker += sum(from_surface[i]) < sum(right[i]) ? 1 : 0;
    }
    const Questions lesson("31-shadows");
    lesson.require_choice("own-surface", darker == 0 ? 0 : darker < 2'459 ? 1 : 2);
}

PREDICTIONS_TEST("Lesson 31: what the lamp sees", "31-shadows", "open-front") {
    const Room room;
    const glm::dvec3 lamp(default_settings(room.scene).light.position);
    // A texel's centre, in units of half a side of the face: from -1 to 1.
    const auto across = [](int texel) { return (texel + 0.5) / 256.0 - 1.0; };
    int filled = 0;
    for (int row = 0; row < 512; row += 7) {
        for (int column = 0; column < 512; column += 7) {
            const glm::dvec3 way(across(column), across(row), -1.0);
            filled += room.first(lamp, way, 1e9, -1).triangle >= 0 ? 1 : 0;
        }
    }
    const Questions lesson("31-shadows");
    lesson.require_number("open-front", filled, 0.5, 262'144);
    // The texel of the task: down is forward, +z is up in the picture, +x is right.
    const glm::dvec3 way(across(393), 1.0, -across(221));
    const Met met = room.first(lamp, way, 1e9, -1);
    CHECK(met.triangle == 19);
    CHECK(met.t == Approx(0.9054).margin(0.001)); // the z from the lamp: y of `way` is 1
    // The top of the block: level, and above the floor.
    CHECK(std::abs(room.normal(19).y) > 0.999);
    // The floor at the point that pixel (410, 449) shows is in its shadow, at a depth of 1.5.
    const glm::dvec3 eye(default_settings(room.scene).camera.position);
    const glm::dvec3 place = eye + room.first(eye, {160.0 / 500.0, 199.0 / 500.0, 1.0}, 1e9, -1).t *
                                       glm::dvec3(160.0 / 500.0, 199.0 / 500.0, 1.0);
    CHECK(place.y - lamp.y == Approx(1.5).margin(0.001));
    const glm::dvec3 seen = (place - lamp) / (place.y - lamp.y);
    // But for the rounding of the row's ends, which moves the point a little.
    CHECK((seen.x + 1.0) * 256.0 == Approx(393.5).margin(3.0));
    CHECK((1.0 - seen.z) * 256.0 == Approx(221.5).margin(3.0));
}

} // namespace shadow_lesson
} // namespace
