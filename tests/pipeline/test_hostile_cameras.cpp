// The room from everywhere: inside walls, on vertices, in planes, through lenses of every length.
// Nothing may crash or hang, and a triangle may be left out only because of its place.

#include <cmath>
#include <string>
#include <vector>

#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "pipeline/replay.h"
#include "pipeline/timeline.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/effort.h"
#include "support/recorder.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr float quarter_turn = 1.57079633f;

/// A camera anywhere: at random, on a vertex, in the middle of a triangle, or a hair away.
Camera hostile_camera(const Scene& room, Random& random) {
    Camera camera;
    const auto corners = corners_of(room, random.integer(0, 29));
    switch (random.integer(0, 5)) {
    case 0:
        camera.position = {random.number(-1, 1), random.number(-1, 1), random.number(-1, 1)};
        break;
    case 1:
        camera.position = corners[static_cast<std::size_t>(random.integer(0, 2))].position;
        break;
    case 2:
        camera.position = (corners[0].position + corners[1].position + corners[2].position) / 3.0f;
        break;
    case 3:
        camera.position =
            corners[0].position + random.number(-1, 1) * std::pow(10.0f, random.number(-9, -1)) *
                                      glm::vec3(random.number(-1, 1), random.number(-1, 1), 1.0f);
        break;
    case 4:
        camera.position = {random.number(-3, 3), random.number(-3, 3), random.number(-5, 5)};
        break;
    default:
        camera.position = std::pow(10.0f, random.number(0, 30)) *
                          glm::vec3(random.number(-1, 1), random.number(-1, 1), -1.0f);
        break;
    }
    switch (random.integer(0, 3)) {
    case 0:
        break;
    case 1: // exactly along an axis, up to float precision
        camera.yaw = quarter_turn * static_cast<float>(random.integer(-4, 4));
        camera.pitch = quarter_turn * static_cast<float>(random.integer(-1, 1));
        break;
    default:
        camera.yaw = random.number(-100, 100);
        camera.pitch = random.number(-1.6, 1.6);
        break;
    }
    camera.focal_length =
        random.integer(0, 2) == 0 ? random.number(10, 1000) : std::pow(10.0f, random.number(-6, 6));
    return camera;
}

Settings hostile_settings(const Scene& room, int stage, Random& random) {
    Settings settings = default_settings(room);
    set_step(settings, stage_list()[static_cast<std::size_t>(stage)].step);
    settings.camera = hostile_camera(room, random);
    settings.viewport = {random.integer(1, 24), random.integer(1, 18)};
    // A few rules and mistakes at once, sometimes all of them.
    const int most = random.integer(0, 9) == 0 ? 1 : 3;
    for (const Setting& setting : setting_table()) {
        const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
        if (choice == nullptr || setting.name == "stage" || random.integer(0, most) > 0) continue;
        choice->write(settings, random.integer(0, static_cast<int>(choice->words.size()) - 1));
    }
    if (random.integer(0, 5) == 0) settings.depth_clear = random.number(-2, 2);
    if (random.integer(0, 3) == 0) {
        settings.light.position = settings.camera.position;
        settings.light.power = glm::vec3(std::pow(10.0f, random.number(-30, 30)));
    }
    return settings;
}

std::string describe(const Settings& s) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "camera %.9g,%.9g,%.9g yaw %.9g pitch %.9g focal_length %.9g size %dx%d stage %d",
                  s.camera.position.x, s.camera.position.y, s.camera.position.z, s.camera.yaw,
                  s.camera.pitch, s.camera.focal_length, s.viewport.width, s.viewport.height,
                  static_cast<int>(s.stage));
    return text;
}

/// However near a vertex is to the camera, no number may grow beyond the limit on its pixel.
void check_bounds(const Frame& frame) {
    constexpr int limit = 16384 + 4096 + 2;
    // The ways that divide without a check.
    const bool may_be_behind =
        frame.settings.clip == Clip::none || frame.settings.clip == Clip::after_division;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t)) continue;
        for (const ScreenVertex& vertex : frame.triangle_vertices(t)) {
            if (std::abs(vertex.column) > limit || std::abs(vertex.row) > limit ||
                !std::isfinite(vertex.inv_w) || !(vertex.inv_w > 0.0f || may_be_behind))
                FAIL("triangle " << t << " has a vertex out of bounds");
        }
    }
}

} // namespace

TEST_CASE("From thousands of hostile cameras every stage is drawn, watched and replayed") {
    const Scene room = lab_room();
    Random random(50);
    int with_fragments = 0, without = 0;
    const int cameras = rounds(3500, 350);
    for (int i = 0; i < cameras; ++i) {
        const Settings settings = hostile_settings(room, i % stage_count, random);
        const Frame frame = prepare_frame(room, settings);
        CAPTURE(i, describe(settings));
        check_bounds(frame);
        Framebuffer whole;
        clear(whole, frame);
        const DrawTally tally = draw(frame, {}, whole);
        (tally.fragments > 0 ? with_fragments : without) += 1;
        const std::int64_t pixels =
            static_cast<std::int64_t>(settings.viewport.width) * settings.viewport.height;
        if (has_fragments(settings.stage) && tally.fragments > 30 * pixels)
            FAIL("more fragments than every triangle on every pixel");
        for (const View view : {View::colour, View::depth, View::triangle, View::overdraw})
            view_image(whole, view);
        if (i % 5 != 0) continue;

        Recorder recorder(true);
        Framebuffer watched;
        clear(watched, frame);
        draw(frame, {}, watched, &recorder);
        std::string difference = first_difference(whole, watched);
        if (!difference.empty()) FAIL("watched: " << difference);

        const Timeline timeline(frame);
        Replay replay;
        replay.begin(frame);
        for (const double place : {0.7, 0.2, 0.9, 0.5}) {
            const Cursor cursor = timeline.at_place(place);
            REQUIRE(timeline.exists(cursor));
            timeline.next(cursor, Granularity::line);
            timeline.previous(cursor, Granularity::moment);
            replay.at(cursor);
        }
        difference = first_difference(whole, replay.at(cursor_end));
        if (!difference.empty()) FAIL("replayed: " << difference);
    }
    // Both kinds must occur often, or the sweep has missed the room.
    CHECK(with_fragments > cameras / 7);
    CHECK(without > cameras / 7);
}

TEST_CASE("Triangles are left out for the reasons that double precision finds, and counted so") {
    const Scene room = lab_room();
    Random random(51);
    int decided = 0, behind = 0, too_far = 0, drawn = 0;
    const int cameras = rounds(4000, 400);
    for (int i = 0; i < cameras; ++i) {
        Settings settings = default_settings(room);
        settings.camera = hostile_camera(room, random);
        const Camera& camera = settings.camera;
        const Frame frame = prepare_frame(room, settings);
        const double cy = std::cos(double{camera.yaw}), sy = std::sin(double{camera.yaw});
        const double cp = std::cos(double{camera.pitch}), sp = std::sin(double{camera.pitch});
        for (int t = 0; t < 30; ++t) {
            Rejection expected = Rejection::none;
            bool certain = true;
            for (const Vertex& vertex : corners_of(room, t)) {
                const glm::dvec3 moved = glm::dvec3(vertex.position) - glm::dvec3(camera.position);
                const double depth = moved.x * sy + moved.z * cy;
                const double x = moved.x * cy - moved.z * sy;
                const double y = moved.y * cp + depth * sp;
                const double z = -moved.y * sp + depth * cp;
                // Floats lose this much of the place; within it either answer is right.
                const double doubt = 1e-5 * (1.0 + std::abs(moved.x) + std::abs(moved.y) +
                                             std::abs(moved.z) + 3.0 * std::abs(camera.yaw));
                const double reach = camera.focal_length * std::max(std::abs(x), std::abs(y));
                const double margin = camera.focal_length * doubt + 16384.0 * doubt;
                Rejection fault = Rejection::none;
                if (z <= 0.0) fault = Rejection::behind_camera;
                if (z > 0.0 && reach > 16384.0 * z) fault = Rejection::too_far_out;
                certain = certain && std::abs(z) > doubt &&
                          (z < 0.0 || std::abs(reach - 16384.0 * z) > margin);
                if (expected == Rejection::none) expected = fault;
            }
            if (!certain) continue;
            ++decided;
            behind += expected == Rejection::behind_camera ? 1 : 0;
            too_far += expected == Rejection::too_far_out ? 1 : 0;
            drawn += expected == Rejection::none ? 1 : 0;
            const Rejection fault = frame.rejection(t);
            if (fault == expected) continue;
            CAPTURE(describe(settings), t, static_cast<int>(fault), static_cast<int>(expected));
            FAIL("left out for a different reason, or not at all");
        }
    }
    CHECK(decided > 15 * cameras);
    CHECK(behind > 5 * cameras / 2);
    CHECK(too_far > cameras / 4);
    CHECK(drawn > 5 * cameras / 2);
}
