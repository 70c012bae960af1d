#include "settings/setting_faults.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("Faulty planes are reported wherever they act, a faulty aim only in the world") {
    Settings settings;
    settings.near = 3.0f;
    settings.far = 1.0f;
    settings.camera.aim = CameraAim::look_at;
    settings.camera.target = settings.camera.position;
    const auto in_short = [&](SceneSpace space) {
        Scene scene;
        scene.space = space;
        std::vector<std::string> texts;
        for (const SettingFault& fault : setting_faults(settings, scene))
            texts.push_back(fault.in_short);
        return texts;
    };
    const std::string planes = "far plane not behind the near one",
                      aim = "the camera has no direction";
    for (const std::string_view word : enum_words<DepthFormat>) {
        settings.depth_format = *value_of_word<DepthFormat>(word);
        CAPTURE(word);
        // 1/z needs no planes; a depth between 0 and 1 is measured from one to the other.
        const bool is_measured = word.find("inv_z") == std::string_view::npos;
        CHECK(in_short(SceneSpace::world) == std::vector<std::string>{planes, aim});
        CHECK(in_short(SceneSpace::pixels) ==
              (is_measured ? std::vector<std::string>{planes} : std::vector<std::string>{}));
    }
    settings.near = 0.5f;
    CHECK(in_short(SceneSpace::world) == std::vector<std::string>{aim});
    CHECK(in_short(SceneSpace::pixels).empty());
}

TEST_CASE("A tessellation that makes too many triangles is reported with the one drawn instead") {
    Scene scene;
    for (int t = 0; t < 200; ++t)
        scene.mesh.add_triangle_of({});
    Settings settings;
    const auto faults = [&] { return setting_faults(settings, scene); };
    // 200 * 31 * 31 = 192 200, and 200 * 32 * 32 = 204 800.
    settings.tessellation = 31;
    CHECK(faults().empty());
    settings.tessellation = 32;
    REQUIRE(faults().size() == 1);
    CHECK(faults()[0].sentence == "tessellation = 32 makes more than 200000 triangles of this "
                                  "scene, so it is cut into 31 parts per edge");
    CHECK(faults()[0].in_short == "tessellation 31");
    scene.space = SceneSpace::pixels;
    CHECK(faults().empty());
}

TEST_CASE("A box that has no effect on the lab's projection is reported") {
    Scene scene;
    Settings settings;
    const auto faults = [&] { return setting_faults(settings, scene); };
    settings.view_box = ViewBox{-0.1f, 0.1f, 0.0f, 0.2f};
    REQUIRE(faults().size() == 1);
    CHECK(faults()[0].in_short == "view_box needs matrices");
    settings.transform = Transform::matrices;
    CHECK(faults().empty());
    settings.transform = Transform::lab;
    scene.space = SceneSpace::pixels;
    CHECK(faults().empty());
}
