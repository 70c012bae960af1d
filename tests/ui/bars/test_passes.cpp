#include <string>

#include "session/tabs.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/actions/actions.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

std::string where(const Driver& driver) {
    return to_text(driver.ui.session.cursor);
}

/// The room with a shadow map, and the pixel of lesson 31 picked.
void take_map(Driver& driver) {
    for (const char* assignment : {"stage=pixel_light", "shadows=map", "light.power=8"})
        set_from_text(driver.ui.session.a.settings, assignment);
    driver.ui.session.selection.pixel = glm::ivec2(410, 449);
    driver.ui.session.tab = "fragment";
    driver.hand.rest();
}

} // namespace

TEST_CASE("Only a picture with a shadow map has passes on its time line") {
    Driver driver("lab-room.toml");
    CHECK(driver.ui.widgets.count("walk.pass.1") == 0);
    CHECK(where(driver) == "end");
}

TEST_CASE("Blocks in front of the time line lead to the passes, and back to the picture") {
    Driver driver("lab-room.toml");
    take_map(driver);
    driver.hand.click("stage.shadow");
    CHECK(where(driver) == "p1:t0/v0");
    driver.hand.click("walk.pass.3");
    CHECK(where(driver) == "p3:end");
    CHECK(driver.ui.results.a.frame.pass == -4);
    CHECK(driver.ui.widgets.at("canvas.pass").text == "p3: what the lamp sees along +y");
    driver.hand.click("walk.step");
    CHECK(where(driver) == "p4:t0/v0");
    driver.hand.click("walk.back");
    CHECK(where(driver) == "p3:end");
    driver.hand.click("walk.pass.picture");
    CHECK(where(driver) == "end");
    CHECK(driver.ui.widgets.count("walk.pass.picture") == 0);
    CHECK(driver.ui.widgets.count("canvas.pass") == 0);
    driver.hand.press(key::home);
    CHECK(where(driver) == "t0/v0");
    driver.hand.press(key::comma);
    CHECK(where(driver) == "p6:end");
    driver.hand.press(key::home);
    driver.hand.press(key::home);
    CHECK(where(driver) == "p1:t0/v0");
}

TEST_CASE("The Fragment tab leads to the texel that decided, and Back returns") {
    Driver driver("lab-room.toml");
    take_map(driver);
    const ShadowTerms shadow = driver.ui.results.a.inspected.fragment->light.shadow;
    const ShadowTexel texel = shadow.texels[0];
    driver.hand.click("fragment.shadow.texel.0");
    CHECK(driver.ui.results.a.frame.pass == shadow.face - shadow_face_count);
    CHECK(driver.ui.session.selection.pixel == glm::ivec2(texel.column, texel.row));
    // What has just been drawn is that texel.
    REQUIRE(driver.ui.results.a.inspected.fragment);
    CHECK(driver.ui.results.a.inspected.fragment->pixel == glm::ivec2(texel.column, texel.row));
    const Framebuffer& face = *driver.ui.results.a.framebuffer;
    CHECK(face.depth[face.at(texel.column, texel.row)] == texel.inv_depth);
    find_action("go.back").run(driver.ui);
    driver.hand.rest();
    CHECK(where(driver) == "end");
    CHECK(driver.ui.session.selection.pixel == glm::ivec2(410, 449));
}

} // namespace rasterwalk
