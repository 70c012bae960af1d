#pragma once

// The questions that a student's functions are asked: our inputs, so that a mistake in one function
// does not show in the next. Always the same for the same room and program.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "mine/kit/recording.h"
#include "scene/scene.h"

namespace rasterwalk {

/// What is known about a program, from its answer to part_globals; the rest is the lab's.
struct KnownProgram {
    Camera camera;
    Light light;
    Viewport viewport;
    bool knows_light = false; ///< position, power and indirect light are the program's own
    std::optional<glm::mat3> rotation{}; ///< the program's, on whichever side it multiplies by it
};

/// Asks VertexShader.
struct VertexQuestion {
    glm::vec3 position{0.0f}, normal{0.0f}, colour{0.0f};
};

/// Asks Interpolate.
struct LineQuestion {
    rasterwalk_kit::PixelValues a{}, b{};
    int count = 1; ///< samples, at least 1
};

/// Asks ComputePolygonRows.
struct PolygonQuestion {
    std::vector<rasterwalk_kit::PixelValues> corners;
    std::string name; ///< "triangles[7]"
};

/// Asks DrawPolygonRows. Both ends of a row have the same y.
struct RowsQuestion {
    std::vector<rasterwalk_kit::PixelValues> left, right;
    glm::vec3 colour{0.0f};
    std::string name;
};

/// A fragment of a depth question: a row of one pixel.
struct DepthFragment {
    rasterwalk_kit::PixelValues at{};
    glm::vec3 colour{0.0f};
};

/// Asks for the depth test: fragments in the order in which they are drawn.
struct DepthQuestion {
    std::vector<DepthFragment> fragments;
    std::string name; ///< "a far fragment behind a near one"
};

/// Asks PixelShader.
struct ShaderQuestion {
    rasterwalk_kit::PixelValues at{}; ///< `place` is the position times zinv
    glm::vec3 normal{0.0f}, colour{0.0f};
    glm::vec3 position{0.0f}; ///< world units
};

/// All of them. Single-sample lines, and rows that are empty or reach outside the picture, come
/// last in their part: a program that dies there has answered the others.
struct Questions {
    KnownProgram program;
    std::vector<VertexQuestion> vertices;
    std::vector<LineQuestion> lines;
    std::vector<PolygonQuestion> polygons;
    std::vector<RowsQuestion> rows;
    std::vector<DepthQuestion> depths;
    std::vector<ShaderQuestion> points;
    std::array<std::string, rasterwalk_kit::part_count> fed; ///< in words, for each part
};

/// The corners of a triangle of the bench: column, row, depth.
using BenchTriangle = std::array<glm::vec3, 3>;

/// Makes the questions.
/// @param room    the lab's room
/// @param bench   examples of the bench, in whole pixels
/// @param program how the room is seen, and the size of the picture
Questions make_questions(const Scene& room, std::span<const BenchTriangle> bench,
                         const KnownProgram& program);

/// How many questions a part has.
std::size_t question_count(const Questions& questions, rasterwalk_kit::Part part);

/// Questions as the program reads them, see kit/recording.h.
struct QuestionStream {
    std::vector<double> numbers;                                  ///< at most most_questions
    std::array<std::uint64_t, rasterwalk_kit::part_count> ends{}; ///< for Task::question_end
};

/// Writes them out. Throws std::length_error if they do not fit, which no picture size causes.
QuestionStream to_stream(const Questions& questions);

} // namespace rasterwalk
