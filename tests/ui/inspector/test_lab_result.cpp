#include <cstdlib>
#include <fstream>
#include <map>

#include "laboratory/image_variant.h"
#include "picture/resample.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/support/handout_rows.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/diagnosed.h"
#include "tests/ui/lit_room.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/compare.h"
#include "ui/actions/lab.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/view_files.h"
#include "ui/app/app.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

Image picture_with(const Bug& bug, const Session& session) {
    const Settings settings = wrong_run(bug, with_handout_rules(session.a.settings));
    const Frame frame = prepare_frame(*session.scene, settings);
    return view_image(draw_frame(frame), View::colour, std::nullopt);
}

/// Keeps all textures.
struct AllTextures : TextureHost {
    ImTextureID upload(ImTextureID old, const Image& image) override {
        const ImTextureID id = old != ImTextureID{} ? old : ImTextureID(images.size() + 1000);
        images[id] = image;
        return id;
    }
    std::map<ImTextureID, Image> images;
};

/// Pixels of the colour that marks differences.
int marked_pixels(const Image& image) {
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const std::uint8_t* const p = &image.rgba[i];
        count += p[0] == 0xF0 && p[1] == 0x72 && p[2] == 0x2B ? 1 : 0;
    }
    return count;
}

/// The mistake shown makes as many pixels wrong as the diagnosis says. What differs by one step of
/// 255 is not wrong: only the comparison counts it.
void check_counts_of_shown(const Driver& driver, std::int64_t wrong) {
    REQUIRE(driver.ui.session.b);
    const Image a = drawn_by(driver, driver.ui.session.a.settings);
    const Image b = drawn_by(driver, driver.ui.session.b->settings);
    std::int64_t by_a_step = 0, by_more = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        int largest = 0;
        for (std::size_t k = i; k < i + 3; ++k)
            largest = std::max(largest, std::abs(a.rgba[k] - b.rgba[k]));
        by_a_step += largest == 1 ? 1 : 0;
        by_more += largest > 1 ? 1 : 0;
    }
    CHECK(by_more == wrong);
    CHECK(driver.ui.results.comparison.whole().pixels.shown == by_a_step + by_more);
}

} // namespace

TEST_CASE("A picture with a mistake is diagnosed when its path is named, and the mistake shown") {
    const Session session = lit_room(120);
    test::TemporaryFolder folder;
    const std::string path = folder.file("mine.bmp.png");
    const std::vector<Bug> bugs = read_bugs();
    write_png(picture_with(find_bug(bugs, "B9"), session), path);
    Driver driver(session);
    driver.open("lab");
    driver.hand.click("lab.mode.result");
    driver.hand.enter("lab.path", path);
    finish_check(driver);
    REQUIRE(driver.ui.lab.answer);
    REQUIRE_FALSE(driver.ui.lab.answer->diagnosis.candidates.empty());
    CHECK(shown_text(driver, "lab.candidate.0") == "B9");
    driver.hand.click("lab.show.0");
    CHECK(is_on(driver.ui.session, "B9"));
}

TEST_CASE("A picture is checked a part a frame, says how far it is, and is dropped by Esc or a "
          "second stop") {
    Driver driver;
    const Settings reference = pixel_light(driver, 400);
    driver.ui.session.a.settings = reference;
    Settings wrong = reference;
    wrong.camera.yaw = 0.2f;
    test::TemporaryFolder folder;
    const std::string path = folder.file("mine.png");
    write_png(drawn_by(driver, wrong), path);
    for (const bool by_key : {true, false}) {
        diagnose_file(driver.ui, path);
        CHECK(is_diagnosing(driver.ui));
        driver.hand.frames(40);
        REQUIRE(driver.ui.lab.check);
        CHECK(is_animating(driver.ui));
        // A frame's share of the work is about two of these pictures, of some hundred.
        CHECK(driver.ui.lab.check->work->pictures().done < 100);
        CHECK_THAT(shown_text(driver, "lab.progress"),
                   Catch::Matchers::ContainsSubstring(" pictures"));
        if (by_key) {
            driver.ui.focus.is_shown = false;
            driver.hand.press(key::escape);
        } else {
            stop_diagnosis(driver.ui); // shows what was found
            CHECK(is_diagnosing(driver.ui));
            stop_diagnosis(driver.ui); // and drops that, too
        }
        CHECK_FALSE(is_diagnosing(driver.ui));
        CHECK_FALSE(driver.ui.lab.answer);
        driver.hand.rest();
        CHECK(driver.hand.is_visible("lab.choose"));
    }
}

TEST_CASE("A diagnosis shows the student's picture next to its differences from the right one") {
    constexpr int side = 160;
    Driver driver;
    AllTextures textures;
    driver.ui.host.textures = &textures;
    const auto shown = [&](std::size_t i) -> const Image& {
        return textures.images.at(driver.ui.lab.pictures.small[i].id);
    };
    const Settings reference = pixel_light(driver, side);
    const Image right = drawn_by(driver, reference);
    Settings wrong = reference;
    wrong.spans = Spans::last_dropped;
    const Image mine = drawn_by(driver, wrong);
    check_image(driver, mine);
    const WidgetPlace own = driver.hand.find("lab.picture.own");
    const WidgetPlace beside = driver.hand.find("lab.picture.beside");
    CHECK(own.is_whole);
    CHECK(beside.is_whole);
    CHECK(own.top_left.y == beside.top_left.y);
    CHECK(own.bottom_right.x < beside.top_left.x);
    CHECK(shown_text(driver, "lab.picture.own") == "Your picture");
    const auto width = static_cast<float>(shown(0).width);
    CHECK(own.bottom_right.x - own.top_left.x == Approx(width));
    CHECK(width > 150.0f);
    CHECK(shown(0) == resampled(mine, driver.ui.lab.pictures.small[0].scale));
    CHECK(marked_pixels(shown(1)) == differences_of(right, mine).pixels);
    // Another lamp is no mistake: only what the mistake makes is marked.
    Settings lit = reference;
    lit.light.power = wrong.light.power = glm::vec3(14.0f);
    const Image bright = drawn_by(driver, wrong);
    check_image(driver, bright);
    CHECK(marked_pixels(shown(1)) == differences_of(drawn_by(driver, lit), bright).pixels);
    CHECK_THAT(shown_text(driver, "lab.difference"),
               Catch::Matchers::StartsWith(grouped(driver.ui.lab.answer->diagnosis.different)) &&
                   Catch::Matchers::ContainsSubstring("correct picture. They are in "));
    CHECK(shown_text(driver, "lab.rules") ==
          "Your program draws with “Lamp power: 14”, which is just as correct.");
    CHECK(marked_pixels(shown(1)) == driver.ui.lab.answer->diagnosis.different);
    // Even one pixel is noticed, and its place is given.
    Image scratched = right;
    std::fill_n(scratched.rgba.begin() + 4 * (side / 2 * side + side / 2), 3, std::uint8_t{255});
    check_image(driver, scratched);
    CHECK(marked_pixels(shown(1)) >= 1);
    CHECK(marked_pixels(shown(1)) <= 4);
    CHECK(shown_text(driver, "lab.difference") ==
          "1 pixel differs from the correct picture. It is in column 80 and row 80.");
    check_image(driver, right);
    CHECK_THAT(shown_text(driver, "lab.picture.beside"),
               Catch::Matchers::EndsWith("Exactly the same."));
    CHECK(marked_pixels(shown(1)) == 0);
    driver.ui.host.textures = &driver.textures;
}

TEST_CASE("One card names the mistake, its place, its cure and its lesson, and leads there") {
    Driver driver;
    const Settings reference = pixel_light(driver);
    const Bug bug = find_bug(read_bugs(), "B9");
    check_image(driver, drawn_by(driver, wrong_run(bug, reference)));
    CHECK_THAT(shown_text(driver, "lab.diagnosis"), Catch::Matchers::ContainsSubstring(bug.name));
    CHECK_THAT(shown_text(driver, "lab.difference"),
               Catch::Matchers::ContainsSubstring("They are in columns "));
    CHECK_THAT(shown_text(driver, "lab.remedy"),
               Catch::Matchers::ContainsSubstring(bug.look) &&
                   Catch::Matchers::ContainsSubstring("**Cure.** Both ends") &&
                   Catch::Matchers::ContainsSubstring("**Lesson 6.** "));
    driver.hand.click("lab.remedy.1");
    CHECK(driver.ui.session.lesson == bug.lesson);
    CHECK(bug.lesson == "06-filling");
}

TEST_CASE("A lesson leaves nothing behind in what a picture is compared with") {
    test::TemporaryFolder folder;
    const std::string path = folder.file("mine.png");
    std::int64_t fresh = 0;
    {
        Driver driver;
        Settings wrong = pixel_light(driver, 200);
        wrong.spans = Spans::last_dropped;
        write_png(drawn_by(driver, wrong), path);
        diagnose_file(driver.ui, path);
        finish_check(driver);
        fresh = driver.ui.lab.answer->diagnosis.different;
        REQUIRE(fresh > 0);
    }
    Driver driver;
    open_lesson(driver.ui, "31-shadows", 7);
    driver.hand.rest();
    driver.ui.start.is_open = true;
    driver.hand.rest();
    driver.hand.click("start.picture");
    driver.hand.enter("files.path", path);
    finish_check(driver);
    REQUIRE(driver.ui.lab.answer);
    CHECK(driver.ui.lab.answer->diagnosis.different == fresh);
    CHECK_THAT(shown_text(driver, "lab.difference"), Catch::Matchers::StartsWith(grouped(fresh)));
    CHECK_THAT(shown_text(driver, "lab.held_against"),
               Catch::Matchers::ContainsSubstring("as the handout draws it"));
    driver.hand.click("lab.show.0");
    driver.hand.rest();
    check_counts_of_shown(driver, fresh);
    // A picture from another place is compared with what is set, when that is asked for.
    driver.hand.press('C');
    driver.ui.session.a.settings.camera.yaw = 0.2f;
    driver.hand.click("lab.other_reference");
    finish_check(driver);
    CHECK(driver.ui.lab.answer->subject.reference.camera.yaw == 0.2f);
    CHECK_THAT(shown_text(driver, "lab.held_against"),
               Catch::Matchers::ContainsSubstring("with the current camera"));
    driver.hand.click("lab.other_reference");
    finish_check(driver);
    CHECK(driver.ui.lab.answer->diagnosis.different == fresh);
}

TEST_CASE("In a small window both pictures of a diagnosis can be seen whole") {
    for (const SmallWindow& window : small_windows) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        driver.ui.session.a.settings = pixel_light(driver);
        Settings wrong = pixel_light(driver);
        wrong.interpolation = Interpolation::affine;
        set_from_text(wrong, "viewport.size=300x100");
        driver.ui.session.a.settings = wrong;
        driver.ui.session.a.settings.interpolation = Interpolation::perspective;
        check_picture(driver, wrong);
        for (const char* name : {"lab.picture.own", "lab.picture.beside"}) {
            INFO(name);
            const WidgetPlace place = driver.hand.find(name);
            CHECK(place.is_whole);
            CHECK(place.bottom_right.x - place.top_left.x >= 60.0f * window.text_scale);
        }
    }
}

TEST_CASE("What is wrong with a picture is in sight at once, and scrolled by keys") {
    for (const SmallWindow& window : test::some_of(small_windows, 2)) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        driver.ui.session.tab = "lab";
        driver.ui.lab.mode = LabMode::result;
        driver.hand.rest();
        CHECK(driver.ui.widgets.contains("lab.intro"));
        Settings wrong = pixel_light(driver);
        wrong.interpolation = Interpolation::affine;
        driver.ui.session.a.settings = pixel_light(driver);
        check_picture(driver, wrong);
        REQUIRE(driver.ui.lab.answer);
        CHECK_FALSE(driver.ui.widgets.contains("lab.intro"));
        const WidgetPlace before = driver.ui.widgets.at("lab.diagnosis");
        CHECK(before.is_whole);
        const Modifiers ctrl{.ctrl = true};
        driver.hand.press(key::down, ctrl);
        driver.hand.frames(2);
        CHECK(driver.ui.widgets.at("lab.diagnosis").top_left.y < before.top_left.y);
    }
}

TEST_CASE(
    "A mistake is shown as it was compared with the picture: same lamp, same size, same room") {
    Driver driver;
    const Settings reference = pixel_light(driver);
    driver.ui.session.a.settings = reference;
    const std::shared_ptr<const Scene> room = driver.ui.session.scene;
    Settings wrong = reference;
    wrong.interpolation = Interpolation::affine;
    check_picture(driver, wrong);
    REQUIRE(driver.ui.lab.answer);
    // Whatever is opened in between, and however it is lit.
    driver.hand.click("menu.Scene");
    driver.hand.click("scene.one-triangle");
    driver.open("lab");
    driver.hand.click("lab.show.0");
    REQUIRE(driver.ui.session.b);
    CHECK(driver.ui.session.scene == room);
    CHECK(driver.ui.session.a.settings == wrong);
    CHECK(driver.ui.session.b->settings == reference);
    driver.hand.rest();
    check_counts_of_shown(driver, driver.ui.lab.answer->diagnosis.different);
    driver.hand.press('C');
    CHECK_FALSE(driver.ui.session.b);
    CHECK(driver.ui.session.scene != room);
}

TEST_CASE("An unreadable file is reported in the laboratory, and rows of the lab are accepted") {
    test::TemporaryFolder folder;
    Driver driver(lit_room(200));
    open_dropped(driver.ui, folder.file("nothing.png"));
    driver.hand.frames(2);
    CHECK(driver.ui.session.tab == "lab");
    CHECK(driver.hand.is_visible("lab.result.fault"));
    const std::string path = folder.file("rows.txt");
    std::ofstream(path) << test::handout_rows;
    open_dropped(driver.ui, path);
    driver.hand.frames(2);
    REQUIRE(driver.ui.lab.answer);
    CHECK(driver.ui.lab.answer->diagnosis.is_same());
    CHECK(driver.hand.is_visible("lab.diagnosis"));
}

TEST_CASE("The first row that differs is named, and no mistake is offered without reason") {
    test::TemporaryFolder folder;
    Driver driver;
    std::string text(test::handout_rows);
    const std::size_t at = text.find("Start: (6,9)");
    REQUIRE(at != std::string::npos);
    text.replace(at, 12, "Start: (7,9)");
    const std::string path = folder.file("rows.txt");
    std::ofstream(path) << text;
    open_dropped(driver.ui, path);
    driver.hand.frames(3);
    REQUIRE(driver.ui.lab.answer);
    CHECK(shown_text(driver, "lab.difference") ==
          "1 row differs from the reference. The first is row 9: columns 6 to 12 in the "
          "reference, columns 7 to 12 in yours.");
    CHECK(driver.ui.lab.answer->diagnosis.candidates.empty());
    CHECK(shown_text(driver, "lab.diagnosis") == "No known mistake explains the difference.");
}

TEST_CASE("What is below an answer does not jump from one frame to the next") {
    Driver driver;
    Settings wrong = pixel_light(driver, small_side);
    wrong.interpolation = Interpolation::affine;
    check_picture(driver, wrong);
    REQUIRE(driver.ui.lab.answer);
    for (const float height : {1000.0f, 990.0f, 980.0f, 970.0f, 960.0f, 950.0f, 940.0f, 930.0f}) {
        INFO("a window " << height << " high");
        driver.resize({1600.0f, height});
        driver.hand.rest();
        const float top = driver.ui.widgets.at("lab.path").top_left.y;
        for (int frame = 0; frame < 4; ++frame) {
            driver.hand.frames(1);
            CHECK(driver.ui.widgets.at("lab.path").top_left.y == top);
        }
    }
}

TEST_CASE("Below the answer about a picture the controls for choosing another stay whole") {
    for (const ImVec2 window : {ImVec2{1600, 1000}, ImVec2{1280, 800}}) {
        INFO(window.x << " x " << window.y);
        Driver driver("lab-room.toml", window);
        driver.ui.session.a.settings = pixel_light(driver);
        const Settings reference = driver.ui.session.a.settings;
        check_image(driver, drawn_by(driver, wrong_run(find_bug(read_bugs(), "B3"), reference)));
        driver.hand.leave();
        REQUIRE(driver.ui.lab.answer);
        CHECK(driver.ui.widgets.at("lab.choose").is_whole);
        CHECK(driver.ui.widgets.at("lab.path").is_whole);
        CHECK(driver.ui.widgets.at("lab.diagnosis").is_whole);
        CHECK_THAT(shown_text(driver, "lab.diagnosis"), Catch::Matchers::StartsWith("B3 “"));
        CHECK_THAT(shown_text(driver, "lab.diagnosis"),
                   Catch::Matchers::EndsWith(" It explains your picture down to the last pixel."));
    }
}

} // namespace rasterwalk
