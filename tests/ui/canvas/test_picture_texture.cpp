// What of the picture the graphics system is given.

#include <catch2/catch.hpp>

#include "picture/resample.h"
#include "settings/setting_table.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// Is what was uploaded last the texture's part of the picture, resampled?
bool is_up_to_date(const Driver& driver) {
    const PictureTexture& texture = driver.ui.canvas.picture;
    const Image whole = resampled(driver.ui.results.a.picture, texture.scale);
    const Image& shown = driver.textures.last;
    const Rectangle& window = texture.window;
    if (shown.width != window.right - window.left || shown.height != window.bottom - window.top)
        return false;
    for (int row = 0; row < shown.height; ++row) {
        const auto from =
            whole.rgba.begin() +
            4 * ((static_cast<std::ptrdiff_t>(window.top) + row) * whole.width + window.left);
        const auto line = shown.rgba.begin() + 4 * static_cast<std::ptrdiff_t>(row) * shown.width;
        if (!std::equal(line, line + 4 * static_cast<std::ptrdiff_t>(shown.width), from))
            return false;
    }
    return true;
}

} // namespace

TEST_CASE("After every moment the picture shown is that of the frame, resampled") {
    for (const float zoom : {0.0f, 0.7f, 1.4f, 4.0f}) {
        Driver driver;
        driver.hand.click("stage.depth");
        driver.ui.session.canvas.zoom = zoom;
        driver.ui.session.canvas.centre = {250.0f, 300.0f};
        driver.ui.session.cursor = *parse_cursor("t24/r90");
        driver.hand.frames(frames_to_rest);
        for (int i = 0; i < 12; ++i) {
            const int uploads = driver.textures.uploads;
            driver.hand.press('.');
            driver.hand.frames(3);
            CAPTURE(zoom, i);
            CHECK(driver.textures.uploads > uploads);
            CHECK(is_up_to_date(driver));
        }
    }
}

TEST_CASE("Of a picture larger than the canvas the texture holds what is in view") {
    for (const float zoom : {1.0f, 1.3f, 6.0f}) {
        Driver driver;
        set_from_text(driver.ui.session.a.settings, "viewport.size=2400x2400");
        driver.hand.frames(frames_to_rest);
        const WidgetPlace canvas = driver.ui.widgets.at("canvas");
        const float room = (canvas.bottom_right.x - canvas.top_left.x) *
                           (canvas.bottom_right.y - canvas.top_left.y);
        for (const glm::vec2 centre : {glm::vec2(1200, 1200), glm::vec2(1300, 1200),
                                       glm::vec2(300, 2300), glm::vec2(2380, 0)}) {
            driver.ui.session.canvas.zoom = zoom;
            driver.ui.session.canvas.centre = centre;
            driver.hand.frames(frames_to_rest);
            CAPTURE(zoom, centre.x, centre.y);
            const PictureTexture& texture = driver.ui.canvas.picture;
            CHECK(static_cast<float>(driver.textures.last.width) *
                      static_cast<float>(driver.textures.last.height) <=
                  1.7f * room);
            CHECK(is_up_to_date(driver));
            // All that is in view lies in it.
            const PicturePlace& place = driver.ui.canvas.place;
            const auto seen = [&](float screen, float origin) {
                return std::clamp((screen - origin) / place.scale, 0.0f, 2400.0f);
            };
            CHECK(texture.corner.x <= seen(canvas.top_left.x, place.origin.x));
            CHECK(texture.corner.y <= seen(canvas.top_left.y, place.origin.y));
            CHECK(texture.corner.x + texture.size.x >=
                  seen(canvas.bottom_right.x, place.origin.x) - 0.01f);
            CHECK(texture.corner.y + texture.size.y >=
                  seen(canvas.bottom_right.y, place.origin.y) - 0.01f);
        }
    }
}

} // namespace rasterwalk
