// Changed lessons and what goes with them: what teachers write.

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "facts/expression.h"
#include "lab_code/chosen_lines.h"
#include "laboratory/bug.h"
#include "lessons/course.h"
#include "lessons/course_test.h"
#include "lessons/lesson.h"
#include "lessons/stage_note.h"
#include "session/content.h"
#include "session/glossary.h"
#include "settings/preset.h"
#include "support/changed_formats.h"
#include "text/markdown.h"
#include "text/math.h"
#include "text/prose.h"
#include "text/style.h"
#include "view/widget_names.h"

namespace rasterwalk::test {

namespace {

std::string file_of_lessons(const std::string& name) {
    return bytes_of(lessons_folder() + "/" + name);
}

/// The first three tables of a file that is a list of them.
std::string first_tables(const std::string& name) {
    const std::string text = file_of_lessons(name);
    const std::size_t begin = text.find("\n[[");
    std::size_t end = begin;
    for (int tables = 0; tables < 3; ++tables)
        end = text.find("\n[[", end + 1);
    return text.substr(begin, end - begin) + "\n";
}

/// A reader that throws, of text and the name of its file.
template <auto read>
FileOutcome read_outcome(const std::string& bytes, const TemporaryFolder&) {
    return text_outcome([&] {
        read(bytes, "x");
        return std::string();
    });
}

const FactReader no_facts = [](std::string_view) { return Value(); };

FileOutcome lesson_outcome(const std::string& bytes, const TemporaryFolder&) {
    const Lesson lesson = parse_lesson(bytes, "x");
    if (is_readable(lesson) && lesson.steps.empty()) return {true, "it has no step."};
    for (const LessonStep& step : lesson.steps) {
        heading_text(step);
        for (const LessonPart& part : step.parts)
            parse_markdown(with_footnotes(lesson, part.text));
    }
    const auto lines = std::count(bytes.begin(), bytes.end(), '\n') + 1;
    for (const Fault& fault : lesson.faults) {
        const std::string problem =
            problem_of_refusal(fault.sentence, fault.line >= 0 && fault.line <= lines);
        if (!problem.empty()) return {false, problem};
    }
    return {lesson.faults.empty(), ""};
}

FileOutcome page_outcome(const std::string& bytes, const TemporaryFolder&) {
    const MarkdownDocument page = parse_markdown(note_about(bytes, no_facts));
    for (const MarkdownPart& part : parse_as_written(bytes, deepest_lesson).parts)
        if (part.kind == MarkdownPart::Kind::formula) parse_math(part.text);
    for (const ProseKind kind :
         {ProseKind::markdown, ProseKind::program, ProseKind::data, ProseKind::script})
        prose_of(bytes, kind);
    const bool is_read = page.fault.empty();
    return {is_read, is_read ? "" : problem_of_refusal(page.fault, page.blocks.empty())};
}

int depth_of(const MathNode& node) {
    int deepest = 0;
    for (const MathNode& child : node.children)
        deepest = std::max(deepest, depth_of(child));
    return deepest + 1;
}

FileOutcome formula_outcome(const std::string& bytes, const TemporaryFolder&) {
    std::vector<std::string> faults;
    if (depth_of(parse_math(bytes, &faults)) > 8 * deepest_math) return {true, "it is too deep."};
    for (const std::string& fault : faults) {
        const std::string problem = problem_of_refusal(fault, true);
        if (!problem.empty()) return {false, problem};
    }
    return {faults.empty(), ""};
}

FileOutcome condition_outcome(const std::string& bytes, const TemporaryFolder&) {
    return word_outcome([&]() -> std::string {
        const Expression condition = parse_condition(bytes);
        impossible_parts(condition);
        number_of(condition, no_facts);
        return holds(condition, no_facts) && holds(parse_condition("not (" + bytes + ")"), no_facts)
                   ? "both it and its opposite hold."
                   : "";
    });
}

FileOutcome code_outcome(const std::string& bytes, const TemporaryFolder&) {
    return text_outcome([&] {
        std::vector<ChosenLine> lines, right;
        choose_lines(
            bytes, "x", 0, [](std::string_view word) { return word.size() % 2 == 0; }, lines);
        choose_lines(
            bytes, "x", 0, [](std::string_view word) { return word.size() % 3 == 0; }, right);
        mark_mistakes(lines, right);
        return std::string();
    });
}

const std::string page_seed =
    "# A *note* about `x`\n\nIt has {triangle.shown:2} of **two**, see [it](set:stage=fill).\n\n"
    "> **Try**\n>\n> - one $\\frac{a_1}{\\sqrt{b^2}}$\n> - ![two](p.png)[^a]\n\n"
    "| a | b |\n|:--|--:|\n| 1 | $\\vec v$ |\n\n```cpp\nint x = 1; // one\n```\n\n---\n\n"
    "$$\\left(1 - t\\right) \\cdot \\hat n$$\n\n1. <!-- no --> \"two\"\n\n[^a]: A source.\n";

const std::vector<std::string> page_words{
    "*",  "**", "_",    "`",  "```\n", "$",    "$$", "[",    "](", ")",  "![",        "[^a]",
    "> ", "- ", "1. ",  "# ", "|",     "|--|", "\n", "\\",   "{",  "}",  "<!--",      "-->",
    "<",  "\t", "    ", "\"", "'",     "\x80", "\r", "&#0;", "/*", "//", "{1 / 0:9}", "---\n"};

const std::vector<std::string> formula_words{"\\frac",  "\\sqrt", "{",     "}",       "^",  "_",
                                             "\\left",  "\\",     "\\hat", "\\text",  "$",  "\\vec",
                                             "\\right", "|",      "\x80",  "\\alpha", "^2", "'"};

const std::vector<std::string> condition_words{
    "(",    ")",       "not ", " and ", " or ",   "==",   "!=",   "=",           "<",     "-",
    "/ 0",  "min",     "abs(", ", ",    "none",   "end",  "t0/e", "²",           "1e999", "1e-9",
    "fill", "pixel.x", "0x1",  "stage", "cursor", "\x80", ".",    "999999999999"};

const std::vector<std::string> code_words{"#if ",    "#elif ", "#else\n", "#endif\n", "!", "&&",
                                          "||",      "(",      ")",       "\n",       "#", "a",
                                          "#define", "//",     "\x80",    "defined",  " ", "\r"};

std::vector<std::string> with_toml_words(std::vector<std::string> words) {
    words.insert(words.end(), toml_words.begin(), toml_words.end());
    return words;
}

} // namespace

std::vector<ChangedFormat> course_formats() {
    const std::string code = "int a;\n#if a && !(bb || c)\nint b;\n#elif dd\n// note\n#else\n"
                             "int c;\n#if e\nint d;\n#endif\n#endif\nint e;\n";
    const std::string style = "meant = [\"a|b *\"]\n[[rule]]\nphrases = [\"x|y z\", \"w\"]\n"
                              "advice = \"write 'u'.\"\n";
    return {
        {"lesson",
         {file_of_lessons("TEMPLATE.md"), file_of_lessons("08-depth-buffer.md"),
          file_of_lessons("01-pinhole-camera.md")},
         with_toml_words({"<!-- ", "-->", "\n\n", "## ", "order", "control", "task", "> ", "```\n",
                          "[^1]", "${", "id = ", "`", "](", "note"}),
         lesson_outcome},
        {"course", {file_of_lessons("course.toml")}, toml_words, read_outcome<parse_course>},
        {"test", {first_tables("course-test.toml")}, toml_words, read_outcome<parse_course_test>},
        {"bugs", {first_tables("bugs.toml")}, toml_words, read_outcome<parse_bugs>},
        {"glossary", {first_tables("glossary.toml")}, toml_words, read_outcome<parse_glossary>},
        {"presets", {first_tables("presets.toml")}, toml_words, read_outcome<parse_presets>},
        {"style", {style}, toml_words, read_outcome<parse_style>},
        {"widgets",
         {"# a\ncanvas\ncanvas.row#\n- tab.{tab}.*\n"},
         {"#", "- ", "\n", "{", "}", "*", "{vector}", " ", "\x80"},
         read_outcome<parse_widget_patterns>},
        {"code", {code}, code_words, code_outcome},
        {"page", {page_seed}, page_words, page_outcome, false},
        {"formula",
         {"\\frac{a_1 + b}{\\sqrt{c^2}} = \\hat n \\cdot \\vec{AB}",
          "\\left(\\text{a b}\\right)^{x_i}"},
         formula_words,
         formula_outcome},
        {"condition",
         {"stage == fill and not (pixel.column > 2 or cursor >= t0/e1/s2)",
          "abs(camera.position.z - 1) / min(2, table.rows) < 0.5", "triangle == none"},
         condition_words,
         condition_outcome},
    };
}

} // namespace rasterwalk::test
