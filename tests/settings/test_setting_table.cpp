#include "settings/setting_table.h"

#include <cmath>
#include <cstring>
#include <random>

#include "base/error.h"
#include "base/limits.h"
#include "base/numbers.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;

namespace {

std::string value_of(const Settings& settings, std::string_view name) {
    const Setting* setting = find_setting(name);
    REQUIRE(setting != nullptr);
    return value_text(*setting, settings);
}

/// The sentence with which an assignment is refused.
std::string assignment_refusal(const std::string& assignment) {
    Settings settings;
    try {
        set_from_text(settings, assignment);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST_CASE("Each setting has a group, a section and a sentence of help") {
    for (const Setting& setting : setting_table()) {
        INFO(setting.name);
        CHECK_FALSE(setting.group.empty());
        CHECK(setting.help.ends_with('.'));
        CHECK_FALSE(setting.section.empty());
    }
}

TEST_CASE("The defaults are the lab's rules") {
    const Settings settings;
    CHECK(value_of(settings, "stage") == "pixel_light");
    CHECK(value_of(settings, "rounding") == "truncate");
    CHECK(value_of(settings, "coverage") == "rows");
    CHECK(value_of(settings, "line") == "interpolate");
    CHECK(value_of(settings, "line_walk") == "accumulate");
    CHECK(value_of(settings, "edge_samples") == "longest_axis");
    CHECK(value_of(settings, "depth_test") == "inverse_z");
    CHECK(value_of(settings, "interpolation") == "perspective");
    CHECK(value_of(settings, "camera.position") == "0,0,-3.001");
    CHECK(value_of(settings, "light.power") == "1.1");
    CHECK(value_of(settings, "viewport.size") == "500x500");
}

TEST_CASE("Every word of every choice is set and read back") {
    Settings settings;
    for (const Setting& setting : setting_table()) {
        const auto* choice = std::get_if<ChoiceSetting>(&setting.kind);
        if (choice == nullptr) continue;
        for (const std::string_view word : choice->words) {
            set_value(settings, setting, word);
            INFO(setting.name << " = " << word);
            CHECK(value_text(setting, settings) == word);
        }
    }
    // Every choice now has its last word, also where it is not one member of its own.
    CHECK(step_of(settings) == StripStep::pixel_light);
    CHECK(settings.vertex_rounding == VertexRounding::truncate_sum);
    CHECK(settings.line_rounding == Rounding::round);
    CHECK(settings.projection_mix == 1.0f);
}

TEST_CASE("A setting's values as text are those of its defaults: every choice's first word") {
    const Settings settings;
    for (const Setting& setting : setting_table()) {
        const auto* choice = std::get_if<ChoiceSetting>(&setting.kind);
        if (choice == nullptr || setting.name == "stage" || setting.name == "shading") continue;
        INFO(setting.name);
        CHECK(value_text(setting, settings) == choice->words.front());
    }
}

TEST_CASE("Numbers, places, colours and sizes are set from text") {
    Settings settings;
    for (const char* assignment :
         {"camera.yaw=-0.25", "camera.pitch= 0.5 ", "camera.focal_length=1e3",
          "camera.position=1, -2.5 ,3", "light.position=4,5,6", "light.power=14",
          "light.indirect=0.1,0.2,0.3", "viewport.size=640x480", "tessellation= 64"}) {
        set_from_text(settings, assignment);
    }
    CHECK(settings.camera.yaw == -0.25f);
    CHECK(settings.camera.pitch == 0.5f);
    CHECK(settings.camera.focal_length == 1000.0f);
    CHECK(settings.camera.position == glm::vec3(1.0f, -2.5f, 3.0f));
    CHECK(settings.light.position == glm::vec3(4.0f, 5.0f, 6.0f));
    CHECK(settings.light.power == glm::vec3(14.0f));
    CHECK(settings.light.indirect == glm::vec3(0.1f, 0.2f, 0.3f));
    CHECK(settings.viewport == Viewport{640, 480});
    CHECK(settings.tessellation == 64);
    CHECK(value_of(settings, "tessellation") == "64");
    CHECK(value_of(settings, "light.power") == "14");
    CHECK(value_of(settings, "light.indirect") == "0.1,0.2,0.3");
    CHECK(value_of(settings, "camera.focal_length") == "1000");
}

TEST_CASE("A box is set from text, off-centre too, and set back by auto") {
    Settings settings;
    CHECK(value_of(settings, "view_box") == "auto");
    set_from_text(settings, "view_box= -0.1, 0.1 ,0.0,0.2");
    CHECK(settings.view_box == ViewBox{-0.1f, 0.1f, 0.0f, 0.2f});
    CHECK(value_of(settings, "view_box") == "-0.1,0.1,0,0.2");
    CHECK_FALSE(has_same_value(*find_setting("view_box"), settings, Settings()));
    set_from_text(settings, "view_box= auto ");
    CHECK(settings == Settings());
}

TEST_CASE("The text of any value is read back as the same bits") {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> exponent(-30.0f, 9.9f);
    const Setting& place = *find_setting("camera.position");
    for (int i = 0; i < 20000; ++i) {
        Settings settings;
        for (int axis = 0; axis < 3; ++axis) {
            const float size = std::exp2(exponent(random));
            settings.camera.position[axis] = i % 2 == 0 ? size : -size;
        }
        Settings again;
        const std::string text = value_text(place, settings);
        set_value(again, place, text);
        if (std::memcmp(&again.camera.position, &settings.camera.position, sizeof(glm::vec3)) !=
            0) {
            FAIL(text << " is not read back as what it was made from");
        }
    }
}

TEST_CASE("An unknown setting is refused with the nearest name") {
    CHECK(assignment_refusal("roundign=floor") ==
          "there is no setting 'roundign'. Did you mean 'rounding'?");
    CHECK(assignment_refusal("power=3") ==
          "there is no setting 'power'. Did you mean 'light.power'?");
    CHECK(assignment_refusal("light.powr=3") == "there is no setting 'light.powr'. Did you mean "
                                                "'light.power'?");
    CHECK(assignment_refusal("qqqqqqqqqqqqqq=3") == "there is no setting 'qqqqqqqqqqqqqq'.");
    CHECK(assignment_refusal("=3") == "there is no setting ''.");
    CHECK(assignment_refusal("rounding") == "'rounding' is not of the form name=value.");
    CHECK(assignment_refusal("") == "'' is not of the form name=value.");
}

TEST_CASE("A value that a setting does not take is refused with what it does take") {
    CHECK(assignment_refusal("rounding=up") ==
          "rounding cannot be 'up': it takes truncate, floor or round.");
    CHECK(assignment_refusal("stage=Depth") ==
          "stage cannot be 'Depth': it takes points, edges, rows, fill, "
          "depth, vertex_light or pixel_light.");
    CHECK(assignment_refusal("camera.focal_length=0") ==
          "camera.focal_length cannot be '0': it takes a number from 1 to 100000.");
    CHECK(assignment_refusal("viewport.size=0x0") ==
          "viewport.size cannot be '0x0': it takes WIDTHxHEIGHT, each from 1 to 4096.");
    CHECK(assignment_refusal("tessellation=65") ==
          "tessellation cannot be '65': it takes a whole number from 1 to 64.");
    CHECK(
        assignment_refusal("view_box=0.1,-0.1,0,0.2") ==
        "view_box cannot be '0.1,-0.1,0,0.2': it takes auto or left,right,bottom,top, each from " +
            number_text(-largest_place) + " to " + number_text(largest_place) +
            ", with right more than left and top more than bottom by at least 1e-06.");
    for (const char* assignment : {"rounding=",
                                   "camera.yaw=",
                                   "camera.yaw=nan",
                                   "camera.yaw=inf",
                                   "camera.yaw=1e99",
                                   "camera.yaw=0x10",
                                   "camera.yaw=1 2",
                                   "camera.yaw=1,2",
                                   "camera.position=1",
                                   "camera.position=1,2",
                                   "camera.position=1,2,3,4",
                                   "camera.position=1,,3",
                                   "camera.position=1,nan,3",
                                   "camera.position=1e6,0,0",
                                   "light.power=-1",
                                   "light.power=1,2",
                                   "light.power=",
                                   "viewport.size=500",
                                   "viewport.size=500x",
                                   "viewport.size=5x5x5",
                                   "viewport.size=-5x5",
                                   "viewport.size=100000x100000",
                                   "viewport.size=99999999999x1",
                                   "viewport.size=5.5x5",
                                   "view_box=",
                                   "view_box=none",
                                   "view_box=1",
                                   "view_box=-1,1,-1",
                                   "view_box=-1,1,-1,1,1",
                                   "view_box=-1,1,-1,",
                                   "view_box=-1,1,,1",
                                   "view_box=1,1,-1,1",
                                   "view_box=1,-1,-1,1",
                                   "view_box=-1,1,1,1",
                                   "view_box=-1,1,1,-1",
                                   "view_box=0,1e-9,-1,1",
                                   "view_box=-1,1,-1,nan",
                                   "view_box=nan,1,-1,1",
                                   "view_box=-inf,1,-1,1",
                                   "view_box=-1,inf,-1,1",
                                   "view_box=-1,1e9,-1,1",
                                   "view_box=-1,1e99,-1,1",
                                   "view_box=-1;1;-1;1",
                                   "tessellation=0",
                                   "tessellation=-1",
                                   "tessellation=2.5",
                                   "tessellation=99999999999",
                                   "tessellation="}) {
        INFO(assignment);
        CHECK_THAT(assignment_refusal(assignment), ContainsSubstring(" cannot be "));
    }
}

TEST_CASE("A refused value leaves all settings as they were") {
    Settings settings;
    const Settings before;
    for (const char* assignment :
         {"camera.position=1,2,x", "viewport.size=7x0", "light.power=3,4", "view_box=1,2,3"}) {
        CHECK_THROWS_AS(set_from_text(settings, assignment), UsageError);
    }
    for (const Setting& setting : setting_table()) {
        CHECK(value_text(setting, settings) == value_text(setting, before));
    }
}

TEST_CASE("A message about a monstrous value is itself short and on one line") {
    const std::string sentence = assignment_refusal("camera.yaw=" + std::string(100000, '\n'));
    CHECK(sentence.size() < 200);
    CHECK(sentence.find('\n') == std::string::npos);
}

TEST_CASE("Numbers and vectors that have left their range are brought back into it") {
    for (const float stray : {1e30f, -1e30f, INFINITY, -INFINITY, NAN}) {
        Settings settings;
        settings.camera.position = glm::vec3(stray, 0.0f, stray);
        settings.camera.yaw = settings.camera.pitch = settings.camera.focal_length = stray;
        settings.light.position.y = stray;
        settings.light.power = settings.light.indirect = glm::vec3(stray);
        settings.view_box = ViewBox{-1.0f, stray, -1.0f, 1.0f};
        clamp_to_ranges(settings);
        INFO("from " << stray);
        for (const Setting& setting : setting_table()) {
            INFO(setting.name << " is " << value_text(setting, settings));
            Settings again = settings;
            CHECK_NOTHROW(set_value(again, setting, value_text(setting, settings)));
        }
        CHECK(settings.camera.pitch == (stray > 0.0f ? largest_pitch : -largest_pitch));
        CHECK(settings.camera.position.y == 0.0f);
        CHECK_FALSE(settings.view_box);
    }
}

TEST_CASE("Settings within their ranges keep every bit") {
    Settings settings;
    settings.camera.pitch = largest_pitch;
    settings.light.power = glm::vec3(0.0f, largest_power, 0.1f);
    const Settings before = settings;
    clamp_to_ranges(settings);
    CHECK(settings == before);
}

TEST_CASE("Each setting is compared and copied separately") {
    for (const Setting& setting : setting_table()) {
        Settings from, to;
        const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
        if (choice != nullptr) {
            const int other = (choice->read(from) + 1) % static_cast<int>(choice->words.size());
            choice->write(from, other);
        } else if (std::holds_alternative<SizeSetting>(setting.kind)) {
            set_value(from, setting, "3x4");
        } else if (std::holds_alternative<BoxSetting>(setting.kind)) {
            set_value(from, setting, "-1,2,-3,0.5");
        } else if (const auto* const whole = std::get_if<WholeSetting>(&setting.kind)) {
            set_value(from, setting, std::to_string(whole->smallest + whole->step));
        } else {
            const auto* const number = std::get_if<NumberSetting>(&setting.kind);
            const bool is_share = number != nullptr && number->largest <= 1.0f;
            set_value(from, setting, number == nullptr ? "1,2,0.5" : is_share ? "0.75" : "1.5");
        }
        INFO(setting.name);
        CHECK(has_same_value(setting, from, from));
        CHECK_FALSE(has_same_value(setting, from, to));
        copy_value(setting, from, to);
        CHECK(has_same_value(setting, from, to));
        CHECK(to == from);
    }
}

TEST_CASE("The two words of light on the strip set stage and shading") {
    Settings settings;
    set_from_text(settings, "stage=vertex_light");
    CHECK(settings.stage == Stage::shade);
    CHECK(settings.shading == Shading::gouraud);
    set_from_text(settings, "shading=phong");
    CHECK(value_of(settings, "stage") == "pixel_light");
    set_from_text(settings, "stage=depth");
    CHECK(value_of(settings, "shading") == "phong");
    CHECK(shading_rule(settings) == Shading::unlit);
    // Shadings without a separate step.
    for (const auto& [word, shading] :
         {std::pair("shading=unlit", Shading::unlit), std::pair("shading=flat", Shading::flat)}) {
        set_from_text(settings, "stage=vertex_light");
        set_from_text(settings, word);
        CHECK(settings.stage == Stage::shade);
        CHECK(shading_rule(settings) == shading);
        CHECK(value_of(settings, "stage") == "pixel_light");
    }
}

TEST_CASE("Former words of shading set depth_order") {
    Settings settings;
    set_from_text(settings, "shading = before_depth_test");
    CHECK(settings.depth_order == DepthOrder::before_depth_test);
    CHECK(settings.shading == Shading::phong);
    set_from_text(settings, "shading=after_depth_test");
    CHECK(settings.depth_order == DepthOrder::after_depth_test);
    CHECK(meant_setting(*find_setting("shading"), "before_depth_test").name == "depth_order");
    CHECK(meant_setting(*find_setting("shading"), "gouraud").name == "shading");
    CHECK(assignment_refusal("shading=toon") ==
          "shading cannot be 'toon': it takes unlit, flat, gouraud or phong.");
}

TEST_CASE("Former words of behind_camera set clip, and the laboratory's mark") {
    Settings settings;
    set_from_text(settings, "behind_camera=drawn");
    CHECK(settings.clip == Clip::none);
    set_from_text(settings, " behind_camera = left_out ");
    CHECK(settings == Settings{});
    set_from_text(settings, "behind_camera=mark_minus_one");
    CHECK(settings.behind_mark == BehindMark::minus_one);
    CHECK(settings.clip == Clip::leave_out);
    CHECK_THROWS_AS(set_from_text(settings, "behind_camera=near"), UsageError);
}

TEST_CASE("rounding is the rounding of vertices and lines, as long as both have the same word") {
    Settings settings;
    set_from_text(settings, "rounding=floor");
    CHECK(settings.vertex_rounding == VertexRounding::floor);
    CHECK(settings.line_rounding == Rounding::floor);
    set_from_text(settings, "vertex_rounding=truncate_sum");
    CHECK(settings.line_rounding == Rounding::floor);
    CHECK(value_of(settings, "rounding").empty());
    set_from_text(settings, "line_rounding=round");
    set_from_text(settings, "vertex_rounding=round");
    CHECK(value_of(settings, "rounding") == "round");
}

namespace {

/// The names of the settings that are different in b.
std::string differing(const Settings& a, const Settings& b) {
    std::string names;
    for (const Setting& setting : setting_table()) {
        if (must_be_listed(setting, a, b)) names.append(setting.name).append(" ");
    }
    return names;
}

Settings with(std::initializer_list<const char*> assignments) {
    Settings settings;
    for (const char* assignment : assignments)
        set_from_text(settings, assignment);
    return settings;
}

} // namespace

TEST_CASE(
    "A difference is listed once, under a combined name if there is one, otherwise in parts") {
    const Settings usual;
    CHECK(differing(usual, with({"rounding=floor"})) == "rounding ");
    CHECK(differing(usual, with({"vertex_rounding=truncate_sum"})) == "vertex_rounding ");
    CHECK(differing(with({"vertex_rounding=floor"}), with({"rounding=round"})) ==
          "vertex_rounding line_rounding ");
    CHECK(differing(usual, with({"stage=vertex_light"})) == "stage ");
    CHECK(differing(usual, with({"stage=fill"})) == "stage ");
    CHECK(differing(usual, with({"shading=unlit"})) == "shading ");
    CHECK(differing(usual, with({"stage=fill", "shading=gouraud"})) == "stage shading ");
    CHECK(differing(with({"stage=fill", "shading=gouraud"}), with({"stage=vertex_light"})) ==
          "stage ");
}

TEST_CASE("Setting the differences in the order of the table makes one the other") {
    const Settings all[] = {with({}),
                            with({"rounding=floor"}),
                            with({"vertex_rounding=truncate_sum"}),
                            with({"line_rounding=round"}),
                            with({"stage=vertex_light"}),
                            with({"stage=fill"}),
                            with({"stage=fill", "shading=gouraud"}),
                            with({"shading=unlit"}),
                            with({"depth_order=before_depth_test", "rounding=round"})};
    for (const Settings& from : all) {
        for (const Settings& to : all) {
            Settings made = from;
            for (const Setting& setting : setting_table()) {
                if (must_be_listed(setting, from, to)) {
                    set_value(made, setting, value_text(setting, to));
                }
            }
            CHECK(made == to);
        }
    }
}

TEST_CASE("A pixel has one sample or four, and nothing between") {
    Settings settings;
    set_from_text(settings, "samples=4");
    CHECK(settings.samples == 4);
    for (const char* const wrong : {"samples=2", "samples=3", "samples=0", "samples=5"})
        CHECK_THROWS_WITH(set_from_text(settings, wrong),
                          Catch::Matchers::ContainsSubstring("1 or 4"));
    CHECK(settings.samples == 4);
    settings.samples = 3;
    clamp_to_ranges(settings);
    CHECK(settings.samples == 1);
}
