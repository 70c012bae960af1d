// Textures in whole pictures.

#include <map>
#include <string>

#include <fmt/format.h>

#include "pipeline/draw.h"
#include "pipeline/surface.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/recorder.h"
#include "support/samples.h"
#include "support/texture_oracle.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// The reports of draw() about every fragment.
std::vector<FragmentEvent> fragments_of(const Frame& frame) {
    Framebuffer picture;
    clear(picture, frame);
    Recorder recorder;
    draw(frame, {}, picture, &recorder);
    return recorder.fragments;
}

Settings settings_for(const Scene& scene, const std::string& assignments) {
    Settings settings = default_settings(scene);
    std::size_t begin = 0;
    while (begin < assignments.size()) {
        const std::size_t end = std::min(assignments.find(' ', begin), assignments.size());
        set_from_text(settings, assignments.substr(begin, end - begin));
        begin = end + 1;
    }
    return settings;
}

/// Triangles that go beyond the texture on all sides, with far fewer and far more texels than
/// pixels.
Scene tilted_triangles() {
    Scene scene = textured_scene(many_colours(13, 6), {40, 40});
    add_textured(
        scene,
        {{{{1, 2, 1}, {-1.3f, 0.2f}}, {{38, 5, 6}, {2.6f, -0.7f}}, {{7, 37, 2.5f}, {0.1f, 1.9f}}}});
    add_textured(scene, {{{{39, 6, 2}, {0.21f, 0.33f}},
                          {{36, 39, 1.5f}, {0.43f, 0.52f}},
                          {{9, 38, 3}, {0.36f, 0.71f}}}});
    return scene;
}

std::array<glm::dvec3, 3> places_of(const Scene& scene, int triangle) {
    std::array<glm::dvec3, 3> places;
    for (int v = 0; v < 3; ++v) {
        // A point in pixels is at the middle of its pixel.
        places[static_cast<std::size_t>(v)] =
            glm::dvec3(scene.corner(triangle, v).position) + glm::dvec3(0.5, 0.5, 0.0);
    }
    return places;
}

std::array<glm::dvec2, 3> texcoords_of(const Scene& scene, int triangle) {
    return {glm::dvec2(scene.corner(triangle, 0).texcoord),
            glm::dvec2(scene.corner(triangle, 1).texcoord),
            glm::dvec2(scene.corner(triangle, 2).texcoord)};
}

} // namespace

TEST_CASE("Every filter and wrap paints each pixel as a second implementation in double does") {
    const Scene scene = tilted_triangles();
    const std::vector<OracleLevel> chain = oracle_chain(many_colours(13, 6));
    int compared = 0, ties = 0;
    std::map<int, int> levels; // rounded: the test must see more than one
    for (const std::string_view interpolation : {"perspective", "affine"}) {
        for (const std::string_view filter : enum_words<TextureFilter>) {
            for (const std::string_view wrap : enum_words<TextureWrap>) {
                const std::string name =
                    fmt::format("stage=fill coverage=edge_functions interpolation={} "
                                "texture_filter={} texture_wrap={}",
                                interpolation, filter, wrap);
                const Settings settings = settings_for(scene, name);
                const Frame frame = prepare_frame(scene, settings);
                for (const FragmentEvent& event : fragments_of(frame)) {
                    const int triangle = event.cursor.triangle;
                    const TexturedPlane plane(places_of(scene, triangle),
                                              texcoords_of(scene, triangle),
                                              interpolation == "perspective");
                    const double x = event.fragment.column + 0.5, y = event.fragment.row + 0.5;
                    const glm::dvec2 right = plane.change(x, y, 1, 0),
                                     down = plane.change(x, y, 0, 1);
                    const OracleColour wanted =
                        oracle_sample(chain, plane.at(x, y), right, down, settings.texture_filter,
                                      settings.texture_wrap);
                    if (wanted.is_tie) {
                        ++ties;
                        continue;
                    }
                    ++compared;
                    ++levels[static_cast<int>(std::lround(texture_level(
                        {glm::vec2(right), glm::vec2(down)}, *scene.textures.front())))];
                    const glm::dvec3 off = glm::abs(glm::dvec3(event.after) - wanted.colour);
                    if (std::max({off.x, off.y, off.z}) > 1.0 / 255.0) {
                        FAIL(name << " pixel " << event.fragment.column << "," << event.fragment.row
                                  << " triangle " << triangle << " is " << event.after.x << " "
                                  << event.after.y << " " << event.after.z << ", in double "
                                  << wanted.colour.x << " " << wanted.colour.y << " "
                                  << wanted.colour.z);
                    }
                }
            }
        }
    }
    CHECK(compared > 20000);
    CHECK(ties < compared / 100);
    CHECK(levels.size() >= 3);
}

TEST_CASE("Halfway across a wall that recedes from depth 2 to 4 u is 1/3, and affine says 1/2") {
    const Scene scene = receding_wall(many_colours(8, 8));
    for (const std::string_view coverage :
         {"rows", "edge_functions", "scan_conversion", "active_edges"}) {
        for (const std::string_view interpolation : {"perspective", "affine"}) {
            const bool is_right = interpolation == "perspective";
            const Frame frame =
                prepare_frame(scene, settings_for(scene, fmt::format("stage=fill coverage={} "
                                                                     "interpolation={}",
                                                                     coverage, interpolation)));
            int found = 0;
            for (const FragmentEvent& event : fragments_of(frame)) {
                if (event.fragment.column != 20) continue;
                ++found;
                INFO(coverage << " " << interpolation << " row " << event.fragment.row);
                const Surface surface = surface_of(frame, event.cursor.triangle);
                const float u =
                    place_in_texture(event.fragment, surface, pixel_rules(frame), frame.stages)
                        .texcoord.x;
                // The lab's rows end on whole pixels of slanted edges.
                const float margin = coverage == "rows" ? 0.02f : 2e-6f;
                CHECK(u == Approx(is_right ? 1.0f / 3.0f : 0.5f).margin(margin));
            }
            CHECK(found >= 29);
        }
    }
}

TEST_CASE("A footprint is the difference between neighbours, even where the near plane cuts") {
    Scene scene = textured_scene(many_colours(16, 16), {40, 40});
    scene.space = SceneSpace::world;
    scene.camera = {{0.0f, 0.0f, 0.0f}, 0.0f, 0.0f, 40.0f};
    // A floor from behind the camera to far in front of it.
    add_textured(scene, {{{{-4, 1, -1}, {0, 1}}, {{-4, 1, 30}, {0, 0}}, {{4, 1, -1}, {1, 1}}}});
    add_textured(scene, {{{{4, 1, -1}, {1, 1}}, {{-4, 1, 30}, {0, 0}}, {{4, 1, 30}, {1, 0}}}});
    const Frame frame = prepare_frame(
        scene, settings_for(scene, "stage=fill coverage=edge_functions snap=subpixel clip=near"));
    REQUIRE(frame.is_cut(0));
    std::map<std::array<int, 3>, TexturePlace> places;
    for (const FragmentEvent& event : fragments_of(frame)) {
        const int triangle = event.cursor.triangle;
        places[{triangle, event.fragment.column, event.fragment.row}] = place_in_texture(
            event.fragment, surface_of(frame, triangle), pixel_rules(frame), frame.stages);
    }
    int compared = 0;
    for (const auto& [where, place] : places) {
        const int triangle = where[0], column = where[1], row = where[2];
        const auto compare = [&](int dx, int dy, const glm::vec2& side) {
            const auto before = places.find({triangle, column - dx, row - dy});
            const auto after = places.find({triangle, column + dx, row + dy});
            if (before == places.end() || after == places.end()) return;
            const glm::vec2 change = (after->second.texcoord - before->second.texcoord) / 2.0f;
            INFO("triangle " << triangle << " pixel " << column << "," << row);
            // From row to row below the horizon the depth changes by 1 / (row - 20) of itself.
            const float bend =
                row - 20 > 2 ? 2.0f / static_cast<float>((row - 20) * (row - 20)) : 1;
            CHECK(glm::distance(side, change) <= bend * glm::length(side) + 1e-5f);
            ++compared;
        };
        compare(1, 0, place.footprint.right);
        compare(0, 1, place.footprint.down);
    }
    CHECK(compared > 500);
}

TEST_CASE("A texture paints a white surface in every shading, and tints one that is not") {
    Scene white = receding_wall(many_colours(4, 4));
    for (const std::string_view shading : enum_words<Shading>) {
        const std::string step = fmt::format("stage=pixel_light shading={}", shading);
        const auto painted = fragments_of(prepare_frame(white, settings_for(white, step)));
        const auto bare =
            fragments_of(prepare_frame(white, settings_for(white, step + " texture=off")));
        REQUIRE(painted.size() == bare.size());
        const Frame frame = prepare_frame(white, settings_for(white, step));
        for (std::size_t i = 0; i < bare.size(); ++i) {
            if (painted[i].fate != Fate::written) continue;
            const Surface surface = surface_of(frame, painted[i].cursor.triangle);
            const glm::vec3 texel = sample_nearest(
                *surface.texture,
                place_in_texture(painted[i].fragment, surface, pixel_rules(frame), frame.stages),
                frame.stages, nullptr);
            INFO(shading << " fragment " << i);
            CHECK(glm::distance(painted[i].after, bare[i].after * texel) <=
                  1e-5f * glm::length(bare[i].after));
        }
    }
    Scene tinted = white;
    Mesh mesh;
    for (int t = 0; t < white.triangle_count(); ++t) {
        std::array<Vertex, triangle_corners> corners = corners_of(white, t);
        for (Vertex& corner : corners)
            corner.reflectance = {0.5f, 0.0f, 1.0f};
        mesh.add_triangle_of(corners);
    }
    tinted.mesh = mesh;
    const auto pure = fragments_of(prepare_frame(white, settings_for(white, "stage=fill")));
    const auto mixed = fragments_of(prepare_frame(tinted, settings_for(tinted, "stage=fill")));
    REQUIRE(pure.size() == mixed.size());
    for (std::size_t i = 0; i < pure.size(); ++i)
        CHECK(mixed[i].after == pure[i].after * glm::vec3(0.5f, 0.0f, 1.0f));
}

TEST_CASE("A picture is the same watched and unwatched, and by parts") {
    const Scene scene = tilted_triangles();
    for (const std::string_view filter : enum_words<TextureFilter>) {
        const Frame frame = prepare_frame(
            scene, settings_for(scene, fmt::format("stage=pixel_light texture_filter={}", filter)));
        const Framebuffer whole = draw_frame(frame);
        Framebuffer watched;
        clear(watched, frame);
        Recorder recorder;
        draw(frame, {}, watched, &recorder);
        CHECK(first_difference(whole, watched).empty());
        Framebuffer parts;
        clear(parts, frame);
        const Cursor middle{0, Phase::rows, 13, 4};
        draw(frame, {cursor_begin, middle, {}}, parts);
        draw(frame, {middle, cursor_end, {}}, parts);
        CHECK(first_difference(whole, parts).empty());
    }
}

TEST_CASE("Without a texture its settings change nothing, and nothing more is carried") {
    const Scene scene = small_scene();
    const Settings settings = settings_for(scene, "stage=pixel_light");
    const Framebuffer whole = draw_frame(prepare_frame(scene, settings));
    for (const char* const other :
         {"texture=off", "texture_filter=trilinear", "texture_wrap=mirror"}) {
        const Frame frame =
            prepare_frame(scene, settings_for(scene, std::string("stage=pixel_light ") + other));
        CHECK(first_difference(whole, draw_frame(frame)).empty());
        CHECK(carried_varyings(frame) ==
              (VaryingSet::of(&Varyings::position_world) | VaryingSet::of(&Varyings::colour)));
    }
    const Scene wall = receding_wall(many_colours(4, 4));
    const auto carries = [&](const char* text) {
        return carried_varyings(prepare_frame(wall, settings_for(wall, text)))
            .has(varying_index(&Varyings::texcoord));
    };
    CHECK(carries("stage=fill"));
    CHECK_FALSE(carries("stage=fill texture=off"));
    CHECK_FALSE(carries("stage=rows"));
}
