#include "pipeline/shadow_pass.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// The report that a test makes for itself, of the picked pixel.
FragmentReport report_on_picked(const Driver& driver) {
    const Frame& frame = driver.ui.results.a.frame;
    const auto cursor =
        fragment_on_pixel(frame, *driver.ui.session.selection.pixel, driver.ui.results.a.cursor);
    REQUIRE(cursor);
    const auto report = fragment_report(frame, *cursor);
    REQUIRE(report);
    return *report;
}

double value_of(const FragmentReport& report, const std::string& id) {
    const Formula* const formula = find_formula(report.formulas, id);
    REQUIRE(formula != nullptr);
    return static_cast<double>(formula->result.value);
}

} // namespace

TEST_CASE("The values of a clicked pixel are those of the report, right and wrong side by side") {
    Driver driver;
    driver.open("fragment");
    driver.hand.click_picture(398, 121);
    const FragmentReport report = report_on_picked(driver);
    for (const std::string quantity : {"z", "x", "y", "z_world"}) {
        for (const std::string way : {".affine", ".perspective", ".off"}) {
            const std::string id = quantity + way;
            INFO(id);
            CHECK(number_in(shown_text(driver, "fragment." + id)) ==
                  Approx(value_of(report, id)).margin(0.000051));
            driver.hand.click("fragment." + id);
            CHECK(driver.ui.inspector.chosen.fragment_number == id);
            CHECK(shown_text(driver, "fragment.formula.result") ==
                  shown(find_formula(report.formulas, id)->result));
        }
    }
    CHECK(value_of(report, "z_world.off") > 0.1);
}

TEST_CASE("The colours of a pixel's samples are found from the resolved colour") {
    Driver driver;
    driver.open("fragment");
    driver.hand.click_picture(398, 121);
    CHECK_FALSE(driver.hand.is_visible("fragment.resolve.red"));
    for (const char* assignment : {"coverage=edge_functions", "supersample=2"})
        set_from_text(driver.ui.session.a.settings, assignment);
    driver.hand.leave();
    CHECK(driver.hand.is_visible("fragment.supersampled"));
    driver.hand.click("fragment.resolve.red");
    CHECK(driver.ui.inspector.chosen.fragment_number == "resolve.red");
    CHECK(number_in(shown_text(driver, "fragment.formula.result")) ==
          Approx(value_of(report_on_picked(driver), "resolve.red")).margin(0.00051));
}

TEST_CASE("The way in force is marked, and the switch changes it but not the numbers") {
    Driver driver;
    driver.open("fragment");
    driver.hand.click_picture(398, 121);
    const std::string affine = shown_text(driver, "fragment.z_world.affine");
    const std::string right = shown_text(driver, "fragment.z_world.perspective");
    CHECK(affine != right);
    driver.hand.click("switch.perspective");
    CHECK(driver.ui.results.a.inspected.fragment->interpolation == Interpolation::affine);
    CHECK(shown_text(driver, "fragment.z_world.affine") == affine);
    CHECK(shown_text(driver, "fragment.z_world.perspective") == right);
}

TEST_CASE("The light term by term is that of the report, of the lighting in force and the other") {
    Driver driver;
    driver.open("fragment");
    driver.hand.click_picture(398, 121);
    const FragmentReport report = report_on_picked(driver);
    for (const std::string id : {"pixel_light.r2", "pixel_light.cosine", "pixel_light.area",
                                 "pixel_light.D.red", "pixel_light.R.red", "pixel_light.R.blue"}) {
        INFO(id);
        const Formula* const formula = find_formula(report.formulas, id);
        REQUIRE(formula != nullptr);
        CHECK(shown_text(driver, "fragment." + id) == shown(formula->result));
    }
    driver.hand.click("fragment.light.per_vertex");
    CHECK_FALSE(driver.hand.is_visible("fragment.pixel_light.r2"));
    const std::string light = shown_text(driver, "fragment.vertex_light.v1.red");
    CHECK(light == shown({report.at_vertex[1].reflected.r}));
    // Its source is the vertex, which has the same number.
    driver.hand.click("fragment.vertex_light.v1.red");
    CHECK(driver.ui.session.tab == "vertices");
    CHECK(driver.ui.session.selection.vertex == 1);
    CHECK(driver.ui.inspector.chosen.vertex_number == "light.R.red");
    CHECK(shown_text(driver, "vertices.formula.result") == light);
}

TEST_CASE("The panel follows the cursor again when the picked pixel is let go") {
    Driver driver;
    driver.open("fragment");
    driver.hand.click_picture(398, 121);
    driver.ui.session.cursor = *parse_cursor("t20/r5/c3");
    driver.hand.frames(2);
    CHECK(driver.ui.results.a.inspected.fragment->pixel == glm::ivec2(398, 121));
    driver.hand.click("fragment.follow");
    CHECK_FALSE(driver.ui.session.selection.pixel);
    CHECK(driver.ui.results.a.inspected.fragment->cursor.triangle == 20);
    driver.hand.click_picture(398, 121);
    driver.hand.click("fragment.go");
    CHECK(driver.ui.results.a.done == driver.ui.results.a.inspected.fragment->cursor);
}

TEST_CASE("Where there is no fragment the panel says why") {
    Driver driver;
    driver.open("fragment");
    driver.hand.click_picture(0, 250);
    CHECK(driver.hand.is_visible("fragment.none"));
    driver.hand.click("stage.edges");
    driver.hand.click("fragment.fill");
    CHECK(driver.ui.session.a.settings.stage == Stage::fill);
}

TEST_CASE("With a shadow map its faces are shown, and a click leads to the end of a pass") {
    Driver driver;
    follow_link(driver.ui, "set:stage=pixel_light&shadows=rays");
    follow_link(driver.ui, "tab:fragment");
    follow_link(driver.ui, "pixel:410,449");
    driver.hand.rest();
    CHECK(driver.ui.widgets.count("fragment.shadow.face.0") == 0);
    for (int face = 0; face < shadow_face_count; ++face) {
        follow_link(driver.ui, "set:shadows=map");
        follow_link(driver.ui, "pixel:410,449");
        driver.hand.rest();
        INFO("face " << face);
        driver.hand.click("fragment.shadow.face." + std::to_string(face));
        driver.hand.rest();
        CHECK(driver.ui.session.cursor == in_pass(cursor_end, pass_of_face(face)));
        driver.ui.session.cursor = cursor_end;
        driver.hand.rest();
    }
}

} // namespace rasterwalk
