#pragma once

// A lesson: text that drives the program. The format is described in lessons/README.md.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/limits.h"
#include "facts/expression.h"
#include "lessons/lesson_puzzle.h"
#include "settings/control_range.h"
#include "view/view_state.h"

namespace rasterwalk {

/// A link target with its place.
struct LinkPlace {
    std::string target;
    std::string words; ///< the text shown, without styles
    int line = 0;
    bool is_picture = false; ///< ![words](target)
};

/// The reply to a try that does not solve a task.
struct NotYet {
    Expression when;  ///< holds for such tries, and not when the step opens
    std::string says; ///< Markdown with {EXPRESSION}, see fill_in(): what is missing
    int line = 0;
};

/// Something to do, ticked off when a condition holds while the input is at rest.
struct LessonTask {
    std::string id;
    std::optional<Expression> done;  ///< none if it could not be read
    std::vector<std::string> recipe; ///< link targets that solve it, from what the step shows
    std::string hint;                ///< Markdown; may be empty
    std::string because;         ///< why it is solved: Markdown with {EXPRESSION}, see fill_in()
    std::vector<NotYet> not_yet; ///< the first that holds is the reply
    std::string text;            ///< Markdown that the student reads, without the quote's `>`
    int step = 0;
    int line = 0; ///< of its comment
    int done_line = 0, recipe_line = 0, because_line = 0;
};

/// A wrong answer that comes from a misconception, and the reply to it before the second try.
struct Misconception {
    /// Of a number: that number. Of a pixel: a condition, with the student's pixel picked.
    std::optional<Expression> answer;
    std::optional<Expression> tolerance; ///< of a number; none: the prediction's
    int choice = -1;                     ///< of a choice: which
    std::string says; ///< Markdown with {EXPRESSION}, see fill_in(); not the right answer
    int line = 0;
};

/// A question that is answered before the program shows.
struct LessonPrediction {
    enum class Kind : std::uint8_t { number, pixel, choice };

    std::string id;
    Kind kind = Kind::number;
    bool looks_back = false; ///< it is about an earlier lesson; only in the opening
    // A number:
    std::optional<Expression> answer;
    std::optional<Expression> tolerance; ///< how far a right answer may be off; none: 0
    std::string unit;                    ///< after the field; may be empty
    // One of several:
    std::vector<std::string> choices;
    std::vector<Expression> right; ///< a condition for each choice; exactly one holds
    std::vector<int> order;        ///< the order they are offered in, see shuffled()
    // A pixel:
    std::optional<Expression> where;                    ///< with the student's pixel picked
    std::optional<glm::ivec2> right_pixel, wrong_pixel; ///< examples; both are tried by `check`

    std::vector<Misconception> misconceptions; ///< the first that fits counts

    ViewState at;                  ///< where the answer is found; already includes the step's
    std::optional<ViewState> then; ///< shown after the answer, also complete; none: no change
    std::string because; ///< Markdown with {answer} and {EXPRESSION}, see fill_in(); may be empty
    std::string text;    ///< Markdown that the student reads, without the quote's `>`
    int step = 0;
    int line = 0; ///< of its comment
    int answer_line = 0, because_line = 0;
};

/// A setting with a control in the step itself.
struct LessonControl {
    std::string name;                 ///< as in conditions: `camera.position.z`
    const Setting* setting = nullptr; ///< with this name
    ControlRange range;               ///< the part of it that is offered
    std::string read_out;             ///< text with {EXPRESSION}, see fill_in(); may be empty
    int line = 0;                     ///< of its comment
    int read_out_line = 0;
};

/// A piece of a step, in reading order.
struct LessonPart {
    enum class Kind : std::uint8_t { text, task, prediction, control, puzzle };
    Kind kind = Kind::text;
    std::string text; ///< Markdown; only for a text
    int index = -1;   ///< in Lesson::tasks, predictions, controls or puzzles
    int line = 0;     ///< where its text begins
};

/// A piece of text with its place.
struct TextPlace {
    std::string text;
    int line = 0;
};

/// One screen of a lesson.
struct LessonStep {
    std::string heading; ///< inline Markdown; in step 0, the lesson's
    ViewState state;     ///< complete: the lesson's and the step's own
    std::vector<LessonPart> parts;
    std::vector<LinkPlace> links;     ///< and pictures in its texts, tasks, hints and predictions
    std::vector<TextPlace> formulas;  ///< TeX between dollar signs, in the same texts
    std::vector<TextPlace> footnotes; ///< labels that are referred to there
    int line = 0;
};

/// A footnote: [^label] in a text, [^label]: text at the end of the file.
struct LessonFootnote {
    std::string label;
    std::string text; ///< Markdown
    int line = 0;
};

/// A lesson as read. If there are faults, everything else is still there as far as possible.
struct Lesson {
    std::string id;     ///< the file's name without .md: `07-painters-order`
    std::string path;   ///< of the file
    std::string folder; ///< of lessons; scenes and pictures are found from there
    std::string title;
    std::string section; ///< of the lab
    int minutes = 0;
    std::string about;                ///< one sentence for the list
    std::string program;              ///< the part of the student's program that it is about
    int picture = 0;                  ///< step that its picture in screenshots/ shows
    std::vector<std::string> sources; ///< its sources, Markdown of one line each
    std::vector<LessonStep> steps;    ///< step 0 is the opening; there is always one
    std::vector<LessonTask> tasks;
    std::vector<LessonPrediction> predictions;
    std::vector<LessonControl> controls;
    std::vector<LessonPuzzle> puzzles;
    std::vector<LessonFootnote> footnotes;
    std::vector<Fault> faults; ///< in the order of their lines
};

/// Reads a lesson. Never throws: what is wrong is in its faults. If it exceeds the limits below,
/// only its faults are left, see is_readable().
/// @param path names the lesson, and is used in messages
Lesson parse_lesson(std::string_view text, const std::string& path);
Lesson read_lesson(const std::string& path);

/// Is there anything to show of it?
bool is_readable(const Lesson& lesson);

/// "lessons/01-pinhole.md:12: sentence", as printed.
std::string fault_text(const Lesson& lesson, const Fault& fault);

/// A link to the lesson in Markdown, with its title.
std::string link_to_lesson(const Lesson& lesson);

/// The text with the footnotes that it refers to, in the form in which they can be read together.
std::string with_footnotes(const Lesson& lesson, const std::string& text);

/// The step's heading as a reader sees it, without styles.
std::string heading_text(const LessonStep& step);

/// Its tasks and puzzles: what is ticked off when it is done.
int task_count(const Lesson& lesson);

/// The prediction of this id; null if there is none.
const LessonPrediction* find_prediction(const Lesson& lesson, std::string_view id);

inline constexpr std::size_t largest_lesson = std::size_t{1} << 20; ///< bytes
inline constexpr int most_lesson_lines = 20'000;
inline constexpr std::size_t longest_lesson_line = 4'000; ///< bytes
inline constexpr int most_lesson_questions = 100;         ///< tasks, predictions and puzzles
inline constexpr int most_lesson_links = 2'000;
inline constexpr int most_recipe_links = 50;
inline constexpr int most_step_controls = 3;
inline constexpr int most_slider_steps = 1'000;
inline constexpr std::size_t longest_read_out = 100; ///< bytes
inline constexpr int most_choices = 8;
inline constexpr std::size_t longest_choice = 400; ///< bytes
inline constexpr std::size_t longest_unit = 60;    ///< bytes
inline constexpr int most_misconceptions = 12;
inline constexpr int most_not_yet = 12; ///< replies of a task
inline constexpr int most_sources = 8;
inline constexpr std::size_t most_lesson_footnotes = 99;
inline constexpr int most_table_columns = 40;
inline constexpr int deepest_lesson = 24; ///< nesting of quotes, lists, emphasis and brackets

} // namespace rasterwalk
