#pragma once

#include <string>
#include <vector>

#include "opening/opened_view.h"

namespace CLI {
class App;
}

namespace rasterwalk {

/// Adds to a command the options for what is drawn: --scene --lesson --step --stage --bug
/// --preset --set --to --size --vertices --texture.
void add_view_options(CLI::App& command, ViewOptions& options);

/// Adds the options for what of it is shown, and how: --view --tab --pixel --zoom --b ...
void add_look_options(CLI::App& command, ViewOptions& options);

/// Adds only --view and --depth-range, for a command that writes one picture.
void add_plane_options(CLI::App& command, ViewOptions& options);

/// Changes arguments that begin like a negative number ("-5,3") so that CLI11 does not mistake them
/// for options; restore_arguments() changes them back. The program's own name is left out.
std::vector<std::string> command_arguments(int argc, const char* const* argv);

/// Lets every option of an app and of its commands take such an argument as given. Call it when all
/// options have been added.
void restore_arguments(CLI::App& app);

} // namespace rasterwalk
