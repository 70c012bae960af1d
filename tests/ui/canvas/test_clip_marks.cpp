// The marks of clipping on the picture and from outside.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "inspect/cut_corners.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/actions/lesson_links.h"
#include "ui/canvas/canvas_marks.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// The left wall of the corridor is triangle 5, C G E: it begins behind the camera.
constexpr const char* wall = "triangle:5";

Driver& with_clip(Driver& driver, const std::string& clip) {
    follow_link(driver.ui, "set:clip=" + clip);
    follow_link(driver.ui, wall);
    driver.hand.rest();
    return driver;
}

/// How often a word is alone on the canvas.
int count_on_canvas(const std::string& word) {
    const std::vector<ScreenText> texts = screen_text();
    return static_cast<int>(std::count_if(texts.begin(), texts.end(), [&](const ScreenText& text) {
        return text.window == "canvas" && text.words == word;
    }));
}

/// The corners of all that is marked on the picture.
std::vector<ImDrawVert> clip_marks(Driver& driver) {
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    list.PushClipRectFullScreen();
    draw_canvas_marks(driver.ui, run_a(driver.ui), &list, {-9999, -9999}, {9999, 9999});
    return {list.VtxBuffer.begin(), list.VtxBuffer.end()};
}

/// The names of corners that are marked on the canvas.
std::vector<CanvasLabel> corner_labels(Driver& driver) {
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    list.PushClipRectFullScreen();
    const WidgetPlace& canvas = driver.ui.widgets.at("canvas");
    return draw_canvas_marks(driver.ui, run_a(driver.ui), &list, canvas.top_left,
                             canvas.bottom_right);
}

} // namespace

TEST_CASE("New corners are marked on the picture with the names of their planes") {
    Driver driver("corridor.toml");
    with_clip(driver, "all");
    const ClipHistory& history = *driver.ui.results.a.inspected.clip;
    const std::vector<CutCorner> corners = corners_before(history);
    REQUIRE(corners.size() >= 4);
    int made = 0;
    for (const CutCorner& corner : corners) {
        if (!corner.is_new()) continue;
        ++made;
        CAPTURE(std::string(word_of(corner.plane)));
        CHECK(count_on_canvas(std::string(word_of(corner.plane))) >= 1);
    }
    CHECK(made >= 2);
    // Without a selection nothing of it is marked.
    follow_link(driver.ui, "triangle:none");
    driver.hand.rest();
    for (const CutCorner& corner : corners)
        CHECK((!corner.is_new() || count_on_canvas(std::string(word_of(corner.plane))) == 0));
}

TEST_CASE("The corners of a cut triangle are named in order, and no two names overlap") {
    int named = 0, made = 0;
    for (const ImVec2 window : {ImVec2(1600, 1000), ImVec2(1024, 640)}) {
        for (const int triangle : {0, 1, 5, 9}) {
            Driver driver("corridor.toml", window);
            // A picture so small that pixels are large enough for the names of all corners.
            for (const char* set : {"clip=all", "viewport.size=40x32", "camera.focal_length=32"})
                follow_link(driver.ui, std::string("set:") + set);
            follow_link(driver.ui, "triangle:" + std::to_string(triangle));
            driver.ui.session.canvas.row_table = false;
            driver.hand.press('F');
            driver.hand.leave();
            CAPTURE(window.x, triangle);
            const std::vector<CutCorner> corners =
                corners_before(*driver.ui.results.a.inspected.clip);
            const std::vector<CanvasLabel> labels = corner_labels(driver);
            int last = -1;
            for (const CanvasLabel& label : labels) {
                CAPTURE(label.name);
                const auto is_named = [&](const CutCorner& one) {
                    return label.name == short_corner_name(one) ||
                           label.name.starts_with(corner_name(one));
                };
                // Starting at the first corner, as the edges go.
                const auto found =
                    std::find_if(corners.begin() + last + 1, corners.end(), is_named);
                REQUIRE(found != corners.end());
                last = static_cast<int>(found - corners.begin());
                const CutCorner& corner = *found;
                const bool is_short = label.name == short_corner_name(corner);
                if (corner.is_new() && !is_short)
                    CHECK(label.name.ends_with(", " + std::string(word_of(corner.plane))));
                CHECK(count_on_canvas(label.name) == 1);
                for (const CanvasLabel& other : labels) {
                    if (&other == &label) break;
                    const bool is_apart =
                        label.high.x <= other.low.x || other.high.x <= label.low.x ||
                        label.high.y <= other.low.y || other.high.y <= label.low.y;
                    CHECK(is_apart);
                }
                ++named;
                made += corner.is_new() ? 1 : 0;
            }
        }
    }
    CHECK(named > 12);
    CHECK(made > 6);
}

TEST_CASE("The outline before the cut reaches beyond the picture's border") {
    Driver driver("corridor.toml");
    with_clip(driver, "leave_out");
    const auto beyond = [&] {
        const PicturePlace& place = driver.ui.canvas.place;
        const std::vector<ImDrawVert> marks = clip_marks(driver);
        return std::count_if(marks.begin(), marks.end(), [&](const ImDrawVert& corner) {
            return corner.pos.x < place.origin.x - 20.0f;
        });
    };
    CHECK(beyond() == 0);
    with_clip(driver, "all");
    CHECK(beyond() > 0);
    for (const ImDrawVert& corner : clip_marks(driver)) {
        CHECK(std::isfinite(corner.pos.x));
        CHECK(std::abs(corner.pos.x) < 2e4f);
        CHECK(std::abs(corner.pos.y) < 2e4f);
    }
}

TEST_CASE("The default picture has no mark of clipping") {
    Driver driver;
    follow_link(driver.ui, "triangle:12");
    driver.hand.rest();
    const std::size_t with = clip_marks(driver).size();
    ShownRun run = run_a(driver.ui);
    REQUIRE(run.clip != nullptr);
    run.clip = nullptr;
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    list.PushClipRectFullScreen();
    draw_canvas_marks(driver.ui, run, &list, {-9999, -9999}, {9999, 9999});
    CHECK(static_cast<std::size_t>(list.VtxBuffer.Size) == with);
}

TEST_CASE("While planes are at work no edge of the polygon is drawn yet") {
    Driver driver("corridor.toml");
    with_clip(driver, "all");
    const ClipHistory history = *driver.ui.results.a.inspected.clip;
    const auto first = static_cast<int>(history.planes[0].plane);
    const std::string word(word_of(history.planes[0].plane));
    // The corner appears with the step that makes it.
    for (std::size_t s = 0; s < history.planes[0].steps.size(); ++s) {
        const std::string moment = "cursor:t5/p" + std::to_string(first) + "/s" + std::to_string(s);
        CAPTURE(moment);
        follow_link(driver.ui, moment);
        driver.hand.rest();
        const std::optional<ClipProgress> progress =
            clip_progress(history, driver.ui.results.a.done);
        CHECK((s == 0 || progress));
        if (!progress) continue;
        CHECK(progress->steps == static_cast<int>(s));
        for (const ImDrawVert& corner : clip_marks(driver))
            CHECK(std::isfinite(corner.pos.x));
    }
}

TEST_CASE("During clipping the picture shows where dividing would put a corner behind the camera") {
    Driver driver;
    driver.hand.rest();
    Settings& settings = driver.ui.session.a.settings;
    settings.clip = Clip::near;
    settings.camera.position.z = -0.5f;
    follow_link(driver.ui, "triangle:1");
    driver.ui.session.canvas.zoom = 0.25f; // shows what is far outside the picture, too
    driver.hand.rest();
    const ClipHistory history = *driver.ui.results.a.inspected.clip;
    REQUIRE(history.planes.size() == 1);
    const std::vector<CutCorner> behind = corners_behind_camera(history);
    REQUIRE(behind.size() == 1);
    CHECK(behind[0].vertex_index == 2);
    // By hand: f x / z from the middle, with z negative: mirrored to the other side.
    const glm::vec3 place =
        driver.ui.results.a.scene->corner(1, 2).position - settings.camera.position;
    REQUIRE(place.z < 0.0f);
    const float f = settings.camera.focal_length;
    const glm::vec2 divided{f * place.x / place.z + 250.0f, f * place.y / place.z + 250.0f};
    const glm::vec4& clip = behind[0].vertex.position_clip;
    CHECK(clip.x / clip.w + 250.0f == Approx(divided.x).margin(0.01));
    CHECK(clip.y / clip.w + 250.0f == Approx(divided.y).margin(0.01));
    const auto says = [] {
        const std::vector<ScreenText> texts = screen_text();
        return std::any_of(texts.begin(), texts.end(), [](const ScreenText& text) {
            return text.window == "canvas" && text.words == "dividing puts v2 here";
        });
    };
    CHECK_FALSE(says());
    follow_link(driver.ui, "cursor:t1/p0/s1");
    driver.hand.rest();
    REQUIRE(clip_progress(history, driver.ui.results.a.done));
    CHECK(says());
    follow_link(driver.ui, "cursor:end");
    driver.hand.rest();
    CHECK_FALSE(says());
}

TEST_CASE("The cull step says on the picture which side it takes the triangle for") {
    Driver driver("corridor.toml");
    with_clip(driver, "all");
    follow_link(driver.ui, "set:cull=screen_area");
    driver.hand.rest();
    CHECK(count_on_canvas("front") + count_on_canvas("back") == 0);
    follow_link(driver.ui, "cursor:t5/k");
    driver.hand.rest();
    driver.hand.press('.');
    const bool is_back = driver.ui.results.a.inspected.clip->cull.is_back;
    CHECK(count_on_canvas(is_back ? "back" : "front") == 1);
}

TEST_CASE("From outside the plane that cuts is named, and others can be looked at") {
    Driver driver("corridor.toml");
    follow_link(driver.ui, "canvas:outside");
    with_clip(driver, "leave_out");
    driver.open("clip");
    CHECK_FALSE(shows_words("near plane", "canvas"));
    CHECK_FALSE(shows_words("dividing puts it here", "canvas"));
    with_clip(driver, "near");
    CHECK(shows_words("near plane", "canvas"));
    with_clip(driver, "all");
    CHECK(shows_words("near plane", "canvas"));
    with_clip(driver, "none");
    CHECK_FALSE(shows_words("near plane", "canvas"));
}

} // namespace rasterwalk
