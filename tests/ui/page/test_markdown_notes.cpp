#include "text/markdown_notes.h"

#include "tests/support/catch.h"

namespace rasterwalk {

namespace {

using Notes = std::vector<std::string>;

/// The text after its notes were taken out.
std::string taken(std::string text, Notes* notes = nullptr) {
    Notes all = take_footnotes(text);
    if (notes != nullptr) *notes = std::move(all);
    return text;
}

} // namespace

TEST_CASE("References become links in the order in which they come") {
    Notes notes;
    CHECK(taken("One.[^b] Two.[^a] Again.[^b]\n\n[^a]: The *A*.\n[^b]: The B,\n  in two lines.\n",
                &notes) == "One.[¹](note:1) Two.[²](note:2) Again.[¹](note:1)\n\n\n---\n\n"
                           "1. The B, in two lines.\n2. The *A*.\n");
    CHECK(notes == Notes{"The B, in two lines.", "The *A*."});
}

TEST_CASE("A text without notes stays as it is") {
    for (const char* text : {"", "Plain text.\n", "A [link](set:stage=rows).\n", "[^", "[^a", "[^]",
                             "x[^a] but no note\n", "[^a b]: no id\n"}) {
        INFO(text);
        Notes notes;
        CHECK(taken(text, &notes) == text);
        CHECK(notes.empty());
    }
}

TEST_CASE("Text in code is no reference") {
    const std::string text =
        taken("`[^a]` and [^a].\n\n```\n[^a]\n[^b]: not a note\n```\n\n[^a]: note\n");
    CHECK(text.find("`[^a]` and [¹](note:1).") == 0);
    CHECK(text.find("```\n[^a]\n[^b]: not a note\n```\n") != std::string::npos);
}

TEST_CASE("A note that is not there, or that nothing refers to, makes no link") {
    Notes notes;
    CHECK(taken("One.[^a] Two.[^c]\n\n[^a]: A.\n[^b]: B.\n", &notes) ==
          "One.[¹](note:1) Two.[^c]\n\n\n---\n\n1. A.\n");
    CHECK(notes == Notes{"A."});
    CHECK(taken("None.\n\n[^b]: B.\n") == "None.\n\n");
}

TEST_CASE("A note keeps to its end: an empty line, or a line that is not indented") {
    Notes notes;
    taken("One.[^a]\n\n[^a]: first\n  second\nthird\n", &notes);
    CHECK(notes == Notes{"first second"});
    taken("One.[^a]\n\n[^a]:\n", &notes);
    CHECK(notes == Notes{""});
}

TEST_CASE("The number of notes is limited to two digits") {
    std::string text;
    for (int i = 0; i < 300; ++i)
        text.append("[^n").append(std::to_string(i)).append("] ");
    text += "\n\n";
    for (int i = 0; i < 300; ++i)
        text.append("[^n").append(std::to_string(i)).append("]: note\n");
    Notes notes;
    const std::string result = taken(text, &notes);
    CHECK(notes.size() == most_footnotes);
    CHECK(result.find("[⁹⁹](note:99) [^n99]") != std::string::npos);
}

} // namespace rasterwalk
