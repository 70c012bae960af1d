#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/progress_line.h"
#include "opening/view_options.h"

namespace rasterwalk {

struct DiagnoseOptions {
    ViewOptions view;                 ///< the reference
    std::string file;                 ///< a picture, or a printed row table
    std::vector<std::string> polygon; ///< X,Y of each vertex whose table was printed; may be empty
    double seconds = 20.0;            ///< for searching a picture, above 0
    bool json = false;
};

/// Prints what may be wrong with a result. Returns ExitCode::difference if it differs from the
/// reference. Throws Error.
ExitCode diagnose_command(const DiagnoseOptions& options, std::ostream& out, std::ostream& err,
                          ProgressLine& progress);

} // namespace rasterwalk
