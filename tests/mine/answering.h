#pragma once

// A student's functions, written here in the ways in which students write them, and what a program
// with these functions answers. Nothing of the program under test is used but its questions.

#include <algorithm>
#include <climits>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "mine/functions/questions.h"

namespace rasterwalk::test {

/// The student's struct Pixel.
struct StudentPixel {
    int x = 0, y = 0;
    float zinv = 0.0f;
    glm::vec3 place{0.0f}, light{0.0f};
};

using StudentLine = std::vector<StudentPixel>;

/// A pixel that the student's PixelShader puts.
struct StudentPut {
    int x = 0, y = 0;
    glm::vec3 colour{0.0f};
};

/// The student's functions; an empty one is not written.
struct Student {
    std::function<StudentPixel(glm::vec3 position, glm::vec3 normal, glm::vec3 colour)> vertex;
    std::function<StudentLine(const StudentPixel&, const StudentPixel&, int count)> line;
    std::function<std::pair<StudentLine, StudentLine>(const StudentLine& corners)> rows;
    std::function<std::vector<StudentPut>(const StudentLine&, const StudentLine&, glm::vec3 colour)>
        draw;
    std::function<bool(float zinv, float& stored)> depth;
    std::function<std::optional<StudentPut>(const StudentPixel&, glm::vec3 normal,
                                            glm::vec3 colour)>
        shade;
    bool tells_light = true; ///< its lamp and indirect light are globals
};

inline constexpr float student_pi = 3.14159265f;
inline const glm::vec3 student_lamp(0.0f, -0.5f, -0.7f), student_power(14.0f),
    student_indirect(0.5f);

/// The light by the lab's formula.
inline glm::vec3 student_light(const glm::vec3& point, const glm::vec3& normal) {
    const glm::vec3 r = student_lamp - point;
    const float distance = glm::length(r);
    const float cosine = std::max(glm::dot(glm::normalize(r), normal), 0.0f);
    return student_power * cosine / (4.0f * student_pi * distance * distance) + student_indirect;
}

inline StudentPixel pixel_of(const rasterwalk_kit::PixelValues& values) {
    StudentPixel pixel;
    pixel.x = static_cast<int>(values.x);
    pixel.y = static_cast<int>(values.y);
    pixel.zinv = static_cast<float>(values.zinv);
    pixel.place = {values.place[0], values.place[1], values.place[2]};
    pixel.light = {values.light[0], values.light[1], values.light[2]};
    return pixel;
}

inline StudentLine pixels_of(const std::vector<rasterwalk_kit::PixelValues>& all) {
    StudentLine pixels;
    for (const rasterwalk_kit::PixelValues& values : all)
        pixels.push_back(pixel_of(values));
    return pixels;
}

/// Writes a stream of answers.
class AnswerWriter {
  public:
    void put(double number) { numbers.push_back(number); }
    void put(const glm::vec3& vector) {
        for (int i = 0; i < 3; ++i)
            put(double{vector[i]});
    }
    void put(const StudentPixel& pixel) {
        put(15.0);
        put(pixel.x);
        put(pixel.y);
        put(double{pixel.zinv});
        put(pixel.place);
        put(pixel.light);
    }
    void put(const StudentPut& pixel) {
        put(pixel.x);
        put(pixel.y);
        put(pixel.colour);
    }
    template <class Item>
    void put_all(const std::vector<Item>& items) {
        for (const Item& item : items)
            put(item);
    }
    static double size_of(std::size_t size) { return static_cast<double>(size); }

    std::vector<double> numbers;
};

/// One part: `answer(question)` for each question, or not_written.
template <class Question, class Answer>
void answer_part(AnswerWriter& writer, rasterwalk_kit::Part part,
                 const std::vector<Question>& questions, bool is_written, Answer answer) {
    writer.put(static_cast<double>(part));
    if (!is_written) writer.put(rasterwalk_kit::not_written);
    for (std::size_t i = 0; is_written && i < questions.size(); ++i) {
        writer.put(AnswerWriter::size_of(i));
        answer(questions[i]);
    }
    writer.put(rasterwalk_kit::end_of_part);
}

/// All that a program with these functions answers.
inline std::vector<double> answers_of(const Student& student, const Questions& questions) {
    using namespace rasterwalk_kit;
    AnswerWriter writer;
    writer.put(double{part_globals});
    writer.put(0.0); // the only question
    if (student.tells_light) {
        writer.put(double{global_light_position});
        writer.put(3.0);
        writer.put(student_lamp);
        writer.put(double{global_light_power});
        writer.put(3.0);
        writer.put(student_power);
        writer.put(double{global_indirect});
        writer.put(3.0);
        writer.put(student_indirect);
    }
    writer.put(end_of_part);
    answer_part(writer, part_vertex_shader, questions.vertices, bool(student.vertex),
                [&](const VertexQuestion& asked) {
                    writer.put(student.vertex(asked.position, asked.normal, asked.colour));
                });
    answer_part(writer, part_interpolate, questions.lines, bool(student.line),
                [&](const LineQuestion& asked) {
                    const StudentLine line =
                        student.line(pixel_of(asked.a), pixel_of(asked.b), asked.count);
                    writer.put(AnswerWriter::size_of(line.size()));
                    writer.put_all(line);
                });
    answer_part(writer, part_polygon_rows, questions.polygons, bool(student.rows),
                [&](const PolygonQuestion& asked) {
                    const auto rows = student.rows(pixels_of(asked.corners));
                    writer.put(AnswerWriter::size_of(rows.first.size()));
                    writer.put(AnswerWriter::size_of(rows.second.size()));
                    writer.put_all(rows.first);
                    writer.put_all(rows.second);
                });
    answer_part(writer, part_draw_rows, questions.rows, bool(student.draw),
                [&](const RowsQuestion& asked) {
                    const std::vector<StudentPut> drawn =
                        student.draw(pixels_of(asked.left), pixels_of(asked.right), asked.colour);
                    writer.put(AnswerWriter::size_of(drawn.size()));
                    writer.put_all(drawn);
                });
    answer_part(writer, part_depth_test, questions.depths, bool(student.depth),
                [&](const DepthQuestion& asked) {
                    std::map<std::pair<double, double>, float> buffer;
                    for (const DepthFragment& fragment : asked.fragments) {
                        float& stored = buffer[{fragment.at.x, fragment.at.y}];
                        const bool passed =
                            student.depth(static_cast<float>(fragment.at.zinv), stored);
                        writer.put(passed ? 1.0 : 0.0);
                    }
                });
    answer_part(writer, part_pixel_shader, questions.points, bool(student.shade),
                [&](const ShaderQuestion& asked) {
                    const auto drawn =
                        student.shade(pixel_of(asked.at), asked.normal, asked.colour);
                    writer.put(drawn ? 1.0 : 0.0);
                    if (drawn) writer.put(*drawn);
                });
    return writer.numbers;
}

// Interpolate, as students write it.

/// Values at a share of the way.
inline StudentPixel values_between(const StudentPixel& a, const StudentPixel& b, float t) {
    StudentPixel pixel;
    pixel.zinv = a.zinv + t * (b.zinv - a.zinv);
    pixel.place = a.place + t * (b.place - a.place);
    pixel.light = a.light + t * (b.light - a.light);
    return pixel;
}

inline float share(int i, int count) {
    return static_cast<float>(i) / static_cast<float>(std::max(count - 1, 1));
}

/// The handout's: everything is added up in float, and int() cuts.
inline StudentLine line_as_handout(const StudentPixel& a, const StudentPixel& b, int count) {
    const float steps = static_cast<float>(std::max(count - 1, 1));
    const float step_x = static_cast<float>(b.x - a.x) / steps;
    const float step_y = static_cast<float>(b.y - a.y) / steps;
    const float step_z = (b.zinv - a.zinv) / steps;
    const glm::vec3 step_place = (b.place - a.place) / steps,
                    step_light = (b.light - a.light) / steps;
    float x = static_cast<float>(a.x), y = static_cast<float>(a.y);
    StudentPixel current = a;
    StudentLine line;
    for (int i = 0; i < count; ++i) {
        StudentPixel pixel = current;
        pixel.x = static_cast<int>(x);
        pixel.y = static_cast<int>(y);
        line.push_back(pixel);
        x += step_x;
        y += step_y;
        current.zinv += step_z;
        current.place += step_place;
        current.light += step_light;
    }
    return line;
}

/// A line whose pixels come from a function of i.
template <class PixelAt>
StudentLine line_by(const StudentPixel& a, const StudentPixel& b, int count, PixelAt pixel_at) {
    StudentLine line;
    for (int i = 0; i < count; ++i) {
        StudentPixel pixel = values_between(a, b, share(i, count));
        const std::pair<int, int> at = pixel_at(i);
        pixel.x = at.first;
        pixel.y = at.second;
        line.push_back(pixel);
    }
    return line;
}

// ComputePolygonRows.

/// What differs between students.
struct RowStyle {
    bool from_top = false, from_left = false, clamps = false;
    bool lacks_last_edge = false, lacks_last_row = false, lacks_last_sample = false;
    bool counts_by_rows = false, counts_shifted = false;
    int left_start = INT_MAX, right_start = -INT_MAX;
    bool takes_only_x = false;
};

inline std::pair<StudentLine, StudentLine>
rows_with(const StudentLine& corners, const decltype(Student::line)& line, const RowStyle& style) {
    int top = INT_MAX, bottom = INT_MIN;
    for (const StudentPixel& corner : corners) {
        top = std::min(top, corner.y);
        bottom = std::max(bottom, corner.y);
    }
    const int size = std::max(bottom - top + (style.lacks_last_row ? 0 : 1), 1);
    StudentLine left(static_cast<std::size_t>(size)), right = left;
    for (int i = 0; i < size; ++i) {
        const auto at = static_cast<std::size_t>(i);
        left[at].x = style.left_start;
        right[at].x = style.right_start;
        left[at].y = right[at].y = top + i;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (style.lacks_last_edge && i + 1 == corners.size()) continue;
        StudentPixel a = corners[i], b = corners[(i + 1) % corners.size()];
        if ((style.from_top && a.y > b.y) || (style.from_left && a.x > b.x)) std::swap(a, b);
        int count = std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) + 1;
        if (style.counts_by_rows) count = std::abs(a.y - b.y) + 1;
        if (style.counts_shifted)
            count = std::max({std::abs(a.x - b.x + 1), std::abs(a.y - b.y + 1), 1});
        StudentLine samples = line(a, b, count);
        if (style.lacks_last_sample) samples.pop_back();
        for (const StudentPixel& sample : samples) {
            int row = sample.y - top;
            if (style.clamps) row = std::clamp(row, 0, size - 1);
            if (row < 0 || row >= size) continue;
            StudentPixel entered = sample;
            entered.y = top + row;
            if (style.takes_only_x) entered.zinv = 0.0f, entered.place = entered.light = {};
            const auto at = static_cast<std::size_t>(row);
            if (sample.x < left[at].x) left[at] = entered;
            if (sample.x > right[at].x) right[at] = entered;
        }
    }
    return {left, right};
}

// DrawPolygonRows.

struct DrawStyle {
    bool lacks_last = false, skips_single = false, lacks_zero = false, lacks_last_row = false;
    bool clips = true;
};

inline std::vector<StudentPut> draw_with(const StudentLine& left, const StudentLine& right,
                                         const glm::vec3& colour, const DrawStyle& style) {
    std::vector<StudentPut> drawn;
    for (std::size_t i = 0; i + (style.lacks_last_row ? 1 : 0) < left.size(); ++i) {
        if (left[i].x > right[i].x || (style.skips_single && left[i].x == right[i].x)) continue;
        const int end = right[i].x - (style.lacks_last ? 1 : 0);
        for (int x = left[i].x; x <= end; ++x) {
            const bool is_outside = x < 0 || left[i].y < 0 || x >= 500 || left[i].y >= 500;
            if (style.clips && is_outside) continue;
            if (style.lacks_zero && (x == 0 || left[i].y == 0)) continue;
            drawn.push_back({x, left[i].y, colour});
        }
    }
    return drawn;
}

/// A student who has done all as the handout says, with a colour per pixel.
inline Student handout_student() {
    Student student;
    student.vertex = [](glm::vec3 position, glm::vec3 normal, glm::vec3 colour) {
        const glm::vec3 p = position - glm::vec3(0.0f, 0.0f, -3.001f);
        StudentPixel pixel;
        pixel.zinv = 1.0f / p.z;
        pixel.x = static_cast<int>(500.0f * p.x * pixel.zinv) + 250;
        pixel.y = static_cast<int>(500.0f * p.y * pixel.zinv) + 250;
        pixel.place = position * pixel.zinv;
        pixel.light = colour * student_light(position, normal);
        return pixel;
    };
    student.line = line_as_handout;
    student.rows = [](const StudentLine& corners) {
        return rows_with(corners, line_as_handout, {});
    };
    student.draw = [](const StudentLine& left, const StudentLine& right, glm::vec3 colour) {
        return draw_with(left, right, colour, {});
    };
    student.depth = [](float zinv, float& stored) {
        if (zinv <= stored) return false;
        stored = zinv;
        return true;
    };
    student.shade = [](const StudentPixel& pixel, glm::vec3 normal, glm::vec3 colour) {
        const glm::vec3 position = pixel.place / pixel.zinv;
        return std::optional(
            StudentPut{pixel.x, pixel.y, colour * student_light(position, normal)});
    };
    return student;
}

} // namespace rasterwalk::test
