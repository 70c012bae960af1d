#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rasterwalk {

/// The folder `lessons`: scenes, presets and lessons. It is $RASTERWALK_LESSONS, or else
/// own_lessons_folder(). Throws AccessError if none is there.
std::string lessons_folder();

/// The folder `lessons` that comes with the program: the one beside or above it, or the one it was
/// built from. Throws AccessError if none is there.
std::string own_lessons_folder();

/// The scene where none is named, in lessons_folder().
inline constexpr std::string_view usual_scene = "scenes/lab-room.toml";

/// The file a lesson names by a relative path: within `folder`, or else within lessons_folder().
/// Throws UsageError for a path that is absolute or leads out of the folder, or a file that is not
/// there.
std::string find_lesson_file(const std::string& folder, std::string_view relative);

/// The name of a file from lessons_folder(), "scenes/fence.toml"; none if it does not lie there, or
/// only by a link of the file system. It need not exist.
std::optional<std::string> name_in_lessons_folder(const std::string& path);

/// The version of the program: "0.2.0".
std::string version_text();

} // namespace rasterwalk
