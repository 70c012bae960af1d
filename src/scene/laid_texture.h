#pragma once

#include <string>

#include "scene/scene.h"

namespace rasterwalk {

/// Lays an image on every part that has texture coordinates and no texture: many models are sold
/// with an image that only a program names. Scene::laid_texture remembers the file. Throws
/// AccessError if the image cannot be read, InputError if it is none that can be used, if the scene
/// has as many textures or texels as it may have (limits.h), or if no part can show it.
Scene with_texture(Scene scene, const std::string& path);

} // namespace rasterwalk
