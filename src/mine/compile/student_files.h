#pragma once

// Which files make up a student's program.

#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A program in the student's own files. Paths are absolute.
struct StudentFiles {
    std::string name;                 ///< for people: "skeleton.cpp", or the folder's name
    std::string folder;               ///< where it is, and where it runs
    std::string main;                 ///< the source with main()
    std::vector<std::string> sources; ///< the others that are compiled with it
    std::string fault;                ///< why it cannot be checked, a sentence; empty: it can
};

/// The program of a .cpp file (alone, or with the other sources of its folder if it needs them) or
/// of a folder with one main(). Another source is needed if the main one includes a header of the
/// same name, or if it defines a function that is declared, and defined nowhere else; so do the
/// sources that are needed. Of several with a main(), those named as copies do not count
/// ("skeleton_backup.cpp"), nor those in folders further down. Throws AccessError, or InputError if
/// there is no main(), or several.
StudentFiles find_student_files(const std::string& path);

/// The hand-ins of a folder: each folder in it with a program, or each source in it with a main().
/// Sorted by name. Empty: it is no folder of hand-ins. Nobody's is forgotten: a folder without
/// sources or without one main(), and among other hand-ins an archive, are listed with a `fault`.
std::vector<StudentFiles> find_hand_ins(const std::string& folder);

/// Does this source define main()? Comments and strings do not count.
bool defines_main(std::string_view source);

} // namespace rasterwalk
