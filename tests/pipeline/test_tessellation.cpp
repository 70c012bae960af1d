// The cut mesh compared with barycentric points in double, and its pictures with the uncut ones.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <set>
#include <tuple>
#include <vector>

#include <glm/geometric.hpp>

#include "compare/compare.h"
#include "compare/divergence.h"
#include "pipeline/draw.h"
#include "scene/tessellation.h"
#include "stages/vertex_shader.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {
namespace cut {

using Corners = std::array<Vertex, 3>;

/// Two triangles of a square in the plane z = 1, side 2. They share the vertices of the diagonal.
Scene wall() {
    Scene scene;
    scene.name = "a wall";
    for (const glm::vec2 at :
         {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(-1, 1), glm::vec2(1, 1)}) {
        Vertex vertex;
        vertex.position = glm::vec3(at, 1.0f);
        vertex.normal = {0.0f, 0.0f, -1.0f};
        vertex.reflectance = glm::vec3(0.8f, 0.6f, 0.4f);
        vertex.texcoord = at;
        scene.mesh.add_vertex(vertex);
    }
    scene.mesh.add_triangle({0, 1, 2});
    scene.mesh.add_triangle({2, 1, 3});
    scene.parts = {{"left", 0, 1}, {"right", 1, 1}};
    scene.viewport = {60, 60};
    scene.camera = {{0.137f, 0.052f, -0.93f}, 0.2f, 0.0f, 55.0f};
    scene.light.position = {0.21f, -0.13f, 0.3f};
    scene.light.power = glm::vec3(6.0f);
    return scene;
}

/// One triangle with different values at each corner.
Scene slope() {
    Scene scene;
    scene.mesh.add_triangle_of(
        {Vertex{{-1.0f, 0.3f, 2.0f}, {0.0f, 0.6f, -0.8f}, {0.9f, 0.1f, 0.2f}, {0.0f, 0.0f}},
         Vertex{{2.0f, -0.7f, 3.1f}, {0.0f, -0.8f, -0.6f}, {0.2f, 0.8f, 0.2f}, {1.0f, 0.5f}},
         Vertex{{0.4f, 1.9f, 5.0f}, {0.6f, 0.0f, -0.8f}, {0.1f, 0.3f, 1.0f}, {0.0f, 2.0f}}});
    scene.parts = {{"slope", 0, 1}};
    return scene;
}

glm::dvec3 cross_of(const Mesh& mesh, int t) {
    const glm::dvec3 a(mesh.corner(t, 0).position);
    return glm::cross(glm::dvec3(mesh.corner(t, 1).position) - a,
                      glm::dvec3(mesh.corner(t, 2).position) - a);
}

Settings sharp(const Scene& scene, Shading shading, int tessellation) {
    Settings settings = default_settings(scene);
    settings.stage = Stage::shade;
    settings.shading = shading;
    settings.tessellation = tessellation;
    settings.coverage = Coverage::edge_functions;
    settings.fill_rule = FillRule::top_left;
    settings.snap = Snap::subpixel;
    return settings;
}

struct Apart {
    double mean = 0.0, largest = 0.0;
};

/// The largest difference of light in any channel, over all pixels.
Apart apart(const Framebuffer& a, const Framebuffer& b) {
    Apart result;
    for (std::size_t i = 0; i < a.colour.size(); ++i) {
        double most = 0.0;
        for (int channel = 0; channel < 3; ++channel)
            most = std::max(most, std::abs(static_cast<double>(a.colour[i][channel]) -
                                           static_cast<double>(b.colour[i][channel])));
        result.mean += most / static_cast<double>(a.colour.size());
        result.largest = std::max(result.largest, most);
    }
    return result;
}

} // namespace cut
} // namespace

TEST_CASE("Each triangle is cut into n * n of equal area and orientation, on a barycentric grid") {
    const Scene scene = cut::slope();
    for (const int n : {1, 2, 3, 7}) {
        CAPTURE(n);
        const Mesh mesh = tessellate(scene, n).mesh;
        REQUIRE(mesh.triangle_count() == n * n);
        CHECK(static_cast<int>(mesh.vertices().size()) == (n + 1) * (n + 2) / 2);
        const glm::dvec3 whole = cut::cross_of(scene.mesh, 0);
        for (int t = 0; t < n * n; ++t) {
            CAPTURE(t);
            const glm::dvec3 part = cut::cross_of(mesh, t) * static_cast<double>(n * n);
            CHECK(glm::length(part - whole) < 1e-4 * glm::length(whole));
        }
        // Every point of the grid exists, with the right values.
        for (int i = 0; i <= n; ++i) {
            for (int k = 0; i + k <= n; ++k) {
                const glm::dvec3 weights(static_cast<double>(n - i - k) / n,
                                         static_cast<double>(i) / n, static_cast<double>(k) / n);
                const auto mixed = [&](auto Vertex::*member) {
                    glm::dvec3 sum(0.0);
                    for (int c = 0; c < 3; ++c) {
                        const auto& value = scene.corner(0, c).*member;
                        for (int axis = 0; axis < value.length(); ++axis)
                            sum[axis] += weights[c] * static_cast<double>(value[axis]);
                    }
                    return sum;
                };
                const glm::dvec3 place = mixed(&Vertex::position);
                const auto found = std::find_if(
                    mesh.vertices().begin(), mesh.vertices().end(), [&](const Vertex& vertex) {
                        return glm::length(glm::dvec3(vertex.position) - place) < 1e-5;
                    });
                REQUIRE(found != mesh.vertices().end());
                CHECK(glm::length(glm::dvec3(found->reflectance) - mixed(&Vertex::reflectance)) <
                      1e-6);
                CHECK(glm::length(glm::dvec3(found->texcoord, 0.0f) - mixed(&Vertex::texcoord)) <
                      1e-6);
                const glm::dvec3 normal = glm::normalize(mixed(&Vertex::normal));
                CHECK(glm::length(glm::dvec3(found->normal) - normal) < 1e-6);
            }
        }
    }
}

TEST_CASE("A vertex on a shared edge is in the list once; parts and flat normals are kept") {
    const Scene scene = cut::wall();
    const int n = 5;
    const Scene made = tessellate(scene, n);
    // Two triangles, which share the n + 1 vertices of the diagonal.
    CHECK(static_cast<int>(made.mesh.vertices().size()) == (n + 1) * (n + 2) - (n + 1));
    CHECK(made.parts == std::vector<Part>{{"left", 0, n * n}, {"right", n * n, n * n}});
    CHECK(made.mesh.differences() == CornerDifferences{});
    for (int v = 0; v < 4; ++v)
        CHECK(made.mesh.vertices()[static_cast<std::size_t>(v)] ==
              scene.mesh.vertices()[static_cast<std::size_t>(v)]);
}

TEST_CASE("Neighbours with separate vertices have the same places on their edge to the bit") {
    Scene scene;
    const glm::vec3 a(-0.3f, 0.11f, 1.7f), b(0.91f, -1.3f, 2.9f);
    scene.mesh.add_triangle_of({Vertex{a}, Vertex{b}, Vertex{{-2.0f, -2.0f, 2.0f}}});
    Vertex other_a{a}, other_b{b};
    other_a.normal = other_b.normal = {1.0f, 0.0f, 0.0f};
    scene.mesh.add_triangle_of({other_b, other_a, Vertex{{3.0f, 3.0f, 2.0f}, other_a.normal}});
    for (const int n : {3, 7, 10}) {
        using Place = std::tuple<float, float, float>;
        std::array<std::set<Place>, 2> on_edge;
        const Mesh mesh = tessellate(scene, n).mesh;
        const glm::dvec3 way = glm::dvec3(b) - glm::dvec3(a);
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            for (int c = 0; c < 3; ++c) {
                const glm::vec3& p = mesh.corner(t, c).position;
                const glm::dvec3 off = glm::cross(glm::dvec3(p) - glm::dvec3(a), way);
                if (glm::length(off) < 1e-5)
                    on_edge[static_cast<std::size_t>(t / (n * n))].insert({p.x, p.y, p.z});
            }
        }
        CAPTURE(n);
        CHECK(on_edge[0].size() == static_cast<std::size_t>(n + 1));
        CHECK(on_edge[0] == on_edge[1]);
    }
}

TEST_CASE("An object's places before its model transformation are cut like the mesh") {
    Scene scene = cut::slope();
    std::vector<glm::vec3>& places = scene.parts[0].model.positions;
    for (int c = 0; c < 3; ++c)
        places.push_back(scene.corner(0, c).position * 2.0f);
    const Scene made = tessellate(scene, 4);
    REQUIRE(made.parts[0].model.positions.size() == 3u * 16u);
    for (int t = 0; t < 16; ++t) {
        for (int c = 0; c < 3; ++c) {
            const glm::vec3 place =
                made.parts[0].model.positions[static_cast<std::size_t>(3 * t + c)];
            CHECK(glm::length(place - made.corner(t, c).position * 2.0f) < 1e-5f);
        }
    }
}

TEST_CASE("A scene is cut as finely as the limit allows, and one in pixels not at all") {
    Scene scene = cut::wall();
    CHECK(tessellation_of(scene, 1) == 1);
    CHECK(tessellation_of(scene, 64) == 64);
    scene.space = SceneSpace::pixels;
    CHECK(tessellation_of(scene, 64) == 1);
    Scene many;
    for (int t = 0; t < 50'001; ++t)
        many.mesh.add_triangle_of({});
    CHECK(tessellation_of(many, 64) == 1); // 4 * 50 001 are too many
}

TEST_CASE(
    "An uncut frame draws the scene itself, and a cut one keeps its mesh while it is the same") {
    const Scene scene = cut::wall();
    Frame frame = prepare_frame(scene, cut::sharp(scene, Shading::phong, 1));
    CHECK(frame.scene == &scene);
    CHECK(frame.tessellated == nullptr);
    Settings settings = cut::sharp(scene, Shading::phong, 3);
    prepare_frame(scene, settings, nullptr, frame);
    CHECK(frame.given == &scene);
    CHECK(frame.triangle_count() == 18);
    CHECK(frame.triangles_of_each() == 9);
    CHECK(frame.projected.size() == frame.scene->mesh.vertices().size());
    const Scene* const made = frame.scene;
    settings.camera.yaw = 0.2f;
    prepare_frame(scene, settings, nullptr, frame);
    CHECK(frame.scene == made);
    Scene moved = scene;
    moved.mesh.place_corner(0, 0, {-1.5f, -1.0f, 1.0f});
    prepare_frame(moved, settings, nullptr, frame);
    CHECK(frame.scene->corner(0, 0).position.x == -1.5f);
}

TEST_CASE("A triangle of one frame is found among the parts of another frame of the scene") {
    const Scene scene = cut::wall();
    const Frame whole = prepare_frame(scene, cut::sharp(scene, Shading::phong, 1));
    const Frame fine = prepare_frame(scene, cut::sharp(scene, Shading::phong, 4));
    CHECK(triangle_in(whole, fine, 15) == 0);
    CHECK(triangle_in(whole, fine, 16) == 1);
    CHECK(triangle_in(fine, whole, 1) == 16);
    CHECK(triangle_in(fine, fine, 21) == 21);
}

TEST_CASE("Light at the vertices approaches light at the pixels as triangles are cut") {
    const Scene scene = cut::wall();
    std::vector<cut::Apart> errors;
    for (const int n : {1, 2, 4, 8, 16}) {
        const Framebuffer gouraud =
            draw_frame(prepare_frame(scene, cut::sharp(scene, Shading::gouraud, n)));
        const Framebuffer phong =
            draw_frame(prepare_frame(scene, cut::sharp(scene, Shading::phong, n)));
        errors.push_back(cut::apart(gouraud, phong));
        INFO(n << " parts an edge: mean " << errors.back().mean << ", largest "
               << errors.back().largest);
        if (errors.size() < 2) continue;
        const cut::Apart& before = errors[errors.size() - 2];
        CHECK(errors.back().mean < before.mean);
        CHECK(errors.back().largest < before.largest);
    }
    // Straight lines replace a curve: with half the length a quarter of the error remains.
    CHECK(errors[4].mean < 0.35 * errors[3].mean);
    CHECK(errors[4].largest < 0.1 * errors[0].largest);
}

TEST_CASE("With light at the pixels the cut surface is the same, except for ties on edges") {
    const Scene scene = cut::wall();
    const Framebuffer whole =
        draw_frame(prepare_frame(scene, cut::sharp(scene, Shading::phong, 1)));
    for (const int n : {2, 5, 16}) {
        const Framebuffer fine =
            draw_frame(prepare_frame(scene, cut::sharp(scene, Shading::phong, n)));
        int covered = 0, other_owner = 0, other_coverage = 0, other_light = 0;
        for (std::size_t i = 0; i < whole.colour.size(); ++i) {
            const int owner = fine.owner[i] < 0 ? -1 : fine.owner[i] / (n * n);
            covered += whole.owner[i] >= 0 ? 1 : 0;
            other_coverage += (owner < 0) != (whole.owner[i] < 0) ? 1 : 0;
            other_owner += owner != whole.owner[i] ? 1 : 0;
            if (owner < 0 || whole.owner[i] < 0) continue;
            const glm::dvec3 off = glm::dvec3(fine.colour[i]) - glm::dvec3(whole.colour[i]);
            // Corners are on 256ths of a pixel, so the point under a pixel moves by as little.
            other_light += glm::length(off) > 0.005 ? 1 : 0;
        }
        CAPTURE(n, covered, other_owner, other_coverage, other_light);
        CHECK(covered > 2000);
        CHECK(other_coverage <= 3);
        CHECK(other_owner <= 5);
        CHECK(other_light == 0);
    }
}

TEST_CASE("Runs that cut a scene differently are compared by their pictures, which is reported") {
    const Scene scene = cut::wall();
    const Frame a = prepare_frame(scene, cut::sharp(scene, Shading::gouraud, 1));
    const Frame b = prepare_frame(scene, cut::sharp(scene, Shading::gouraud, 4));
    const Comparison found = compare_runs(a, b);
    CHECK(found.pixels == pixel_difference(draw_frame(a), draw_frame(b)));
    CHECK(found.pixels.different > 1000);
    CHECK(found.only_pictures ==
          "A draws 1 triangle for each triangle of the scene and B 16, so only the pictures are "
          "compared.");
    CHECK_FALSE(found.is_same());
    CHECK_FALSE(next_divergence(a, b, cursor_begin));
    // Done in parts, the result is the same.
    ComparisonWork work;
    work.begin(b, a);
    int calls = 0;
    for (; !work.is_done() && calls < 10'000; ++calls)
        work.advance({.at_once = 100.0, .slice = 100.0});
    CHECK(calls > 2);
    CHECK(work.found().pixels == pixel_difference(draw_frame(b), draw_frame(a)));
    // If both are cut the same way, moments are compared as usual.
    CHECK(compare_runs(b, b).is_same());
}
