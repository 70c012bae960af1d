#pragma once

// Lines of a student's source, to be shown next to what was found there.

#include <string>
#include <string_view>
#include <vector>

#include "mine/compile/student_files.h"
#include "mine/program_places.h"

namespace rasterwalk {

/// Some lines of a source.
struct SourceLines {
    int first = 1;                  ///< number of the first of them, from 1
    std::vector<std::string> lines; ///< without line breaks; blanks for tabs
};

/// The line of a place and so many lines before and after it. Empty if there is no such line, or if
/// the file cannot be read.
SourceLines source_lines(const ProgramPlace& place, int before, int after);

/// Where a program defines a function; line 0: in none of its sources, as far as can be seen.
/// @param name "Interpolate", without class or namespace, in any spelling of its letters' case
ProgramPlace definition_of(const StudentFiles& files, std::string_view name);

/// A file's path as people see it: without the folder of the program, if it is in it.
std::string shown_path(const StudentFiles& files, const std::string& path);

} // namespace rasterwalk
