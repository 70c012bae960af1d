#pragma once

#include <string>
#include <string_view>

#include "ui/app/options_state.h"

namespace rasterwalk {

struct Ui;

/// Keeps how the window looks in this file from now on, and takes up the file's content: theme,
/// text size, widths of the columns, and the score of the quiz if it is to be kept. An empty path,
/// or a file that cannot be read: nothing is kept, the file is left unchanged, and session.notice
/// says so.
void keep_options(Ui& ui, const std::string& path);

/// Writes the options that were changed in this window, together with what another window has
/// changed in the same file; the score adds up. To be called when the input has come to rest.
void save_options(Ui& ui);

/// The options as TOML, and back. Reading throws InputError with file:line; what is not named keeps
/// its value in `options`.
std::string options_text(const UiOptions& options);
UiOptions parse_options(std::string_view text, const std::string& path, UiOptions options);

} // namespace rasterwalk
