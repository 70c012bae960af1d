// The reader compared with tinyobjloader, on files that the library reads correctly: without
// faults, with polygons that are not cut, so that faces, corners and numbers can be compared one by
// one.

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include "scene/read_obj.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/made_models.h"
#include "tests/support/random.h"

using namespace rasterwalk;

namespace {

struct TinyModel {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
};

TinyModel read_by_tinyobj(const std::string& text, bool cuts) {
    TinyModel model;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    std::istringstream stream(text);
    REQUIRE(tinyobj::LoadObj(&model.attributes, &model.shapes, &materials, &warning, &error,
                             &stream, nullptr, cuts));
    REQUIRE(error.empty());
    return model;
}

/// A mesh of triangles in several groups, in each of the four forms of corners, some counted back.
std::string made_text(test::Random& random) {
    const int points = random.integer(3, 30), texcoords = random.integer(1, 9);
    const int normals = random.integer(1, 9);
    std::ostringstream text;
    const auto number = [&] { return random.number(-9, 9); };
    for (int i = 0; i < points; ++i)
        text << "v " << number() << ' ' << number() << ' ' << number() << '\n';
    for (int i = 0; i < texcoords; ++i)
        text << "vt " << number() << ' ' << number() << '\n';
    for (int i = 0; i < normals; ++i)
        text << "vn " << number() << ' ' << number() << " 0.5\n";
    const auto index = [&](int count) {
        const int i = random.integer(1, count);
        return random.integer(0, 1) != 0 ? i : i - count - 1;
    };
    for (int face = random.integer(1, 20); face > 0; --face) {
        if (random.integer(0, 4) == 0) text << "g part" << face << '\n';
        const int form = random.integer(0, 3);
        text << "f";
        for (int i = 0; i < 3; ++i) {
            text << ' ' << index(points);
            if (form == 1 || form == 3) text << '/' << index(texcoords);
            if (form == 2) text << '/';
            if (form >= 2) text << '/' << index(normals);
        }
        text << (random.integer(0, 1) != 0 ? "\r\n" : "\n");
    }
    return text.str();
}

bool is_near(float a, float b) {
    return std::abs(a - b) <= 1e-5f * (1.0f + std::abs(b));
}

} // namespace

TEST_CASE("Triangles are those that tinyobjloader reads, corner by corner") {
    test::Random random(304);
    for (int i = 0; i < test::rounds(300, 30); ++i) {
        const std::string text = made_text(random);
        INFO("round " << i << ":\n" << text);
        const ObjModel ours = parse_obj(text, "m.obj");
        const TinyModel theirs = read_by_tinyobj(text, false);
        REQUIRE(ours.report.counts.faults == 0);
        CHECK(ours.report.counts.positions * 3 ==
              static_cast<std::int64_t>(theirs.attributes.vertices.size()));
        CHECK(ours.report.counts.texcoords * 2 ==
              static_cast<std::int64_t>(theirs.attributes.texcoords.size()));
        CHECK(ours.report.counts.normals * 3 ==
              static_cast<std::int64_t>(theirs.attributes.normals.size()));
        int corner = 0;
        for (const tinyobj::shape_t& shape : theirs.shapes) {
            for (const tinyobj::index_t& index : shape.mesh.indices) {
                INFO("corner " << corner);
                REQUIRE(corner < 3 * ours.mesh.triangle_count());
                const Vertex& vertex = ours.mesh.corner(corner / 3, corner % 3);
                const auto at = [](const std::vector<float>& list, int i_of, int size, int axis) {
                    return list[static_cast<std::size_t>(i_of * size + axis)];
                };
                glm::vec3 normal(0.0f);
                for (int axis = 0; axis < 3; ++axis) {
                    CHECK(is_near(vertex.position[axis],
                                  at(theirs.attributes.vertices, index.vertex_index, 3, axis)));
                    if (index.normal_index >= 0)
                        normal[axis] = at(theirs.attributes.normals, index.normal_index, 3, axis);
                }
                for (int axis = 0; axis < 2; ++axis) {
                    const float expected =
                        index.texcoord_index < 0
                            ? 0.0f
                            : at(theirs.attributes.texcoords, index.texcoord_index, 2, axis);
                    CHECK(is_near(vertex.texcoord[axis], expected));
                }
                if (index.normal_index >= 0) {
                    const float length =
                        std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
                    for (int axis = 0; axis < 3; ++axis)
                        CHECK(is_near(vertex.normal[axis], normal[axis] / length));
                }
                ++corner;
            }
        }
        CHECK(corner == 3 * ours.mesh.triangle_count());
    }
}

TEST_CASE("The models that come with the program have the faces that tinyobjloader counts") {
    for (const test::MadeFile& made : test::made_models()) {
        if (!is_model_file(made.name)) continue;
        INFO(made.name);
        const ObjCounts counts = parse_obj(made.text, made.name).report.counts;
        std::size_t faces = 0, corners = 0, triangles = 0;
        for (const tinyobj::shape_t& shape : read_by_tinyobj(made.text, false).shapes) {
            faces += shape.mesh.num_face_vertices.size();
            corners += shape.mesh.indices.size();
        }
        for (const tinyobj::shape_t& shape : read_by_tinyobj(made.text, true).shapes)
            triangles += shape.mesh.num_face_vertices.size();
        CHECK(counts.faces == static_cast<std::int64_t>(faces));
        CHECK(counts.corners == static_cast<std::int64_t>(corners));
        CHECK(counts.triangles == static_cast<std::int64_t>(triangles));
    }
}
