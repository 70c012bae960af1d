#pragma once

// The files in a student's folder.

#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A file in a folder, and how deep: 0 in the folder itself.
struct FoundFile {
    std::string path;
    int depth = 0;
};

/// The files of a folder and of those below it, down to `depth`; nearer ones first, then by name.
/// Folders that hold no work of the student's are left out (hidden, build, CMakeFiles, glm, SDL
/// ...), and so are links to folders, and to files outside. At most 5,000 are found. Throws
/// AccessError if the folder cannot be read; those below it are left out if they cannot.
std::vector<FoundFile> files_in(const std::string& folder, int depth);

/// The folders directly in a folder, sorted; the same ones are left out.
std::vector<std::string> folders_in(const std::string& folder);

/// Is it the name of a C++ source: .cpp, .cc, .cxx, .c++, in any case?
bool is_source_name(std::string_view path);

/// Is it the name of a C++ header: .h, .hh, .hpp, .hxx, .inl, in any case?
bool is_header_name(std::string_view path);

/// Is it the name of an archive: .zip, .tar, .tar.gz, .7z ..., in any case?
bool is_archive_name(std::string_view path);

/// Does a name say that the file is a copy of another: "draw_backup.cpp", "Copy of draw.cpp",
/// "draw (2).cpp"?
bool is_name_of_copy(std::string_view path);

/// The last part of a path, and the same without its ending.
std::string file_name(std::string_view path);
std::string file_stem(std::string_view path);

/// Is a path the folder itself, or below it? Both are absolute, without links and dots.
bool is_below(std::string_view path, std::string_view folder);

} // namespace rasterwalk
