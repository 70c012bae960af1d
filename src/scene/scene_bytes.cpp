#include "scene/scene_bytes.h"

namespace rasterwalk {

namespace {

template <typename Element>
std::size_t bytes_of(const std::vector<Element>& list) {
    return list.capacity() * sizeof(Element);
}

} // namespace

void SceneBytes::add(const Scene* scene) {
    if (scene == nullptr || !counted_.insert(scene).second) return;
    total_ += sizeof(Scene) + bytes_of(scene->mesh.vertices()) + bytes_of(scene->mesh.triangles()) +
              bytes_of(scene->parts) + bytes_of(scene->polygons) + bytes_of(scene->examples);
    for (const SharedTexture& texture : scene->textures) {
        if (!counted_.insert(&*texture).second) continue;
        for (const TextureLevel& level : (*texture).levels)
            total_ += bytes_of(level.texels) + bytes_of(level.alphas);
    }
}

} // namespace rasterwalk
