#include "text/sentences.h"

#include <cctype>
#include <string>
#include <string_view>

#include "lessons/lesson_list.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "text/markdown_text.h"

namespace rasterwalk {

namespace {

using Sentences = std::vector<std::string>;

/// What is read of each piece of a text.
Sentences sentences_of(std::string_view markdown) {
    Sentences sentences;
    for (const ReadingPiece& piece : reading_pieces(parse_markdown(markdown)))
        sentences.push_back(plain_text(piece.page.blocks));
    return sentences;
}

} // namespace

TEST_CASE("A paragraph is cut into its sentences") {
    CHECK(sentences_of("One. Two, 3.5 of it! Three?") ==
          Sentences{"One.", "Two, 3.5 of it!", "Three?"});
    CHECK(sentences_of("It goes on\nbelow. And ends") ==
          Sentences{"It goes on below.", "And ends"});
    CHECK(sentences_of("He said \"No.\" Then (so it is.) More.") ==
          Sentences{"He said \"No.\"", "Then (so it is.)", "More."});
}

TEST_CASE("A sentence does not end in code, formulas, links or emphasis") {
    CHECK(sentences_of("See `a. b` and $x. y$. Next.") == Sentences{"See a. b and x.y.", "Next."});
    CHECK(sentences_of("See [One. Two](set:a=1). Next.") == Sentences{"See One. Two.", "Next."});
    CHECK(sentences_of("**Look. Here.** Next.") == Sentences{"Look. Here.", "Next."});
    CHECK(sentences_of("A note.[^1] Next.\n\n[^1]: Not read.") == Sentences{"A note.", "Next."});
}

TEST_CASE("A full stop that is a key or within a sentence does not end it") {
    CHECK(sentences_of("Press `.` and watch it. Then `.`, and read.") ==
          Sentences{"Press . and watch it.", "Then ., and read."});
    CHECK(sentences_of("Numbers, e.g. these. More.") == Sentences{"Numbers, e.g. these.", "More."});
    CHECK(sentences_of("Press `.`. More.") == Sentences{"Press ..", "More."});
}

TEST_CASE("An unfinished sentence stays with its continuation") {
    const std::vector<ReadingPiece> pieces =
        reading_pieces(parse_markdown("One. So it gives\n\n```\na\n```\n\nEnd."));
    REQUIRE(pieces.size() == 3);
    CHECK(pieces[1].page.blocks.size() == 2);
}

TEST_CASE("A text is read in pieces: sentences, items of lists, and blocks as they are") {
    const std::string text =
        "One. Two:[^1]\n\n3. first\n   goes on\n4. second\n\nCode:\n\n```\na\n\nb\n"
        "```\n\n> **Box**\n>\n> - in it\n\n[^1]: A note.\n";
    CHECK(sentences_of(text) ==
          Sentences{"One.", "Two:", "first goes on", "second", "Code: a b", "Box in it"});
    const std::vector<ReadingPiece> pieces = reading_pieces(parse_markdown(text));
    CHECK(pieces[3].page.blocks[0].start == 4);
    std::string starts;
    for (const ReadingPiece& piece : pieces)
        starts += piece.is_first ? '1' : '0';
    CHECK(starts == "101011");
    CHECK(reading_pieces({}).empty());
}

TEST_CASE("Pieces that continue each other are the text again, with its styles") {
    const MarkdownDocument page = parse_markdown("One *two.* Three [four](set:a=1). Five.");
    const std::vector<ReadingPiece> pieces = reading_pieces(page);
    REQUIRE(pieces.size() == 3);
    const MarkdownDocument again =
        continued(continued(pieces[0].page, pieces[1].page), pieces[2].page);
    CHECK(again.blocks == page.blocks);
    CHECK(again.links == page.links);
    const MarkdownDocument list = parse_markdown("- one\n- two");
    const std::vector<ReadingPiece> items = reading_pieces(list);
    REQUIRE(items.size() == 2);
    CHECK(continued(items[0].page, items[1].page).blocks == list.blocks);
}

TEST_CASE("Plain text is what a reader sees") {
    const auto plain = [](std::string_view text) {
        return plain_text(parse_markdown(text).blocks);
    };
    CHECK(plain("**Strong** and *slanted*, `code`, [a link](set:stage=rows).") ==
          "Strong and slanted, code, a link.");
    CHECK(plain("> **Label**\n>\n> a quote\n> of two lines\n\n- an item") ==
          "Label a quote of two lines an item");
    CHECK(plain("| a | b |\n|---|---|\n| 1 | $2$ |\n\n$$\\frac{x}{y}$$") == "a b 1 2 x/y");
    CHECK(plain("").empty());
}

TEST_CASE("No word of a lesson is lost when it is cut into pieces") {
    LessonList lessons;
    lessons.read_folder(lessons_folder());
    int steps = 0;
    for (const Lesson& lesson : lessons.all()) {
        for (const LessonStep& step : lesson.steps) {
            INFO(lesson.id << ": " << step.heading);
            ++steps;
            bool has_text = false;
            for (const LessonPart& part : step.parts) {
                if (part.kind != LessonPart::Kind::text) continue;
                has_text = true;
                INFO(part.text);
                std::string pieces;
                for (const ReadingPiece& piece : reading_pieces(parse_markdown(part.text))) {
                    const std::string text = plain_text(piece.page.blocks);
                    pieces += (pieces.empty() ? "" : " ") + text;
                    // Each begins a sentence rather than continuing one; "f" is a name.
                    const MarkdownBlock& block = piece.page.blocks.front();
                    const bool is_word = block.kind == MarkdownBlock::Kind::paragraph &&
                                         has_same_style(block.runs.front(), {}) &&
                                         text.find(' ') != 1;
                    CHECK_FALSE(
                        (is_word && std::islower(static_cast<unsigned char>(text[0])) != 0));
                }
                CHECK(pieces == plain_text(parse_markdown(part.text).blocks));
            }
            CHECK(has_text);
        }
    }
    CHECK(steps > 60);
}

} // namespace rasterwalk
