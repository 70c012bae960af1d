#include "engines/workload.h"

#include <set>

#include "base/error.h"
#include "engines/llvmpipe_peer.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("The lamp has a different place in every picture, and is never far away") {
    const glm::vec3 at(0.0f, -0.5f, -0.7f);
    CHECK(lamp_in_picture(at, 0) == at);
    std::set<float> places;
    for (int number = 0; number < 500; ++number) {
        const glm::vec3 lamp = lamp_in_picture(at, number);
        places.insert(lamp.x);
        CHECK(std::abs(lamp.x - at.x) <= 0.02f);
        CHECK(lamp.y == at.y);
        CHECK(lamp.z == at.z);
    }
    CHECK(places.size() > 450);
}

TEST_CASE(
    "The first workload is the lab's room with a brighter lamp, and the others are the knot") {
    const Scene room = read_scene(lessons_folder() + '/' + std::string(usual_scene));
    Scene lit = room;
    lit.light.power = glm::vec3(14.0f);
    CHECK(workload_scene(Workload::w1, room) == lit);
    CHECK(workload_scene(Workload::w2, room).triangle_count() == 200'000);
    const Settings settings = workload_settings(Workload::w3, lit, {640, 360});
    CHECK(settings.shading == Shading::gouraud);
    CHECK(settings.viewport == Viewport{640, 360});
    CHECK(settings.camera.focal_length == 360.0f);
    CHECK(workload_settings(Workload::w1, lit, {640, 360}).shading == Shading::phong);
}

TEST_CASE("The peer reads its task just as it is written") {
    const PeerTask task{Workload::w2, {640, 360}, 2};
    const std::vector<std::string> words = peer_arguments(task);
    CHECK(words == std::vector<std::string>{"w2", "640x360", "2"});
    const PeerTask read = parse_peer_arguments(words);
    CHECK(read.workload == task.workload);
    CHECK(read.size == task.size);
    CHECK(read.threads == task.threads);
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{},
                                                  {"w2"},
                                                  {"w4", "5x5", "1"},
                                                  {"w1", "5", "1"},
                                                  {"w1", "5x5", "3"},
                                                  {"w1", "5x5", "0"},
                                                  {"w1", "5x5", "1", "1"}})
        CHECK_THROWS_AS(parse_peer_arguments(wrong), UsageError);
}
