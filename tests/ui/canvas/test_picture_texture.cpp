// The part of the picture that is sent to the graphics system.

#include <algorithm>
#include <cmath>

#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// A channel of a pixel of the opaque picture in another size: the mean of the old ones that it
/// covers, each weighted by the area covered.
double resampled_channel(const Image& image, double scale, int column, int row, int channel) {
    const auto covered = [&](int old, int now) {
        return std::max(std::min((now + 1) / scale, old + 1.0) - std::max(now / scale, old + 0.0),
                        0.0);
    };
    double sum = 0.0, area = 0.0;
    for (int y = static_cast<int>(row / scale); y < image.height && covered(y, row) > 0.0; ++y) {
        for (int x = static_cast<int>(column / scale); x < image.width && covered(x, column) > 0.0;
             ++x) {
            const double part = covered(x, column) * covered(y, row);
            const std::size_t at =
                4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(x));
            sum += part * image.rgba[at + static_cast<std::size_t>(channel)];
            area += part;
        }
    }
    return area > 0.0 ? sum / area : 0.0;
}

/// Is what was uploaded last the texture's part of the picture, resampled?
bool is_up_to_date(const Driver& driver) {
    const PictureTexture& texture = driver.ui.canvas.picture;
    const Image& picture = driver.ui.results.a.picture;
    const Image& shown = driver.textures.last;
    const Rectangle& window = texture.window;
    if (shown.width != window.right - window.left || shown.height != window.bottom - window.top)
        return false;
    const double scale = static_cast<double>(texture.scale);
    std::size_t at = 0;
    for (int row = window.top; row < window.bottom; ++row) {
        for (int column = window.left; column < window.right; ++column, at += 4) {
            for (int channel = 0; channel < 3; ++channel) {
                const double expected = resampled_channel(picture, scale, column, row, channel);
                // To the next whole number, either way at a half.
                if (std::abs(shown.rgba[at + static_cast<std::size_t>(channel)] - expected) > 0.51)
                    return false;
            }
        }
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
        driver.hand.rest();
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

TEST_CASE("If the picture is larger than the canvas, the texture holds what is in view") {
    for (const float zoom : {1.0f, 1.3f, 6.0f}) {
        Driver driver;
        set_from_text(driver.ui.session.a.settings, "viewport.size=2400x2400");
        driver.hand.rest();
        const WidgetPlace canvas = driver.ui.widgets.at("canvas");
        const float room = (canvas.bottom_right.x - canvas.top_left.x) *
                           (canvas.bottom_right.y - canvas.top_left.y);
        for (const glm::vec2 centre : {glm::vec2(1200, 1200), glm::vec2(1300, 1200),
                                       glm::vec2(300, 2300), glm::vec2(2380, 0)}) {
            driver.ui.session.canvas.zoom = zoom;
            driver.ui.session.canvas.centre = centre;
            driver.hand.rest();
            CAPTURE(zoom, centre.x, centre.y);
            const PictureTexture& texture = driver.ui.canvas.picture;
            CHECK(static_cast<float>(driver.textures.last.width) *
                      static_cast<float>(driver.textures.last.height) <=
                  1.7f * room);
            CHECK(is_up_to_date(driver));
            // It contains all that is in view.
            const PicturePlace& place = driver.ui.canvas.place;
            const auto visible = [&](float screen, float origin) {
                return std::clamp((screen - origin) / place.scale, 0.0f, 2400.0f);
            };
            CHECK(texture.corner.x <= visible(canvas.top_left.x, place.origin.x));
            CHECK(texture.corner.y <= visible(canvas.top_left.y, place.origin.y));
            CHECK(texture.corner.x + texture.size.x >=
                  visible(canvas.bottom_right.x, place.origin.x) - 0.01f);
            CHECK(texture.corner.y + texture.size.y >=
                  visible(canvas.bottom_right.y, place.origin.y) - 0.01f);
        }
    }
}

} // namespace rasterwalk
