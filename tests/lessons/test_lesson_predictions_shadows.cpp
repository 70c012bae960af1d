// The predictions and the figures of lesson 31, found a second time: every second pixel's own ray
// from the eye, and from where it ends one to the lamp; for the map one from the lamp through the
// centre of the texel. All in double.

#include <algorithm>
#include <array>
#include <cmath>
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

/// What a pixel shows, as far as the lamp's light asks for it.
struct Place {
    int triangle = -1;
    glm::dvec3 position{0.0};
    double cosine = 0.0; ///< between normal and light
    bool is_dark = false;
};

constexpr int stride = 2; // of the pixels that are asked

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

    /// How many of the pixels hold a condition, counted for all of the picture.
    template <typename Condition>
    double count(const Condition& holds) const {
        return static_cast<double>(stride * stride *
                                   std::count_if(places_.begin(), places_.end(), holds));
    }

    /// How far a place lies behind what the lamp sees in its texel of 512, and behind the bias.
    double behind(const Place& place, double bias) {
        constexpr int resolution = 512;
        const glm::dvec3 from_lamp = place.position - lamp_;
        int axis = 0;
        for (int i = 1; i < 3; ++i) {
            if (std::abs(from_lamp[i]) > std::abs(from_lamp[axis])) axis = i;
        }
        const double z = std::abs(from_lamp[axis]);
        // The centre of the texel along both other axes; which way they run does not matter.
        glm::dvec3 centre = from_lamp / z;
        std::array<int, 3> key{from_lamp[axis] > 0.0 ? axis : axis + 3, 0, 0};
        for (int i = 0, k = 1; i < 3; ++i) {
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

    /// Pixels that the map puts in shadow though nothing stands between; those that lie no farther
    /// behind than this are left out. Across the way of the light rounding decides.
    double acne(double bias, double least) {
        return count([&](const Place& place) {
            return place.cosine > 0.0 && !place.is_dark && behind(place, bias) > least;
        });
    }

  private:
    Room room_;
    Settings settings_;
    glm::dvec3 lamp_;
    std::vector<Place> places_;
    std::map<std::array<int, 3>, double> depths_; ///< by face and texel
};

PREDICTIONS_TEST("Lesson 31: what lies in shadow, and what a map takes for it", "31-shadows",
                 "floor-share", "acne", "lost-foot") {
    Places places;
    const auto is_floor = [](const Place& place) { return place.triangle < 2; };
    const double floor = places.count(is_floor);
    const double dark_floor =
        places.count([&](const Place& place) { return is_floor(place) && place.is_dark; });
    const double facing = places.count([](const Place& place) { return place.cosine > 0.0; });
    CHECK(floor == Approx(31'038).epsilon(0.02));
    CHECK(dark_floor == Approx(5'686).epsilon(0.03));
    CHECK(places.count([](const Place& place) { return place.is_dark; }) ==
          Approx(12'338).epsilon(0.03));
    // What the program counts lies between what is surely dark and what may be.
    constexpr double rounding = 1e-4;
    const Room room;
    const auto acne_of_program = [&](const char* bias) {
        Settings settings = default_settings(room.scene);
        for (const char* text : {"stage=pixel_light", "light.power=8", "shadows=map", bias})
            set_from_text(settings, text);
        return static_cast<double>(count_shadows(prepare_frame(room.scene, settings)).all.acne);
    };
    const double bare = acne_of_program("shadow_bias=0");
    CHECK(bare > 0.97 * places.acne(0.0, rounding));
    CHECK(bare < 1.03 * places.acne(0.0, -rounding));
    CHECK(places.acne(0.0, rounding) > 0.15 * facing);
    CHECK(acne_of_program("shadow_bias=0.02") ==
          Approx(places.acne(0.02, 0.0)).epsilon(0.1).margin(60));
    CHECK(places.acne(0.05, 0.0) < 100);
    // Half a unit of bias lights what lies less than that behind what casts the shadow.
    const double dark = places.count([](const Place& place) { return place.is_dark; });
    const double lost = places.count(
        [&](const Place& place) { return place.is_dark && places.behind(place, 0.5) <= 0.0; });
    CHECK(lost > 300);
    CHECK(10.0 * lost < dark);

    const Questions lesson("31-shadows");
    lesson.require_number("floor-share", 100.0 * dark_floor / floor, 0.6, 50.0);
    lesson.require_choice("acne", 2);
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

} // namespace shadow_lesson
} // namespace
