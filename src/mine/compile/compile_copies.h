#pragma once

// Copies of a student's files, in which each #include leads to the kit, to GLM or to another copy.

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mine/compile/compile.h"

namespace rasterwalk {

/// The copies of a program that are compiled.
struct ProgramCopies {
    struct Source {
        std::string original;
        std::string copy;
        std::string fingerprint; ///< of all that it reads, except the kit and the system
    };
    std::vector<Source> sources;        ///< the one with main() first
    std::set<std::string> originals;    ///< the student's files that were copied
    std::vector<std::string> own_files; ///< the student's files whose place the kit takes
};

/// Copies a program's sources, and the headers that they include from the program's folder, into
/// another folder. What cannot be found is left as it is, for the compiler to tell. Throws
/// AccessError, or InputError if a file is no text, or if they are too many or too large.
/// @param driver path of the text to append to the source with main(); empty: none
ProgramCopies copy_program(const StudentFiles& files, const std::string& folder, KitUse kit,
                           const std::string& driver);

/// The kit's file for a header that a student includes: "SDLauxiliary.h" for
/// "../Source/sdlauxiliary.h"; empty if it is none of the kit's.
std::string kit_file_for(std::string_view include_name);

/// What an #include says about GLM, as it can be found: "glm/gtc/type_ptr.hpp" for
/// "C:\libs\glm\gtc\type_ptr.hpp"; empty if it is not about GLM.
std::string glm_file_for(std::string_view include_name);

/// A path as #line takes it, in quotes.
std::string quoted_for_line(std::string_view path);

} // namespace rasterwalk
