#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rasterwalk {

/// The `lessons` folder: scenes, presets and lessons. It is $RASTERWALK_LESSONS, or else
/// own_lessons_folder(). Throws AccessError if there is none.
std::string lessons_folder();

/// The `lessons` folder that comes with the program: the one next to or above it, or
/// installed with it. Throws AccessError if there is none.
std::string own_lessons_folder();

/// The default scene, in lessons_folder().
inline constexpr std::string_view usual_scene = "scenes/lab-room.toml";

/// The file a lesson names by a relative path: within `folder`, or else within lessons_folder().
/// Throws UsageError for a path that is absolute or leads out of the folder, or a file that does
/// not exist.
std::string find_lesson_file(const std::string& folder, std::string_view relative);

/// The name of a file relative to lessons_folder(), "scenes/fence.toml"; none if it is not there,
/// or only through a symbolic link. It need not exist.
std::optional<std::string> name_in_lessons_folder(const std::string& path);

/// The version of the program: "1.0.0".
std::string version_text();

} // namespace rasterwalk
