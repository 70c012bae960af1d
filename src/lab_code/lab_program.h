#pragma once

// The lab's program, in C++, as it draws a frame: the functions that a good student would write for
// these settings. tests/lab_code holds it to the same bits as the stages.

#include <set>
#include <string>
#include <vector>

#include "lab_code/chosen_lines.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// A file of the code, with lines for all settings.
struct LabFile {
    std::string name; ///< "interpolate.cpp"
    std::string text;
};

/// The files of the code, in the order in which a compiler reads them.
struct LabCode {
    std::vector<LabFile> files;
    std::set<std::string, std::less<>> words; ///< all that conditions in them ask for
};

/// The names of the files, in that order.
const std::vector<std::string>& lab_file_names();

/// Reads the files. Throws AccessError or InputError.
/// @param folder `code` in the lessons folder
LabCode read_lab_code(const std::string& folder);

/// The lines of the code that draw a frame.
std::vector<ChosenLine> lines_for(const LabCode& code, const Frame& frame);

/// A file in the program: its first and last line, of the program, from 1.
struct FileLines {
    int file = 0; ///< in the order in which files are read
    int first = 1, last = 1;
};

/// The file that a line of the program is of.
/// @param line from 1; one that is not there stands for the nearest
FileLines file_around(const std::vector<ChosenLine>& lines, int line);

/// The text of the lines, as it is compiled: the picture's size is that of the frame.
std::string source_text(const std::vector<ChosenLine>& lines, Viewport picture);

} // namespace rasterwalk
