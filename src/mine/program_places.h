#pragma once

// From an address in a compiled program to the line of the student's source.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A place in a program.
struct ProgramPlace {
    std::string function; ///< "DrawPolygonRows(...)"; empty: not known
    std::string file;     ///< as the compiler was given it; empty: not known
    int line = 0;         ///< from 1; 0: not known

    friend bool operator==(const ProgramPlace&, const ProgramPlace&) = default;
};

/// Where these addresses are, each with the functions that were compiled into its own, innermost
/// first. Empty if this machine has no addr2line, or if it cannot read the program.
/// @param program   a file with debug information
/// @param addresses relative to where it is loaded
std::vector<std::vector<ProgramPlace>> places_of(const std::string& program,
                                                 std::span<const std::uint64_t> addresses);

/// What addr2line -a -f -i -C prints: an address, and after it a function and a place in turn.
std::vector<std::vector<ProgramPlace>> parse_places(const std::string& printed);

/// Is this file in the folder, or in one further down, or is it the folder itself?
bool is_in_folder(std::string_view file, std::string_view folder);

/// The innermost of them that is in this folder; null if none is.
const ProgramPlace* innermost_in(std::span<const std::vector<ProgramPlace>> stack,
                                 const std::string& folder);

} // namespace rasterwalk
