#pragma once

// Reads what a student's program answered. The stream is hostile: each count and each number is
// checked before it is used, and nothing that is read is larger than the stream itself.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "mine/functions/questions.h"
#include "mine/kit/recording.h"

namespace rasterwalk {

/// How the answers of a part end.
enum class PartEnd {
    not_asked,   ///< the stream does not have the part
    complete,    ///< every question is answered
    not_written, ///< the program lacks the function
    not_askable, ///< it has the function, with parameters that cannot be filled
    cut_short,   ///< the stream ends in it: the program died
    unreadable,  ///< it breaks the rules of the stream
};

/// Variables of the program; none: it has no such variable.
struct ProgramGlobals {
    std::optional<glm::vec3> camera;
    std::optional<glm::mat3> rotation; ///< as glm stores it
    std::optional<float> yaw;          ///< radians
    std::optional<float> focal_length; ///< pixels
    std::optional<glm::vec3> light_position, light_power, indirect;
    std::optional<Viewport> screen;
    std::vector<std::array<glm::vec3, 5>> triangles; ///< v0, v1, v2, normal, colour
};

/// A list of pixels that a function gave back.
struct PixelList {
    double size = 0.0; ///< as the program says; more than most_listed are not listed
    std::vector<rasterwalk_kit::PixelValues> pixels;
};

/// leftPixels and rightPixels.
struct RowLists {
    PixelList left, right;
};

/// A pixel that was put.
struct DrawnPixel {
    double x = 0.0, y = 0.0;
    glm::dvec3 colour{0.0};
};

/// Pixels in the order in which they were put.
struct PutList {
    double size = 0.0;
    std::vector<DrawnPixel> pixels;
};

/// The answers of one function, from question 0 on; fewer than there are questions if the program
/// died.
template <class Answer>
struct PartAnswers {
    PartEnd end = PartEnd::not_asked;
    std::vector<Answer> answers;
    std::string fault; ///< if it is unreadable: a sentence
};

/// All answers.
struct Answers {
    PartAnswers<ProgramGlobals> globals; ///< one
    PartAnswers<rasterwalk_kit::PixelValues> vertices;
    PartAnswers<PixelList> lines;
    PartAnswers<RowLists> polygons;
    PartAnswers<PutList> rows;
    PartAnswers<std::vector<bool>> depths;         ///< for each fragment: was it put?
    PartAnswers<std::optional<DrawnPixel>> points; ///< none: nothing was put
};

/// Reads a stream of answers. Never throws for what is in it: a part that breaks the rules is
/// unreadable, and so is all that follows, since where that begins is not known.
/// @param numbers Recorded::answers, as many as Progress::answers says and the memory holds
Answers read_answers(std::span<const double> numbers, const Questions& questions);

/// What the globals say about a program, in place of what was known before. Values that no program
/// of this lab can work with (not finite, a focal length below 1, a picture of 0 or more than 4096
/// pixels a side) change nothing.
KnownProgram known_program(const ProgramGlobals& globals, const KnownProgram& before);

} // namespace rasterwalk
