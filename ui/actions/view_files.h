#pragma once

// What is opened from files and saved to them: views, scenes, lessons, the student's results.

#include <string>
#include <string_view>
#include <vector>

#include "session/session.h"
#include "ui/sheets/sheets_state.h"

namespace rasterwalk {

struct Ui;

/// Shows a session that was opened from a file in place of the current one. What the student did
/// before can be undone, and Back leads to it; a quiz ends.
void show_view(Ui& ui, Session&& opened);

/// Opens a file by its ending: a saved view (.walk.toml), a lesson (.md), a picture or a text of
/// printed rows to be diagnosed, a program (.cpp or its folder) to be checked, otherwise a scene.
/// Throws Error; everything is then unchanged.
void open_file(Ui& ui, const std::string& path);

/// Checks the student's own program, or compares a picture or printed rows of it with the correct
/// result. Throws Error if the file is none of these.
void check_result(Ui& ui, const std::string& path);

/// Lays an image on the scene, see with_texture(); undo takes it away again. Throws Error;
/// everything is then unchanged.
void apply_texture(Ui& ui, const std::string& path);

/// Opens a file that was dropped on the window; what is being read is stopped. A fault is shown on
/// the sheet for opening.
void open_dropped(Ui& ui, const std::string& path);

/// Shows why a file could not be opened, on the sheet for opening.
void show_opening_fault(Ui& ui, const std::string& path, const std::string& sentence);

/// Copies the view as a command line, for ImGui's clipboard; says so in session.notice.
void copy_command_line(Ui& ui);

/// Copies the view as a link to the page in a browser, or, if the page is not known, the part of
/// the link that begins with '#'; says so in session.notice.
void copy_link(Ui& ui);

/// Opens the sheet on which a file is opened, a result or a texture is chosen, or the view is
/// saved.
void begin_opening(Ui& ui);
void begin_choosing_result(Ui& ui);
void begin_choosing_texture(Ui& ui);
void begin_saving(Ui& ui);

/// The most files of a folder that the sheet lists.
inline constexpr std::size_t most_listed_files = 400;
/// The most entries of a folder that it looks at, so that the window does not freeze.
inline constexpr std::size_t most_seen_files = 20'000;

/// Goes to a folder on the sheet. A folder that cannot be read is a fault on the sheet.
void enter_folder(FileSheet& sheet, const std::string& folder,
                  std::size_t most_seen = most_seen_files);

/// Does what the sheet is for with its path: enters a folder, opens a file, saves the view. Asks
/// before overwriting a file; a second call overwrites it. Faults go to the sheet.
void finish_sheet(Ui& ui);

/// The path meant by what was typed: relative to the sheet's folder, absolute, or relative to the
/// home folder (~). What is saved ends with .walk.toml.
std::string meant_path(const FileSheet& sheet);

} // namespace rasterwalk
