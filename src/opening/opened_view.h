#pragma once

// Makes the session that the program opens with from a command line, a lesson or a saved view.

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"
#include "session/session.h"

namespace rasterwalk {

struct ViewField;

/// What a command line says about the view, as written. Empty members were not given. If a lesson
/// or a saved view sets something, `none` removes it again.
struct ViewOptions {
    std::string file;    ///< a scene (.toml, .obj), a lesson (.md) or a saved view (.walk.toml)
    std::string scene;   ///< path, from here or from lessons_folder(); the lab's room if not given
    std::string texture; ///< path of an image that is laid on the scene, see with_texture()
    std::string lesson;  ///< id, or path of a lesson
    std::string step;    ///< of the lesson; 0 is its opening
    std::string stage;
    std::string bug; ///< id; its scene is used unless one is named
    std::vector<std::string> presets;
    std::vector<std::string> assignments; ///< name=value
    std::string size;                     ///< WIDTHxHEIGHT; keeps the field of view
    /// The words of the other options by the key of their field in view_table(), `compare` for
    /// --b. No list is empty.
    std::map<std::string, std::vector<std::string>, std::less<>> given;

    friend bool operator==(const ViewOptions&, const ViewOptions&) = default;
};

/// The session that the options describe. It begins with the scene, the step of the lesson or the
/// saved view; then size, bug, presets, stage and assignments take effect, in this order, so that
/// the more exact ones win, and then all others. With a bug, the correct run is run B unless `b`
/// says otherwise. Throws Error: a mistake in a file is an InputError with file:line. A lesson with
/// faults that do not concern this step opens, and session.notice says so; so does a model with
/// faults. Throws ReadingStopped if the watch stops it.
Session open_view(const ViewOptions& given, const ReadingWatch& watch = {});

/// The option of a field as written: "--compare-view".
std::string option_name(const ViewField& field);

/// The path of the scene that a text names: a file, or one in lessons_folder()
/// ("scenes/fence.toml").
std::string find_scene_file(const std::string& name);

/// The lesson of this id or at this path. Throws Error if there is none; what is wrong in it is in
/// its faults.
Lesson lesson_named(const std::string& name);

/// Is this the name of a saved view?
bool is_view_file(std::string_view path);

} // namespace rasterwalk
