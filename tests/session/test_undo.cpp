#include "session/undo.h"

#include "session/session.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

/// A scene of so many triangles that has this texture.
Scene large_scene(const std::string& name, int triangles, const SharedTexture& texture) {
    Scene scene;
    scene.name = name;
    for (int i = 0; i < triangles; ++i)
        scene.mesh.add_triangle_of({});
    scene.textures.push_back(texture);
    return scene;
}

SharedTexture texture_of_side(int side) {
    Image image{side, side, {}};
    image.rgba.resize(std::size_t{4} * image.width * image.height);
    return SharedTexture(make_texture("made", image));
}

std::size_t bytes_of_scenes(const std::vector<const Scene*>& scenes) {
    KeptBytes bytes;
    for (const Scene* scene : scenes)
        bytes.add(scene);
    return bytes.total();
}

std::size_t triangle_bytes(int triangles) {
    return static_cast<std::size_t>(triangles) *
           (triangle_corners * sizeof(Vertex) + sizeof(TriangleIndices));
}

} // namespace

TEST_CASE("Scenes take the memory of their triangles and texels, and anything shared counts once") {
    const SharedTexture texture = texture_of_side(64);
    const std::size_t texels = 64 * 64 * sizeof(glm::vec3);
    const Scene small = large_scene("small", 1, texture), large = large_scene("l", 1000, texture);
    CHECK(bytes_of_scenes({&small}) > texels);
    CHECK(bytes_of_scenes({&large}) > texels + triangle_bytes(1000));
    CHECK(bytes_of_scenes({&large, &large, nullptr}) == bytes_of_scenes({&large}));
    const std::size_t both = bytes_of_scenes({&small, &large});
    CHECK(both < bytes_of_scenes({&small}) + bytes_of_scenes({&large}) - texels);
    CHECK(both > bytes_of_scenes({&large}) + triangle_bytes(1));
}

TEST_CASE("Undo forgets the oldest scenes when they take too much, but never the newest step") {
    const SharedTexture texture = texture_of_side(1);
    Session session;
    session.undo.most_bytes = 3 * triangle_bytes(1000);
    CHECK(UndoStack{}.most_bytes == std::size_t{256} << 20);
    const auto open = [&](const std::string& name, int triangles) {
        set_scene(session, large_scene(name, triangles, texture));
        record_undo_step(session);
    };
    const auto oldest = [&] {
        while (undo(session)) {
        }
        return session.scene->name;
    };
    const auto newest = [&] {
        while (redo(session)) {
        }
        return session.scene->name;
    };
    for (int i = 0; i < 8; ++i)
        open(std::to_string(i), 100);
    // Steps that share a scene take its memory once.
    for (int i = 0; i < 50; ++i) {
        session.view = i % 2 == 0 ? View::depth : View::colour;
        record_undo_step(session);
    }
    CHECK(session.undo.past.size() == 7 + 50);
    CHECK(oldest() == "0");
    CHECK(newest() == "7");
    CHECK(session.undo.past.size() == 7 + 50);
    // Older ones are forgotten as soon as they and all later ones together are too much.
    for (int i = 0; i < 4; ++i)
        open("large " + std::to_string(i), 1200);
    CHECK(session.undo.past.size() == 2);
    CHECK(oldest() == "large 1");
    CHECK(newest() == "large 3");
    // The newest step is kept even if it alone is too much.
    open("largest", 5000);
    open("small", 1);
    CHECK(session.undo.past.size() == 1);
    CHECK(oldest() == "largest");
}
