#include <iterator>
#include <stdexcept>

#include "mine/functions/questions.h"

namespace rasterwalk {

namespace {

using rasterwalk_kit::PixelValues;

void put_values(const PixelValues& values, std::vector<double>& numbers) {
    for (const double value : {values.fields, values.x, values.y, values.zinv})
        numbers.push_back(value);
    numbers.insert(numbers.end(), std::begin(values.place), std::end(values.place));
    numbers.insert(numbers.end(), std::begin(values.light), std::end(values.light));
}

void put_vector(const glm::vec3& vector, std::vector<double>& numbers) {
    for (int i = 0; i < 3; ++i)
        numbers.push_back(double{vector[i]});
}

void put_question(const VertexQuestion& question, std::vector<double>& numbers) {
    put_vector(question.position, numbers);
    put_vector(question.normal, numbers);
    put_vector(question.colour, numbers);
}

void put_question(const LineQuestion& question, std::vector<double>& numbers) {
    put_values(question.a, numbers);
    put_values(question.b, numbers);
    numbers.push_back(question.count);
}

void put_question(const PolygonQuestion& question, std::vector<double>& numbers) {
    numbers.push_back(static_cast<double>(question.corners.size()));
    for (const PixelValues& corner : question.corners)
        put_values(corner, numbers);
}

void put_question(const RowsQuestion& question, std::vector<double>& numbers) {
    numbers.push_back(static_cast<double>(question.left.size()));
    for (const PixelValues& end : question.left)
        put_values(end, numbers);
    for (const PixelValues& end : question.right)
        put_values(end, numbers);
    put_vector(question.colour, numbers);
}

void put_question(const DepthQuestion& question, std::vector<double>& numbers) {
    numbers.push_back(static_cast<double>(question.fragments.size()));
    for (const DepthFragment& fragment : question.fragments) {
        put_values(fragment.at, numbers);
        put_vector(fragment.colour, numbers);
    }
}

void put_question(const ShaderQuestion& question, std::vector<double>& numbers) {
    put_values(question.at, numbers);
    put_vector(question.normal, numbers);
    put_vector(question.colour, numbers);
}

template <class Question>
void put_questions(const std::vector<Question>& questions, std::vector<double>& numbers) {
    for (const Question& question : questions)
        put_question(question, numbers);
}

} // namespace

std::size_t question_count(const Questions& questions, rasterwalk_kit::Part part) {
    switch (part) {
    case rasterwalk_kit::part_globals:
        return 1;
    case rasterwalk_kit::part_vertex_shader:
        return questions.vertices.size();
    case rasterwalk_kit::part_interpolate:
        return questions.lines.size();
    case rasterwalk_kit::part_polygon_rows:
        return questions.polygons.size();
    case rasterwalk_kit::part_draw_rows:
        return questions.rows.size();
    case rasterwalk_kit::part_depth_test:
        return questions.depths.size();
    case rasterwalk_kit::part_pixel_shader:
        return questions.points.size();
    case rasterwalk_kit::part_picture:
    case rasterwalk_kit::part_count:
        break;
    }
    return 0;
}

QuestionStream to_stream(const Questions& questions) {
    QuestionStream stream;
    std::vector<double>& numbers = stream.numbers;
    const auto end = [&](rasterwalk_kit::Part part) { stream.ends[part] = numbers.size(); };
    end(rasterwalk_kit::part_picture);
    end(rasterwalk_kit::part_globals);
    put_questions(questions.vertices, numbers);
    end(rasterwalk_kit::part_vertex_shader);
    put_questions(questions.lines, numbers);
    end(rasterwalk_kit::part_interpolate);
    put_questions(questions.polygons, numbers);
    end(rasterwalk_kit::part_polygon_rows);
    put_questions(questions.rows, numbers);
    end(rasterwalk_kit::part_draw_rows);
    put_questions(questions.depths, numbers);
    end(rasterwalk_kit::part_depth_test);
    put_questions(questions.points, numbers);
    end(rasterwalk_kit::part_pixel_shader);
    if (numbers.size() > rasterwalk_kit::most_questions)
        throw std::length_error("the questions do not fit in the recording");
    return stream;
}

} // namespace rasterwalk
