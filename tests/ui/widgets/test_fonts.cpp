// The atlases of fonts: kept for a text size that comes back.

#include <memory>

#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

void set_text_scale(Driver& driver, float scale) {
    driver.ui.options.wished_text_scale = scale;
    driver.hand.leave();
    REQUIRE(driver.ui.options.text_scale == scale);
    CHECK(ImGui::GetIO().Fonts == driver.ui.fonts.atlas.get());
}

} // namespace

TEST_CASE("Windows with the same text size show the letters of one atlas") {
    std::shared_ptr<ImFontAtlas> atlas;
    {
        const Driver first;
        atlas = first.ui.fonts.atlas;
    }
    const Driver second;
    CHECK(second.ui.fonts.atlas == atlas);
    CHECK(ImGui::GetIO().Fonts == atlas.get());
}

TEST_CASE("The last four atlases are kept for a text size that comes back") {
    Driver driver;
    const std::weak_ptr<ImFontAtlas> first = driver.ui.fonts.atlas;
    for (const float scale : {0.75f, 0.875f, 1.125f, 1.0f}) {
        INFO(scale);
        set_text_scale(driver, scale);
        CHECK_FALSE(first.expired());
        CHECK((driver.ui.fonts.atlas == first.lock()) == (scale == 1.0f));
    }
    for (const float scale : {0.75f, 0.875f, 1.125f, 1.25f}) {
        INFO(scale);
        set_text_scale(driver, scale);
        CHECK(first.expired() == (scale == 1.25f));
    }
}

TEST_CASE("The texture of the fonts keeps its name when the text size changes") {
    int texture = 0;
    const auto name = static_cast<ImTextureID>(&texture);
    {
        Driver driver;
        ImGui::GetIO().Fonts->SetTexID(name);
        for (const float scale : {1.25f, 1.0f}) {
            driver.ui.host.fonts_changed = false;
            set_text_scale(driver, scale);
            CHECK(driver.ui.host.fonts_changed);
            CHECK(ImGui::GetDrawData()->CmdLists[0]->CmdBuffer[0].GetTexID() == name);
        }
    }
    const Driver another;
    CHECK(ImGui::GetIO().Fonts->TexID == nullptr);
}

} // namespace rasterwalk
