#include <cmath>
#include <string>

#include "explain/vertex_spaces.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/shown_number.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

void open_chain(Driver& driver) {
    set_from_text(driver.ui.session.a.settings, "transform=matrices");
    driver.ui.session.selection.triangle = 14;
    driver.ui.session.selection.vertex = 1;
    driver.open("vertices");
    driver.hand.rest();
}

double at(const Driver& driver) {
    return driver.ui.inspector.chain.at;
}

} // namespace

TEST_CASE("Without matrices the Vertices tab has no figure of their chain") {
    Driver driver("turned-block.toml");
    driver.open("vertices");
    CHECK(driver.ui.widgets.count("chain.figure") == 0);
    open_chain(driver);
    CHECK(driver.ui.widgets.count("chain.figure") == 1);
}

TEST_CASE("A click on a space shows the figure there, with the four numbers of the vertex") {
    Driver driver("turned-block.toml");
    open_chain(driver);
    const SpacesOfVertex spaces =
        spaces_of_vertex(driver.ui.results.a.frame, 14, 1, MatrixOrder::row_vectors);
    REQUIRE(spaces.places.size() == space_names.size());
    for (std::size_t i = 0; i < space_names.size(); ++i) {
        const std::string space(space_names[i]);
        driver.hand.click("chain.space." + space);
        CHECK(at(driver) == static_cast<double>(i));
        CHECK(shown_text(driver, "chain.figure") == space);
        const glm::dvec4& place = spaces.places[i].place;
        const int digits = space == "window" ? 1 : 3;
        CHECK(shown_text(driver, "chain.numbers") ==
              "v1 in " + space + ": (" + fixed(place.x, digits) + ", " + fixed(place.y, digits) +
                  ", " + fixed(place.z, 3) + ", " + fixed(place.w, 3) + ")");
    }
}

TEST_CASE("The slider rests at spaces, names what is between, and changes nothing else") {
    Driver driver("turned-block.toml");
    open_chain(driver);
    driver.hand.find("chain.slider");
    const SessionInputs before = driver.ui.session;
    const int uploads = driver.textures.uploads;
    const std::uint64_t frame = driver.ui.results.a.frame_number;
    const WidgetPlace slider = driver.hand.find("chain.slider");
    const float step = (slider.bottom_right.x - slider.top_left.x - 16.0f) / 5.0f;
    // The middle is between camera and clip.
    driver.hand.click("chain.slider");
    CHECK(at(driver) == Approx(2.5).margin(0.02));
    CHECK(shown_text(driver, "chain.figure") == "camera → clip: Tp");
    driver.hand.drag("chain.slider", 1.5f * step, 0.0f);
    CHECK(at(driver) == 4.0);
    CHECK(shown_text(driver, "chain.figure") == "ndc");
    driver.hand.drag("chain.slider", 1.03f * step, 0.0f);
    CHECK(at(driver) == Approx(3.53).margin(0.03));
    CHECK(shown_text(driver, "chain.figure") == "clip → ndc: divide by w");
    driver.hand.drag("chain.slider", 100.0f * step, 0.0f);
    CHECK(at(driver) == 5.0);
    driver.hand.drag("chain.slider", -100.0f * step, 0.0f);
    CHECK(at(driver) == 0.0);
    CHECK(before == static_cast<const SessionInputs&>(driver.ui.session));
    CHECK(driver.ui.results.a.frame_number == frame);
    CHECK(driver.textures.uploads == uploads);
}

TEST_CASE("Edges with an end behind the camera are left out once it would be divided") {
    Driver driver("turned-block.toml");
    open_chain(driver);
    driver.ui.session.a.settings.camera.position = {0.0f, -0.6f, 0.2f};
    driver.ui.session.selection.triangle = 0;
    driver.hand.click("chain.space.camera");
    CHECK(driver.ui.widgets.count("chain.behind") == 0);
    driver.hand.click("chain.space.clip");
    CHECK(driver.ui.widgets.count("chain.behind") == 0);
    // At least one of the three is behind.
    for (int v = 0; v < 3; ++v) {
        driver.ui.session.selection.vertex = v;
        driver.hand.rest();
        CHECK(shown_text(driver, "chain.numbers").find(" in clip: (") != std::string::npos);
    }
    driver.hand.click("chain.space.ndc");
    CHECK(driver.ui.widgets.count("chain.behind") == 1);
    driver.hand.click("chain.whole_scene");
    CHECK(driver.ui.inspector.chain.chain.edges.size() == 5 + 3 * 18);
    driver.hand.click("chain.whole_scene");
    CHECK(driver.ui.inspector.chain.chain.edges.size() == 5);
}

} // namespace rasterwalk
