#pragma once

#include <string>

#include "scene/scene.h"

namespace rasterwalk {

/// Lays an image on every part that has texture coordinates and no texture: many models are sold
/// with an image that only a program names. Scene::applied_texture remembers the file. Throws
/// AccessError if the image cannot be read, InputError if it is not one that can be used, if the
/// scene already has the most textures or texels allowed (limits.h), or if no part can show it.
Scene with_texture(Scene scene, const std::string& path);

} // namespace rasterwalk
