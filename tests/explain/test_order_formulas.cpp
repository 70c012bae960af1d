#include "explain/order_formulas.h"

#include <string>
#include <vector>

#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/formula_checks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Frame frame_of_room(const Scene& scene, const std::vector<std::string>& assignments) {
    Settings settings = default_settings(scene);
    set_from_text(settings, "stage=depth");
    for (const std::string& assignment : assignments)
        set_from_text(settings, assignment);
    return prepare_frame(scene, settings);
}

} // namespace

TEST_CASE("The formulas of a triangle's place give the numbers it was sorted by") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    CHECK(order_formulas(frame_of_room(scene, {}), 3).empty());
    for (const char* mix : {"projection_mix=0", "projection_mix=0.5", "projection_mix=1"}) {
        for (const char* hidden : {"hidden=painter", "hidden=bsp"}) {
            for (const char* rule : {"painter_rule=right", "painter_rule=nearest_corner"}) {
                const Frame frame = frame_of_room(scene, {mix, hidden, rule, "camera.yaw=0.3"});
                for (int t = 0; t < frame.triangle_count(); ++t) {
                    CAPTURE(mix, hidden, rule, t);
                    const std::vector<Formula> formulas = order_formulas(frame, t);
                    REQUIRE_FALSE(formulas.empty());
                    test::check_formulas(frame, formulas, "order");
                }
            }
        }
    }
}

TEST_CASE("The way to a triangle agrees with the sides its corners are on") {
    const Scene scene = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    const Frame frame = frame_of_room(scene, {"hidden=bsp", "camera.yaw=0.2"});
    const BspTree& tree = frame.list->divided->tree;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        CAPTURE(t);
        for (const OrderNode& node : order_nodes(frame, t)) {
            const BspPlane& plane = tree.nodes[static_cast<std::size_t>(node.node)].plane;
            for (int i = 0; i < triangle_corners; ++i) {
                const double d =
                    glm::dot(plane.normal, glm::dvec3(frame.scene->corner(t, i).position)) -
                    plane.offset;
                CHECK((node.is_front ? d : -d) > -1e-5);
            }
            const bool camera_in_front =
                glm::dot(plane.normal, glm::dvec3(frame.settings.camera.position)) > plane.offset;
            CHECK(node.is_near == (camera_in_front == node.is_front));
        }
    }
}
