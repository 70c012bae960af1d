#pragma once

// What passes between asking.cpp, which is compiled once, and the driver, which is compiled with
// every program and must be short: one question to each function, its answer, and how to ask it.

#include <cstddef>
#include <vector>

#include "recording.h"

namespace rasterwalk_kit {

/// Pixels of an answer.
struct PixelList {
    std::size_t count = 0;         ///< as many as the program made
    PixelValues* values = nullptr; ///< room for most_listed
};

/// The answer to part_globals: variable by variable.
class NumberList {
  public:
    /// A variable begins.
    void begin(Global global);
    void add(double number);
    void add_three(double first, double second, double third);
    /// The variable ends. If it was not found, it is left out.
    void end(bool is_found);

    const std::vector<double>& numbers() const { return m_numbers; }

  private:
    std::vector<double> m_numbers;
    std::size_t m_begin = 0; ///< of the variable
};

/// The surface that a function is asked about.
struct Surface {
    const double* normal = nullptr; ///< three numbers
    const double* colour = nullptr; ///< three numbers
};

struct VertexQuestion : Surface {
    const double* position = nullptr; ///< three numbers
    PixelValues answer{};
};

struct InterpolateQuestion : Surface {
    PixelValues from{}, to{};
    std::size_t count = 0;
    bool is_asked_y = false;     ///< a function for single numbers: from.y to to.y, not x
    bool is_for_numbers = false; ///< answer: it is such a function
    PixelList answer;
};

struct RowsQuestion : Surface {
    const PixelValues* polygon = nullptr;
    std::size_t count = 0; ///< of its corners
    PixelList left, right; ///< answer
};

/// The answer are the pixels that are put.
struct DrawQuestion : Surface {
    const PixelValues* left = nullptr;
    const PixelValues* right = nullptr;
    std::size_t count = 0; ///< of rows
};

/// The answer is the pixel that is put.
struct ShaderQuestion : Surface {
    PixelValues pixel{};
};

/// A function of the program.
template <class Question>
struct Function {
    bool is_written = false;
    void (*ask)(Question& question) = nullptr; ///< null: the driver does not know how
};

/// What the driver knows about a program.
struct Functions {
    Function<VertexQuestion> vertex_shader;
    Function<InterpolateQuestion> interpolate;
    Function<RowsQuestion> polygon_rows;
    Function<DrawQuestion> draw_rows;
    Function<ShaderQuestion> pixel_shader;
    void (*set_surface)(const Surface& surface) = nullptr; ///< sets the variables that hold it
    void (*clear_depth)(double depth) = nullptr;
    double (*greatest_depth)() = nullptr; ///< in its depth buffers now
    void (*list_variables)(NumberList& list) = nullptr;
};

/// Asks what the task says, and writes the answers. An exception of the program ends it.
void ask_all(const Functions& functions) noexcept;

} // namespace rasterwalk_kit
