#pragma once

// The questions that a student's function is asked when a puzzle is judged.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// What a function is asked once.
struct PuzzleQuestion {
    std::string words; ///< how the verdict names it: "From (4, 2) to (1, 8) with 4 samples"
    std::vector<float> given;
};

/// Questions, and the C++ that asks a function one of them.
struct PuzzleExam {
    std::string_view name;
    /// What the function may use. It declares `vector<float> given` and `vector<float> answer`.
    std::string_view before;
    /// A function Ask() that calls the student's with what is given, and fills the answer.
    std::string_view after;
    std::vector<PuzzleQuestion> questions;
    /// How the numbers of an answer are named, in turn; # is replaced by the round: "result[#].x".
    std::vector<std::string_view> names;
    /// Of a picture with a round for each pixel, row by row: # is replaced by the pixel's place,
    /// "(1, 2)". 0: the answer is no picture.
    std::size_t columns = 0;
};

/// The exam of this name; null if there is none. `interpolate` asks for the samples of a line,
/// `polygon_rows` for the row tables of polygons, `depth` for the picture that fragments leave,
/// `line` for the pixels of a line, `cosine` and `light` for how a lamp lights a place, `middle`
/// for the position halfway along a row, and `positions` for several along it.
const PuzzleExam* find_exam(std::string_view name);

/// The names of all.
std::vector<std::string_view> exam_names();

} // namespace rasterwalk
