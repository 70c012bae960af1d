#include "inspect/shadow_count.h"

#include "facts/facts.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "session/results.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace shadow_count_tests {

Settings small_room(const Scene& room, std::initializer_list<const char*> assignments) {
    Settings settings = default_settings(room);
    for (const char* usual : {"viewport.size=80x80", "camera.focal_length=80", "light.power=8",
                              "shadow_resolution=128"})
        set_from_text(settings, usual);
    for (const char* assignment : assignments)
        set_from_text(settings, assignment);
    return settings;
}

TEST_CASE("The pixels counted as shadow are those darker in the picture, part by part") {
    std::int64_t dark = 0;
    struct Case {
        const char* scene;
        const char* way;
    };
    for (const auto& [name, way] :
         {Case{"lab-room", "shadows=rays"}, Case{"lab-room", "shadows=map"},
          Case{"lab-room", "shadow_filter=four"}, Case{"lab-room", "shadow_bias=0"},
          Case{"lab-room", "shading=flat"}, Case{"studs", "shadows=rays"},
          Case{"brick-relief", "shadow_bias=0"}}) {
        CAPTURE(name, way);
        const Scene room = read_scene(lessons_folder() + "/scenes/" + name + ".toml");
        const Settings shaded = small_room(room, {"shadows=map", way});
        Settings bare = shaded;
        bare.shadows = Shadows::off;
        Settings truth = shaded;
        truth.shadows = Shadows::rays;
        const Frame frame = prepare_frame(room, shaded);
        Settings lamp_alone = bare;
        lamp_alone.light.indirect = glm::vec3(0.0f);
        const FrameShadows counted = count_shadows(frame);
        const Framebuffer by_lamp = draw_frame(prepare_frame(room, lamp_alone));
        const Framebuffer with = draw_frame(frame), without = draw_frame(prepare_frame(room, bare)),
                          by_rays = draw_frame(prepare_frame(room, truth));
        FrameShadows seen;
        seen.parts.resize(room.parts.size());
        // A channel that the surface reflects.
        const auto brightness = [](const glm::vec3& c) { return c.r + c.g + c.b; };
        for (std::size_t i = 0; i < with.colour.size(); ++i) {
            if (with.owner[i] < 0) continue;
            const bool is_dark = brightness(with.colour[i]) < brightness(without.colour[i]);
            const bool is_right = brightness(by_rays.colour[i]) < brightness(without.colour[i]);
            const auto part = static_cast<std::size_t>(part_of(room, with.owner[i]));
            for (ShadowCount* count : {&seen.all, &seen.parts[part]}) {
                ++count->pixels;
                count->in_shadow += is_dark ? 1 : 0;
                count->acne += is_dark && !is_right ? 1 : 0;
                count->leaks += !is_dark && is_right ? 1 : 0;
                count->facing += brightness(by_lamp.colour[i]) > 0.0f ? 1 : 0;
            }
        }
        CHECK(seen.all.facing > 100);
        dark += seen.all.in_shadow;
        const auto compare = [](const ShadowCount& a, const ShadowCount& b,
                                const std::string& of_part) {
            INFO(of_part);
            CHECK(a.in_shadow <= a.facing);
            CHECK(a.pixels == b.pixels);
            CHECK(a.facing == b.facing);
            CHECK(a.in_shadow == b.in_shadow);
            CHECK(a.acne == b.acne);
            CHECK(a.leaks == b.leaks);
        };
        compare(counted.all, seen.all, "all");
        for (std::size_t i = 0; i < room.parts.size(); ++i)
            compare(counted.parts[i], seen.parts[i], room.parts[i].name);
    }
    CHECK(dark > 400);
}

TEST_CASE("There are facts of shadows for the picked pixel, the shown part and the picture") {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    session.a.settings = small_room(*session.scene, {"shadows=rays"});
    session.selection.pixel = glm::ivec2(64, 72); // on the floor, next to the red block
    session.selection.triangle = 0;
    Results results;
    const auto value = [&](const char* name) {
        update(session, results);
        return Facts(session, results)(name);
    };
    const auto number = [&](const char* name) {
        const Value found = value(name);
        INFO(name);
        REQUIRE(std::holds_alternative<double>(found));
        return std::get<double>(found);
    };
    const FrameShadows counted = count_shadows(prepare_frame(*session.scene, session.a.settings));
    CHECK(number("frame.in_shadow") == static_cast<double>(counted.all.in_shadow));
    CHECK(number("part.in_shadow") == static_cast<double>(counted.parts[0].in_shadow));
    CHECK(number("part.pixels") == static_cast<double>(counted.parts[0].pixels));
    CHECK(number("pixel.lit") == 0.0);
    const int occluder = static_cast<int>(number("pixel.occluder"));
    CHECK(part_name(*session.scene, occluder) == "short block");
    CHECK(number("pixel.occluder_way") > 0.0);
    CHECK(number("pixel.occluder_way") < 1.0);
    CHECK_FALSE(is_there(value("pixel.map_z")));
    CHECK(number("frame.acne") == 0.0);

    set_from_text(session.a.settings, "shadows=map");
    CHECK_FALSE(is_there(value("pixel.occluder")));
    CHECK(number("pixel.lit") == 0.0);
    CHECK(number("pixel.lamp_z") == Approx(1.5).margin(1e-3)); // from the lamp down to the floor
    CHECK(number("pixel.map_z") < 1.5 - 0.05);
    CHECK(number("pixel.map_face") == 2.0);
    set_from_text(session.a.settings, "shadow_bias=0");
    CHECK(number("frame.acne") > 100.0);

    set_from_text(session.a.settings, "shadows=off");
    CHECK_FALSE(is_there(value("pixel.lit")));
    CHECK(number("frame.in_shadow") == 0.0);
    CHECK(number("frame.facing_lamp") == static_cast<double>(counted.all.facing));
}

} // namespace shadow_count_tests
} // namespace
