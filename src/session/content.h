#pragma once

#include <string>

namespace rasterwalk {

/// The folder `lessons`: scenes, presets and lessons. It is $RASTERWALK_LESSONS, or the folder that
/// lies beside or above the program, or the one it was built from. Throws AccessError if none is
/// there.
std::string lessons_folder();

/// The version of the program: "0.1.0".
std::string version_text();

} // namespace rasterwalk
