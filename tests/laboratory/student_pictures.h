#pragma once

// Pictures that students may bring to the laboratory, each with the facts about it.

#include <string>
#include <vector>

#include "laboratory/second_rasterizer.h"

namespace rasterwalk::test {

/// The facts about a picture.
enum class StudentKind {
    right,         ///< drawn by the handout's own rules
    equally_right, ///< with rules, a lamp or a camera that are just as right
    single,        ///< with one known mistake
    pair,          ///< with two
    unknown,       ///< with a mistake that the laboratory does not know
};

/// A known mistake.
struct KnownMistake {
    std::string id; ///< of the laboratory: "B5"
    /// Ids of other mistakes that make the same picture.
    std::vector<std::string> same{};
    bool is_lamp = false;           ///< is it the same as another power of the lamp?
    void (*make)(StudentMistakes&); ///< switches it on
};

/// All mistakes of the laboratory that the second rasterizer can make.
const std::vector<KnownMistake>& known_mistakes();

/// A picture: the program that draws it, and what is true of it.
struct BroughtPicture {
    std::string name;
    StudentKind kind = StudentKind::right;
    StudentProgram program;
    std::vector<KnownMistake> mistakes{}; ///< one of a single, two of a pair
    bool is_camera_known = false; ///< does the laboratory know where the student's camera is?
};

/// The list. Its order mixes the kinds, so that any part of it has some of each.
std::vector<BroughtPicture> student_pictures();

/// Those of unknown mistakes (unknown_mistakes.cpp).
std::vector<BroughtPicture> pictures_of_unknown_mistakes();

/// Sets what the words name, such as "depth sum_cut 320x240"; the picture is 200x200 unless they
/// say otherwise. Throws std::invalid_argument at a word that student_pictures.cpp does not list.
void apply_words(const std::string& words, StudentProgram& program);

} // namespace rasterwalk::test
