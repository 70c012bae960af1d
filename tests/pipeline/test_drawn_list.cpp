#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "base/limits.h"
#include "inspect/hidden_ways.h"
#include "pipeline/draw.h"
#include "pipeline/replay.h"
#include "scene/read_scene.h"
#include "session/bench.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/moments.h"
#include "support/project_root.h"
#include "support/random.h"
#include "support/ray_caster.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace hiding {

Settings settings_of(const Scene& scene, const std::vector<std::string>& assignments) {
    Settings settings = default_settings(scene);
    for (const std::string& assignment : assignments)
        set_from_text(settings, assignment);
    return settings;
}

/// Samples at the centres of pixels, so that a ray can ask for the same place.
const std::vector<std::string> at_centres{"stage=depth", "coverage=edge_functions",
                                          "fill_rule=top_left", "snap=subpixel"};

Scene random_scene(Random& random) {
    Scene scene;
    scene.name = "random";
    scene.viewport = {48, 40};
    scene.camera.position = {0, 0, 0};
    scene.camera.focal_length = 40.0f;
    const int triangles = random.integer(2, 10);
    for (int t = 0; t < triangles; ++t) {
        std::array<Vertex, triangle_corners> corners;
        for (Vertex& corner : corners) {
            const float z = random.number(1.5, 6.0);
            corner.position = {random.number(-0.7, 0.7) * z, random.number(-0.6, 0.6) * z, z};
            corner.normal = {0, 0, -1};
        }
        scene.mesh.add_triangle_of(corners);
    }
    scene.parts.push_back({"all", 0, triangles});
    return scene;
}

struct Exceptions {
    std::int64_t pixels = 0, asked = 0, wrong = 0;
};

/// Does every pixel farther than a pixel from all outlines and cuts show the nearest surface?
void ask_oracle(const Scene& scene, const Settings& settings, Exceptions& found) {
    const Frame frame = prepare_frame(scene, settings);
    REQUIRE(frame.list != nullptr);
    const Framebuffer picture = draw_frame(frame);
    const RayCaster rays(scene, settings.camera, settings.light);
    const RayCaster pieces(frame.list->scene, settings.camera, settings.light);
    const Viewport size = settings.viewport;
    for (int row = 0; row < size.height; ++row) {
        for (int column = 0; column < size.width; ++column) {
            ++found.pixels;
            const glm::dvec2 place(column + 0.5 - size.width / 2, row + 0.5 - size.height / 2);
            if (pieces.distance_to_edges(place) <= 1.0) continue;
            const std::vector<RayHit> hits = rays.hits(place);
            // Where two surfaces meet, either may be seen.
            if (hits.size() > 1 && hits[0].zinv - hits[1].zinv < 1e-5) continue;
            ++found.asked;
            const int owner = picture.owner[picture.at(column, row)];
            const int shown = owner < 0 ? -1 : scene_triangle(*frame.scene, owner);
            const int nearest = hits.empty() ? -1 : hits.front().triangle;
            if (shown == nearest) continue;
            ++found.wrong;
            CAPTURE(column, row, owner, shown, nearest);
            FAIL_CHECK("another surface than the nearest");
        }
    }
}

std::vector<Scene> world_scenes() {
    std::vector<Scene> scenes;
    for (const auto& entry :
         std::filesystem::directory_iterator(project_root() + "/lessons/scenes")) {
        if (entry.path().extension() != ".toml") continue;
        Scene scene = read_scene(entry.path().string());
        if (scene.space == SceneSpace::world) scenes.push_back(std::move(scene));
    }
    std::sort(scenes.begin(), scenes.end(),
              [](const Scene& a, const Scene& b) { return a.path < b.path; });
    return scenes;
}

} // namespace hiding
} // namespace

TEST_CASE("With a depth buffer there is no list, and before stage depth there never is") {
    for (const Scene& scene : hiding::world_scenes()) {
        CAPTURE(scene.path);
        const Frame frame = prepare_frame(scene, hiding::settings_of(scene, {"stage=depth"}));
        CHECK(frame.list == nullptr);
        CHECK(frame.scene == &scene);
        for (const char* hidden : {"hidden=painter", "hidden=bsp"}) {
            const Settings before = hiding::settings_of(scene, {"stage=fill", hidden});
            CHECK(prepare_frame(scene, before).list == nullptr);
        }
    }
    const Scene pixels = small_scene();
    CHECK(prepare_frame(pixels, hiding::settings_of(pixels, {"stage=depth", "hidden=bsp"})).list ==
          nullptr);
}

TEST_CASE("A BSP tree shows the nearest surface, for any camera") {
    Random random(266);
    hiding::Exceptions found;
    for (int round = 0; round < rounds(1000, 30); ++round) {
        const Scene scene = hiding::random_scene(random);
        std::vector<std::string> assignments = hiding::at_centres;
        assignments.emplace_back("hidden=bsp");
        CAPTURE(round);
        hiding::ask_oracle(scene, hiding::settings_of(scene, assignments), found);
    }
    CHECK(found.wrong == 0);
    // The margin must not swallow the pictures.
    CHECK(found.asked > found.pixels / 4);
}

TEST_CASE("A BSP tree shows the nearest surface in the scenes of the repository") {
    for (const Scene& scene : hiding::world_scenes()) {
        if (scene.camera.aim != CameraAim::angles || scene.textures.size() > 0) continue;
        const SceneBox box = box_of(scene);
        const Settings settings = hiding::settings_of(scene, {});
        // The oracle's edges need everything in front of the camera.
        const auto is_in_front = [&](const Vertex& vertex) {
            const CameraAxes axes = camera_axes(settings.camera);
            return glm::dot(axes.forward, glm::dvec3(vertex.position - settings.camera.position)) >
                   0.01;
        };
        const std::vector<Vertex>& all = scene.mesh.vertices();
        if (!std::all_of(all.begin(), all.end(), is_in_front)) continue;
        CAPTURE(scene.path, box.radius());
        std::vector<std::string> assignments = hiding::at_centres;
        assignments.emplace_back("hidden=bsp");
        assignments.emplace_back("viewport.size=120x120");
        assignments.push_back("camera.focal_length=" +
                              std::to_string(120.0f * scene.camera.focal_length /
                                             static_cast<float>(scene.viewport.width)));
        hiding::Exceptions found;
        hiding::ask_oracle(scene, hiding::settings_of(scene, assignments), found);
        CHECK(found.wrong == 0);
    }
}

TEST_CASE("The painter's wrong pixels are those of a second painter") {
    Random random(267);
    std::vector<Scene> scenes = hiding::world_scenes();
    for (int round = 0; round < rounds(60, 6); ++round)
        scenes.push_back(hiding::random_scene(random));
    std::int64_t all_wrong = 0;
    for (const Scene& scene : scenes) {
        CAPTURE(scene.path);
        if (has_alpha(scene) || has_texture_alpha(scene)) continue;
        const Settings settings =
            hiding::settings_of(scene, {"stage=depth", "viewport.size=100x100"});
        // The order, from the projected vertices of the scene.
        const Frame frame = prepare_frame(scene, settings);
        std::vector<int> order(static_cast<std::size_t>(scene.triangle_count()));
        std::iota(order.begin(), order.end(), 0);
        std::vector<float> depths;
        for (const int t : order) {
            float sum = 0.0f;
            for (int i = 0; i < triangle_corners; ++i)
                sum += frame.given_clip_vertex(t, i).position_clip.w;
            depths.push_back(sum / 3.0f);
        }
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
            return depths[static_cast<std::size_t>(a)] > depths[static_cast<std::size_t>(b)];
        });
        std::vector<int> rank(order.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            rank[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
        // Every fragment of the depth buffer's drawing; the painter shows the last by rank.
        struct Fallen {
            int last = -1, nearest = -1;
            float zinv = 0.0f;
        };
        std::map<std::pair<int, int>, Fallen> pixels;
        Framebuffer buffer;
        clear(buffer, frame);
        Observer observer;
        observer.fragment = [&](const FragmentEvent& event) {
            Fallen& pixel = pixels[{event.fragment.column, event.fragment.row}];
            const int now = event.cursor.triangle;
            const auto rank_of = [&](int t) { return rank[static_cast<std::size_t>(t)]; };
            if (pixel.last < 0 || rank_of(now) >= rank_of(pixel.last)) pixel.last = now;
            if (pixel.nearest < 0 || event.fragment.depth > pixel.zinv) {
                pixel.nearest = now;
                pixel.zinv = event.fragment.depth;
            }
        };
        draw(frame, {}, buffer, &observer);
        std::int64_t wrong = 0;
        for (const auto& [place, pixel] : pixels) {
            bool is_near = false;
            for (int i = 0; i < 9; ++i) {
                const auto found = pixels.find({place.first + i % 3 - 1, place.second + i / 3 - 1});
                is_near = is_near || (found != pixels.end() && found->second.nearest == pixel.last);
            }
            wrong += is_near ? 0 : 1;
        }
        const std::vector<HiddenWay> ways = hidden_ways(scene, settings);
        CHECK(ways[static_cast<std::size_t>(Hidden::painter)].wrong == wrong);
        CHECK(ways[static_cast<std::size_t>(Hidden::depth_buffer)].wrong == 0);
        all_wrong += wrong;
    }
    CHECK(all_wrong > 1000); // some of them must be wrong, or nothing was compared
}

TEST_CASE("Every moment of a drawn list is reached alike forward, backward and at random") {
    Random random(268);
    for (const char* hidden : {"hidden=painter", "hidden=bsp"}) {
        for (const char* stage : {"stage=depth", "stage=pixel_light", "stage=vertex_light"}) {
            const Scene scene = hiding::random_scene(random);
            const Frame frame = prepare_frame(scene, hiding::settings_of(scene, {stage, hidden}));
            CAPTURE(hidden, stage);
            REQUIRE(frame.list != nullptr);
            std::vector<Cursor> moments = all_moments(frame);
            moments.push_back(cursor_end);
            Replay replay;
            replay.begin(frame);
            const auto require_at = [&](const Cursor& cursor) {
                CAPTURE(to_text(cursor));
                Framebuffer expected;
                clear(expected, frame);
                draw(frame, {cursor_begin, cursor, {}}, expected);
                require_same(expected, replay.at(cursor));
            };
            const std::size_t step = std::max<std::size_t>(moments.size() / 60, 1);
            for (std::size_t i = 0; i < moments.size(); i += step)
                require_at(moments[i]);
            for (std::size_t i = moments.size(); i > step; i -= step)
                require_at(moments[i - 1]);
            for (int i = 0; i < 40; ++i)
                require_at(moments[static_cast<std::size_t>(
                    random.integer(0, static_cast<int>(moments.size()) - 1))]);
        }
    }
}

TEST_CASE("The tree is kept while only the camera moves, and the list follows the camera") {
    const Scene scene = read_scene(project_root() + "/lessons/scenes/lab-room.toml");
    Settings settings = hiding::settings_of(scene, {"stage=depth", "hidden=bsp"});
    Frame frame = prepare_frame(scene, settings);
    REQUIRE(frame.list != nullptr);
    const auto divided = frame.list->divided;
    const std::vector<TriangleSource> before = frame.list->scene.sources;
    settings.camera.position = {0.7f, -0.4f, -0.2f};
    settings.camera.yaw = 2.0f;
    prepare_frame(scene, settings, nullptr, frame);
    CHECK(frame.list->divided == divided);
    CHECK_FALSE(frame.list->scene.sources == before);
    Scene other = scene;
    other.mesh.place_corner(12, 0, {0.1f, 0.2f, 0.3f});
    prepare_frame(other, settings, nullptr, frame);
    CHECK_FALSE(frame.list->divided == divided);
}

TEST_CASE("Part, texture and object space of a piece are those of its triangle") {
    const Scene scene = read_scene(project_root() + "/lessons/scenes/lab-room.toml");
    const Frame frame =
        prepare_frame(scene, hiding::settings_of(scene, {"stage=depth", "hidden=bsp"}));
    for (int t = 0; t < frame.triangle_count(); ++t) {
        const TriangleSource& source = frame.scene->sources[static_cast<std::size_t>(t)];
        CAPTURE(t, source.triangle);
        CHECK(part_of(*frame.scene, t) == part_of(scene, source.triangle));
        for (int i = 0; i < triangle_corners; ++i) {
            const glm::vec3& weights = source.weights[static_cast<std::size_t>(i)];
            glm::vec3 place(0.0f);
            for (int k = 0; k < triangle_corners; ++k)
                place += weights[k] * scene.corner(source.triangle, k).position;
            CHECK(glm::length(place - frame.scene->corner(t, i).position) < 1e-5f);
            CHECK(frame.scene->corner(t, i).normal == scene.corner(source.triangle, i).normal);
        }
    }
}
