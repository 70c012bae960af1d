// Pictures of clipped scenes compared with a ray caster: with the view volume clipped, no camera
// makes a hole, however many triangles it cuts, and nothing is drawn that a ray does not find.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "inspect/stats.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/random.h"
#include "support/ray_picture.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

constexpr Viewport small_picture{64, 48};

/// A scene, and the box in the world where the camera moves.
struct Walk {
    Scene scene;
    glm::vec3 low, high;
    std::uint32_t seed;
};

/// A camera anywhere on the walk, in any direction, through any lens.
Settings somewhere_on(const Walk& walk, Random& random) {
    Settings settings = default_settings(walk.scene);
    set_step(settings, {Stage::depth, Shading::unlit});
    settings.viewport = small_picture;
    settings.camera.position = {random.number(walk.low.x, walk.high.x),
                                random.number(walk.low.y, walk.high.y),
                                random.number(walk.low.z, walk.high.z)};
    settings.camera.yaw = random.number(-3.2, 3.2);
    settings.camera.pitch = random.number(-1.2, 1.2);
    settings.camera.focal_length = random.number(20, 80);
    settings.near = random.integer(0, 1) == 0 ? 0.1f : 0.02f;
    return settings;
}

/// How many pixels were compared with rays.
struct PixelCount {
    std::int64_t compared = 0, wrong = 0;
    std::string first_wrong;
};

/// Compares a picture with what rays meet.
/// @param border pixels left out on each side
PixelCount compare_pixels(const Framebuffer& drawn, const std::vector<int>& met, int border) {
    PixelCount count;
    for (int row = border; row < drawn.size.height - border; ++row) {
        for (int column = border; column < drawn.size.width - border; ++column) {
            const std::size_t pixel = drawn.at(column, row);
            if (met[pixel] == ray_near_outline) continue;
            ++count.compared;
            if (drawn.owner[pixel] == met[pixel] || ++count.wrong > 1) continue;
            count.first_wrong =
                "column " + std::to_string(column) + ", row " + std::to_string(row) + ": drawn " +
                std::to_string(drawn.owner[pixel]) + ", ray " + std::to_string(met[pixel]);
        }
    }
    return count;
}

/// @param margin how far a pixel must be from an outline to be compared
PixelCount compare_with_rays(const Frame& frame, double margin, int border) {
    const Settings& settings = frame.settings;
    const std::vector<int> met = cast_rays(*frame.scene, settings.camera, settings.viewport,
                                           {settings.near, settings.far}, margin);
    return compare_pixels(draw_frame(frame), met, border);
}

/// The camera whose picture differs from the rays, and the first wrong pixel.
std::string fault_words(const Settings& settings, const PixelCount& count) {
    const Camera& camera = settings.camera;
    char text[200];
    std::snprintf(text, sizeof text,
                  "camera %.9g,%.9g,%.9g yaw %.9g pitch %.9g focal_length %.9g near %g",
                  camera.position.x, camera.position.y, camera.position.z, camera.yaw, camera.pitch,
                  camera.focal_length, settings.near);
    return "clip " + std::string(word_of(settings.clip)) + ", reject " +
           std::string(word_of(settings.reject)) + ", " + text + ": " +
           std::to_string(count.wrong) + " pixels, the first at " + count.first_wrong;
}

/// The walk with the lab's rows, and every way to clip that leaves no hole. Corners are whole
/// pixels there, and so are the samples of edges, so outlines can be two pixels off the true ones.
void check_walk_by_rows(const Walk& walk) {
    constexpr double margin = 3.0;
    Random random(walk.seed);
    std::int64_t compared = 0, pixels = 0;
    int cut = 0, reported = 0;
    const int cameras = rounds(400, 40);
    for (int i = 0; i < cameras; ++i) {
        Settings settings = somewhere_on(walk, random);
        constexpr Clip ways[] = {Clip::all, Clip::near, Clip::guard_band};
        settings.clip = ways[i % 3];
        constexpr Reject rejections[] = {Reject::outcodes, Reject::none, Reject::cheap,
                                         Reject::none};
        settings.reject = rejections[i % 4];
        const Frame frame = prepare_frame(walk.scene, settings);
        cut += count_clipping(frame).clipped;
        const bool is_reported = count_left_out(frame).of(Rejection::too_far_out) > 0;
        if (is_reported && settings.clip == Clip::near) {
            // The near plane alone leaves corners too far out for the arithmetic, which is
            // reported.
            ++reported;
            continue;
        }
        REQUIRE_FALSE(is_reported);
        // Cut at the very border, a corner is rounded to a whole pixel on either side of it.
        const int border = settings.clip == Clip::all ? 1 : 0;
        const PixelCount count = compare_with_rays(frame, margin, border);
        if (count.wrong > 0) FAIL("camera " << i << ", " << fault_words(settings, count));
        compared += count.compared;
        pixels += small_picture.width * small_picture.height;
    }
    CAPTURE(cameras, compared, pixels, cut, reported);
    CHECK(2 * compared > pixels);
    CHECK(cut > cameras);
    CHECK(reported <= 1 + cameras / 20);
}

/// If coverage tests the centres of pixels and corners are snapped to 256ths of one, outlines are
/// drawn in place: pixels farther from all outlines than this show what their rays meet.
constexpr double centre_margin = 1.0 / 16.0;

void ask_centres(Settings& settings) {
    settings.coverage = Coverage::edge_functions;
    settings.snap = Snap::subpixel;
}

/// The walk with every pixel compared, except those that an outline runs through.
void check_walk_by_centres(const Walk& walk) {
    Random random(walk.seed + 100);
    std::int64_t compared = 0, pixels = 0;
    int cut = 0;
    Frame frame;
    const int cameras = rounds(1000, 100); // effort 10 walks ten thousand
    for (int i = 0; i < cameras; ++i) {
        Settings settings = somewhere_on(walk, random);
        ask_centres(settings);
        settings.clip = Clip::all;
        constexpr Reject rejections[] = {Reject::none, Reject::outcodes, Reject::cheap};
        settings.reject = rejections[i % 3];
        prepare_frame(walk.scene, settings, nullptr, frame);
        const PixelCount count = compare_with_rays(frame, centre_margin, 0);
        if (count.wrong > 0) FAIL("camera " << i << ", " << fault_words(settings, count));
        cut += count_clipping(frame).clipped;
        compared += count.compared;
        pixels += small_picture.width * small_picture.height;
    }
    CAPTURE(cameras, compared, pixels, cut);
    CHECK(10 * compared > 9 * pixels);
    CHECK(cut > cameras);
}

Scene scene_of_lessons(const std::string& name) {
    return read_scene(lessons_folder() + "/scenes/" + name + ".toml");
}

Walk walk_in_room() {
    return {lab_room(), {-0.8f, -0.8f, -1.6f}, {0.8f, 0.8f, 0.8f}, 76};
}
Walk walk_in_corridor() {
    return {scene_of_lessons("corridor"), {-0.8f, -0.8f, -1.8f}, {0.8f, 0.8f, 7.0f}, 78};
}

/// Is a triangle drawn that is completely nearer than the near plane or farther than the far one?
/// Only possible if nothing is cut.
bool draws_beyond_ends(const Frame& frame) {
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t)) continue;
        float nearest = INFINITY, farthest = 0.0f;
        for (const ScreenVertex& vertex : frame.triangle_vertices(t)) {
            nearest = std::min(nearest, vertex.z);
            farthest = std::max(farthest, vertex.z);
        }
        if (farthest < frame.settings.near || nearest > frame.settings.far) return true;
    }
    return false;
}

/// A camera near the scene's own, in any direction.
Camera camera_about(const Camera& own, Random& random) {
    Camera camera = own;
    for (int axis = 0; axis < 3; ++axis)
        camera.position[axis] += random.number(-1.5, 1.5);
    camera.position.z += random.number(0.0, 2.0);
    camera.yaw += random.number(-3.2, 3.2);
    camera.pitch += random.number(-0.6, 0.6);
    camera.focal_length = random.number(20, 80);
    return camera;
}

} // namespace

TEST_CASE("From any camera in the room the clipped picture is what rays find") {
    check_walk_by_rows(walk_in_room());
}

TEST_CASE("From any camera in the corridor, which continues behind it, the picture has no hole") {
    check_walk_by_rows(walk_in_corridor());
}

TEST_CASE("In the room all pixels away from outlines show what their ray meets, without a hole") {
    check_walk_by_centres(walk_in_room());
}

TEST_CASE(
    "In the corridor all pixels away from outlines show what their ray meets, without a hole") {
    check_walk_by_centres(walk_in_corridor());
}

TEST_CASE("Rays see the holes left by clipping nothing or clipping wrongly") {
    const Walk walk = walk_in_corridor();
    for (const Clip clip : {Clip::none, Clip::leave_out, Clip::whole_only, Clip::wrong_t,
                            Clip::after_division, Clip::clamped}) {
        Random random(80);
        int wrong = 0;
        const int cameras = rounds(40, 8);
        for (int i = 0; i < cameras; ++i) {
            Settings settings = somewhere_on(walk, random);
            ask_centres(settings);
            settings.clip = clip;
            const Frame frame = prepare_frame(walk.scene, settings);
            wrong += compare_with_rays(frame, centre_margin, 0).wrong > 0 ? 1 : 0;
        }
        CAPTURE(word_of(clip), cameras);
        CHECK(wrong > cameras / 2);
    }
}

TEST_CASE("Cheap clipping gives the same picture, and walks nothing outside it") {
    const Scene scenes[] = {lab_room(), scene_of_lessons("corridor"), scene_of_lessons("outcodes"),
                            scene_of_lessons("turned-block")};
    constexpr Clip ways[] = {Clip::leave_out, Clip::leave_out, Clip::near, Clip::all,
                             Clip::guard_band};
    Random random(79);
    int compared = 0, rejected = 0;
    std::int64_t spared = 0;
    const int cameras = rounds(2000, 200);
    for (int i = 0; i < cameras; ++i) {
        const Scene& scene = scenes[i % std::ssize(scenes)];
        Settings settings = default_settings(scene);
        set_step(settings, i % 3 == 0 ? StripStep::pixel_light : StripStep{Stage::depth});
        settings.viewport = small_picture;
        settings.camera = camera_about(scene.camera, random);
        settings.clip = ways[i % std::ssize(ways)];
        CAPTURE(i, scene.name, word_of(settings.clip));
        const Frame all = prepare_frame(scene, settings);
        // Cheap rejection has near and far planes, which the lab does not have.
        if (draws_beyond_ends(all)) continue;
        settings.reject = Reject::cheap;
        const Frame cheap = prepare_frame(scene, settings);
        require_same(draw_frame(all), draw_frame(cheap));
        const FrameStats before = frame_stats(all), after = frame_stats(cheap);
        REQUIRE(before.fragments == after.fragments);
        REQUIRE(before.shaded == after.shaded);
        REQUIRE(after.fragments_outside == 0);
        spared += before.fragments_outside;
        rejected += after.left_out.of(Rejection::outside);
        ++compared;
    }
    CHECK(compared > cameras * 3 / 4);
    CHECK(rejected > cameras);
    CHECK(spared > 1000 * cameras);
}

TEST_CASE("Triangles outside by their outcodes are not missed") {
    const Scene room = lab_room();
    Random random(77);
    std::int64_t spared = 0;
    for (int i = 0; i < rounds(400, 40); ++i) {
        Settings settings = default_settings(room);
        settings.viewport = small_picture;
        settings.camera.focal_length = 48.0f;
        settings.camera.position.z = random.number(-3.0, -0.9);
        settings.camera.yaw = random.number(-0.6, 0.6);
        const Frame all = prepare_frame(room, settings);
        settings.reject = Reject::outcodes;
        const Frame fewer = prepare_frame(room, settings);
        CAPTURE(i);
        CHECK(draw_frame(all).colour == draw_frame(fewer).colour);
        const FrameStats before = frame_stats(all), after = frame_stats(fewer);
        CHECK(before.fragments == after.fragments);
        CHECK(after.left_out.of(Rejection::outside) + after.clip_triangles +
                  after.left_out.of(Rejection::behind_camera) +
                  after.left_out.of(Rejection::too_far_out) ==
              30);
        spared += before.fragments_outside - after.fragments_outside;
    }
    CHECK(spared > 0);
}

TEST_CASE("Fragments outside are those of rows outside the picture") {
    const Scene room = lab_room();
    for (const float z : {-1.5f, -1.2f, -1.05f}) {
        Settings settings = default_settings(room);
        settings.camera.position.z = z;
        const Frame frame = prepare_frame(room, settings);
        std::int64_t all = 0;
        PolygonRows rows;
        for (int t = 0; t < frame.triangle_count(); ++t) {
            if (!frame.is_drawn(t)) continue;
            compute_rows(frame, t, rows);
            for (int r = 0; r < rows.size(); ++r) {
                const auto i = static_cast<std::size_t>(r);
                if (rows.left[i].column > rows.right[i].column) continue;
                all += rows.right[i].column - rows.left[i].column + 1;
            }
        }
        const FrameStats stats = frame_stats(frame);
        CAPTURE(z, stats.fragments_outside);
        CHECK(stats.fragments + stats.fragments_outside == all);
        CHECK(stats.fragments_outside > 0);
    }
}
