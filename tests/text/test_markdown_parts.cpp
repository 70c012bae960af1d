#include "text/markdown.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <sstream>

#include "base/files.h"
#include "lessons/lesson.h"
#include "session/content.h"
#include "support/random.h"
#include "tests/support/catch.h"
#include "text/markdown_notes.h"

namespace rasterwalk {

namespace {

using PartKind = MarkdownPart::Kind;

constexpr int deepest = 24;

/// "2 link tab:rows (the rows)" and so on, a line for each part.
std::string parts_of(std::string_view text) {
    constexpr const char* names[] = {"link",    "picture",      "formula", "footnote",
                                     "address", "split_target", "comment", "definition",
                                     "table",   "nesting"};
    std::ostringstream all;
    for (const MarkdownPart& part : parse_as_written(text, deepest).parts) {
        all << part.line << ' ' << names[static_cast<std::size_t>(part.kind)];
        if (!part.text.empty()) all << ' ' << part.text;
        if (!part.words.empty()) all << " (" << part.words << ')';
        if (part.columns > 0) all << ' ' << part.columns;
        all << '\n';
    }
    return all.str();
}

std::string repeated(std::string_view text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i)
        result += text;
    return result;
}

} // namespace

TEST_CASE("Every link, picture, formula and footnote is found, with its line") {
    CHECK(parts_of("One [*a* `b`](tab:rows) and [two](x.md).\n"
                   "\n"
                   "- ![a view](room.png)\n"
                   "  and $a\n"
                   "  < b$.[^note]\n"
                   "\n"
                   "> [words over\n"
                   "> two lines](pixel:1,2)[](set:a=b) [![p](q.png)](r.md) **$c$**\n"
                   "\n"
                   "$$\n"
                   "\\frac{1}{z}\n"
                   "$$\n"
                   "\n"
                   "| [a](b) | $d$ |\n"
                   "|--------|-----|\n"
                   "| c      | [^d] |\n") == "0 link tab:rows (a b)\n"
                                             "0 link x.md (two)\n"
                                             "2 picture room.png (a view)\n"
                                             "3 formula a < b\n"
                                             "4 footnote note\n"
                                             "7 link pixel:1,2 (words over\ntwo lines)\n"
                                             "7 link set:a=b\n"
                                             "7 picture q.png (p)\n"
                                             "7 link r.md (p)\n"
                                             "7 formula c\n"
                                             "9 formula \\frac{1}{z}\n"
                                             "13 table 2\n"
                                             "13 link b (a)\n"
                                             "13 formula d\n"
                                             "15 footnote d\n");
}

TEST_CASE("Text in code or after a backslash is not a part") {
    CHECK(parts_of("`[a](b) $c$ [^d] <!--` \\[a](b) \\$c$ \\[^d] \\<!--\n"
                   "\n"
                   "```\n"
                   "[a](b) $c$ [^d] <!--\n"
                   "[a]: b\n"
                   "```\n"
                   "\n"
                   "    [a](b)\n")
              .empty());
}

TEST_CASE("Markup that would be drawn as text, or not at all, is reported") {
    CHECK(parts_of("a <!-- b --> <https://example.org/> <a b> [c](d e) [f] (g h)\n") ==
          "0 comment\n0 address <https://example.org/>\n0 split_target d e\n");
    CHECK(parts_of("[a]\n\n[a]: b\n> [c]: d\n") == "0 link b (a)\n2 definition\n3 definition\n");
    CHECK(parts_of("[a]: two words, so it is text\n").empty());
    CHECK(parts_of("Words.\n\n| | |\n|---|---|\n| a | b |\n") == "2 table 2\n");
}

TEST_CASE("Only parts drawn inside each other are nested") {
    CHECK(parts_of("a\n" + repeated("*a **b ", 20) + repeated("c** d* ", 20)) == "1 nesting\n");
    CHECK(parts_of(repeated("*a **b ", 500)).empty());
    CHECK(parts_of("a\n\n" + repeated("[", 30)) == "2 nesting\n");
    CHECK(parse_as_written(repeated("> ", deepest) + "a", deepest).fault.empty());
    const MarkdownDocument deep =
        parse_as_written("a\n\n---\n\n" + repeated("> ", deepest + 1) + "a", deepest);
    CHECK(deep.fault == "The text is nested deeper than 24 levels.");
    CHECK(deep.fault_line == 4);
    CHECK(parse_as_written("a\n\n" + repeated("> ", 30), deepest).fault_line == 2);
}

TEST_CASE("Texts that would keep the parser busy are refused with a sentence") {
    CHECK(parse_as_written(std::string(largest_markdown + 1, 'a'), deepest).fault ==
          "The text is longer than 1 MB.");
    CHECK(parse_as_written(repeated("[a](\n", 200'000), deepest).fault ==
          "A paragraph has too many lines and brackets.");
    const std::string targets =
        "[a]: /" + std::string(400'000, 'u') + "\n\nb\n" + repeated("[a] ", 100'000);
    CHECK(parse_as_written(targets, deepest).fault_line == 3);
}

TEST_CASE("Random marks give the links that are drawn, on lines of the text") {
    const std::string_view marks[] = {
        "*", "_",   "`",    "[",   "](",   ")",          "|",     "\n",       "\n\n",   "> ",
        "-", "1.",  "    ", "#",   "&",    "\\",         "```\n", "x ",       "$",      "![",
        "<", "<a:", "<!--", "[^a", "\xC3", "<http://x>", "[a]",   "[a]: b\n", "](c d)", "](<e f>)"};
    test::Random random(3);
    std::size_t count = 0;
    for (int round = 0; round < 2000; ++round) {
        std::string text;
        for (int i = random.integer(1, 60); i > 0; --i)
            text += marks[static_cast<std::size_t>(
                random.integer(0, static_cast<int>(std::size(marks)) - 1))];
        INFO(text);
        // Footnotes are not drawn where they are written.
        std::string without_notes = text;
        take_footnotes(without_notes);
        if (without_notes != text) continue;
        const MarkdownDocument found = parse_as_written(text, deepest_markdown);
        if (!found.fault.empty()) continue;
        std::size_t links = 0;
        for (const MarkdownPart& part : found.parts) {
            if (part.kind == PartKind::link || part.kind == PartKind::address) ++links;
            CHECK(part.line >= 0);
            CHECK(part.line <= std::count(text.begin(), text.end(), '\n'));
        }
        CHECK(links == parse_markdown(text).links.size());
        count += links;
    }
    CHECK(count > 100);
}

TEST_CASE("The links that are checked are the links that are drawn") {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(lessons_folder())) {
        if (entry.path().extension() != ".md") continue;
        INFO(entry.path().filename().string());
        for (const LessonStep& step : read_lesson(entry.path().string()).steps) {
            for (const LessonPart& part : step.parts) {
                std::vector<std::string> checked;
                for (const MarkdownPart& found : parse_as_written(part.text, deepest).parts) {
                    if (found.kind == PartKind::link) checked.push_back(found.text);
                }
                CHECK(checked == parse_markdown(part.text).links);
                count += checked.size();
            }
        }
    }
    CHECK(count > 50);
}

} // namespace rasterwalk
