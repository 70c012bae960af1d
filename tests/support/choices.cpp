#include "support/choices.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/numbers.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"

namespace rasterwalk::test {

namespace {

Settings small_settings(const Scene& scene, const std::string& base) {
    Settings settings = default_settings(scene);
    if (scene.space == SceneSpace::world) {
        constexpr int side = 60;
        settings.camera.focal_length *=
            static_cast<float>(side) / static_cast<float>(scene.viewport.width);
        settings.viewport = {side, side};
    }
    set_from_text(settings, "shadow_resolution=32");
    settings.stage = Stage::shade;
    set_from_text(settings, base);
    return settings;
}

/// The values of one setting that are worth a try.
struct Values {
    std::vector<std::string> operator()(const ChoiceSetting& kind) const {
        return {kind.words.begin(), kind.words.end()};
    }
    std::vector<std::string> operator()(const NumberSetting& kind) const {
        return {number_text(kind.smallest), number_text(kind.largest)};
    }
    std::vector<std::string> operator()(const WholeSetting& kind) const {
        constexpr int most = 32; // with many triangles or large maps a picture takes long
        return {fmt::format("{}", kind.smallest),
                fmt::format("{}", std::clamp(most, kind.smallest, kind.largest))};
    }
    std::vector<std::string> operator()(const VectorSetting& kind) const {
        const std::string low = number_text(kind.smallest), high = number_text(kind.largest);
        return {fmt::format("{0},{0},{0}", low), fmt::format("{0},{0},{0}", high)};
    }
    std::vector<std::string> operator()(const SizeSetting&) const { return {}; }
    std::vector<std::string> operator()(const BoxSetting& kind) const {
        // Off-centre, and thin.
        return {"auto", "-0.06,0.09,-0.04,0.05",
                fmt::format("0,{},-0.05,0.05", number_text(kind.least_side))};
    }
};

/// `name=value`, for each setting that changes how the scene is drawn.
std::vector<std::vector<std::string>> assignments_for(const Scene& scene) {
    std::vector<std::vector<std::string>> all;
    for (const Setting& setting : setting_table()) {
        // What is drawn is the base's; a camera elsewhere would see nothing.
        const bool is_kept =
            setting.name == "stage" || setting.name == "shading" ||
            setting.name == "tessellation" ||
            (setting.group == "Camera" && !std::holds_alternative<ChoiceSetting>(setting.kind));
        if (is_kept || !is_of_use(setting, scene)) continue;
        std::vector<std::string>& of_setting = all.emplace_back();
        for (const std::string& value : std::visit(Values{}, setting.kind))
            of_setting.push_back(fmt::format("{}={}", setting.name, value));
    }
    std::erase_if(all, [](const auto& of_setting) { return of_setting.empty(); });
    return all;
}

} // namespace

Scene lesson_scene(const std::string& name) {
    return read_scene(fmt::format("{}/scenes/{}.toml", lessons_folder(), name));
}

std::vector<Choice> single_choices(const Scene& scene, const std::string& base) {
    std::vector<Choice> choices;
    for (const std::vector<std::string>& of_setting : assignments_for(scene)) {
        for (const std::string& assignment : of_setting) {
            Choice& choice = choices.emplace_back();
            choice.name = fmt::format("{}, {}, {}", scene.name, base, assignment);
            choice.settings = small_settings(scene, base);
            set_from_text(choice.settings, assignment);
        }
    }
    return choices;
}

std::vector<Choice> mixed_choices(const Scene& scene, const std::string& base, int count,
                                  Random& random) {
    const std::vector<std::vector<std::string>> all = assignments_for(scene);
    std::vector<Choice> choices;
    for (int i = 0; i < count; ++i) {
        Choice& choice = choices.emplace_back();
        choice.name = fmt::format("{}, {}", scene.name, base);
        choice.settings = small_settings(scene, base);
        for (const std::vector<std::string>& of_setting : all) {
            if (random.integer(0, 9) != 0) continue;
            const int value = random.integer(0, static_cast<int>(of_setting.size()) - 1);
            const std::string& assignment = of_setting[static_cast<std::size_t>(value)];
            choice.name += ", " + assignment;
            set_from_text(choice.settings, assignment);
        }
    }
    return choices;
}

} // namespace rasterwalk::test
