#pragma once

#include <string>
#include <vector>

#include "session/session.h"

namespace CLI {
class App;
}

namespace rasterwalk {

/// What the command line says about the view: VIEW in the help.
struct ViewOptions {
    std::string scene; ///< path; empty: the lab's room
    std::string stage;
    std::string bug; ///< id; its scene is taken unless one is named
    std::vector<std::string> presets;
    std::vector<std::string> assignments; ///< name=value
    std::string to;                       ///< a cursor
    std::string size;                     ///< WIDTHxHEIGHT; keeps the field of view

    friend bool operator==(const ViewOptions&, const ViewOptions&) = default;
};

/// Gives a command the options --scene --stage --bug --preset --set --to --size.
void add_view_options(CLI::App& command, ViewOptions& options);

/// The session that the options describe. They take effect in the order scene, size, bug, presets,
/// stage, assignments, so that what is more exact wins. With a bug the correct run is run B. Throws
/// Error.
Session open_view(const ViewOptions& options);

/// Turns arguments that begin like a negative number ("-5,3") into ones that CLI11 does not take
/// for options. The program's own name is left out.
std::vector<std::string> command_arguments(int argc, const char* const* argv);

} // namespace rasterwalk
