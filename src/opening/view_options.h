#pragma once

#include <string>
#include <vector>

#include "opening/opened_view.h"

namespace CLI {
class App;
}

namespace rasterwalk {

/// Gives a command the options that say what is drawn: --scene --lesson --step --stage --bug
/// --preset --set --to --size --vertices --texture.
void add_view_options(CLI::App& command, ViewOptions& options);

/// Gives it those that say what of it is shown, and how: --view --tab --pixel --zoom --b ...
void add_look_options(CLI::App& command, ViewOptions& options);

/// --view and --depth-range alone, for what writes one picture.
void add_plane_options(CLI::App& command, ViewOptions& options);

/// Turns arguments that begin like a negative number ("-5,3") into ones that CLI11 does not take
/// for options; restore_arguments() turns them back. The program's own name is left out.
std::vector<std::string> command_arguments(int argc, const char* const* argv);

/// Lets every option of an app and of its commands take such an argument as it was given. To be
/// called when all options are there.
void restore_arguments(CLI::App& app);

} // namespace rasterwalk
