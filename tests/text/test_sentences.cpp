#include "text/sentences.h"

#include <algorithm>
#include <cctype>

#include "lessons/lesson_list.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "text/markdown.h"

namespace rasterwalk {

using Sentences = std::vector<std::string>;

TEST_CASE("The first paragraph is cut into its sentences") {
    CHECK(leading_sentences("One. Two, 3.5 of it! Three?\n\nFour.") ==
          Sentences{"One.", "Two, 3.5 of it!", "Three?"});
    CHECK(leading_sentences("It goes on\nbelow. And ends") ==
          Sentences{"It goes on\nbelow.", "And ends"});
    CHECK(leading_sentences("He said \"No.\" Then (so it is.) More.") ==
          Sentences{"He said \"No.\"", "Then (so it is.)", "More."});
}

TEST_CASE("A sentence does not end in code, formulas, links or emphasis") {
    CHECK(leading_sentences("See `a. b` and $x. y$. Next.") ==
          Sentences{"See `a. b` and $x. y$.", "Next."});
    CHECK(leading_sentences("See [one. two](set:a=1). Next.") ==
          Sentences{"See [one. two](set:a=1).", "Next."});
    CHECK(leading_sentences("**Look. Here.** Next.") == Sentences{"**Look. Here.**", "Next."});
    CHECK(leading_sentences("A note.[^1] Next.") == Sentences{"A note.", "Next."});
}

TEST_CASE("A full stop that is a key or within a sentence does not end it") {
    CHECK(leading_sentences("Press `.` and watch it. Then `.`, and read.") ==
          Sentences{"Press `.` and watch it.", "Then `.`, and read."});
    CHECK(leading_sentences("Numbers, e.g. these. More.") ==
          Sentences{"Numbers, e.g. these.", "More."});
    CHECK(leading_sentences("Press `.`. More.") == Sentences{"Press `.`.", "More."});
}

TEST_CASE("An unfinished sentence stays with its continuation") {
    const std::vector<ReadingPiece> pieces =
        reading_pieces("One. So it gives\n\n```\na\n```\n\nEnd.");
    REQUIRE(pieces.size() == 3);
    CHECK(pieces[1].text == "So it gives\n\n```\na\n```");
}

TEST_CASE("Anything but running text is skipped") {
    CHECK(leading_sentences("# Title\n\n```cpp\na. b\n\nc\n```\n\n- item. item\n  more.\n\n"
                            "1. first\n\n![words](a.png)\n\nHere. It begins.") ==
          Sentences{"Here.", "It begins."});
    CHECK(leading_sentences("").empty());
    CHECK(leading_sentences("# Only a title\n").empty());
    CHECK(leading_sentences("```\nnever closed. Really").empty());
    CHECK(leading_sentences("[^").size() <= 1);
    CHECK(leading_sentences("*`[$ . . .").size() <= 1);
}

TEST_CASE("A text is read in pieces: sentences, items of lists, and blocks as they are") {
    const std::string text =
        "One. Two:[^1]\n\n- first\n  goes on\n- second\n\nCode:\n\n```\na\n\nb\n"
        "```\n\n> **Box**\n>\n> - in it\n\n[^1]: A note.\n";
    std::vector<std::string> texts;
    std::string starts;
    for (const ReadingPiece& piece : reading_pieces(text)) {
        texts.push_back(piece.text);
        starts += piece.is_first ? '1' : '0';
    }
    CHECK(texts == Sentences{"One.", "Two:", "- first\n  goes on", "- second",
                             "Code:\n\n```\na\n\nb\n```", "> **Box**\n>\n> - in it"});
    CHECK(starts == "101011");
    CHECK(reading_pieces("").empty());
}

TEST_CASE("A text is cut at its first table, which keeps its head") {
    const CutTable cut =
        cut_table("In this order:\n\n| a | b |\n|---|---|\n| 1 | 2 |\n| 3 | 4 |\n\nAnd on.");
    CHECK(cut.before == "In this order:\n");
    CHECK(cut.head == "| a | b |\n|---|---|");
    CHECK(cut.rows == std::vector<std::string>{"| 1 | 2 |", "| 3 | 4 |"});
    CHECK(cut.after == "And on.");
    CHECK(cut_table("No table.").rows.empty());
    CHECK(cut_table("```\n| a |\n|---|\n| 1 |\n```").rows.empty());
    CHECK(cut_table("| a |").rows.empty());
    CHECK(cut_table("").before.empty());
}

TEST_CASE("No word of a lesson is lost when it is cut into pieces") {
    LessonList lessons;
    lessons.read_folder(lessons_folder());
    for (const Lesson& lesson : lessons.all()) {
        for (const LessonStep& step : lesson.steps) {
            for (const LessonPart& part : step.parts) {
                if (part.kind != LessonPart::Kind::text) continue;
                INFO(lesson.id << ": " << part.text);
                std::string pieces;
                for (const ReadingPiece& piece : reading_pieces(part.text)) {
                    // Each begins a sentence rather than continuing one; "f" is a name.
                    const std::string first = piece.text.substr(0, piece.text.find(' '));
                    const auto letter = static_cast<unsigned char>(first.front());
                    CHECK((first.size() == 1 || std::islower(letter) == 0));
                    pieces += piece.text;
                }
                // Letters only, because blanks are put between pieces and notes are left out.
                const auto letters = [](const std::string& words) {
                    return std::count_if(words.begin(), words.end(),
                                         [](unsigned char c) { return std::isalpha(c) != 0; });
                };
                CHECK(letters(pieces) == letters(part.text));
            }
        }
    }
}

TEST_CASE("Every step of every lesson has a sentence that stands for it, with complete marks") {
    LessonList lessons;
    lessons.read_folder(lessons_folder());
    int steps = 0;
    for (const Lesson& lesson : lessons.all()) {
        for (const LessonStep& step : lesson.steps) {
            INFO(lesson.id << ": " << step.heading);
            ++steps;
            Sentences sentences;
            for (const LessonPart& part : step.parts) {
                if (part.kind == LessonPart::Kind::text && sentences.empty()) {
                    sentences = leading_sentences(part.text);
                }
            }
            REQUIRE_FALSE(sentences.empty());
            // Read alone, it is running text without a mark that was torn apart.
            const MarkdownDocument document = parse_markdown(sentences[0]);
            REQUIRE(document.blocks.size() == 1);
            CHECK(document.blocks[0].kind == MarkdownBlock::Kind::paragraph);
            for (const MarkdownRun& run : document.blocks[0].runs) {
                if (run.code) continue;
                CHECK(run.text.find_first_of("*`[]") == run.text.npos);
            }
        }
    }
    CHECK(steps > 60);
}

} // namespace rasterwalk
