// The small pictures below the large one while two runs are compared, and the room that is left.

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "session/second_run.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/project_root.h"
#include "tests/support/catch.h"
#include "tests/ui/shown_colours.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/compare.h"
#include "ui/actions/open_lesson.h"
#include "ui/canvas/compare_variants.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/small_pictures.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

constexpr const char* small_names[] = {"compare.small.run_a", "compare.small.run_b",
                                       "compare.small.difference"};

Session lit_room_of(Viewport size) {
    Session session = open_session(project_root() + "/lessons/scenes/lab-room.toml");
    set_step(session.a.settings, StripStep::pixel_light);
    session.a.settings.light.power = glm::vec3(14.0f);
    session.a.settings.viewport = size;
    return session;
}

/// Keeps every picture that it is given.
struct AllTextures : TextureHost {
    std::map<ImTextureID, Image> images;
    std::intptr_t next = 1000;
    int uploads = 0;

    ImTextureID upload(ImTextureID old, const Image& image) override {
        ++uploads;
        if (old == ImTextureID{}) old = ImTextureID(++next);
        images[old] = image;
        return old;
    }
};

/// The mean of the part of a picture that a small pixel covers, by channel, added up the slow way.
double mean_of(const Image& image, double scale, int column, int row, int channel) {
    const auto covered = [](double from, double to, int cell) {
        return std::max(0.0, std::min(to, cell + 1.0) - std::max(from, cell + 0.0));
    };
    const double left = column / scale, right = (column + 1) / scale;
    const double top = row / scale, bottom = (row + 1) / scale;
    double sum = 0.0, area = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double part = covered(left, right, x) * covered(top, bottom, y);
            if (part <= 0.0) continue;
            const std::size_t at = 4 * (static_cast<std::size_t>(y) * image.width + x);
            sum += part * image.rgba[at + static_cast<std::size_t>(channel)];
            area += part;
        }
    }
    return sum / area;
}

void check_small(const Image& small, const Image& large, double scale) {
    for (const auto& [u, v] :
         {std::pair{0.1, 0.1}, {0.5, 0.5}, {0.3, 0.62}, {0.8, 0.2}, {0.66, 0.7}, {0.95, 0.95}}) {
        const int column = static_cast<int>(u * small.width),
                  row = static_cast<int>(v * small.height);
        for (int channel = 0; channel < 3; ++channel) {
            INFO("at " << column << ", " << row << " channel " << channel);
            const std::size_t at = 4 * (static_cast<std::size_t>(row) * small.width + column) +
                                   static_cast<std::size_t>(channel);
            CHECK(std::abs(small.rgba[at] - mean_of(large, scale, column, row, channel)) <= 1.0);
        }
    }
}

ImVec2 extent_of(const WidgetPlace& place) {
    return {place.bottom_right.x - place.top_left.x, place.bottom_right.y - place.top_left.y};
}

} // namespace

TEST_CASE("A click on a small picture shows it large, and only that one is outlined") {
    Driver driver(lit_room_of({500, 500}));
    driver.hand.click("switch.compare");
    const CompareView views[] = {CompareView::run_a, CompareView::run_b, CompareView::difference};
    CHECK(driver.ui.session.compare_view == CompareView::run_a);
    for (const std::size_t i : {1, 2, 0}) {
        INFO(small_names[i]);
        driver.hand.click(small_names[i]);
        driver.hand.leave();
        CHECK(driver.ui.session.compare_view == views[i]);
        const ImU32 outline = packed(palette(driver.ui.options.theme).link);
        for (std::size_t k = 0; k < 3; ++k) {
            const WidgetPlace card = driver.hand.find(small_names[k]);
            CHECK((shown_colours(card).count(outline) > 0) == (k == i));
        }
        CHECK_FALSE(driver.ui.compare.place_of_b);
    }
    driver.hand.click("switch.compare");
    driver.hand.leave();
    for (const char* name : small_names)
        CHECK(driver.ui.widgets.count(name) == 0);
}

TEST_CASE("The small pictures say what is different in them, and by how much") {
    Driver driver(lit_room_of({500, 500}));
    driver.hand.click("switch.compare");
    CHECK(shown_text(driver, "compare.small.run_a") == "between the vertices: perspective");
    CHECK(shown_text(driver, "compare.small.run_b") == "between the vertices: affine");
    CHECK(shown_text(driver, "compare.small.difference") ==
          grouped(driver.ui.results.comparison.pixels.shown) + " pixels");
    driver.open("compare");
    driver.hand.click("compare.tab.light");
    CHECK(shown_text(driver, "compare.small.run_a") == "drawn up to: pixel light");
    CHECK(shown_text(driver, "compare.small.run_b") == "drawn up to: vertex light");
}

TEST_CASE("The small pictures are those of the runs and of their difference, made smaller") {
    Driver driver(lit_room_of({250, 200}));
    AllTextures textures;
    driver.ui.host.textures = &textures;
    driver.open("compare");
    driver.hand.click("switch.compare");
    driver.hand.click("compare.run_b"); // none of them depends on which is large
    const auto check_all = [&] {
        driver.hand.frames(2);
        const Results& results = driver.ui.results;
        const Image* const large[] = {&results.a.picture, &results.b->picture,
                                      &results.comparison.difference};
        for (std::size_t i = 0; i < 3; ++i) {
            INFO(small_names[i]);
            const PictureTexture& shown = driver.ui.compare.small[i];
            REQUIRE(textures.images.count(shown.id) == 1);
            check_small(textures.images.at(shown.id), *large[i], static_cast<double>(shown.scale));
        }
    };
    check_all();
    const Image before = textures.images.at(driver.ui.compare.small[1].id);
    driver.ui.session.cursor = Cursor{12, Phase::rows, 20, 3};
    check_all();
    CHECK(textures.images.at(driver.ui.compare.small[1].id) != before);
    driver.hand.click("compare.tab.depth");
    check_all();
    driver.ui.host.textures = &driver.textures;
}

TEST_CASE("At rest no small picture is made again, whichever is shown large") {
    Driver driver(lit_room_of({1100, 1000})); // too large to look at every pixel
    driver.hand.click("switch.compare");
    for (const CompareViewInfo& info : compare_view_list()) {
        INFO(info.name);
        driver.hand.click(std::string("compare.").append(info.name));
        driver.hand.leave();
        const int before = driver.textures.uploads;
        driver.hand.frames(20);
        if (info.view == CompareView::blink) {
            CHECK(driver.textures.uploads <= before + 1); // the picture of B, when it is seen first
        } else {
            CHECK(driver.textures.uploads == before);
        }
    }
}

TEST_CASE("Only some columns and rows of a huge picture are looked at, evenly spaced") {
    Image image{4096, 4096, {}};
    image.rgba.resize(4UL * 4096 * 4096);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            std::uint8_t* const at = image.rgba.data() + 4 * (static_cast<std::size_t>(y) * 4096 +
                                                              static_cast<std::size_t>(x));
            at[0] = static_cast<std::uint8_t>(x / 16);
            at[1] = static_cast<std::uint8_t>(y / 16);
            at[2] = 77;
            at[3] = 255;
        }
    }
    const float scale = 100.0f / 4096.0f;
    const Image small = small_picture(image, scale);
    CHECK(std::abs(small.width - 100) <= 1);
    CHECK(std::abs(small.height - 100) <= 1);
    for (const int i : {0, 20, 50, 77, 98}) {
        const std::uint8_t* const at =
            small.rgba.data() + 4 * (static_cast<std::size_t>(i) * small.width + (98 - i));
        CHECK(std::abs(at[0] - 256.0 * (98.5 - i) / 100.0) <= 2.0);
        CHECK(std::abs(at[1] - 256.0 * (i + 0.5) / 100.0) <= 2.0);
        CHECK(at[2] == 77);
    }
}

TEST_CASE("No comparison makes a picture of the lab smaller where the window has room") {
    const std::vector<ImVec2> windows{{1600, 1000}, {1920, 1080}, {2560, 1440}};
    for (const ImVec2 window : test::some_of(windows, 2)) {
        Driver driver(lit_room_of({500, 500}), window);
        driver.open("compare");
        for (const ComparePair& pair : test::some_of(compare_pairs(), 2)) {
            driver.hand.click(std::string("compare.tab.").append(pair.name));
            for (const CompareViewInfo& info : compare_view_list()) {
                INFO(pair.name << ", " << info.name << " at " << window.x << " x " << window.y);
                driver.hand.click(std::string("compare.").append(info.name));
                CHECK(driver.ui.canvas.place.scale >= 1.0f);
                const bool is_pair = info.view == CompareView::side_by_side;
                CHECK(driver.ui.compare.place_of_b.has_value() == is_pair);
                if (is_pair)
                    CHECK(driver.ui.compare.place_of_b->scale == driver.ui.canvas.place.scale);
                for (const char* name : small_names)
                    CHECK(driver.hand.find(name).is_whole);
            }
        }
    }
}

TEST_CASE("The lesson makes room for two pictures only where they would be made smaller") {
    Driver driver(lit_room_of({500, 500}));
    const auto has_column = [&] {
        driver.hand.leave();
        return driver.ui.widgets.count("splitter.lesson") > 0;
    };
    driver.hand.click("switch.compare");
    CHECK(has_column());
    driver.hand.click("compare.side_by_side");
    CHECK_FALSE(has_column());
    driver.hand.click("compare.difference");
    CHECK(has_column());
    driver.hand.click("compare.side_by_side");
    driver.hand.click("switch.compare");
    CHECK(has_column());
    driver.resize({2560, 1440});
    driver.hand.click("switch.compare");
    CHECK(driver.ui.session.compare_view == CompareView::side_by_side);
    CHECK(has_column());
}

TEST_CASE("Two pictures are one above the other where that leaves them larger") {
    Driver driver(lit_room_of({500, 500}), {1200, 1600});
    driver.hand.click("switch.compare");
    driver.ui.session.compare_view = CompareView::side_by_side;
    driver.hand.rest();
    REQUIRE(driver.ui.compare.place_of_b);
    CHECK(driver.ui.canvas.place.scale >= 1.0f);
    const PicturePlace a = driver.ui.canvas.place, b = *driver.ui.compare.place_of_b;
    CHECK(b.origin.x == a.origin.x);
    CHECK(b.origin.y >= a.origin.y + 500.0f * a.scale);
    // Each can be pointed at.
    const ImVec2 pointer{std::floor(b.origin.x + b.scale * 300.5f),
                         std::floor(b.origin.y + b.scale * 100.5f)};
    play_pointer(pointer);
    driver.hand.frames(3);
    REQUIRE(driver.ui.canvas.hovered_pixel);
    CHECK(driver.ui.canvas.hovered_pixel->x ==
          static_cast<int>(std::floor((pointer.x - b.origin.x) / b.scale)));
    CHECK(driver.ui.canvas.hovered_pixel->y ==
          static_cast<int>(std::floor((pointer.y - b.origin.y) / b.scale)));
    // Titles cover neither the pictures nor each other.
    const WidgetPlace title_b = driver.hand.find("compare.title_b");
    CHECK(title_b.top_left.y >= a.origin.y + 500.0f * a.scale);
    CHECK(title_b.bottom_right.y <= b.origin.y);
}

TEST_CASE("In every window the row lies below the picture and inside the canvas") {
    for (const SmallWindow& window : small_windows) {
        Driver driver(lit_room_of({500, 500}), window.size, window.text_scale);
        driver.hand.click("switch.compare");
        for (const CompareViewInfo& info : compare_view_list()) {
            INFO(info.name << " at " << window.size.x << " x " << window.size.y << ", text "
                           << window.text_scale);
            driver.ui.session.compare_view = info.view;
            driver.hand.rest();
            const WidgetPlace canvas = driver.hand.find("canvas");
            float right = canvas.top_left.x;
            for (const char* name : small_names) {
                if (driver.ui.widgets.count(name) == 0) continue;
                const WidgetPlace card = driver.hand.find(name);
                CHECK(card.is_whole);
                CHECK(card.top_left.y >= canvas.bottom_right.y);
                CHECK(card.top_left.x >= right);
                CHECK(extent_of(card).y <= 0.4f * extent_of(canvas).y);
                right = card.bottom_right.x;
            }
            CHECK(right <= canvas.bottom_right.x + 1.0f);
        }
    }
    for (const auto& [window, scale] :
         {std::pair{ImVec2{320, 200}, 1.0f}, {ImVec2{200, 900}, 1.0f}, {ImVec2{3000, 240}, 2.0f}}) {
        Driver driver(lit_room_of({500, 500}), window, scale);
        toggle_compare(driver.ui);
        for (const CompareViewInfo& info : compare_view_list()) {
            driver.ui.session.compare_view = info.view;
            CHECK_NOTHROW(driver.hand.rest());
            CHECK(driver.ui.canvas.place.scale > 0.0f);
        }
    }
}

TEST_CASE(
    "Where the small pictures have no room both runs are seen on either side of the divider") {
    {
        Driver driver(lit_room_of({500, 500}), {1024, 640}, 1.5f);
        driver.hand.press('C');
        driver.hand.frames();
        REQUIRE_FALSE(driver.hand.is_visible("compare.small.run_b"));
        CHECK(driver.ui.session.compare_view == CompareView::wipe);
        driver.hand.press('C');
        driver.ui.session.compare_view = CompareView::blink; // as was chosen
        driver.hand.press('C');
        CHECK(driver.ui.session.compare_view == CompareView::blink);
    }
    Driver driver(lit_room_of({500, 500}));
    driver.hand.press('C');
    driver.hand.frames();
    CHECK(driver.hand.is_visible("compare.small.run_b"));
    CHECK(driver.ui.session.compare_view == CompareView::run_a);
}

TEST_CASE("In a small window both small pictures say what is different in their runs") {
    Driver driver("lab-room.toml", {800, 600});
    open_lesson(driver.ui, "11-perspective", 0);
    driver.hand.press('C');
    driver.hand.frames();
    CHECK(shown_text(driver, "compare.small.run_a") == "affine");
    CHECK(shown_text(driver, "compare.small.run_b") == "perspective");
}

} // namespace rasterwalk
