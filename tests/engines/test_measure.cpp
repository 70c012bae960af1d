#include "engines/measure.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "engines/own_engines.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using rasterwalk::test::lab_room;

namespace {

const Viewport small_size{60, 40};

/// How a made peer draws wrongly.
struct Fault {
    int patch = 0;           ///< number of black pixels
    bool keeps_lamp = false; ///< the lamp is where it was in the first picture
};

/// A peer that draws as the steps do but for its fault, and says that a picture takes it 100 ms the
/// first time it is asked, 200 ms the second, and so on.
class MadePeer final : public TimedEngine {
  public:
    MadePeer(const PeerTask& task, const Fault& fault)
        : scene_(workload_scene(task.workload, lab_room())),
          steps_(steps_engine(scene_, workload_settings(task.workload, scene_, task.size))),
          fault_(fault) {}

    Milliseconds time_pictures(int, int count) override {
        const double each = ++asked_ * 100.0;
        return {each * count, each * count};
    }
    EnginePicture picture(int number) override {
        EnginePicture picture = steps_->picture(fault_.keeps_lamp ? 0 : number);
        std::fill_n(picture.colour.begin() + 20 * picture.size.width + 20, fault_.patch, 0U);
        return picture;
    }

  private:
    Scene scene_;
    std::unique_ptr<TimedEngine> steps_;
    Fault fault_;
    int asked_ = 0;
};

StartPeer made_peer(const Fault& fault = {}) {
    return [fault](const PeerTask& task) {
        return Peer{"a made one", std::make_unique<MadePeer>(task, fault)};
    };
}

MeasurePlan small_plan() {
    MeasurePlan plan;
    plan.workloads = {Workload::w1};
    plan.sizes = {small_size};
    plan.threads = {1};
    plan.levels = {simd_levels().front()};
    plan.round_milliseconds = 1.0;
    return plan;
}

const EngineResult& result_of(const Measurement& measurement, const std::string& engine) {
    const auto found =
        std::find_if(measurement.engines.begin(), measurement.engines.end(),
                     [&](const EngineResult& result) { return result.engine == engine; });
    REQUIRE(found != measurement.engines.end());
    return *found;
}

} // namespace

TEST_CASE("The median is the middle one, or the mean of the middle two") {
    CHECK(median({3.0}) == 3.0);
    CHECK(median({9.0, 1.0, 2.0}) == 2.0);
    CHECK(median({9.0, 1.0, 2.0, 4.0}) == 3.0);
}

TEST_CASE("Each engine has a median, and a ratio to the peer's if their pictures agree") {
    const std::vector<Measurement> all = measure_engines(small_plan(), lab_room(), made_peer(), {});
    REQUIRE(all.size() == 1);
    const Measurement& measurement = all.front();
    CHECK(measurement.peer == "a made one");
    CHECK(measurement.rounds == fewest_rounds);
    // Two times of the warm-up come first, then rounds 3 to 7.
    const EngineResult& peer = result_of(measurement, "llvmpipe");
    CHECK(peer.milliseconds == 500.0);
    CHECK_FALSE(peer.ratio);
    const EngineResult& steps = result_of(measurement, "steps");
    REQUIRE(steps.from_peer);
    CHECK(steps.from_peer->different == 0);
    REQUIRE(steps.ratio);
    CHECK(*steps.ratio == Approx(500.0 / steps.milliseconds));
    const EngineResult& student = result_of(measurement, "student");
    REQUIRE(student.from_peer);
    CHECK(student.from_peer->different > 0);
    CHECK_FALSE(student.ratio); // it rounds to whole pixels
    CHECK(student.from_steps == student.from_peer);
}

TEST_CASE("No engine has a ratio to a peer that draws a wrong patch") {
    const std::vector<Measurement> all =
        measure_engines(small_plan(), lab_room(), made_peer({.patch = 20}), {});
    REQUIRE(all.size() == 1);
    for (const EngineResult& result : all.front().engines)
        CHECK_FALSE(result.ratio);
    const EngineResult& steps = result_of(all.front(), "steps");
    REQUIRE(steps.from_peer);
    CHECK(steps.from_peer->different == 20);
    CHECK(steps.from_peer->first == glm::ivec2(20, 20));
    CHECK(result_of(all.front(), "llvmpipe").from_steps == steps.from_peer);
}

TEST_CASE("No engine has a ratio to a peer that ignores where the lamp is") {
    const std::vector<Measurement> all =
        measure_engines(small_plan(), lab_room(), made_peer({.keeps_lamp = true}), {});
    REQUIRE(all.size() == 1);
    for (const EngineResult& result : all.front().engines)
        CHECK_FALSE(result.ratio);
}

TEST_CASE("On two threads only engines that can use them are measured") {
    MeasurePlan plan = small_plan();
    plan.threads = {2};
    const std::vector<Measurement> all = measure_engines(plan, lab_room(), made_peer(), {});
    REQUIRE(all.size() == 1);
    std::vector<std::string> names;
    for (const EngineResult& result : all.front().engines)
        names.push_back(result.engine);
    CHECK(names == std::vector<std::string>{"fast " + std::string(word_of(simd_levels().front())),
                                            "llvmpipe"});
}

TEST_CASE("A stopped measurement returns the rounds that all engines completed") {
    MeasurePlan plan = small_plan();
    plan.rounds = 50;
    plan.sizes = {small_size, small_size};
    int round = 0;
    const MeasureWatch watch{[&] { return round == 4; },
                             [&](const std::string& words) {
                                 if (words.find("round") != std::string::npos) ++round;
                             }};
    const std::vector<Measurement> all = measure_engines(plan, lab_room(), made_peer(), watch);
    REQUIRE(all.size() == 1);
    CHECK(all.front().rounds == 3);
    CHECK(result_of(all.front(), "llvmpipe").milliseconds == 400.0); // of 300, 400 and 500
    CHECK(measure_engines(plan, lab_room(), made_peer(), {[] { return true; }, {}}).empty());
}

TEST_CASE("The peer's complaint is passed on") {
    const StartPeer missing = [](const PeerTask&) -> Peer { throw AccessError("it is missing."); };
    CHECK_THROWS_AS(measure_engines(small_plan(), lab_room(), missing, {}), AccessError);
}
