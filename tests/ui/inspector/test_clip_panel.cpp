#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "explain/clip_report.h"
#include "explain/cull_formulas.h"
#include "inspect/stats.h"
#include "tests/support/catch.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/lesson_links.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// The floor of the corridor, which begins behind the camera, in the Clip tab.
struct Corridor {
    Driver driver{"corridor.toml"};

    explicit Corridor(const std::string& clip = "all", int triangle = 0) {
        follow_link(driver.ui, "set:clip=" + clip);
        follow_link(driver.ui, "triangle:" + std::to_string(triangle));
        driver.hand.rest();
        driver.open("clip");
    }
    const ClipHistory& history() const { return *driver.ui.results.a.inspected.clip; }
};

/// All text in the inspector.
std::string inspector_words() {
    std::string words;
    for (const ScreenText& text : screen_text(8.0f)) {
        if (text.window.starts_with("inspector")) words += text.words + " ";
    }
    return words;
}

/// z of a vertex of the scene: the camera of the corridor is at the origin and is not turned.
double depth_of(const Driver& driver, int vertex) {
    return static_cast<double>(driver.ui.session.scene->corner(0, vertex).position.z);
}

} // namespace

TEST_CASE("The Clip tab is offered where there is a camera") {
    {
        Driver driver("one-triangle.toml");
        driver.hand.click("group.triangle");
        CHECK_FALSE(driver.hand.is_visible("tab.clip"));
        driver.ui.session.tab = "clip"; // as a file of the student's may say
        driver.hand.rest();
        CHECK_THAT(inspector_words(), Catch::Matchers::ContainsSubstring("no camera"));
    }
    Driver driver;
    driver.hand.click("group.triangle");
    CHECK(driver.hand.is_visible("tab.clip"));
}

TEST_CASE("Where nothing is cut the tab says so, and a button cuts by all planes") {
    Driver driver;
    driver.open("clip");
    REQUIRE(driver.ui.session.a.settings.clip == Clip::leave_out);
    CHECK_THAT(inspector_words(), Catch::Matchers::ContainsSubstring("as in the lab"));
    CHECK_FALSE(driver.hand.is_visible("clip.plane.near"));
    CHECK_FALSE(driver.hand.is_visible("clip.behind"));
    driver.hand.click("clip.cut_all");
    CHECK(driver.ui.session.a.settings.clip == Clip::all);
    CHECK(driver.hand.is_visible("clip.plane.near"));
    CHECK_FALSE(driver.hand.is_visible("clip.cut_all"));
    driver.hand.press('Z', {.ctrl = true});
    CHECK(driver.ui.session.a.settings.clip == Clip::leave_out);
}

TEST_CASE("A triangle that reaches behind the camera is explained, whatever becomes of it") {
    for (const auto& [clip, said] :
         {std::pair{"leave_out", "left out"}, {"none", "drawn now"}, {"near", "cut off"}}) {
        CAPTURE(clip);
        Corridor corridor(clip);
        CHECK(corridor.driver.hand.is_visible("clip.behind"));
        const std::string words = inspector_words();
        CHECK_THAT(words, Catch::Matchers::ContainsSubstring("inside out"));
        CHECK_THAT(words, Catch::Matchers::ContainsSubstring("w = −2"));
        // -160 / -2 and 160 / -2 from the middle of 200 x 160 pixels.
        CHECK_THAT(words, Catch::Matchers::ContainsSubstring("(180, 0)"));
        CHECK_THAT(words, Catch::Matchers::ContainsSubstring(said));
    }
}

TEST_CASE("The near plane cuts each edge where the depths say") {
    Corridor corridor("near");
    Driver& driver = corridor.driver;
    int cut = 0;
    for (int e = 0; e < 3; ++e) {
        const double from = depth_of(driver, e), to = depth_of(driver, (e + 1) % 3);
        const std::string place = "0." + std::to_string(e);
        CAPTURE(place);
        const std::string begin = shown_text(driver, "clip.d." + place + ".from");
        CHECK(number_in(begin) == Approx(from - 0.1).margin(0.00051));
        CHECK(begin.ends_with(from >= 0.1 ? " in" : " out"));
        CHECK(number_in(shown_text(driver, "clip.d." + place + ".to")) ==
              Approx(to - 0.1).margin(0.00051));
        if ((from >= 0.1) == (to >= 0.1)) {
            CHECK(driver.ui.widgets.count("clip.t." + place) == 0);
            continue;
        }
        ++cut;
        // From the corner inside, whichever way the edge runs.
        const double inside = std::max(from, to), outside = std::min(from, to);
        CHECK(number_in(shown_text(driver, "clip.t." + place)) ==
              Approx((inside - 0.1) / (inside - outside)).margin(0.000051));
    }
    CHECK(cut == 2);
}

TEST_CASE("The new corners lie on the edges, with all that they carry") {
    Corridor corridor("near");
    Driver& driver = corridor.driver;
    follow_link(driver.ui, "set:stage=pixel_light"); // there the place in the world is carried
    driver.hand.rest();
    for (const CutCorner& corner : corners_before(corridor.history())) {
        if (!corner.is_new()) continue;
        const std::string name = "clip.new." + std::to_string(corner.new_index);
        CAPTURE(name);
        CHECK(number_in(shown_text(driver, name + ".w")) == Approx(0.1).margin(0.00051));
        // In the world the camera's depth is z.
        const int place = varying_index(&Varyings::position_world);
        CHECK(number_in(shown_text(driver, fmt::format("{}.{}.2", name, place))) ==
              Approx(0.1).margin(0.00051));
        CHECK(number_in(shown_text(driver, fmt::format("{}.{}.1", name, place))) ==
              Approx(1.0).margin(0.00051));
    }
}

TEST_CASE("Every number of clipping leads back to the scene, a click at a time") {
    Corridor corridor("near");
    Driver& driver = corridor.driver;
    driver.hand.click("clip.t.0.0");
    CHECK(driver.ui.inspector.clip.number == "t.0.0");
    CHECK(number_in(shown_text(driver, "clip.formula.result")) ==
          Approx(number_in(shown_text(driver, "clip.t.0.0"))).margin(0.000051));
    driver.hand.click("clip.formula.d_in");
    CHECK(driver.ui.inspector.clip.number == "d.0.1");
    driver.hand.click("clip.formula.w");
    CHECK(driver.ui.inspector.clip.number == "corner.1.w");
    driver.hand.click("clip.formula.z_camera");
    CHECK(driver.ui.session.tab == "vertices");
    CHECK(driver.ui.session.selection.vertex == 1);
    CHECK(driver.ui.inspector.chosen.vertex_number == "rotated.z");
    driver.open("clip");
    driver.hand.click("clip.new.0.x");
    CHECK(shown_text(driver, "clip.formula.result") ==
          shown({corridor.history().planes[0].steps[0].cut.position_clip.x}));
    driver.hand.click("clip.formula.t");
    CHECK(driver.ui.inspector.clip.number == "t.0.0");
    driver.hand.click("clip.d.0.0.from");
    driver.hand.click("clip.formula.near");
    CHECK(driver.ui.session.tab == "settings");
    CHECK(driver.hand.is_visible("setting.near"));
}

TEST_CASE("Only planes that have work are open, and a click opens and closes one") {
    Corridor corridor;
    Driver& driver = corridor.driver;
    REQUIRE(corridor.history().planes.size() >= 2);
    for (std::size_t p = 0; p < clip_plane_count; ++p) {
        const auto plane = static_cast<ClipPlane>(p);
        const bool has_work = work_of(corridor.history(), plane) != nullptr;
        const std::string first_edge = "clip.edge." + std::to_string(p) + ".0";
        const std::string name = "clip.plane." + std::string(word_of(plane));
        CAPTURE(name);
        CHECK((driver.ui.widgets.count(first_edge) == 1) == has_work);
        driver.hand.click(name);
        CHECK((driver.ui.widgets.count(first_edge) == 1) == !has_work);
        if (!has_work) CHECK(driver.ui.inspector.clip.plane == plane);
        driver.hand.click(name);
        CHECK((driver.ui.widgets.count(first_edge) == 1) == has_work);
    }
}

TEST_CASE("The outcodes have a bit for each plane and corner, and lead to its distance") {
    Corridor corridor;
    Driver& driver = corridor.driver;
    for (int v = 0; v < 3; ++v) {
        const double z = depth_of(driver, v);
        const glm::vec3 place = driver.ui.session.scene->corner(0, v).position;
        const double x = 160.0 * static_cast<double>(place.x),
                     y = 160.0 * static_cast<double>(place.y);
        // The picture has 200 x 160 pixels.
        const bool beyond[] = {z<0.1, z> 100.0, x + 100.0 * z < 0.0, 100.0 * z < x,
                               y + 80.0 * z < 0.0, 80.0 * z < y};
        for (int p = 0; p < 6; ++p) {
            const std::string name = fmt::format("clip.code.{}.{}", p, v);
            CAPTURE(name);
            CHECK(shown_text(driver, name) == (beyond[p] ? "1" : "0"));
            driver.hand.click(name);
            CHECK((number_in(shown_text(driver, "clip.formula.result")) < 0.0) == beyond[p]);
        }
    }
}

TEST_CASE("The polygon that remains has the pixels that are drawn") {
    Corridor corridor("all", 1); // one of its vertices is behind the camera
    Driver& driver = corridor.driver;
    const auto pixels = driver.ui.results.a.frame.triangle_vertices(1);
    REQUIRE(pixels.size() > 3);
    for (std::size_t c = 0; c < pixels.size(); ++c) {
        const std::string name = "clip.pixel." + std::to_string(c);
        CHECK(number_in(shown_text(driver, name + ".column")) == pixels[c].column);
        CHECK(number_in(shown_text(driver, name + ".row")) == pixels[c].row);
    }
    driver.hand.click("clip.pixel.1.row");
    CHECK(number_in(shown_text(driver, "clip.formula.result")) == pixels[1].row);
    CHECK_THAT(inspector_words(),
               Catch::Matchers::ContainsSubstring(
                   fmt::format("{} corners make {} triangles", pixels.size(), pixels.size() - 2)));
}

TEST_CASE("Each way of culling says what it takes the triangle for, and which is in force") {
    Corridor corridor("near");
    Driver& driver = corridor.driver;
    for (const Cull way : {Cull::face_normal, Cull::screen_area, Cull::vertex_normals}) {
        follow_link(driver.ui, "set:cull=" + std::string(word_of(way)));
        driver.hand.rest();
        const std::string name = "clip.cull." + std::string(word_of(way));
        CAPTURE(name);
        driver.hand.click(name);
        const auto answers = cull_answers(driver.ui.results.a.frame, corridor.history());
        const auto answer = std::find_if(answers.begin(), answers.end(),
                                         [&](const CullAnswer& a) { return a.rule == way; });
        REQUIRE(answer != answers.end());
        CHECK(shown_text(driver, "clip.formula.result") == shown({answer->measure}));
        const bool is_culled = driver.ui.results.a.frame.rejection(0) == Rejection::back_facing;
        CHECK(is_culled == answer->is_back);
        driver.hand.find("clip.culling");
        CHECK_THAT(inspector_words(), Catch::Matchers::ContainsSubstring(
                                          is_culled ? "It is left out." : "It is drawn."));
    }
}

TEST_CASE("The counters of clipping are those of the frame") {
    for (const char* set : {"clip=all", "cull=screen_area", "reject=outcodes"}) {
        CAPTURE(set);
        Corridor corridor("near");
        Driver& driver = corridor.driver;
        driver.ui.session.a.settings.camera.yaw = 0.6f;
        follow_link(driver.ui, std::string("set:") + set);
        driver.hand.rest();
        const FrameStats stats = frame_stats(driver.ui.results.a.frame);
        const auto count = [&](const char* name) {
            return number_in(shown_text(driver, std::string("clip.count.") + name));
        };
        CHECK(count("clipped") == stats.clipped);
        CHECK(count("clip_triangles") == stats.clip_triangles);
        CHECK(count("rejected") == stats.left_out.of(Rejection::outside));
        CHECK(count("culled") == stats.left_out.of(Rejection::back_facing));
        CHECK(count("fragments_outside") == static_cast<double>(stats.fragments_outside));
    }
}

TEST_CASE("The step at the cursor is explained, and a click on an edge goes to its step") {
    Corridor corridor("near");
    Driver& driver = corridor.driver;
    driver.hand.click("clip.edge.0.1");
    const std::optional<Cursor>& done = driver.ui.results.a.done;
    REQUIRE(done);
    CHECK(*done == Cursor{0, Phase::clip, 0, 1});
    CHECK(driver.ui.widgets.count("clip.formula.d_in") == 1);
    CHECK(shown_text(driver, "clip.formula.result") ==
          shown({corridor.history().planes[0].steps[1].t}));
    driver.hand.press(key::comma);
    CHECK(*done == Cursor{0, Phase::clip, 0, 0});
    driver.hand.press(key::period);
    driver.hand.press(key::period);
    CHECK(*done == Cursor{0, Phase::clip, 0, 2});
    // Its last edge is outside: there is its distance to be explained.
    CHECK(driver.ui.widgets.count("clip.formula.d_in") == 0);
    CHECK(number_in(shown_text(driver, "clip.formula.result")) == Approx(-2.1));
}

TEST_CASE("The Clip tab scrolls to the step at the cursor, forward and backward") {
    for (const SmallWindow& window : small_windows) {
        CAPTURE(window.size.x, window.size.y, window.text_scale);
        Driver driver("corridor.toml", window.size, window.text_scale);
        follow_link(driver.ui, "set:clip=all");
        follow_link(driver.ui, "triangle:1");
        driver.open("clip");
        const ClipHistory history = *driver.ui.results.a.inspected.clip;
        std::vector<Cursor> steps;
        for (const PlaneHistory& plane : history.planes) {
            for (const ClipStep& step : plane.steps)
                steps.push_back({1, Phase::clip, static_cast<int>(plane.plane), step.from});
        }
        REQUIRE(history.planes.size() >= 2);
        const auto edge_of = [](const Cursor& step) {
            return fmt::format("clip.edge.{}.{}", step.index, step.step);
        };
        const auto check_seen = [&](const Cursor& step) {
            const std::string edge = edge_of(step);
            CAPTURE(edge);
            REQUIRE(driver.ui.results.a.done == step);
            const auto found = driver.ui.widgets.find(edge);
            REQUIRE(found != driver.ui.widgets.end());
            CHECK(found->second.is_whole);
        };
        follow_link(driver.ui, fmt::format("cursor:t1/p{}/s0", steps.front().index));
        driver.hand.rest();
        for (const Cursor& step : steps) {
            driver.hand.press(key::period);
            driver.hand.rest();
            check_seen(step);
        }
        // Not because all of them have room at once.
        CHECK_FALSE(driver.hand.is_visible(edge_of(steps.front())));
        for (std::size_t i = steps.size() - 1; i-- > 0;) {
            driver.hand.press(key::comma);
            driver.hand.rest();
            check_seen(steps[i]);
        }
        CHECK_FALSE(driver.hand.is_visible(edge_of(steps.back())));
    }
}

TEST_CASE("Cheap clipping cuts nothing, and the Clip tab says what it leaves out") {
    Corridor corridor("leave_out", 2);
    Driver& driver = corridor.driver;
    driver.ui.session.a.settings.camera.position = {0.9f, 0.0f, 2.0f};
    driver.hand.rest();
    const auto outside = [&] {
        return number_in(shown_text(driver, "clip.count.fragments_outside"));
    };
    CHECK(outside() > 0.0);
    follow_link(driver.ui, "set:reject=cheap");
    driver.hand.rest();
    CHECK(outside() == 0.0);
    driver.hand.find("clip.verdict");
    CHECK_THAT(inspector_words(), Catch::Matchers::ContainsSubstring("cheap clipping"));
}

} // namespace rasterwalk
