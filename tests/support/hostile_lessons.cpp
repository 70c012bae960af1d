#include "tests/support/hostile_lessons.h"

#include <functional>

namespace rasterwalk::test {

namespace {

constexpr int head_lines = 9;

std::string times(int count, const std::string& text) {
    std::string result;
    for (int i = 0; i < count; ++i)
        result += text;
    return result;
}

std::string lines(int count, const std::function<std::string(int)>& line) {
    std::string result;
    for (int i = 0; i < count; ++i)
        result.append(line(i)).append("\n");
    return result;
}

std::string numbered(const std::string& before, int number, const std::string& after) {
    return std::string(before).append(std::to_string(number)).append(after);
}

const std::string too_deep = "the text is nested deeper than 24 levels.";

/// A task whose condition is this.
std::string task(const std::string& id, const std::string& done) {
    return std::string("<!-- task\nid = \"")
        .append(id)
        .append("\"\ndone = \"")
        .append(done)
        .append("\"\nrecipe = [\"set:stage=rows\"]\n-->\n> **Task.** Do it.\n\n");
}

} // namespace

std::string lesson_head() {
    return R"(<!-- lesson
title = "Made to hurt"
section = "Drawing edges"
minutes = 10
about = "It does not want to be read."
program = "nothing"
-->
# Made to hurt

)";
}

std::vector<HostileLesson> hostile_lessons() {
    const int first = head_lines + 1;
    std::vector<HostileLesson> all{
        {"10 MB of text",
         times(160'000, "All work and no play makes a dull lesson, and a long one too.\n"), 0,
         "the file is larger than 1 MB."},
        {"a million empty lines", std::string(1'000'000, '\n'), 20'000,
         "a lesson may have at most 20000 lines."},
        {"a line of 4001 bytes", std::string(4'001, 'a'), first,
         "the line is longer than 4000 bytes."},
        {"quotes in quotes", times(1'000, ">") + " Help!", first, too_deep},
        {"quotes in quotes, with blanks", times(1'000, "> ") + "Help!", first, too_deep},
        {"lists in lists", times(1'000, "- ") + "Help!", first, too_deep},
        {"numbered lists in lists", times(1'000, "1. ") + "Help!", first, too_deep},
        {"lists and quotes", times(900, "> - ") + "Help!", first, too_deep},
        {"lists that are indented",
         lines(1'000,
               [](int i) { return std::string(static_cast<std::size_t>(2 * i), ' ') + "- a"; }),
         first + 12, too_deep},
        {"brackets", times(1'000, "[") + "a" + times(1'000, "]"), first, too_deep},
        {"links in links", times(300, "[") + "a" + times(300, "](tab:rows)"), first, too_deep},
        {"emphasis", times(250, "*a **b ") + times(250, "c** d* "), first, too_deep},
        {"one long mark of emphasis", times(1'000, "*") + "a" + times(1'000, "*"), first, too_deep},
        {"ten thousand links", lines(10'000, [](int) { return "[a](tab:rows)"; }), first + 2'000,
         "a lesson may have at most 2000 links."},
        {"ten thousand footnotes",
         "Text.\n\n" + lines(10'000, [](int i) { return numbered("[^", i, "]: note"); }),
         first + 2 + 99, "a lesson may have at most 99 footnotes."},
        {"ten thousand columns", times(10'000, "|a") + "|\n" + times(10'000, "|-") + "|", first,
         "the line is longer than 4000 bytes."},
        {"ninety columns", times(90, "|a") + "|\n" + times(90, "|---") + "|", first,
         "a table may have at most 40 columns."},
        {"bytes that are no text", "\xff\xfe\xfd", first,
         "the line is not plain UTF-8 text, or contains control characters."},
    };
    // The rest of these can be shown.
    const auto add = [&](const char* about, std::string text, int line, std::string sentence) {
        all.push_back({about, std::move(text), line, std::move(sentence), true});
    };
    add("formulas in formulas", std::string("$") + times(900, "{") + "a" + times(900, "}") + "$",
        first,
        std::string("the formula '") + times(60, "{") + "...' is nested deeper than 12 levels.");
    add("roots of roots", std::string("$") + times(300, "\\sqrt") + " a$", first,
        std::string("the formula '") + times(12, "\\sqrt") +
            "...' is nested deeper than 12 levels.");
    add("powers of powers", std::string("$") + times(900, "a^") + "a$", first,
        std::string("the formula '") + times(30, "a^") +
            "...' has two subscripts or superscripts "
            "in one place.");
    add("parentheses", task("a", times(400, "(") + "1" + times(400, ")")), first + 2,
        "the expression is nested deeper than 32 levels.");
    add("a thousand parentheses", task("a", times(1'000, "(") + "1" + times(1'000, ")")), first + 2,
        "an expression may have at most 1000 bytes.");
    add("signs", task("a", times(900, "-") + "1"), first + 2,
        "the expression is nested deeper than 32 levels.");
    add("no, no, no", task("a", times(240, "not ") + "1"), first + 2,
        "the expression is nested deeper than 32 levels.");
    add("functions of functions", task("a", times(200, "abs(") + "1"), first + 2,
        "the expression is nested deeper than 32 levels.");
    add("65 steps", lines(65, [](int i) { return numbered("## Step ", i, "\n"); }), first + 2 * 64,
        "a lesson may have at most 64 steps.");
    std::string tasks;
    for (int i = 0; i < 101; ++i)
        tasks += task(numbered("a", i, ""), "stage == rows");
    add("101 tasks", tasks, first + 7 * 100,
        "a lesson may have at most 100 tasks, puzzles and "
        "predictions.");
    add("a file outside", "[a](../../../../etc/passwd)", first,
        "the link '../../../../etc/passwd' leads nowhere. Links begin with set: cursor: show: "
        "compare: pixel: triangle: row: vertex: tab: view: overlay: canvas: outside: preset: bug: "
        "term: or name another lesson, NN-name.md.");
    add("a picture outside", "![a](../../../../etc/passwd.png)", first,
        "the picture '../../../../etc/passwd.png' must be a PNG in the lessons folder or in "
        "../screenshots/.");
    // One for each setting; all others are too many.
    const std::string three = "<!-- control\nsetting = \"interpolation\"\n-->\n"
                              "<!-- control\nsetting = \"clip\"\n-->\n"
                              "<!-- control\nsetting = \"cull\"\n-->\n";
    all.push_back({"three thousand controls", three + times(3'000, "<!-- control\n-->\n"),
                   first + 9, "a step may have at most 3 controls.", true});
    for (HostileLesson& lesson : all)
        lesson.text = lesson_head().append(lesson.text);
    return all;
}

std::vector<HostileLesson> tiring_lessons() {
    std::vector<HostileLesson> all;
    for (const char* piece : {"`",   "` ``", "$",    "$a ",    "<",
                              "<a:", "](",   "[a](", "[^",     "[^a]",
                              "!",   "\\",   "*",    "* ",     "_a",
                              "a*b", "||",   "{",    "[a]: b", "&amp;",
                              "> ",  "- ",   "1. ",  "# ",     "<!-- note -->\n"}) {
        HostileLesson lesson;
        lesson.about = piece;
        lesson.text = lesson_head();
        std::string line;
        while (line.size() < 180)
            line += piece;
        while (lesson.text.size() < 900'000)
            lesson.text.append(line).append(lesson.text.size() % 7 == 0 ? "\n\n" : "\n");
        all.push_back(std::move(lesson));
    }
    return all;
}

std::string endless_picture() {
    std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16);
    bytes.append("\0\x01\x86\xa0\0\x01\x86\xa0\x08\x02\0\0\0\0\0\0\0", 17);
    return bytes;
}

} // namespace rasterwalk::test
