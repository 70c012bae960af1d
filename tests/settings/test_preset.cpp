#include "settings/preset.h"

#include "base/error.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

std::vector<Preset> project_presets() {
    return read_presets(lessons_folder() + "/presets.toml");
}

std::string refusal(const std::string& text) {
    try {
        parse_presets(text, "p.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST_CASE("The presets are handout, exact and visible light") {
    const std::vector<Preset> presets = project_presets();
    REQUIRE(presets.size() == 3);
    CHECK(presets[0].name == "handout");
    CHECK(presets[1].name == "exact");
    CHECK(presets[2].name == "visible light");
    for (const Preset& preset : presets) {
        INFO(preset.name);
        CHECK(preset.about.ends_with('.'));
    }
}

TEST_CASE("The handout preset is the default and undoes every other preset") {
    const std::vector<Preset> presets = project_presets();
    Settings settings;
    for (const Preset& preset : presets)
        apply_preset(preset, settings);
    for (const char* assignment :
         {"depth_test=off", "interpolation=affine", "edge_samples=rows", "light.indirect=0"}) {
        set_from_text(settings, assignment);
    }
    apply_preset(find_preset(presets, "handout"), settings);
    for (const Setting& setting : setting_table()) {
        CHECK(value_text(setting, settings) == value_text(setting, Settings{}));
    }
}

TEST_CASE("A preset changes what it names and leaves everything else") {
    const std::vector<Preset> presets = project_presets();
    Settings settings;
    settings.interpolation = Interpolation::affine;
    apply_preset(find_preset(presets, "exact"), settings);
    CHECK(common_rounding(settings) == Rounding::floor);
    CHECK(settings.line_walk == LineWalk::exact);
    CHECK(settings.interpolation == Interpolation::affine);
    apply_preset(find_preset(presets, "visible light"), settings);
    CHECK(settings.light.power == glm::vec3(14.0f));
    CHECK(common_rounding(settings) == Rounding::floor);
}

TEST_CASE("An unknown preset is refused with a list of the presets") {
    const std::vector<Preset> presets = project_presets();
    CHECK_THROWS_WITH(find_preset(presets, "visible ligth"),
                      "there is no preset 'visible ligth'; the presets are: handout, exact, "
                      "visible light. Did you mean 'visible light'?");
}

TEST_CASE("A broken file of presets is refused with file and line") {
    const std::string head = "[[preset]]\nname = \"a\"\nabout = \"b\"\n";
    CHECK(refusal(head + "set = [\"rounding=floor\"]\n") == "accepted");
    CHECK(refusal(head + "set = [\n\"rounding=floor\",\n\"rounding=flor\"]\n") ==
          "p.toml:6: rounding cannot be 'flor': it takes truncate, floor or round.");
    CHECK(refusal(head + "set = [\"roundin=floor\"]\n") ==
          "p.toml:4: there is no setting 'roundin'. Did you mean 'rounding'?");
    CHECK(refusal(head + "set = [3]\n") ==
          "p.toml:4: each entry of 'set' must be text, like \"name=value\".");
    CHECK(refusal(head) == "p.toml:1: preset 1 needs 'set'.");
    CHECK(refusal(head + "set = []\n" + head + "set = []\n") ==
          "p.toml:5: there are two presets named 'a'.");
    CHECK(refusal("x = 1\n") == "p.toml:1: the file of presets has no 'x'; it has: preset.");
    CHECK(refusal("[[preset]\n").substr(0, 9) == "p.toml:1:");
}

TEST_CASE("A preset can use former names and words of settings") {
    const std::vector<Preset> presets = parse_presets(
        "[[preset]]\nname = \"a\"\nabout = \"b\"\n"
        "set = [\"stage=vertex_light\", \"rounding=round\", \"shading=before_depth_test\"]\n",
        "p.toml");
    Settings settings;
    apply_preset(presets[0], settings);
    CHECK(step_of(settings) == StripStep::vertex_light);
    CHECK(common_rounding(settings) == Rounding::round);
    CHECK(settings.depth_order == DepthOrder::before_depth_test);
}
