#include <imgui_internal.h>

#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

TEST_CASE("No tooltip lies over what it explains") {
    for (const float text_scale : {1.0f, 1.5f}) {
        Driver driver("lab-room.toml", {1280, 800}, text_scale);
        driver.ui.session.selection.pixel = glm::ivec2(250, 400);
        int seen = 0;
        for (const std::string& name : driver.hand.names()) {
            const bool is_there = driver.hand.is_visible(name);
            if (!is_there || !driver.ui.widgets.at(name).has_tooltip) continue;
            driver.hand.hover(name);
            const WidgetPlace place = driver.ui.widgets.at(name); // it may have been scrolled
            // A plot or a table's page leaves no room next to it.
            if (place.bottom_right.y - place.top_left.y > 60.0f) continue;
            const ImGuiWindow* const tooltip = ImGui::FindWindowByName("##Tooltip_00");
            if (tooltip == nullptr || !tooltip->Active) continue;
            ++seen;
            INFO(name << ", text " << text_scale);
            const ImRect box = tooltip->Rect();
            const ImRect item(place.top_left, place.bottom_right);
            CHECK_FALSE(box.Overlaps(item));
            CHECK(box.Min.x >= 0.0f);
            CHECK(box.Min.y >= 0.0f);
            CHECK(box.Max.x <= 1280.5f);
            CHECK(box.Max.y <= 800.5f);
        }
        CHECK(seen > 40);
    }
}

} // namespace rasterwalk
