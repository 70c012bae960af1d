#include <cstdlib>
#include <fstream>
#include <map>

#include "base/numbers.h"
#include "laboratory/diagnose.h"
#include "laboratory/image_variant.h"
#include "laboratory/quiz.h"
#include "opening/opened_view.h"
#include "picture/resample.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/support/handout_rows.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/lit_room.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/compare.h"
#include "ui/actions/lab.h"
#include "ui/actions/lesson_links.h"
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

/// Ends the check of a file that has been begun.
void finish_check(Driver& driver) {
    while (is_diagnosing(driver.ui))
        carry_on_diagnosis(driver.ui, {});
    driver.hand.rest();
}

} // namespace

TEST_CASE("A mistake is turned on and compared with the correct run at once, and turned off") {
    Driver driver(lit_room(200));
    const Settings before = driver.ui.session.a.settings;
    driver.open("lab");
    driver.hand.click("lab.B9");
    CHECK(driver.ui.lab.chosen == "B9");
    driver.hand.click("lab.on");
    CHECK(is_on(driver.ui.session, "B9"));
    REQUIRE(driver.ui.results.b);
    CHECK(driver.ui.results.comparison.whole().pixels.different > 0);
    driver.hand.click("lab.B3");
    driver.hand.click("lab.on");
    CHECK(is_on(driver.ui.session, "B3"));
    CHECK_FALSE(is_on(driver.ui.session, "B9"));
    driver.hand.click("lab.off");
    CHECK_FALSE(driver.ui.session.b);
    CHECK(driver.ui.session.a.settings == before);
}

TEST_CASE("What the lab does by itself is said to be on already, and compared with the cure") {
    Driver driver;
    driver.open("lab");
    for (const Bug& bug : lab_bugs(driver.ui)) {
        // By the data alone: each thing that the mistake sets is what the lab has.
        const Settings lab = default_settings(*driver.ui.session.scene);
        Settings set = lab;
        for (const auto& [name, value] : bug.set) {
            if (name != "stage") set_value(set, *find_setting(name), value);
        }
        const bool is_lab = set == lab;
        INFO(bug.id);
        driver.hand.find("lab." + bug.id);
        CHECK(shown_text(driver, "lab." + bug.id) == (is_lab ? "as it is" : ""));
    }
    for (const char* id : {"B1", "B2", "B19"}) {
        INFO(id);
        driver.hand.click(std::string("lab.") + id);
        driver.hand.find("lab.on");
        CHECK(driver.hand.is_visible("lab.made"));
        driver.hand.click("lab.on");
        CHECK(is_on(driver.ui.session, id));
        driver.hand.leave();
        CHECK_FALSE(driver.hand.is_visible("lab.made"));
        CHECK(shown_text(driver, std::string("lab.") + id) == "on");
        driver.hand.click("lab.off");
    }
    driver.hand.click("lab.B9");
    driver.hand.leave();
    CHECK_FALSE(driver.hand.is_visible("lab.made"));
}

TEST_CASE("Every mistake is described and shows on its own scene, from which one comes back") {
    Driver driver(lit_room(200));
    const std::shared_ptr<const Scene> room = driver.ui.session.scene;
    driver.open("lab");
    const std::vector<Bug> bugs = lab_bugs(driver.ui);
    REQUIRE(bugs.size() > 25);
    for (const Bug& bug : test::some_of(bugs, 5)) {
        INFO(bug.id);
        driver.hand.click("lab." + bug.id);
        driver.hand.click("lab.scene");
        CHECK(is_on(driver.ui.session, bug.id));
        CHECK(driver.ui.session.notice == "");
        driver.hand.click("lab.off");
        CHECK(driver.ui.session.scene == room);
    }
}

TEST_CASE("A round of the quiz is won: hint, wrong guess, right guess, and all is as before") {
    Driver driver(lit_room(200));
    const Settings before = driver.ui.session.a.settings;
    driver.open("lab");
    driver.hand.click("lab.mode.quiz");
    driver.ui.lab.seed = 7;
    driver.hand.click("lab.quiz.start");
    REQUIRE(driver.ui.session.quiz);
    const std::vector<std::string> right = driver.ui.session.quiz->questions[0].bugs;
    // Nothing gives it away.
    driver.hand.click("tab.settings");
    CHECK(driver.hand.is_visible("settings.hidden"));
    CHECK_FALSE(driver.hand.is_visible("setting.rounding"));
    const Settings hidden = driver.ui.session.a.settings;
    driver.hand.click("switch.perspective");
    CHECK(driver.ui.session.a.settings == hidden);
    driver.open("lab");
    driver.hand.click("lab.quiz.compare");
    REQUIRE(driver.ui.results.b);
    CHECK(driver.ui.results.comparison.pixels.different > 0);
    driver.hand.click("compare.run_b");
    CHECK(shown_text(driver, "compare.title_b") == "the correct run");
    driver.hand.click("lab.hint");
    CHECK(driver.ui.session.quiz->questions[0].hints == 1);
    const auto choose = [&](const std::string& id) {
        driver.hand.click("lab.choice." + id);
        driver.hand.click("lab.guess");
    };
    for (const Bug& bug : lab_bugs(driver.ui)) {
        if (std::find(right.begin(), right.end(), bug.id) != right.end()) continue;
        choose(bug.id);
        break;
    }
    CHECK_FALSE(is_over(*driver.ui.session.quiz));
    choose(right.front());
    CHECK(is_solved(*driver.ui.session.quiz));
    CHECK(driver.hand.is_visible("lab.verdict"));
    driver.hand.click("lab.quiz.end");
    CHECK_FALSE(driver.ui.session.quiz);
    CHECK(driver.ui.session.a.settings == before);
    CHECK(driver.ui.options.score.rounds == 1);
    CHECK(driver.ui.options.score.points ==
          points_of_question - cost_of_hint - cost_of_wrong_guess);
}

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
    REQUIRE(driver.ui.lab.diagnosis);
    REQUIRE_FALSE(driver.ui.lab.diagnosis->candidates.empty());
    CHECK(shown_text(driver, "lab.candidate.0") == "B9");
    driver.hand.click("lab.show.0");
    CHECK(is_on(driver.ui.session, "B9"));
}

namespace {

/// Holds a picture of these settings against the room as it stands in the driver.
void check_picture(Driver& driver, const Settings& settings) {
    test::TemporaryFolder folder;
    const std::string path = folder.file("mine.png");
    const Frame frame = prepare_frame(*driver.ui.session.scene, settings);
    write_png(view_image(draw_frame(frame), View::colour), path);
    diagnose_file(driver.ui, path);
    finish_check(driver);
}

/// The same with any picture.
void check_image(Driver& driver, const Image& picture) {
    test::TemporaryFolder folder;
    const std::string path = folder.file("mine.png");
    write_png(picture, path);
    diagnose_file(driver.ui, path);
    finish_check(driver);
}

Image drawn_by(const Driver& driver, const Settings& settings) {
    const Frame frame = prepare_frame(*driver.ui.session.scene, settings);
    return view_image(draw_frame(frame), View::colour);
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

/// Pixels of the colour in which differences are marked.
int marked_pixels(const Image& image) {
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const std::uint8_t* const p = &image.rgba[i];
        count += p[0] == 0xF0 && p[1] == 0x72 && p[2] == 0x2B ? 1 : 0;
    }
    return count;
}

/// @param side of the picture: each diagnosis draws it some fifty times
Settings pixel_light(const Driver& driver, int side = 120) {
    Settings settings = with_handout_rules(driver.ui.session.a.settings);
    set_step(settings, StripStep::pixel_light);
    settings.viewport = {side, side};
    settings.camera.focal_length = static_cast<float>(side);
    return settings;
}

} // namespace

TEST_CASE(
    "A picture is checked a part a frame, says how far it is, and is stopped by Esc or button") {
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
        REQUIRE(driver.ui.lab.work);
        CHECK(is_animating(driver.ui));
        // A frame's share of the work is about two of these pictures, of some hundred.
        CHECK(driver.ui.lab.work->pictures().done < 100);
        CHECK_THAT(shown_text(driver, "lab.progress"),
                   Catch::Matchers::ContainsSubstring(" pictures"));
        if (by_key) {
            driver.ui.focus.is_shown = false;
            driver.hand.press(key::escape);
        } else {
            driver.hand.click("lab.stop");
        }
        CHECK_FALSE(is_diagnosing(driver.ui));
        CHECK_FALSE(driver.ui.lab.diagnosis);
        driver.hand.rest();
        CHECK(driver.hand.is_visible("lab.choose"));
    }
}

TEST_CASE("A diagnosis shows the student's picture beside where it differs from the right one") {
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
               Catch::Matchers::StartsWith(grouped(driver.ui.lab.diagnosis->different)) &&
                   Catch::Matchers::ContainsSubstring(" with “Lamp power: 14”. They are in "));
    CHECK(marked_pixels(shown(1)) == driver.ui.lab.diagnosis->different);
    // Even one pixel is seen, and its place is told.
    Image scratched = right;
    std::fill_n(scratched.rgba.begin() + 4 * (side / 2 * side + side / 2), 3, std::uint8_t{255});
    check_image(driver, scratched);
    CHECK(marked_pixels(shown(1)) >= 1);
    CHECK(marked_pixels(shown(1)) <= 4);
    CHECK(shown_text(driver, "lab.difference") ==
          "1 pixel looks different from the right picture. It is in column 80 and row 80.");
    check_image(driver, right);
    CHECK_THAT(shown_text(driver, "lab.picture.beside"),
               Catch::Matchers::EndsWith("The very same."));
    CHECK(marked_pixels(shown(1)) == 0);
    driver.ui.host.textures = &driver.textures;
}

TEST_CASE("One card names the mistake, its place, its cure and its lesson, to which it leads") {
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

TEST_CASE("Each mistake names a lesson that there is") {
    Driver driver;
    for (const Bug& bug : lab_bugs(driver.ui)) {
        INFO(bug.id << ": " << bug.lesson);
        CHECK(driver.ui.lesson.lessons.find(bug.lesson) != nullptr);
    }
}

TEST_CASE("A lesson leaves nothing behind in what a picture is held against") {
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
        fresh = driver.ui.lab.diagnosis->different;
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
    REQUIRE(driver.ui.lab.diagnosis);
    CHECK(driver.ui.lab.diagnosis->different == fresh);
    CHECK_THAT(shown_text(driver, "lab.difference"), Catch::Matchers::StartsWith(grouped(fresh)));
    CHECK_THAT(shown_text(driver, "lab.held_against"),
               Catch::Matchers::ContainsSubstring("as the handout draws it"));
    driver.hand.click("lab.show.0");
    driver.hand.rest();
    CHECK(driver.ui.results.comparison.whole().pixels.shown == fresh);
    CHECK_THAT(difference_forms(driver.ui.results.comparison.pixels).front(),
               Catch::Matchers::StartsWith(grouped(fresh)));
    // A picture from another place is held against what is set, when that is asked for.
    driver.hand.press('C');
    driver.ui.session.a.settings.camera.yaw = 0.2f;
    driver.hand.click("lab.other_reference");
    finish_check(driver);
    CHECK(driver.ui.lab.reference.camera.yaw == 0.2f);
    CHECK_THAT(shown_text(driver, "lab.held_against"),
               Catch::Matchers::ContainsSubstring("that are set"));
    driver.hand.click("lab.other_reference");
    finish_check(driver);
    CHECK(driver.ui.lab.diagnosis->different == fresh);
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
        REQUIRE(driver.ui.lab.diagnosis);
        CHECK_FALSE(driver.ui.widgets.contains("lab.intro"));
        const WidgetPlace before = driver.ui.widgets.at("lab.diagnosis");
        CHECK(before.is_whole);
        const Held ctrl{.ctrl = true};
        driver.hand.press(key::down, ctrl);
        driver.hand.frames(2);
        CHECK(driver.ui.widgets.at("lab.diagnosis").top_left.y < before.top_left.y);
    }
}

TEST_CASE(
    "A mistake is shown as it was held against the picture: same lamp, same size, same room") {
    Driver driver;
    const Settings reference = pixel_light(driver);
    driver.ui.session.a.settings = reference;
    const std::shared_ptr<const Scene> room = driver.ui.session.scene;
    Settings wrong = reference;
    wrong.interpolation = Interpolation::affine;
    check_picture(driver, wrong);
    REQUIRE(driver.ui.lab.diagnosis);
    // Whatever is opened in between, and how ever it is lit.
    driver.hand.click("menu.Scene");
    driver.hand.click("scene.one-triangle");
    driver.open("lab");
    driver.hand.click("lab.show.0");
    REQUIRE(driver.ui.session.b);
    CHECK(driver.ui.session.scene == room);
    CHECK(driver.ui.session.a.settings == wrong);
    CHECK(driver.ui.session.b->settings == reference);
    driver.hand.rest();
    CHECK(driver.ui.results.comparison.whole().pixels.shown == driver.ui.lab.diagnosis->different);
    driver.hand.press('C');
    CHECK_FALSE(driver.ui.session.b);
    CHECK(driver.ui.session.scene != room);
}

TEST_CASE("The diagnosis says sizes and settings in words") {
    Driver driver;
    const Settings reference = pixel_light(driver, 500);
    driver.ui.session.a.settings = reference;
    driver.open("lab");
    check_picture(driver, reference);
    CHECK(shown_text(driver, "lab.diagnosis") == "Your picture is the reference, pixel for pixel.");
    CHECK_THAT(shown_text(driver, "lab.held_against"),
               Catch::Matchers::EndsWith("500 x 500 pixels like yours."));
    Settings small = reference;
    set_from_text(small, "viewport.size=100x100");
    set_from_text(small, "camera.focal_length=" + number_text(reference.camera.focal_length / 5));
    check_picture(driver, small);
    CHECK(driver.ui.lab.diagnosis->is_same());
    CHECK_THAT(shown_text(driver, "lab.held_against"),
               Catch::Matchers::EndsWith("100 x 100 pixels instead of 500 x 500."));
    set_from_text(small, "line_walk=exact");
    check_picture(driver, small);
    REQUIRE_FALSE(driver.ui.lab.diagnosis->is_same());
    CHECK_THAT(shown_text(driver, "lab.diagnosis"),
               Catch::Matchers::ContainsSubstring("“Walking a line: without error”") &&
                   !Catch::Matchers::ContainsSubstring("="));
}

TEST_CASE("What cannot be read is said in the laboratory, and rows of the lab are accepted") {
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
    REQUIRE(driver.ui.lab.diagnosis);
    CHECK(driver.ui.lab.diagnosis->is_same());
    CHECK(driver.hand.is_visible("lab.diagnosis"));
}

TEST_CASE("Of a row table it is said which row differs first, and nothing is offered for nothing") {
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
    REQUIRE(driver.ui.lab.diagnosis);
    CHECK(shown_text(driver, "lab.difference") ==
          "1 row differs from the reference. The first is row 9: columns 6 to 12 in the "
          "reference, columns 7 to 12 in yours.");
    CHECK(driver.ui.lab.diagnosis->candidates.empty());
    CHECK(shown_text(driver, "lab.diagnosis") == "No known mistake explains the difference.");
}

TEST_CASE("All that can be chosen of a quiz stands before it is begun") {
    Driver driver;
    driver.open("lab");
    driver.hand.click("lab.mode.quiz");
    driver.hand.leave();
    const float begin = driver.hand.find("lab.quiz.start").top_left.y;
    for (const char* choice : {"lab.two", "lab.seed", "lab.keep_score"}) {
        INFO(choice);
        CHECK(driver.hand.find(choice).bottom_right.y <= begin);
    }
}

TEST_CASE("Below what is said of a picture the way to another one stays whole") {
    for (const ImVec2 window : {ImVec2{1600, 1000}, ImVec2{1280, 800}}) {
        INFO(window.x << " x " << window.y);
        Driver driver("lab-room.toml", window);
        driver.ui.session.a.settings = pixel_light(driver);
        const Settings reference = driver.ui.session.a.settings;
        check_image(driver, drawn_by(driver, wrong_run(find_bug(read_bugs(), "B3"), reference)));
        driver.hand.leave();
        REQUIRE(driver.ui.lab.diagnosis);
        CHECK(driver.ui.widgets.at("lab.choose").is_whole);
        CHECK(driver.ui.widgets.at("lab.path").is_whole);
        CHECK(driver.ui.widgets.at("lab.diagnosis").is_whole);
        CHECK_THAT(shown_text(driver, "lab.diagnosis"), Catch::Matchers::StartsWith("B3 “"));
        CHECK_THAT(shown_text(driver, "lab.diagnosis"),
                   Catch::Matchers::ContainsSubstring("” makes"));
    }
}

TEST_CASE("While a quiz hides the settings nothing can set them, and nothing tells them") {
    Driver driver(lit_room(200));
    driver.open("lab");
    driver.hand.click("lab.mode.quiz");
    driver.hand.enter("lab.seed", "7");
    driver.hand.click("lab.quiz.start");
    const Settings hidden = driver.ui.session.a.settings;
    driver.hand.click("lab.quiz.compare");
    REQUIRE(driver.ui.session.b);
    driver.hand.click("compare.swap");
    driver.open("compare");
    CHECK_FALSE(driver.hand.is_visible("compare.tab.exact"));
    driver.hand.press('P');
    driver.hand.press('Z');
    follow_link(driver.ui, "set:interpolation=affine");
    follow_link(driver.ui, "preset:exact");
    follow_link(driver.ui, "bug:B9");
    driver.hand.frames(2);
    CHECK(driver.ui.session.a.settings == hidden);
    CHECK(pair_on_show(driver.ui.session) == nullptr);
    driver.hand.press('C');
    CHECK(driver.ui.session.a.settings == hidden);
    driver.hand.click("menu.Scene");
    driver.hand.click("scene.one-triangle");
    CHECK_FALSE(driver.ui.session.quiz);
    CHECK(driver.ui.session.a.settings.viewport == Viewport{20, 20});
}

TEST_CASE("The key C ends a mistake as the button does") {
    Driver driver(lit_room(200));
    const Settings before = driver.ui.session.a.settings;
    driver.open("lab");
    driver.hand.click("lab.B5");
    driver.hand.click("lab.on");
    driver.hand.press('C');
    CHECK(driver.ui.session.a.settings == before);
    CHECK(driver.hand.find("lab.on").visible);
    driver.hand.press('C');
    CHECK_FALSE(is_on(driver.ui.session, "B5"));
}

TEST_CASE("The Scene menu survives that the scenes are gone") {
    const test::TemporaryFolder folder;
    Driver driver(lit_room(200));
    setenv("RASTERWALK_LESSONS", folder.file("nowhere").c_str(), 1);
    driver.hand.click("menu.Scene");
    unsetenv("RASTERWALK_LESSONS");
    CHECK_THAT(driver.ui.session.notice, Catch::Matchers::ContainsSubstring("nowhere"));
}

TEST_CASE("In a small window the laboratory's buttons can be reached") {
    for (const SmallWindow& window : test::some_of(small_windows, 2)) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        Driver driver(lit_room(200), window.size, window.text_scale);
        driver.ui.session.tab = "lab";
        driver.hand.frames(4);
        for (const char* name : {"lab.B9", "lab.on", "lab.scene", "lab.mode.bugs", "lab.mode.quiz",
                                 "lab.mode.result"}) {
            INFO(name);
            CHECK(driver.hand.find(name).is_whole);
        }
        driver.hand.click("lab.mode.quiz");
        driver.hand.click("lab.quiz.start");
        for (const char* name : {"lab.choice.B3", "lab.guess", "lab.hint", "lab.give_up"}) {
            INFO(name);
            CHECK(driver.hand.find(name).is_whole);
        }
    }
}

TEST_CASE("The mistake that is on when the laboratory opens is the one described") {
    for (const char* id : {"B10", "B9", "B2"}) {
        INFO(id);
        ViewOptions options;
        options.bug = id;
        options.given["tab"] = {"lab"};
        Driver driver(open_view(options));
        driver.hand.rest();
        CHECK(is_on(driver.ui.session, id));
        CHECK(driver.ui.lab.chosen == id);
        CHECK(driver.hand.find("lab.off").visible); // the box has the button to turn it off
        // What the student then looks at stays.
        driver.hand.click("lab.B3");
        driver.hand.frames(5);
        CHECK(driver.ui.lab.chosen == "B3");
    }
}

} // namespace rasterwalk
