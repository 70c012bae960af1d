#include "lessons/lesson_search.h"

#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Lesson lesson_of(const std::string& id, const std::string& text) {
    return parse_lesson(R"(<!-- lesson
title = "Made for a test"
section = "Drawing edges"
minutes = 10
about = "To be found."
program = "nothing"
-->
)" + text,
                        id + ".md");
}

const std::vector<Lesson>& some_lessons() {
    static const std::vector<Lesson> lessons{
        lesson_of("01-one",
                  "# The *Opening*\n\nA [camera](show:canvas) looks at the room.\n\n"
                  "## Affine light\n\nIt is skewed.\n\n## Else\n\nNothing is affine here.\n"),
        lesson_of("02-two", "# Another\n\nText.\n\n## Questions\n\n"
                            "<!-- task\nid = \"a\"\ndone = \"stage == rows\"\n"
                            "recipe = [\"set:stage=rows\"]\n-->\n> **Task.** Grow a zebra.\n\n"
                            "<!-- prediction\nid = \"b\"\nkind = \"number\"\nanswer = \"5\"\n-->\n"
                            "> **Prediction.** How many giraffes?\n"),
    };
    return lessons;
}

const std::vector<Term> glossary{
    {"affine", "Of straight lines; the wrong way here.", "Perspective"},
    {"1/z", "What the depth buffer keeps.", "Depth"}};

} // namespace

TEST_CASE("A search finds terms, then headings, then texts") {
    const std::vector<SearchHit> hits = search_lessons(some_lessons(), glossary, "AFFINE");
    REQUIRE(hits.size() == 3);
    CHECK(hits[0].lesson.empty());
    CHECK(hits[0].title == "affine");
    CHECK(hits[1].lesson == "01-one");
    CHECK(hits[1].step == 1);
    CHECK(hits[1].title == "Affine light");
    CHECK(hits[2].step == 2);
    CHECK(hits[2].excerpt.find("affine") != std::string::npos);
}

TEST_CASE("All words must be there, in whichever order and case") {
    CHECK(search_lessons(some_lessons(), glossary, "room camera").size() == 1);
    CHECK(search_lessons(some_lessons(), glossary, "  Room   CAMERA ").size() == 1);
    CHECK(search_lessons(some_lessons(), glossary, "room zebra").empty());
    CHECK(search_lessons(some_lessons(), glossary, "").empty());
    CHECK(search_lessons(some_lessons(), glossary, "   ").empty());
    CHECK(search_lessons(some_lessons(), glossary, "1/z").size() == 1);
}

TEST_CASE("Tasks and predictions are searched as well, but not what a link hides") {
    REQUIRE(search_lessons(some_lessons(), glossary, "zebra").size() == 1);
    CHECK(search_lessons(some_lessons(), glossary, "zebra")[0].step == 1);
    CHECK(search_lessons(some_lessons(), glossary, "giraffes").size() == 1);
    CHECK(search_lessons(some_lessons(), glossary, "canvas").empty());
    CHECK(search_lessons(some_lessons(), glossary, "recipe").empty());
}

TEST_CASE("An excerpt is short, and never cut within a letter") {
    std::string text = "# Long\n\n";
    for (int i = 0; i < 200; ++i)
        text += "ππππππππππππππππππππ";
    text += " needle ";
    for (int i = 0; i < 200; ++i)
        text += "−−−−−−−−−−−−−−−−−−−−";
    const std::vector<Lesson> one{lesson_of("01-long", text.substr(0, 1'900) + " needle " +
                                                           text.substr(text.size() - 1'500))};
    const std::vector<SearchHit> hits = search_lessons(one, {}, "needle");
    REQUIRE(hits.size() == 1);
    const std::string& excerpt = hits[0].excerpt;
    CHECK(excerpt.size() < 130);
    CHECK(excerpt.find("needle") != std::string::npos);
    for (std::size_t i = 0; i + 1 < excerpt.size(); ++i) {
        const auto byte = static_cast<unsigned char>(excerpt[i]);
        const auto next = static_cast<unsigned char>(excerpt[i + 1]);
        if (byte >= 0xc0) CHECK((next & 0xc0u) == 0x80u);
    }
    CHECK((static_cast<unsigned char>(excerpt[0]) & 0xc0u) != 0x80u);
}

TEST_CASE("No more is found than can be shown, whatever is asked for") {
    std::string text = "# Many\n\n";
    for (int i = 0; i < 60; ++i)
        text += "## Step\n\nThe same word.\n\n";
    const std::vector<Lesson> many{lesson_of("01-many", text), lesson_of("02-many", text)};
    CHECK(search_lessons(many, {}, "word").size() == most_search_hits);
    CHECK(search_lessons(many, {}, std::string(100'000, 'w')).empty());
    CHECK(search_lessons(many, {}, "\xff\xfe\n\0").empty());
}
