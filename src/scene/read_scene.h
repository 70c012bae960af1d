#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/limits.h"
#include "scene/reading.h"
#include "scene/scene.h"

namespace rasterwalk {

/// Reads a scene from a TOML file. Throws AccessError if the file cannot be read, InputError with
/// file:line for anything wrong in it: bad syntax, unknown keys, points that do not exist, numbers
/// that are not finite, sizes out of range, more triangles than `max_triangles`, textures that
/// cannot be used (see read_surface.h). Throws ReadingStopped if the watch stops it.
/// @param stages names that `stage` may have; empty: any
Scene read_scene(const std::string& path, std::span<const std::string_view> stages = {},
                 const ReadingWatch& watch = {});

/// The same from text; `path` is only used in messages.
Scene parse_scene(std::string_view text, const std::string& path,
                  std::span<const std::string_view> stages = {}, const ReadingWatch& watch = {});

} // namespace rasterwalk
