#pragma once

// What is known about a student's program as a list in the order of the lab: a line for each thing
// that is checked.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

struct CheckedProgram;

enum class CheckLineKind : std::uint8_t { compiled, ran, function, picture, sequence, keys };

enum class CheckLineState : std::uint8_t {
    right,
    wrong,
    open,    ///< not written, or not judged
    waiting, ///< it has not been checked yet
};

/// A line of the list.
struct CheckLine {
    CheckLineKind kind = CheckLineKind::compiled;
    std::size_t function = 0; ///< of a function: its index in CheckedProgram::functions
    CheckLineState state = CheckLineState::waiting;
    std::string name;  ///< "ComputePolygonRows", "picture"
    std::string count; ///< "26 of 30"; "not written yet"; may be empty
    std::string words; ///< what it was fed, or what was found; may be empty
};

/// The list. It always has the same names in the same order once the functions are known.
/// @param is_whole the check is done: nothing is waited for
std::vector<CheckLine> check_lines(const CheckedProgram& checked, bool is_whole);

/// The first line that is wrong; or else that of the picture, or 0 if it has none.
std::size_t first_wrong(const std::vector<CheckLine>& lines);

/// What has changed from an earlier check to a later one.
struct LineChange {
    std::string text; ///< a sentence
    bool is_better = false;

    friend bool operator==(const LineChange&, const LineChange&) = default;
};

/// First what was right and is wrong now, then what was wrong and is right now. Lines that wait
/// count as unchanged.
std::vector<LineChange> changed_lines(const std::vector<CheckLine>& before,
                                      const std::vector<CheckLine>& now);

} // namespace rasterwalk
