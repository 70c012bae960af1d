// Asks a program the questions of recording.h, part by part, and writes its answers.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "asking_questions.h"
#include "recording.h"
#include "runtime.h"

namespace rasterwalk_kit {

namespace {

constexpr std::array<double, 3> toward_camera = {0.0, 0.0, -1.0};
constexpr std::array<double, 3> white = {1.0, 1.0, 1.0};

/// The questions of a part, from front to back.
class Questions {
  public:
    Questions(const Recorded& memory, Part part) : m_numbers(memory.questions) {
        const std::uint64_t begin = part == 0 ? 0 : memory.task.question_end[part - 1];
        m_at = std::min<std::uint64_t>(begin, most_questions);
        m_end = std::min<std::uint64_t>(memory.task.question_end[part], most_questions);
    }

    bool has_more() const { return m_at < m_end; }

    /// The next number; 0 if there is none.
    double number() { return has_more() ? m_numbers[m_at++] : 0.0; }

    /// The next number as a count of things that are so many numbers each.
    std::size_t count(std::size_t numbers_each) {
        const double wanted = number();
        const std::size_t room = has_more() ? (m_end - m_at) / numbers_each : 0;
        if (!(wanted > 0.0)) return 0;
        return static_cast<std::size_t>(std::min(wanted, static_cast<double>(room)));
    }

    std::array<double, 3> three() {
        const double x = number();
        const double y = number();
        return {x, y, number()};
    }

    PixelValues pixel() {
        PixelValues values{};
        values.fields = number();
        values.x = number();
        values.y = number();
        values.zinv = number();
        for (double& part : values.place)
            part = number();
        for (double& part : values.light)
            part = number();
        return values;
    }

    std::vector<PixelValues> pixels(std::size_t count) {
        std::vector<PixelValues> all(count);
        for (PixelValues& each : all)
            each = pixel();
        return all;
    }

  private:
    const double* m_numbers;
    std::size_t m_at = 0, m_end = 0;
};

/// Writes answers behind those that are already there. What is written counts from keep() on, so
/// that a crash leaves whole answers only.
class Answers {
  public:
    explicit Answers(Recorded& memory) : m_memory(memory), m_used(memory.progress.answers) {}

    void number(double value) {
        // One place is left for the end of the part.
        if (m_used + 1 < most_answers) {
            m_memory.answers[m_used++] = value;
        } else {
            m_is_full = true;
        }
    }

    void pixel(const PixelValues& values) {
        number(values.fields);
        number(values.x);
        number(values.y);
        number(values.zinv);
        for (const double part : values.place)
            number(part);
        for (const double part : values.light)
            number(part);
    }

    void pixels(const PixelList& list) {
        for (std::size_t i = 0; i < std::min(list.count, most_listed); ++i)
            pixel(list.values[i]);
    }

    void put(const Put& one) {
        number(one.x);
        number(one.y);
        number(one.red);
        number(one.green);
        number(one.blue);
    }

    /// The answer is complete. False: there was no room for it, and it does not count.
    bool keep() {
        if (m_is_full) return false;
        m_memory.progress.answers = m_used;
        return true;
    }

    /// Ends a part.
    void end() {
        m_used = m_memory.progress.answers;
        if (m_used < most_answers) m_memory.answers[m_used++] = end_of_part;
        m_memory.progress.answers = m_used;
    }

  private:
    Recorded& m_memory;
    std::size_t m_used;
    bool m_is_full = false;
};

/// Asks a program's functions one after the other.
class Asking {
  public:
    Asking(Recorded& memory, const Functions& functions)
        : m_memory(memory), m_functions(functions), m_answers(memory) {
        // It is 0 for 1/z. If the program keeps z instead, pixels that nothing covers hold a
        // number far above all of the scene.
        constexpr double beyond_the_scene = 100.0;
        const double greatest = functions.greatest_depth();
        if (greatest > beyond_the_scene) m_cleared_depth = greatest;
    }

    void ask_variables() {
        ask(part_globals, [&] {
            m_answers.number(0.0);
            NumberList list;
            m_functions.list_variables(list);
            for (const double number : list.numbers())
                m_answers.number(number);
            m_is_kept = m_answers.keep();
        });
    }

    void ask_functions() {
        ask_function(part_vertex_shader, m_functions.vertex_shader, &Asking::ask_vertex_shader);
        ask_function(part_interpolate, m_functions.interpolate, &Asking::ask_interpolate);
        ask_function(part_polygon_rows, m_functions.polygon_rows, &Asking::ask_polygon_rows);
        ask_function(part_draw_rows, m_functions.draw_rows, &Asking::ask_draw_rows);
        ask_function(part_depth_test, m_functions.draw_rows, &Asking::ask_depth_test);
        ask_function(part_pixel_shader, m_functions.pixel_shader, &Asking::ask_pixel_shader);
    }

  private:
    Recorded& m_memory;
    const Functions& m_functions;
    Answers m_answers;
    double m_cleared_depth = 0.0;
    bool m_is_kept = true; ///< the last answer
    std::vector<Put> m_puts;
    std::vector<PixelValues> m_first_list = std::vector<PixelValues>(most_listed);
    std::vector<PixelValues> m_second_list = std::vector<PixelValues>(most_listed);

    template <class Use>
    void ask(Part part, Use use) {
        const std::uint32_t bit = std::uint32_t{1} << part;
        if ((m_memory.task.parts & bit) == 0) return;
        set_part(part, 0);
        m_answers.number(part);
        m_is_kept = m_answers.keep();
        use();
        m_answers.end();
        if (m_is_kept) m_memory.progress.answered |= bit;
    }

    template <class Question>
    void ask_function(Part part, const Function<Question>& function,
                      void (Asking::*ask_one)(Questions&)) {
        ask(part, [&] {
            if (function.ask == nullptr) {
                m_answers.number(function.is_written ? not_askable : not_written);
                m_is_kept = m_answers.keep();
                return;
            }
            Questions questions(m_memory, part);
            for (std::uint64_t index = 0; m_is_kept && questions.has_more(); ++index) {
                set_part(part, index);
                m_answers.number(static_cast<double>(index));
                (this->*ask_one)(questions);
                m_is_kept = m_answers.keep();
            }
        });
    }

    template <class Question>
    void call(const Function<Question>& function, Question& question) {
        m_functions.set_surface(question);
        m_puts.clear();
        capture_puts(&m_puts);
        function.ask(question);
        capture_puts(nullptr);
    }

    void ask_vertex_shader(Questions& questions) {
        const std::array<double, 3> position = questions.three();
        const std::array<double, 3> normal = questions.three();
        const std::array<double, 3> colour = questions.three();
        VertexQuestion question;
        question.position = position.data();
        question.normal = normal.data();
        question.colour = colour.data();
        call(m_functions.vertex_shader, question);
        m_answers.pixel(question.answer);
    }

    void ask_interpolate(Questions& questions) {
        constexpr double most_samples = 1e6;
        InterpolateQuestion question;
        question.normal = toward_camera.data();
        question.colour = white.data();
        question.from = questions.pixel();
        question.to = questions.pixel();
        question.count =
            static_cast<std::size_t>(std::clamp(questions.number(), 0.0, most_samples));
        question.answer.values = m_first_list.data();
        call(m_functions.interpolate, question);
        if (question.is_for_numbers) {
            question.is_asked_y = true;
            call(m_functions.interpolate, question);
        }
        m_answers.number(static_cast<double>(question.answer.count));
        m_answers.pixels(question.answer);
    }

    void ask_polygon_rows(Questions& questions) {
        const std::vector<PixelValues> polygon =
            questions.pixels(questions.count(doubles_in_pixel));
        RowsQuestion question;
        question.normal = toward_camera.data();
        question.colour = white.data();
        question.polygon = polygon.data();
        question.count = polygon.size();
        question.left.values = m_first_list.data();
        question.right.values = m_second_list.data();
        call(m_functions.polygon_rows, question);
        m_answers.number(static_cast<double>(question.left.count));
        m_answers.number(static_cast<double>(question.right.count));
        m_answers.pixels(question.left);
        m_answers.pixels(question.right);
    }

    void ask_draw_rows(Questions& questions) {
        const std::size_t rows = questions.count(2 * doubles_in_pixel);
        const std::vector<PixelValues> left = questions.pixels(rows);
        const std::vector<PixelValues> right = questions.pixels(rows);
        const std::array<double, 3> colour = questions.three();
        m_functions.clear_depth(m_cleared_depth);
        draw(left, right, colour);
        m_answers.number(static_cast<double>(m_puts.size()));
        for (std::size_t i = 0; i < std::min(m_puts.size(), most_listed_puts); ++i) {
            m_answers.put(m_puts[i]);
        }
    }

    void ask_depth_test(Questions& questions) {
        m_functions.clear_depth(m_cleared_depth);
        for (std::size_t left = questions.count(doubles_in_pixel + 3); left > 0; --left) {
            const std::vector<PixelValues> fragment = questions.pixels(1);
            draw(fragment, fragment, questions.three());
            m_answers.number(m_puts.empty() ? 0.0 : 1.0);
        }
    }

    void draw(const std::vector<PixelValues>& left, const std::vector<PixelValues>& right,
              const std::array<double, 3>& colour) {
        DrawQuestion question;
        question.normal = toward_camera.data();
        question.colour = colour.data();
        question.left = left.data();
        question.right = right.data();
        question.count = left.size();
        call(m_functions.draw_rows, question);
    }

    void ask_pixel_shader(Questions& questions) {
        ShaderQuestion question;
        question.pixel = questions.pixel();
        const std::array<double, 3> normal = questions.three();
        const std::array<double, 3> colour = questions.three();
        question.normal = normal.data();
        question.colour = colour.data();
        m_functions.clear_depth(m_cleared_depth);
        call(m_functions.pixel_shader, question);
        m_answers.number(m_puts.empty() ? 0.0 : 1.0);
        if (!m_puts.empty()) m_answers.put(m_puts.front());
    }
};

} // namespace

void NumberList::begin(Global global) {
    m_begin = m_numbers.size();
    m_numbers.push_back(global);
    m_numbers.push_back(0.0);
}

void NumberList::add(double number) {
    m_numbers.push_back(number);
}

void NumberList::add_three(double first, double second, double third) {
    m_numbers.insert(m_numbers.end(), {first, second, third});
}

void NumberList::end(bool is_found) {
    if (!is_found) {
        m_numbers.resize(m_begin);
        return;
    }
    m_numbers[m_begin + 1] = static_cast<double>(m_numbers.size() - m_begin - 2);
}

void ask_all(const Functions& functions) noexcept {
    Asking asking(*recorded(), functions);
    asking.ask_variables();
    asking.ask_functions();
}

} // namespace rasterwalk_kit
