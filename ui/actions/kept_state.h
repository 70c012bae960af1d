#pragma once

#include <string>

namespace rasterwalk {

/// A file in which something is kept between two runs of the program.
struct KeptFile {
    std::string path;        ///< empty: nowhere
    double next_try = 0.0;   ///< not to be written before ImGui's clock says so, seconds
    bool is_failing = false; ///< it could not be written, and the student was told
    int writes = 0;          ///< how often it was written
};

} // namespace rasterwalk
