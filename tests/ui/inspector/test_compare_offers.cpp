// The offers of the Compare tab: a picture on each card, and its words below it.

#include <algorithm>
#include <string>
#include <vector>

#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

struct Shown {
    std::string window; ///< as ImGui names it
    ImVec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
    float end = 0.0f; ///< below this height nothing of it is seen
};

/// Where the pictures of the offers were drawn in the last frame, read back from their triangles.
std::vector<Shown> shown_offers(const Ui& ui) {
    std::vector<Shown> shown;
    const ImDrawData* const data = ImGui::GetDrawData();
    for (int i = 0; i < data->CmdListsCount; ++i) {
        const ImDrawList& list = *data->CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const auto& offers = ui.compare.offers.textures;
            const bool is_offer =
                std::any_of(offers.begin(), offers.end(), [&](const PictureTexture& texture) {
                    return texture.id == command.GetTexID();
                });
            if (!is_offer || command.ElemCount == 0) continue;
            Shown& picture = shown.emplace_back();
            picture.window = list._OwnerName;
            picture.end = command.ClipRect.w;
            for (unsigned k = 0; k < command.ElemCount; ++k) {
                const auto index = list.IdxBuffer[static_cast<int>(command.IdxOffset + k)];
                const ImVec2 at = list.VtxBuffer[static_cast<int>(command.VtxOffset) + index].pos;
                picture.low = {std::min(picture.low.x, at.x), std::min(picture.low.y, at.y)};
                picture.high = {std::max(picture.high.x, at.x), std::max(picture.high.y, at.y)};
            }
        }
    }
    return shown;
}

} // namespace

TEST_CASE("No words of an offer lie over its picture, however small the window") {
    std::vector<SmallWindow> windows(small_windows.begin(), small_windows.end());
    windows.push_back({{640, 480}, 1.0f});
    windows.push_back({{1366, 768}, 1.0f});
    for (const SmallWindow& window : windows) {
        for (const char* scene : {"lab-room.toml", "one-triangle.toml", "wide-wall.toml"}) {
            INFO(scene << " at " << window.size.x << " x " << window.size.y << ", text "
                       << window.text_scale);
            Driver driver(scene, window.size, window.text_scale);
            driver.ui.session.tab = "compare";
            driver.hand.frames(frames_to_rest + 2);
            REQUIRE(driver.ui.compare.offers.is_drawn);
            const std::vector<Shown> pictures = shown_offers(driver.ui);
            CHECK(pictures.size() >= 2);
            const std::vector<ScreenText> texts = screen_text();
            int words = 0;
            for (const ScreenText& text : texts) {
                for (const Shown& picture : pictures) {
                    if (text.window != picture.window) continue;
                    ++words;
                    INFO(text.words);
                    const bool is_over = text.low.x < picture.high.x &&
                                         picture.low.x < text.high.x &&
                                         text.low.y < picture.high.y && picture.low.y < text.high.y;
                    CHECK_FALSE(is_over);
                }
            }
            CHECK(words > 8);
        }
    }
}

TEST_CASE("The lower edge cuts no picture of an offer") {
    std::vector<SmallWindow> windows(small_windows.begin(), small_windows.end());
    windows.push_back({{1600, 1000}, 1.5f});
    windows.push_back({{1366, 768}, 1.25f});
    for (const SmallWindow& window : windows) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        driver.ui.session.tab = "compare";
        driver.hand.frames(frames_to_rest + 2);
        int whole = 0;
        for (const Shown& picture : shown_offers(driver.ui)) {
            INFO("from " << picture.low.y << " to " << picture.high.y << ", seen to "
                         << picture.end);
            CHECK((picture.end >= picture.high.y || picture.end <= picture.low.y));
            whole += picture.end >= picture.high.y ? 1 : 0;
        }
        CHECK(whole >= 2);
    }
}

} // namespace rasterwalk
