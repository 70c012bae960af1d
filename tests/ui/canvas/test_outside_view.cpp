#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "outside/outside_drawing.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/made_scene.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/app/app.h"
#include "ui/canvas/outside_view.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

CanvasShows shown(const Driver& driver) {
    return driver.ui.session.canvas.shows;
}

const OutsideView& view(const Driver& driver) {
    return driver.ui.session.canvas.outside;
}

/// A click where a place of the world is seen from outside.
void click_at(Driver& driver, const glm::dvec3& world) {
    const auto at = driver.ui.canvas.outside_drawing->eye().pixel_of(world);
    REQUIRE(at);
    const ImVec2 low = driver.ui.widgets.at("canvas.outside").top_left;
    play_pointer({std::floor(low.x + static_cast<float>(at->x)),
                  std::floor(low.y + static_cast<float>(at->y))});
    driver.hand.frames(2);
    play_mouse_button(0, true);
    driver.hand.frames(1);
    play_mouse_button(0, false);
    driver.hand.rest();
}

/// The texts over the view from outside; a name and its halo, which is the same name
/// slightly offset, are one.
std::vector<ScreenText> outside_texts(Driver& driver) {
    const WidgetPlace view = driver.hand.find("canvas.outside");
    std::vector<ScreenText> texts;
    for (const ScreenText& text : screen_text()) {
        const bool is_within = text.window == "canvas" && text.low.x >= view.top_left.x - 1.0f &&
                               text.low.y >= view.top_left.y - 1.0f &&
                               text.low.y < view.bottom_right.y;
        const auto known = std::find_if(texts.begin(), texts.end(), [&](const ScreenText& other) {
            return other.words == text.words && std::abs(other.low.x - text.low.x) < 5.0f &&
                   std::abs(other.low.y - text.low.y) < 5.0f;
        });
        if (!is_within) continue;
        if (known == texts.end()) {
            texts.push_back(text);
            continue;
        }
        known->low = {std::min(known->low.x, text.low.x), std::min(known->low.y, text.low.y)};
        known->high = {std::max(known->high.x, text.high.x), std::max(known->high.y, text.high.y)};
    }
    return texts;
}

bool has_text(const std::vector<ScreenText>& texts, const std::string& words) {
    return std::any_of(texts.begin(), texts.end(),
                       [&](const ScreenText& text) { return text.words == words; });
}

/// Two texts that overlap, or one that is not seen whole; empty if there are none.
std::string crowded_texts(const std::vector<ScreenText>& texts, const WidgetPlace& view) {
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const ScreenText& a = texts[i];
        if (a.high.x > view.bottom_right.x + 1.0f || a.high.y > view.bottom_right.y + 1.0f)
            return a.words + " is cut off";
        for (std::size_t j = 0; j < i; ++j) {
            const ScreenText& b = texts[j];
            if (a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y &&
                b.low.y < a.high.y)
                return b.words + " and " + a.words;
        }
    }
    return "";
}

} // namespace

TEST_CASE("The canvas shows the picture, the scene from outside, or both") {
    Driver driver;
    CHECK(driver.hand.is_visible("canvas"));
    CHECK_FALSE(driver.hand.is_visible("canvas.outside"));
    driver.hand.click("canvas.shows.outside");
    CHECK(shown(driver) == CanvasShows::outside);
    CHECK_FALSE(driver.hand.is_visible("canvas"));
    CHECK(driver.hand.is_visible("canvas.outside"));
    driver.hand.click("canvas.shows.both");
    CHECK(driver.hand.is_visible("canvas"));
    CHECK(driver.hand.is_visible("canvas.outside"));
    // Neither is smaller than the picture is.
    CHECK(driver.ui.canvas.place.scale >= 1.0f);
    driver.hand.click("canvas.shows.picture");
    CHECK(shown(driver) == CanvasShows::picture);
    CHECK_FALSE(driver.hand.is_visible("canvas.outside"));
}

TEST_CASE("Keys show the scene from outside, and the picture again") {
    Driver driver;
    driver.hand.press('9');
    CHECK(shown(driver) == CanvasShows::both);
    driver.hand.press('9');
    CHECK(shown(driver) == CanvasShows::picture);
    driver.hand.press('8');
    CHECK(shown(driver) == CanvasShows::outside);
    const float yaw = view(driver).yaw, pitch = view(driver).pitch;
    driver.hand.press(key::right, {.shift = true});
    CHECK(view(driver).yaw > yaw);
    driver.hand.press(key::up, {.shift = true});
    CHECK(view(driver).pitch > pitch);
    driver.hand.press(key::left, {.shift = true});
    driver.hand.press(key::down, {.shift = true});
    CHECK(view(driver).yaw == Approx(yaw));
    CHECK(view(driver).pitch == Approx(pitch));
    // The camera of the scene stays.
    CHECK(driver.ui.session.a.settings.camera == driver.ui.session.scene->camera);
}

TEST_CASE("Names do not overlap from outside; camera and lamp are always named") {
    for (const SmallWindow& window : small_windows) {
        Driver driver("lab-room.toml", window.size, window.text_scale);
        driver.hand.press('9');
        int vertices = 0;
        for (int triangle = 0; triangle < 30; ++triangle) {
            CAPTURE(window.size.x, window.text_scale, triangle);
            driver.ui.session.selection.triangle = triangle;
            if (triangle % 5 == 0) driver.hand.press(key::right, {.shift = true});
            driver.hand.leave();
            const std::vector<ScreenText> texts = outside_texts(driver);
            CHECK(crowded_texts(texts, driver.hand.find("canvas.outside")) == "");
            CHECK(has_text(texts, "camera"));
            CHECK(has_text(texts, "lamp"));
            for (const char* const name : {"[0]", "[1]", "[2]", "vertices[0]"})
                vertices += has_text(texts, name) ? 1 : 0;
        }
        CHECK(vertices > 45);
    }
}

TEST_CASE("The axes of all spaces are named, in a narrow view each space at its origin") {
    for (const ImVec2 window : {ImVec2(1600, 1000), ImVec2(1366, 768)}) {
        for (const CanvasShows shows : {CanvasShows::outside, CanvasShows::both}) {
            Driver driver("turned-block.toml", window);
            follow_link(driver.ui, "set:transform=matrices");
            follow_link(driver.ui, "triangle:28");
            driver.ui.session.canvas.shows = shows;
            driver.ui.session.canvas.outside.yaw = -0.6f;
            driver.ui.session.canvas.outside.pitch = -0.45f;
            driver.hand.leave();
            CAPTURE(window.x, static_cast<int>(shows));
            const std::vector<ScreenText> texts = outside_texts(driver);
            CHECK(crowded_texts(texts, driver.hand.find("canvas.outside")) == "");
            for (const char* const name : {"camera", "right", "down", "forward"}) {
                CAPTURE(name);
                CHECK(has_text(texts, name));
            }
            const bool is_narrow = has_text(texts, "world");
            int axes = 0;
            for (const std::string space : {"world ", "object "}) {
                for (const char* const axis : {"x", "y", "z"})
                    axes += has_text(texts, space + axis) ? 1 : 0;
            }
            if (is_narrow) {
                CHECK(has_text(texts, "object"));
                axes += static_cast<int>(
                    std::count_if(texts.begin(), texts.end(), [](const ScreenText& text) {
                        return text.words == "x" || text.words == "y" || text.words == "z";
                    }));
            }
            CHECK(axes >= 5);
        }
    }
}

TEST_CASE("The step about near and far shows both with their names") {
    for (const ImVec2 window : {ImVec2(1600, 1000), ImVec2(1366, 768)}) {
        Driver driver("lab-room.toml", window);
        open_lesson(driver.ui, "16-orthographic", 6);
        driver.hand.leave();
        const std::vector<ScreenText> texts = outside_texts(driver);
        for (const std::string plane : {"near", "far"}) {
            CAPTURE(window.x, plane);
            CHECK((has_text(texts, plane) || has_text(texts, plane + " plane")));
        }
    }
}

TEST_CASE("A scene in pixels has no outside") {
    Driver driver("one-triangle.toml");
    CHECK_FALSE(driver.hand.is_visible("canvas.shows.outside"));
    driver.hand.press('9');
    CHECK(driver.hand.is_visible("canvas"));
    CHECK_FALSE(driver.hand.is_visible("canvas.outside"));
    CHECK(driver.ui.session.notice.find("no camera") != std::string::npos);
    // Not even if a view says so.
    driver.ui.session.canvas.shows = CanvasShows::both;
    driver.hand.rest();
    CHECK(driver.hand.is_visible("canvas"));
    CHECK_FALSE(driver.hand.is_visible("canvas.outside"));
}

TEST_CASE("A drag turns the view from outside, and the wheel brings it nearer") {
    Driver driver;
    driver.hand.click("canvas.shows.outside");
    const OutsideView before = view(driver);
    CHECK(before.distance == 0.0f);
    driver.hand.drag("canvas.outside", 80.0f, 0.0f);
    CHECK(view(driver).yaw > before.yaw);
    CHECK(view(driver).pitch == Approx(before.pitch));
    CHECK(view(driver).distance > 0.0f);
    driver.hand.drag("canvas.outside", 0.0f, 40.0f);
    CHECK(view(driver).pitch < before.pitch);
    const float distance = view(driver).distance;
    const OutsideView turned = view(driver);
    driver.hand.wheel("canvas.outside", 2.0f);
    CHECK(view(driver).distance < distance);
    driver.hand.wheel("canvas.outside", -2.0f);
    CHECK(view(driver).distance == Approx(distance));
    driver.hand.drag("canvas.outside", 40.0f, 0.0f, {.shift = true});
    CHECK(view(driver).yaw == turned.yaw);
    CHECK_FALSE(view(driver).target == turned.target);
    CHECK_FALSE(driver.ui.session.selection.triangle);
    driver.hand.press('F');
    CHECK(view(driver).distance == 0.0f);
    CHECK(view(driver).yaw == turned.yaw);
    driver.hand.wheel("canvas.outside", 1.0f);
    driver.hand.click("canvas.fit");
    CHECK(view(driver).distance == 0.0f);
}

TEST_CASE("A drag with the right button turns the camera, from outside too") {
    Driver driver;
    driver.hand.click("canvas.shows.outside");
    driver.hand.drag("canvas.outside", 60.0f, 30.0f, {}, 1);
    CHECK(driver.ui.session.a.settings.camera.yaw > 0.0f);
    CHECK(driver.ui.session.a.settings.camera.pitch < 0.0f);
    CHECK(view(driver) == OutsideView());
}

TEST_CASE("A button or a double click looks through the camera, and back") {
    Driver driver;
    driver.hand.click("canvas.shows.outside");
    driver.hand.click("outside.camera");
    CHECK(view(driver).is_camera);
    driver.hand.click("outside.camera");
    CHECK_FALSE(view(driver).is_camera);
    driver.hand.double_click("canvas.outside");
    CHECK(view(driver).is_camera);
    const OutsideEye& eye = driver.ui.canvas.outside_drawing->eye();
    CHECK(glm::vec3(eye.position) == driver.ui.session.a.settings.camera.position);
    // What turns is the view, not the camera.
    driver.hand.drag("canvas.outside", 50.0f, 0.0f);
    CHECK_FALSE(view(driver).is_camera);
    CHECK(driver.ui.session.a.settings.camera == driver.ui.session.scene->camera);
}

TEST_CASE("A click from outside selects the triangle, or the pixel of the picture") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.hand.click("canvas.shows.both");
    const Scene& scene = *driver.ui.session.scene;
    // The back wall, above the blocks.
    click_at(driver, {0.7, -0.6, 1.0});
    const Selection& selection = driver.ui.session.selection;
    REQUIRE(selection.triangle);
    CHECK(part_name(scene, *selection.triangle) == "back wall");
    CHECK(driver.ui.results.a.triangle == selection.triangle);
    CHECK_FALSE(selection.pixel);
    const PicturePlane plane = driver.ui.canvas.outside_drawing->outside_scene().plane;
    click_at(driver, plane.place_of({60.5, 250.5}));
    REQUIRE(selection.pixel);
    CHECK(std::abs(selection.pixel->x - 60) <= 4);
    CHECK(std::abs(selection.pixel->y - 250) <= 4);
    CHECK(part_name(scene, *selection.triangle) == "left wall");
    // And the other way around: what is picked in the picture is lit outside.
    const std::uint64_t number = driver.ui.canvas.outside_drawing->number();
    driver.hand.click_picture(250, 30);
    CHECK(part_name(scene, *selection.triangle) == "ceiling");
    CHECK(driver.ui.canvas.outside_drawing->number() > number);
}

TEST_CASE("At rest the view from outside is neither drawn nor uploaded again") {
    Driver driver;
    driver.hand.click("canvas.shows.both");
    driver.hand.leave();
    const std::uint64_t number = driver.ui.canvas.outside_drawing->number();
    const int uploads = driver.textures.uploads;
    driver.hand.frames(5);
    CHECK(driver.ui.canvas.outside_drawing->number() == number);
    CHECK(driver.textures.uploads == uploads);
    CHECK_FALSE(is_animating(driver.ui));
}

TEST_CASE("The view from outside gives back its memory while it is not shown for long") {
    Driver driver;
    driver.hand.click("canvas.shows.both");
    driver.hand.leave();
    driver.hand.click("canvas.shows.picture");
    driver.hand.leave();
    driver.hand.frames(5, 1.0f);
    CHECK(driver.ui.canvas.outside_drawing != nullptr);
    driver.hand.frames(5, 10.0f);
    CHECK(driver.ui.canvas.outside_drawing == nullptr);
    // Shown again, it is drawn and uploaded again.
    const int uploads = driver.textures.uploads;
    driver.hand.click("canvas.shows.both");
    driver.hand.leave();
    driver.hand.rest();
    REQUIRE(driver.ui.canvas.outside_drawing != nullptr);
    CHECK(driver.ui.canvas.outside_drawing->number() == driver.ui.canvas.outside.number);
    CHECK(driver.textures.uploads > uploads);
}

TEST_CASE("A large scene is drawn from outside over several frames, and then rests") {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    set_scene(session, test::made_scene(60'000));
    Driver driver(std::move(session));
    driver.hand.press('8');
    driver.ui.session.canvas.outside.yaw = 0.3f;
    driver.hand.frames(1);
    CHECK(is_outside_working(driver.ui));
    CHECK(is_animating(driver.ui));
    driver.hand.frames(40);
    CHECK_FALSE(is_outside_working(driver.ui));
}

TEST_CASE("The view from outside says which triangles are still to come") {
    CHECK(coming_words(30, cursor_begin) == "faint: still to come, triangles[1] to triangles[29]");
    CHECK(coming_words(30, {22, Phase::rows, 3, 1}) ==
          "faint: still to come, triangles[23] to triangles[29]");
    CHECK(coming_words(30, {28, Phase::vertices, 0, 0}) == "faint: still to come, triangles[29]");
    CHECK(coming_words(30, {29, Phase::vertices, 0, 0}).empty());
    CHECK(coming_words(30, cursor_end).empty());
    CHECK(coming_words(0, cursor_begin).empty());
    // In a large scene none is darker.
    CHECK(coming_words(most_ordered + 1, cursor_begin).empty());
}

TEST_CASE("Links and another scene set what the canvas shows") {
    Driver driver;
    follow_link(driver.ui, "canvas:both");
    follow_link(driver.ui, "outside:0.5,-0.25");
    CHECK(shown(driver) == CanvasShows::both);
    CHECK(view(driver).yaw == 0.5f);
    CHECK(view(driver).pitch == -0.25f);
    follow_link(driver.ui, "outside:camera");
    CHECK(view(driver).is_camera);
    follow_link(driver.ui, "outside:0.5,-0.25,4,0,0,1");
    CHECK(view(driver).distance == 4.0f);
    set_scene(driver.ui.session, *driver.ui.session.scene);
    CHECK(view(driver).distance == 0.0f);
    CHECK(shown(driver) == CanvasShows::both);
}

TEST_CASE("The view from outside has its place in windows of every size") {
    Driver driver;
    for (const CanvasShows shows : {CanvasShows::outside, CanvasShows::both}) {
        driver.ui.session.canvas.shows = shows;
        for (const ImVec2 window : {ImVec2{320, 200}, ImVec2{640, 480}, ImVec2{800, 600},
                                    ImVec2{1024, 640}, ImVec2{2560, 1440}, ImVec2{500, 1400}}) {
            driver.resize(window);
            INFO(window.x << " x " << window.y);
            CHECK(driver.hand.is_visible("canvas.outside"));
            driver.hand.drag("canvas.outside", 9.0f, 5.0f);
            driver.hand.wheel("canvas.outside", 3.0f);
        }
    }
}

} // namespace rasterwalk
