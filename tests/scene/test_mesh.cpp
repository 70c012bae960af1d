#include "scene/mesh.h"

#include <limits>
#include <set>
#include <string>

#include "base/error.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "support/bits.h"
#include "support/made_scene.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Vertex vertex_at(float x, float y, float z) {
    Vertex vertex;
    vertex.position = {x, y, z};
    return vertex;
}

bool same_bits_all(const Vertex& a, const Vertex& b) {
    return same_bits(a.position, b.position) && same_bits(a.normal, b.normal) &&
           same_bits(a.reflectance, b.reflectance) && same_bits(a.texcoord.x, b.texcoord.x) &&
           same_bits(a.texcoord.y, b.texcoord.y) && same_bits(a.shine.specular, b.shine.specular) &&
           same_bits(a.shine.exponent, b.shine.exponent);
}

/// Two triangles with a common edge, as four vertices.
Mesh square() {
    Mesh mesh;
    for (const auto& [x, y] : {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}, {1.0f, 1.0f}})
        mesh.add_vertex(vertex_at(x, y, 1.0f));
    mesh.add_triangle({0, 1, 2});
    mesh.add_triangle({1, 3, 2});
    return mesh;
}

/// The sentence with which a mesh refuses a triangle.
std::string refusal(Mesh& mesh, const TriangleIndices& indices) {
    try {
        mesh.add_triangle(indices);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

int calls = 0;

ClipVertex counting_vertex_shader(const Vertex& vertex, const glm::mat3& rotation,
                                  const VertexRules& rules, const Stages& stages,
                                  VertexSpaces* spaces) {
    ++calls;
    return vertex_shader(vertex, rotation, rules, stages, spaces);
}

} // namespace

TEST_CASE("A corner of a triangle is the vertex that its index names") {
    const Mesh mesh = square();
    CHECK(mesh.triangle_count() == 2);
    CHECK(mesh.vertices().size() == 4);
    CHECK(mesh.corner(0, 2).position == glm::vec3(0, 1, 1));
    CHECK(mesh.corner(1, 0).position == glm::vec3(1, 0, 1));
    CHECK(mesh.corner(1, 1).position == glm::vec3(1, 1, 1));
    CHECK(&mesh.corner(0, 2) == &mesh.corner(1, 2));
}

TEST_CASE("A mesh refuses a triangle whose vertex it does not have, and stays as it is") {
    Mesh mesh = square();
    CHECK(refusal(mesh, {0, 1, 4}) == "a triangle has the vertex 4 of a mesh with 4 vertices.");
    CHECK(refusal(mesh, {-1, 1, 2}) == "a triangle has the vertex -1 of a mesh with 4 vertices.");
    CHECK(refusal(mesh, {0, std::numeric_limits<int>::max(), 2}) ==
          "a triangle has the vertex 2147483647 of a mesh with 4 vertices.");
    CHECK(refusal(mesh, {0, 0, std::numeric_limits<int>::min()}) ==
          "a triangle has the vertex -2147483648 of a mesh with 4 vertices.");
    CHECK(mesh.triangle_count() == 2);
    CHECK(mesh == square());
    Mesh empty;
    CHECK(refusal(empty, {0, 0, 0}) == "a triangle has the vertex 0 of a mesh with 0 vertices.");
    CHECK(refusal(mesh, {3, 3, 3}) == "accepted");
}

TEST_CASE("Vertices are joined where they are equal in every bit, and nowhere else") {
    Mesh mesh;
    VertexJoin join(mesh);
    Vertex vertex = vertex_at(1.0f, 0.0f, 3.0f);
    const int first = join.index_of(vertex);
    CHECK(join.index_of(vertex) == first);
    std::set<int> indices{first};
    const auto is_another = [&](const Vertex& changed) {
        const bool is_new = indices.insert(join.index_of(changed)).second;
        return is_new && join.index_of(changed) == static_cast<int>(mesh.vertices().size()) - 1;
    };
    const auto with = [&](auto change) {
        Vertex changed = vertex;
        change(changed);
        return changed;
    };
    for (int i = 0; i < 3; ++i) {
        CAPTURE(i);
        CHECK(is_another(with([&](Vertex& v) { v.position[i] += 1.0f; })));
        CHECK(is_another(with([&](Vertex& v) { v.normal[i] = 1.0f; })));
        CHECK(is_another(with([&](Vertex& v) { v.reflectance[i] = 0.5f; })));
        CHECK(is_another(with([&](Vertex& v) { v.shine.specular[i] = 0.5f; })));
    }
    CHECK(is_another(with([](Vertex& v) { v.texcoord.x = 1.0f; })));
    CHECK(is_another(with([](Vertex& v) { v.texcoord.y = 1.0f; })));
    CHECK(is_another(with([](Vertex& v) { v.shine.exponent = 9.0f; })));
    // -0 and 0 are equal, yet two numbers; a NaN is not equal to itself, yet is one number.
    CHECK(is_another(with([](Vertex& v) { v.position.y = -0.0f; })));
    const Vertex nan =
        with([](Vertex& v) { v.position.y = std::numeric_limits<float>::quiet_NaN(); });
    CHECK(is_another(nan));
    CHECK(join.index_of(vertex) == first);
    CHECK(indices.size() == mesh.vertices().size());
}

TEST_CASE("A mesh knows whether the corners of a triangle differ in normal or colour") {
    Mesh mesh = square();
    CHECK(mesh.differences() == CornerDifferences{});
    std::array<Vertex, triangle_corners> corners{vertex_at(0, 0, 0), vertex_at(1, 0, 0),
                                                 vertex_at(0, 1, 0)};
    corners[1].texcoord.x = 0.5f; // this travels anyway
    mesh.add_triangle_of(corners);
    CHECK(mesh.differences() == CornerDifferences{});
    corners[2].reflectance.b = 0.5f;
    mesh.add_triangle_of(corners);
    CHECK(mesh.differences() == CornerDifferences{false, true});
    corners[1].normal = {0.0f, 0.0f, 1.0f};
    mesh.add_triangle_of(corners);
    CHECK(mesh.differences() == CornerDifferences{true, true});
    const int last = mesh.triangle_count() - 1;
    CHECK(mesh.differences(last) == CornerDifferences{true, true});
    CHECK(mesh.differences(last - 1) == CornerDifferences{false, true});
    CHECK(mesh.differences(last - 2) == CornerDifferences{});
}

TEST_CASE("A mesh knows whether a vertex has a highlight") {
    Mesh mesh;
    Vertex vertex;
    vertex.shine.exponent = 20.0f;
    mesh.add_vertex(vertex);
    CHECK_FALSE(mesh.is_shiny());
    vertex.shine.specular = {0.0f, 0.5f, 0.0f};
    mesh.add_vertex(vertex);
    mesh.add_vertex(Vertex());
    CHECK(mesh.is_shiny());
}

TEST_CASE("Moving a corner leaves the other triangles where they are") {
    const Mesh before = square();
    Mesh mesh = before;
    mesh.place_corner(0, 1, {7.0f, 8.0f, 9.0f});
    CHECK(mesh.corner(0, 1).position == glm::vec3(7, 8, 9));
    CHECK(mesh.corner(1, 0).position == glm::vec3(1, 0, 1));
    CHECK(mesh.vertices().size() == 5);
    // The corner has its own vertex now.
    mesh.place_corner(0, 1, {1.0f, 2.0f, 3.0f});
    CHECK(mesh.vertices().size() == 5);
    CHECK_FALSE(mesh == before);
    // The same triangles are the same mesh, however many vertices they share.
    mesh.place_corner(0, 1, before.corner(0, 1).position);
    CHECK(mesh == before);

    Mesh point;
    point.add_vertex(vertex_at(7.0f, 7.0f, 1.0f));
    point.add_triangle({0, 0, 0});
    point.place_corner(0, 1, {1.0f, 2.0f, 3.0f});
    CHECK(point.corner(0, 0).position == glm::vec3(7, 7, 1));
    CHECK(point.corner(0, 1).position == glm::vec3(1, 2, 3));
    CHECK(point.corner(0, 2).position == glm::vec3(7, 7, 1));
}

TEST_CASE("Triangles in a flat face of the room share the vertices of their common edge") {
    const Scene room = lab_room();
    REQUIRE(room.triangle_count() == 30);
    int shared = 0;
    for (int t = 0; t < 30; t += 2) {
        CAPTURE(t);
        std::set<int> vertices;
        for (const int triangle : {t, t + 1}) {
            const TriangleIndices& indices =
                room.mesh.triangles()[static_cast<std::size_t>(triangle)];
            vertices.insert(indices.begin(), indices.end());
        }
        // In some faces the normals differ in the last bit, or in the sign of a zero.
        const bool is_flat = same_bits(room.corner(t, 0).normal, room.corner(t + 1, 0).normal);
        CHECK(vertices.size() == (is_flat ? 4u : 6u));
        shared += is_flat ? 1 : 0;
    }
    CHECK(shared == 10);
    CHECK(room.mesh.vertices().size() == 90 - 2 * 10);
    // No vertex belongs to two faces: each has its own normal.
    for (int t = 0; t < 30; ++t) {
        for (int u = t / 2 * 2 + 2; u < 30; ++u) {
            for (const int index : room.mesh.triangles()[static_cast<std::size_t>(t)]) {
                for (const int other : room.mesh.triangles()[static_cast<std::size_t>(u)])
                    CHECK(index != other);
            }
        }
    }
}

TEST_CASE("A scene read from a file has each vertex once, in use, with its triangle's normal") {
    for (const char* name : {"lab-room", "corridor", "one-triangle", "fence", "wide-wall",
                             "linear-z", "three-needles"}) {
        CAPTURE(name);
        const Scene scene = read_scene(lessons_folder() + "/scenes/" + name + ".toml");
        const std::vector<Vertex>& vertices = scene.mesh.vertices();
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (same_bits_all(vertices[i], vertices[j])) FAIL(i << " and " << j << " are one");
            }
        }
        std::set<int> used;
        for (int t = 0; t < scene.triangle_count(); ++t) {
            const auto corners = corners_of(scene, t);
            const glm::vec3 normal =
                face_normal(corners[0].position, corners[1].position, corners[2].position);
            for (int i = 0; i < triangle_corners; ++i) {
                const auto v = static_cast<std::size_t>(i);
                CHECK(same_bits(corners[v].normal, normal));
                CHECK(same_bits_all(scene.corner(t, i), corners[v]));
                used.insert(scene.mesh.triangles()[static_cast<std::size_t>(t)][v]);
            }
        }
        CHECK(used.size() == vertices.size());
    }
}

TEST_CASE("A vertex is shaded once, however many triangles meet in it") {
    for (const Scene& scene : {lab_room(), made_scene(1'000), small_scene()}) {
        CAPTURE(scene.name);
        calls = 0;
        const Frame frame = prepare_frame(scene, default_settings(scene), [](Stages& stages) {
            stages.vertex_shader = counting_vertex_shader;
        });
        CHECK(calls == static_cast<int>(scene.mesh.vertices().size()));
        // Drawing what is prepared shades none again.
        draw_frame(frame);
        CHECK(calls == static_cast<int>(scene.mesh.vertices().size()));
    }
}

TEST_CASE("A picture does not show whether vertices are shared") {
    const Scene joined = made_scene(600);
    Scene separate = joined;
    separate.mesh = {};
    for (int t = 0; t < joined.triangle_count(); ++t)
        separate.mesh.add_triangle_of(corners_of(joined, t));
    REQUIRE(separate.mesh.vertices().size() == 1800);
    CHECK(separate == joined);
    for (const StripStep& step : {StripStep{Stage::points}, StripStep{Stage::rows},
                                  StripStep::vertex_light, StripStep::pixel_light}) {
        Settings settings = default_settings(joined);
        set_step(settings, step);
        const Framebuffer a = draw_frame(prepare_frame(joined, settings));
        const Framebuffer b = draw_frame(prepare_frame(separate, settings));
        CHECK(first_difference(a, b) == "");
    }
}

TEST_CASE(
    "A large mesh takes a vertex and an index where a list of triangles took three vertices") {
    const Scene scene = made_scene(20'000);
    REQUIRE(scene.triangle_count() == 20'000);
    CHECK(scene.mesh.vertices().size() < 15'000);
    CHECK(sizeof(TriangleIndices) == 12);
    const std::size_t bytes = scene.mesh.vertices().size() * sizeof(Vertex) +
                              scene.mesh.triangles().size() * sizeof(TriangleIndices);
    CHECK(3 * bytes < scene.mesh.triangles().size() * 3 * sizeof(Vertex));
}

TEST_CASE("Every triangle of a scene belongs to the part that counts it") {
    const Scene room = lab_room();
    for (int p = 0; p < static_cast<int>(room.parts.size()); ++p) {
        const Part& part = room.parts[static_cast<std::size_t>(p)];
        for (int i = 0; i < part.triangle_count; ++i)
            CHECK(part_of(room, part.first_triangle + i) == p);
    }
    CHECK(part_name(room, 0) == "floor");
    CHECK(part_name(room, 29) == "tall block");
    CHECK(part_of(Scene{}, 0) == -1);
}
