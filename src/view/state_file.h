#pragma once

// The exact view in a text file, *.walk.toml, to be opened again or passed on.

#include <string>
#include <string_view>

#include "view/view_state.h"

namespace rasterwalk {

/// A view as stored in a file.
struct SavedView {
    std::string path;    ///< of the file; the scene and the lesson are found from its folder
    std::string scene;   ///< file next to it or in a folder below, or one of the program's own
    std::string texture; ///< an image, found there too, that is laid on the scene; empty: none
    std::string lesson;  ///< id, or a file (.md) next to it; empty: none
    int step = 0;        ///< of the lesson
    std::string own_tab; ///< of the inspector: the student's choice over the lesson's; empty: none
    ViewState state;     ///< on that scene; its lines are those of the file
};

/// The view as text. Scene and lesson are named relative to the folder of the file. Throws
/// UsageError if they cannot be: a file outside this folder cannot be named, so that what is passed
/// on can be opened elsewhere.
/// @param path of the file that will hold it
std::string view_text(const Session& session, const std::string& path);

/// Writes it. Throws Error; the file is then unchanged.
void write_view(const Session& session, const std::string& path);

/// Reads a view. Throws AccessError, or InputError with file:line for anything wrong in it: unknown
/// keys, impossible values, a file that is too large.
SavedView parse_view(std::string_view text, const std::string& path);
SavedView read_view(const std::string& path);

/// The path of the file that a view names: in its own folder, or else in lessons_folder(). Throws
/// InputError with the line of `key`.
std::string find_file(const SavedView& view, const char* key, const std::string& name);

/// The largest file of a view that is read, bytes.
inline constexpr std::size_t largest_view_file = std::size_t{1} << 20;

} // namespace rasterwalk
