#include "mine/functions/answers.h"

#include <cmath>

#include <fmt/format.h>

namespace rasterwalk {

namespace {

using namespace rasterwalk_kit;
using PartNumber = rasterwalk_kit::Part;

/// Thrown where the stream ends.
struct StreamEnded {};
/// Thrown where it breaks its rules.
struct StreamBroken {};

/// Goes through the stream. Throws the two above, which do not leave this file.
class AnswerReader {
  public:
    explicit AnswerReader(std::span<const double> numbers) : numbers_(numbers) {}

    bool is_at_end() const { return at_ == numbers_.size(); }
    double next() {
        if (is_at_end()) throw StreamEnded{};
        return numbers_[at_++];
    }
    double peek() const {
        if (is_at_end()) throw StreamEnded{};
        return numbers_[at_];
    }

    /// A count as the program says it: a whole number, 0 or more. NaN is broken.
    double count() {
        const double said = next();
        if (!(said >= 0.0 && said <= 0x1p53 && std::floor(said) == said)) throw StreamBroken{};
        return said;
    }

  private:
    std::span<const double> numbers_;
    std::size_t at_ = 0;
};

/// How many of a list are in the stream.
/// @param most of the kind
std::size_t listed(double size, std::size_t most) {
    return size > static_cast<double>(most) ? most : static_cast<std::size_t>(size);
}

void read_value(AnswerReader& reader, PixelValues& values) {
    values.fields = reader.next();
    constexpr double most = field_xy | field_zinv | field_place | field_light;
    if (!(values.fields >= 0.0 && values.fields <= most) ||
        std::floor(values.fields) != values.fields)
        throw StreamBroken{};
    values.x = reader.next();
    values.y = reader.next();
    values.zinv = reader.next();
    for (double& value : values.place)
        value = reader.next();
    for (double& value : values.light)
        value = reader.next();
}

void read_pixels(AnswerReader& reader, PixelList& list) {
    // Grows as it is read: a count proves nothing about what follows.
    for (std::size_t i = listed(list.size, most_listed); i > 0; --i)
        read_value(reader, list.pixels.emplace_back());
}

void read_drawn(AnswerReader& reader, DrawnPixel& drawn) {
    drawn.x = reader.next();
    drawn.y = reader.next();
    for (int i = 0; i < 3; ++i)
        drawn.colour[i] = reader.next();
}

void read_answer(AnswerReader& reader, std::size_t, const Questions&, PixelValues& answer) {
    read_value(reader, answer);
}

void read_answer(AnswerReader& reader, std::size_t, const Questions&, PixelList& answer) {
    answer.size = reader.count();
    read_pixels(reader, answer);
}

void read_answer(AnswerReader& reader, std::size_t, const Questions&, RowLists& answer) {
    answer.left.size = reader.count();
    answer.right.size = reader.count();
    read_pixels(reader, answer.left);
    read_pixels(reader, answer.right);
}

void read_answer(AnswerReader& reader, std::size_t, const Questions&, PutList& answer) {
    answer.size = reader.count();
    for (std::size_t i = listed(answer.size, most_listed_puts); i > 0; --i)
        read_drawn(reader, answer.pixels.emplace_back());
}

bool read_flag(AnswerReader& reader) {
    const double flag = reader.next();
    if (flag != 0.0 && flag != 1.0) throw StreamBroken{};
    return flag == 1.0;
}

void read_answer(AnswerReader& reader, std::size_t question, const Questions& questions,
                 std::vector<bool>& answer) {
    for (std::size_t i = questions.depths[question].fragments.size(); i > 0; --i)
        answer.push_back(read_flag(reader));
}

void read_answer(AnswerReader& reader, std::size_t, const Questions&,
                 std::optional<DrawnPixel>& answer) {
    if (read_flag(reader)) read_drawn(reader, answer.emplace());
}

glm::vec3 to_vector(std::span<const double> numbers) {
    if (numbers.size() == 1) return glm::vec3(static_cast<float>(numbers[0]));
    return {static_cast<float>(numbers[0]), static_cast<float>(numbers[1]),
            static_cast<float>(numbers[2])};
}

void expect(bool is_expected) {
    if (!is_expected) throw StreamBroken{};
}

/// A side of a picture, 0 if it cannot be one.
int to_side(double number) {
    return number >= 1.0 && number <= 4096.0 ? static_cast<int>(number) : 0;
}

void put_global(Global global, std::span<const double> numbers, ProgramGlobals& globals) {
    const std::size_t size = numbers.size();
    switch (global) {
    case global_camera:
        expect(size == 3);
        globals.camera = to_vector(numbers);
        break;
    case global_rotation:
        expect(size == 9);
        globals.rotation =
            glm::mat3(to_vector(numbers.subspan(0, 3)), to_vector(numbers.subspan(3, 3)),
                      to_vector(numbers.subspan(6)));
        break;
    case global_yaw:
        expect(size == 1);
        globals.yaw = static_cast<float>(numbers[0]);
        break;
    case global_focal_length:
        expect(size == 1);
        globals.focal_length = static_cast<float>(numbers[0]);
        break;
    case global_light_position:
        expect(size == 3);
        globals.light_position = to_vector(numbers);
        break;
    case global_light_power:
        expect(size == 1 || size == 3);
        globals.light_power = to_vector(numbers);
        break;
    case global_indirect:
        expect(size == 1 || size == 3);
        globals.indirect = to_vector(numbers);
        break;
    case global_screen:
        expect(size == 2);
        globals.screen = Viewport{to_side(numbers[0]), to_side(numbers[1])};
        break;
    case global_triangles:
        expect(size % 15 == 0);
        for (; !numbers.empty(); numbers = numbers.subspan(15)) {
            std::array<glm::vec3, 5>& triangle = globals.triangles.emplace_back();
            for (std::size_t i = 0; i < triangle.size(); ++i)
                triangle[i] = to_vector(numbers.subspan(3 * i, 3));
        }
        break;
    case global_count:
        break;
    }
}

void read_globals(AnswerReader& reader, PartAnswers<ProgramGlobals>& part) {
    part.end = PartEnd::cut_short;
    ProgramGlobals& globals = part.answers.emplace_back();
    expect(reader.next() == 0.0); // the only question
    std::vector<double> numbers;
    while (reader.peek() != end_of_part) {
        const double number = reader.count();
        expect(number < double{global_count});
        numbers.clear();
        for (double left = reader.count(); left > 0.0; --left)
            numbers.push_back(reader.next());
        put_global(static_cast<Global>(number), numbers, globals);
    }
    reader.next();
    part.end = PartEnd::complete;
}

template <class Answer>
void read_part(AnswerReader& reader, PartNumber number, const Questions& questions,
               PartAnswers<Answer>& part) {
    part.end = PartEnd::cut_short;
    if (const double first = reader.peek(); first == not_written || first == not_askable) {
        reader.next();
        expect(reader.next() == end_of_part);
        part.end = first == not_written ? PartEnd::not_written : PartEnd::not_askable;
        return;
    }
    const std::size_t count = question_count(questions, number);
    while (reader.peek() != end_of_part) {
        const std::size_t question = part.answers.size();
        expect(question < count && reader.next() == static_cast<double>(question));
        Answer answer{};
        read_answer(reader, question, questions, answer);
        part.answers.push_back(std::move(answer));
    }
    reader.next();
    expect(part.answers.size() == count);
    part.end = PartEnd::complete;
}

/// Reads one part into its place.
/// @param last the number of the part before it
/// @return this part's number
double read_one(AnswerReader& reader, const Questions& questions, double last, Answers& answers) {
    const double number = reader.next();
    expect(number > last && number >= double{part_globals} && number < double{part_count} &&
           std::floor(number) == number);
    const auto mark = [](auto& part) {
        part.end = PartEnd::unreadable;
        part.fault = "The answers do not follow the order of the questions.";
    };
    const auto read = [&](auto& part, auto read_it) {
        try {
            read_it();
        } catch (const StreamBroken&) {
            mark(part);
            throw;
        }
    };
    const auto part = static_cast<PartNumber>(static_cast<std::uint32_t>(number));
    const auto read_as = [&](auto& answered) {
        read(answered, [&] { read_part(reader, part, questions, answered); });
    };
    switch (part) {
    case part_globals:
        read(answers.globals, [&] { read_globals(reader, answers.globals); });
        break;
    case part_vertex_shader:
        read_as(answers.vertices);
        break;
    case part_interpolate:
        read_as(answers.lines);
        break;
    case part_polygon_rows:
        read_as(answers.polygons);
        break;
    case part_draw_rows:
        read_as(answers.rows);
        break;
    case part_depth_test:
        read_as(answers.depths);
        break;
    case part_pixel_shader:
        read_as(answers.points);
        break;
    case part_picture:
    case part_count:
        break;
    }
    return number;
}

/// After a fault nothing that follows can be found, whether or not it was asked.
void mark_rest(Answers& answers) {
    const auto mark = [](auto& part) {
        if (part.end != PartEnd::not_asked) return;
        part.end = PartEnd::unreadable;
        part.fault =
            "The answers before these could not be read, so where they begin is not known.";
    };
    mark(answers.vertices);
    mark(answers.lines);
    mark(answers.polygons);
    mark(answers.rows);
    mark(answers.depths);
    mark(answers.points);
}

bool is_finite(const glm::vec3& vector) {
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

void take(const std::optional<glm::vec3>& from, glm::vec3& to) {
    if (from && is_finite(*from)) to = *from;
}

} // namespace

Answers read_answers(std::span<const double> numbers, const Questions& questions) {
    Answers answers;
    AnswerReader reader(numbers);
    double last = 0.0;
    try {
        while (!reader.is_at_end())
            last = read_one(reader, questions, last, answers);
    } catch (const StreamBroken&) {
        mark_rest(answers);
    } catch (const StreamEnded&) {
        return answers; // what was answered before is kept
    }
    return answers;
}

KnownProgram known_program(const ProgramGlobals& globals, const KnownProgram& before) {
    KnownProgram known = before;
    take(globals.camera, known.camera.position);
    if (globals.yaw && std::isfinite(*globals.yaw)) known.camera.yaw = *globals.yaw;
    if (globals.focal_length && *globals.focal_length >= 1.0f && *globals.focal_length <= 100000.0f)
        known.camera.focal_length = *globals.focal_length;
    if (globals.screen && globals.screen->width > 0 && globals.screen->height > 0)
        known.viewport = *globals.screen;
    take(globals.light_position, known.light.position);
    take(globals.light_power, known.light.power);
    take(globals.indirect, known.light.indirect);
    if (globals.rotation) known.rotation = globals.rotation;
    if (globals.light_position && globals.light_power && globals.indirect) known.knows_light = true;
    return known;
}

} // namespace rasterwalk
