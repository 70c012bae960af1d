#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "base/error.h"
#include "opening/view_options.h"

namespace rasterwalk {

struct CompareOptions {
    ViewOptions view;           ///< shared by both runs
    std::vector<std::string> a; ///< name=value, only for run A
    std::vector<std::string> b; ///< name=value, only for run B
    std::string output;         ///< PNG of the difference; empty: none
    bool json = false;
};

/// Prints how two runs differ, up to the moment of the view. Returns ExitCode::difference if they
/// do, else ExitCode::done. Throws Error.
ExitCode compare_command(const CompareOptions& options, std::ostream& out);

} // namespace rasterwalk
