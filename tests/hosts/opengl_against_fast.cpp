// OpenGL draws what the fast engine draws, away from outlines: all scenes and models of the
// project, under every kind of light and texture that both support.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include "engines/fast/fast_engine.h"
#include "engines/fast/fast_view.h"
#include "engines/opengl_engine.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/fast_pictures.h"
#include "support/project_scenes.h"
#include "support/random.h"
#include "support/ray_caster.h"
#include "support/samples.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"
#include "ui/hosts/host_opengl.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// What OpenGL draws; the camera is a little off the scene's own, from which borders of texels run
/// exactly through centres of pixels.
Settings settings_of(const Scene& scene, const std::vector<const char*>& assignments) {
    Settings settings = by_fast_rules(default_settings(scene));
    settings.stage = Stage::shade;
    settings.normal_map = NormalMapUse::off;
    settings.parallax = Parallax::off;
    settings.blend = Blend::off;
    settings.texture_filter = TextureFilter::bilinear;
    for (const char* assignment : assignments)
        set_from_text(settings, assignment);
    settings.camera.position += glm::vec3(0.0137f, 0.0071f, 0.0f);
    return settings;
}

/// How two pictures differ. Outlines are pixels that show another triangle than one of their
/// neighbours, in either picture.
struct Difference {
    int outlines = 0;
    int outline_owners = 0; ///< outlines that show another triangle
    int painted = 0;        ///< pixels of textures off outlines
    int border_texels = 0;  ///< of which show the texel across a border; see is_near_border()
    std::string first;      ///< other pixel that differs, in words
};

bool is_outline(const FastPicture& picture, int column, int row) {
    const std::int32_t own = picture.owner[picture.at(column, row)];
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, picture.size.height - 1); ++r) {
        for (int c = std::max(column - 1, 0); c <= std::min(column + 1, picture.size.width - 1);
             ++c) {
            if (picture.owner[picture.at(c, r)] != own) return true;
        }
    }
    return false;
}

int channel_difference(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (const int shift : {0, 8, 16})
        most = std::max(most, std::abs(static_cast<int>(a >> shift & 255U) -
                                       static_cast<int>(b >> shift & 255U)));
    return most;
}

/// A triangle's corners in homogeneous coordinates, column and row times z, on 256ths of a pixel
/// if they are on the screen.
struct HomogeneousTriangle {
    std::array<glm::dvec3, 3> corners;
    bool is_cut = false; ///< by the fast engine, which then rounds other corners
};

glm::dvec3 vector(const float (&of)[3]) {
    return {of[0], of[1], of[2]};
}

HomogeneousTriangle homogeneous(const Scene& scene, const fast::View& view, int triangle) {
    HomogeneousTriangle found;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 ray = glm::dvec3(scene.corner(triangle, i).position) - vector(view.eye);
        const auto along = [&](int axis) { return glm::dot(ray, vector(view.axes[axis])); };
        const double z = along(2);
        glm::dvec2 place = glm::dvec2(along(0), along(1)) * double{view.focal_length} +
                           glm::dvec2(view.middle[0], view.middle[1]) * z;
        const glm::dvec2 size = glm::abs(place / z);
        if (z < view.near || std::max(size.x, size.y) >= fast::guard_band)
            found.is_cut = true;
        else
            place = glm::floor(place / z * 256.0 + 0.5) / 256.0 * z;
        found.corners[static_cast<std::size_t>(i)] = {place, z};
    }
    return found;
}

/// Where a point among the pixels lies in the texture of a triangle, in texels. Homogeneous corners
/// need no cutting: M. Olano, T. Greer, "Triangle Scan Conversion using 2D Homogeneous
/// Coordinates", Graphics Hardware 1997.
glm::dvec2 texel_place_of(const Scene& scene, int triangle, const HomogeneousTriangle& at,
                          const glm::dvec2& point) {
    const auto& [a, b, c] = at.corners;
    const glm::dvec3 from(point, 1.0);
    const std::array<double, 3> weights = {glm::dot(from, glm::cross(b, c)),
                                           glm::dot(from, glm::cross(c, a)),
                                           glm::dot(from, glm::cross(a, b))};
    glm::dvec2 sum(0.0);
    for (int i = 0; i < 3; ++i)
        sum +=
            weights[static_cast<std::size_t>(i)] * glm::dvec2(scene.corner(triangle, i).texcoord);
    const TextureLevel& texels = texture_of(scene, triangle)->base();
    return sum / (weights[0] + weights[1] + weights[2]) * glm::dvec2(texels.width, texels.height);
}

/// Is the centre of a pixel so near to a border of texels that rounding decides which one is
/// nearest? Numbers with 24 bits tell 10,000ths of a texel apart in the project's scenes. Where the
/// fast engine cuts, it moves corners by up to 1/512 of a pixel.
bool is_near_border(const Scene& scene, const fast::View& view, int triangle, int column, int row) {
    const HomogeneousTriangle corners = homogeneous(scene, view, triangle);
    const auto place = [&](double right, double down) {
        return texel_place_of(scene, triangle, corners, {column + right, row + down});
    };
    const glm::dvec2 centre = place(0.5, 0.5);
    const glm::dvec2 by_pixel =
        glm::abs(place(1.0, 0.5) - place(0.0, 0.5)) + glm::abs(place(0.5, 1.0) - place(0.5, 0.0));
    const glm::dvec2 most = 1e-4 + (corners.is_cut ? by_pixel / 512.0 : glm::dvec2(0.0));
    return glm::any(glm::lessThan(glm::abs(centre - glm::round(centre)), most));
}

/// How much 1/z may differ off outlines. OpenGL interpolates it between corners on 256ths of a
/// pixel; the fast engine takes it from the exact plane of a large triangle lit by a lamp, and from
/// the corners that cutting makes. So they differ by what 1/z changes by in such a part of a pixel.
float depth_tolerance(const FastPicture& picture, int column, int row) {
    const float own = picture.inv_z[picture.at(column, row)];
    float change = 0.0f;
    for (const int c : {std::max(column - 1, 0), std::min(column + 1, picture.size.width - 1)})
        change = std::max(change, std::abs(picture.inv_z[picture.at(c, row)] - own));
    for (const int r : {std::max(row - 1, 0), std::min(row + 1, picture.size.height - 1)})
        change = std::max(change, std::abs(picture.inv_z[picture.at(column, r)] - own));
    return 1e-5f * own + change / 128.0f;
}

Difference difference_of(const Scene& scene, const Settings& settings, const FastPicture& fast,
                         const FastPicture& opengl) {
    REQUIRE(fast.size == opengl.size);
    const fast::View view = fast_view(settings);
    const bool is_nearest = settings.texture_filter == TextureFilter::nearest;
    Difference found;
    for (int row = 0; row < fast.size.height; ++row) {
        for (int column = 0; column < fast.size.width; ++column) {
            const std::size_t a = fast.at(column, row), b = opengl.at(column, row);
            const std::int32_t owner = fast.owner[a];
            bool is_other = owner != opengl.owner[b];
            if (is_outline(fast, column, row) || is_outline(opengl, column, row)) {
                ++found.outlines;
                found.outline_owners += is_other ? 1 : 0;
                continue;
            }
            is_other |=
                std::abs(fast.inv_z[a] - opengl.inv_z[b]) > depth_tolerance(fast, column, row);
            const bool is_painted = settings.texture == TextureUse::on && owner >= 0 &&
                                    texture_of(scene, owner) != nullptr;
            found.painted += is_painted ? 1 : 0;
            if (channel_difference(fast.colour[a], opengl.colour[b]) > 2) {
                if (is_painted && is_nearest && is_near_border(scene, view, owner, column, row))
                    ++found.border_texels;
                else
                    is_other = true;
            }
            if (is_other && found.first.empty())
                found.first = fmt::format(
                    "column {}, row {}: {:06x}, 1/z {}, owner {}; OpenGL {:06x}, {}, {}", column,
                    row, fast.colour[a], fast.inv_z[a], owner, opengl.colour[b], opengl.inv_z[b],
                    opengl.owner[b]);
        }
    }
    return found;
}

FastPicture opengl_picture(HostOpenGl& opengl, const Scene& scene, const Settings& settings) {
    FastPicture picture;
    opengl.draw(scene, settings, picture);
    return picture;
}

std::string words_of(const std::vector<const char*>& assignments) {
    std::string words;
    for (const char* const assignment : assignments)
        words += std::string(assignment) + ' ';
    return words;
}

const std::vector<const char*> looks[] = {
    {"shading=phong"},
    {"shading=gouraud"},
    {"stage=depth"},
    {"shading=phong", "light.model=blinn_phong"},
    {"shading=gouraud", "light.model=blinn_phong"},
    {"shading=phong", "cull=screen_area"},
    {"shading=phong", "texture_filter=nearest"},
    {"shading=gouraud", "texture_filter=nearest", "texture_wrap=clamp"},
    {"shading=unlit", "texture_filter=bilinear", "texture_wrap=mirror"},
    {"shading=phong", "viewport.size=251x203", "camera.yaw=0.1", "camera.pitch=-0.07"},
    // Cut by the near plane.
    {"shading=phong", "near=3", "texture_filter=nearest", "camera.yaw=0.2", "camera.pitch=-0.07"},
    {"shading=gouraud", "near=3", "camera.yaw=-0.2"},
    {"shading=phong", "near=0.5", "camera.yaw=1.3", "camera.pitch=0.3"},
};

} // namespace

TEST_CASE("OpenGL draws the scenes and models of the project as the fast engine does") {
    HostOpenGl opengl;
    int compared = 0;
    for (const Scene& scene : some_of(project_scenes_and_models(), 20)) {
        // There surfaces are in one plane, so rounding alone decides which is nearer.
        if (std::filesystem::path(scene.path).stem() == "z-fighting") continue;
        for (const std::vector<const char*>& look : looks) {
            const Settings settings = settings_of(scene, look);
            if (!fast_engine_refuses(scene, settings).empty()) continue;
            CAPTURE(scene.path, words_of(look));
            ++compared;
            const Difference found = difference_of(scene, settings, fast_picture(scene, settings),
                                                   opengl_picture(opengl, scene, settings));
            if (!found.first.empty()) FAIL_CHECK(found.first);
            CHECK(found.outline_owners <= 1 + found.outlines / 300);
            CHECK(found.border_texels <= 1 + found.painted / 300);
        }
    }
    CHECK(compared > 50);
}

TEST_CASE("Far outside a texture OpenGL takes the texels that the fast engine takes") {
    HostOpenGl opengl;
    Random random(23);
    int painted = 0;
    for (int round = 0; round < rounds(40, 8); ++round) {
        Scene scene = textured_scene(many_colours(5, 3), {120, 90});
        scene.space = SceneSpace::world;
        scene.camera = {.position = glm::vec3(0.0f), .focal_length = 1.0f};
        std::array<Vertex, triangle_corners> corners;
        for (std::size_t i = 0; i < triangle_corners; ++i) {
            const float z = random.number(1.0, 2.0);
            const glm::vec2 across(random.number(-60.0, 60.0), random.number(-45.0, 45.0));
            corners[i].position = {across * z, z};
            corners[i].texcoord = {random.number(-4.0, 5.0), random.number(-4.0, 5.0)};
        }
        scene.parts.push_back({.name = "painted", .triangle_count = 1, .texture = 0});
        scene.mesh.add_triangle_of(corners);
        for (const char* const filter : {"texture_filter=nearest", "texture_filter=bilinear"}) {
            for (const char* const wrap :
                 {"texture_wrap=repeat", "texture_wrap=clamp", "texture_wrap=mirror"}) {
                const Settings settings = settings_of(scene, {"shading=unlit", filter, wrap});
                CAPTURE(round, filter, wrap);
                const Difference found =
                    difference_of(scene, settings, fast_picture(scene, settings),
                                  opengl_picture(opengl, scene, settings));
                if (!found.first.empty()) FAIL_CHECK(found.first);
                CHECK(found.border_texels <= 1 + found.painted / 300);
                painted += found.painted;
            }
        }
    }
    CHECK(painted > 20'000);
}

TEST_CASE("Edges through centres of pixels are top or left edges, and bytes are cut off") {
    HostOpenGl opengl;
    Random random(11);
    Settings settings;
    for (int round = 0; round < rounds(200, 20); ++round) {
        Scene scene;
        // One unit is a pixel at z = 1: corners are on centres and between pixels.
        scene.camera = {.position = glm::vec3(0.0f), .focal_length = 1.0f};
        scene.viewport = {64, 48};
        // Halfway between two bytes, of which the lower one is taken.
        const glm::vec3 halves(0.5f, 0.1f, 0.7f);
        const auto corner = [&] {
            return Vertex{.position = {static_cast<float>(random.integer(-64, 64)) / 2.0f,
                                       static_cast<float>(random.integer(-48, 48)) / 2.0f, 1.0f},
                          .reflectance = halves};
        };
        const Vertex a = corner(), b = corner();
        scene.mesh.add_triangle_of({a, b, corner()});
        scene.mesh.add_triangle_of({b, a, corner()});
        settings = default_settings(scene);
        settings.stage = Stage::depth;
        const FastPicture fast = fast_picture(scene, settings);
        const FastPicture drawn = opengl_picture(opengl, scene, settings);
        int other = 0;
        for (int row = 0; row < 48; ++row) {
            for (int column = 0; column < 64; ++column) {
                const std::size_t p = fast.at(column, row), q = drawn.at(column, row);
                other += fast.owner[p] != drawn.owner[q] || fast.colour[p] != drawn.colour[q];
            }
        }
        CHECK(other == 0);
    }
}

TEST_CASE("OpenGL fills without a depth test, and lights whole triangles, as the steps do") {
    HostOpenGl opengl;
    for (const char* const look : {"stage=fill", "shading=flat", "stage=depth"}) {
        for (const Scene& scene :
             {lab_room(), read_scene_file(lessons_folder() + "/scenes/checkered-room.toml"),
              // Its corners have different normals.
              read_scene_file(lessons_folder() + "/scenes/cylinder.toml")}) {
            Settings settings = settings_of(scene, {look, "texture_filter=nearest"});
            CAPTURE(scene.path, look);
            const FastDifference found = difference(opengl_picture(opengl, scene, settings),
                                                    draw_frame(prepare_frame(scene, settings)));
            if (!found.is_small()) FAIL_CHECK(found.words());
        }
    }
}

TEST_CASE("OpenGL's lines are white, run along the edges of all triangles, and have no depth") {
    HostOpenGl opengl;
    const Scene room = lab_room();
    const Settings settings = settings_of(room, {"stage=edges"});
    const FastPicture lines = opengl_picture(opengl, room, settings);
    const RayCaster caster(room, settings.camera, settings.light);
    const glm::dvec2 middle(lines.size.width / 2, lines.size.height / 2); // whole pixels
    int drawn = 0, other = 0;
    for (int row = 1; row < lines.size.height - 1; ++row) {
        for (int column = 1; column < lines.size.width - 1; ++column) {
            const std::size_t at = lines.at(column, row);
            const bool is_line = lines.owner[at] >= 0;
            const double distance =
                caster.distance_to_edges(glm::dvec2(column + 0.5, row + 0.5) - middle);
            drawn += is_line ? 1 : 0;
            // A line is one pixel wide along its shorter axis.
            const bool is_missing = distance < 0.1 && !is_line && !is_outline(lines, column, row);
            other += (is_line && distance > 0.75) || is_missing ? 1 : 0;
            other += lines.colour[at] != (is_line ? 0xffffffU : 0U) ? 1 : 0;
            other += lines.inv_z[at] != 0.0f ? 1 : 0;
        }
    }
    CHECK(drawn > 5000);
    CHECK(other == 0);
}
