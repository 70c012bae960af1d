#include "lessons/course_test.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "base/files.h"
#include "base/html.h"
#include "base/quoted.h"
#include "base/toml_input.h"
#include "lessons/choice_order.h"
#include "lessons/lesson_list.h"
#include "session/content.h"

namespace rasterwalk {

namespace {

/// What fits into the sheet.
constexpr std::size_t most_question_letters = 1000, most_answer_letters = 300, most_answers = 8;

TestItem read_item(const TomlInput& input, const std::vector<TestItem>& before) {
    input.allow_only({"id", "lesson", "question", "right", "wrong"});
    if (before.size() >= most_test_items)
        input.fail(fmt::format("The test may have at most {} items.", most_test_items));
    TestItem item{input.text("id"), input.text("lesson"), input.text("question"), {}, {}};
    for (const TestItem& one : before) {
        if (one.id == item.id) input.fail("There are two items " + in_quotes(item.id) + ".");
    }
    item.choices.push_back(input.text("right"));
    for (const toml::node& node : input.list("wrong")) {
        const auto text = node.value<std::string>();
        if (!text || text->empty()) input.fail(node, "A wrong answer must be text.");
        if (std::find(item.choices.begin(), item.choices.end(), *text) != item.choices.end())
            input.fail(node, "There are two answers " + in_quotes(*text) + ".");
        item.choices.push_back(*text);
    }
    for (const std::string& text : item.choices) {
        if (text.size() > most_answer_letters || item.question.size() > most_question_letters)
            input.fail(fmt::format("A question may have at most {} letters, an answer {}.",
                                   most_question_letters, most_answer_letters));
    }
    if (item.choices.size() > most_answers)
        input.fail(fmt::format("An item may have at most {} answers.", most_answers));
    if (item.choices.size() < 2) input.fail("An item needs at least one wrong answer.");
    item.order = shuffled(static_cast<int>(item.choices.size()), "test/" + item.id);
    return item;
}

std::string said_in(const TestAnswers& answers, const TestItem& item) {
    const auto found = answers.find(item.id);
    return found == answers.end() ? std::string() : found->second;
}

/// The answer; a dash if there is none.
/// @param is_marked with a sign for whether it is right
std::string written_answer(const TestAnswers& answers, const TestItem& item, bool is_marked) {
    const std::string said = said_in(answers, item);
    if (said.empty()) return "–";
    if (!is_marked) return said;
    return (said == item.choices.front() ? "✓ " : "✗ ") + said;
}

std::string score_words(const CourseTest& test, const TestAnswers& answers) {
    const TestScore score = score_of_test(test, answers);
    if (score.answered == 0) return "not taken";
    std::string words = fmt::format("{} of {} right", score.right, test.items.size());
    if (score.answered < static_cast<int>(test.items.size()))
        words += fmt::format(", {} answered", score.answered);
    return words;
}

/// Marks before the second sitting would spoil it.
bool shows_marks(const CourseTest& test, const TestAnswers& after) {
    return score_of_test(test, after).answered == static_cast<int>(test.items.size());
}

constexpr std::string_view page_style = R"(<style>
:root { color-scheme: light dark; }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; } th, td { text-align: left; vertical-align: top; padding: 6px 10px;
border-bottom: 1px solid #8888; }
</style>
)";

} // namespace

CourseTest parse_course_test(std::string_view text, const std::string& path) {
    return {parse_tables<TestItem>(text, path, "item", "the test", read_item)};
}

CourseTest read_course_test() {
    const std::string path = lessons_folder() + "/course-test.toml";
    return parse_course_test(read_file(path), path);
}

TestScore score_of_test(const CourseTest& test, const TestAnswers& answers) {
    TestScore score;
    for (const TestItem& item : test.items) {
        const std::string said = said_in(answers, item);
        const auto found = std::find(item.choices.begin(), item.choices.end(), said);
        score.answered += found != item.choices.end() ? 1 : 0;
        score.right += found == item.choices.begin() ? 1 : 0;
    }
    return score;
}

std::string test_page(const CourseTest& test, const TestAnswers& before, const TestAnswers& after,
                      std::string_view name) {
    std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<title>Rasterwalk: the test before and after</title>\n";
    page.append(page_style).append("</head>\n<body>\n<h1>The test before and after</h1>\n");
    if (!name.empty()) page += "<p>" + in_html(name) + "</p>\n";
    page += "<p>Before the lessons: " + score_words(test, before) +
            ".<br>After the lessons: " + score_words(test, after) + ".</p>\n";
    const bool is_marked = shows_marks(test, after);
    page += "<table>\n<tr><th>lesson</th><th>item</th><th>before</th><th>after</th></tr>\n";
    for (const TestItem& item : test.items) {
        page += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                            lesson_number(item.lesson), in_html(item.question),
                            in_html(written_answer(before, item, is_marked)),
                            in_html(written_answer(after, item, is_marked)));
    }
    return page + "</table>\n</body>\n</html>\n";
}

std::string test_text(const CourseTest& test, const TestAnswers& before, const TestAnswers& after,
                      std::string_view name) {
    std::string text = "Rasterwalk: the test before and after\n";
    if (!name.empty()) text.append(name).append("\n");
    text += "Before the lessons: " + score_words(test, before) + ".\n";
    text += "After the lessons: " + score_words(test, after) + ".\n";
    const bool is_marked = shows_marks(test, after);
    for (const TestItem& item : test.items) {
        text += fmt::format("\n{}. {}\n   before: {}\n   after:  {}\n", lesson_number(item.lesson),
                            item.question, written_answer(before, item, is_marked),
                            written_answer(after, item, is_marked));
    }
    return text;
}

} // namespace rasterwalk
