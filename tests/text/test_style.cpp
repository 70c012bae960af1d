#include "text/style.h"

#include <string>
#include <vector>

#include "base/error.h"
#include "base/files.h"
#include "session/content.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;

namespace {

/// "1 one two / 3 three": lines, and a stroke where a text ends.
std::string listed(std::string_view text, ProseKind kind) {
    std::string list;
    int line = 0;
    for (const ProseWord& word : prose_of(text, kind)) {
        if (!list.empty()) list += word.follows ? " " : " / ";
        if (word.line != line) list += std::to_string(word.line) + " ";
        line = word.line;
        list += word.text;
    }
    return list;
}

std::vector<Fault> faults_of(std::string_view text, ProseKind kind) {
    return style_faults(prose_of(text, kind), read_style(lessons_folder() + "/style.toml"));
}

} // namespace

TEST_CASE("A program's prose is its comments and strings") {
    const auto program = [](std::string_view text) { return listed(text, ProseKind::program); };
    CHECK(program("int a; // One two\n    // three.\nint b = 4; // Five\n") ==
          "1 one two 2 three / 3 five");
    CHECK(program("f(\"Say \" // not said\n  \"it\");") == "1 say / not said / 2 it");
    CHECK(program("f(\"Say \"\n  \"it \\\"so\\\", {} times\");") == "1 say 2 it so / {} times");
    CHECK(program("/// @param a the `code` here\n/* and\n this */") ==
          "1 param a the {} here / 2 and 3 this");
    CHECK(program("#include \"no/prose.h\"\nchar c = '\"'; int n = 1'000; auto s = \"yes\";") ==
          "2 yes");
    CHECK(program("char c = '\\''; auto s = R\"x(raw \"text\")x\";") == "1 raw / text");
    CHECK(program("auto s = \"never closed\n int a;") == "1 never closed");
    CHECK(program("R\"").empty());
    CHECK(program("'").empty());
}

TEST_CASE("A page's prose is its text, and the strings of its comments") {
    const auto page = [](std::string_view text) { return listed(text, ProseKind::markdown); };
    CHECK(page("# Title\n\nThe *first* [link](file.md#a), and `code`.\n") ==
          "1 title / 3 the first link / and {}");
    CHECK(page("One line\ngoes on.\n\nNext") == "1 one line 2 goes on / 4 next");
    CHECK(page("Text.\n```cpp\nint code;\n```\nMore.") == "1 text / 5 more");
    CHECK(page("<!-- task\nid = \"cut\"\nset = 1\n-->\nText") == "2 cut / 5 text");
    CHECK(page("It is {outline.fan_area} large \xE2\x80\x94 it\xE2\x80\x99s so.") ==
          "1 it is {} large / it's so");
}

TEST_CASE("The prose of data and of scripts") {
    CHECK(listed("# The words\n# of it\n[[a]]\nkey = \"Some text\" # why\n", ProseKind::data) ==
          "1 the words 2 of it / 4 some text / why");
    CHECK(listed("#!/bin/bash\nrun \"no prose\"\n  # but this\n", ProseKind::script) ==
          "1 bin / bash / 3 but this");
    CHECK(prose_kind("a/b.cpp") == ProseKind::program);
    CHECK(prose_kind("tests/CMakeLists.txt") == ProseKind::script);
    CHECK_FALSE(prose_kind("picture.png"));
}

TEST_CASE("A phrase that reads as if translated is a fault in each kind of file") {
    const auto is_told = [](const std::vector<Fault>& faults, int line) {
        REQUIRE(faults.size() == 1);
        CHECK(faults.front().line == line);
        CHECK_THAT(faults.front().sentence,
                   ContainsSubstring("tell a") && ContainsSubstring("print"));
    };
    is_told(faults_of("\n\nTell a triangle's vertices.\n", ProseKind::markdown), 3);
    is_told(
        faults_of("add(\"triangle\",\n    \"Tell a triangle's vertices\");", ProseKind::program),
        2);
    is_told(faults_of("add(\"Tell \"\n    \"a triangle's vertices\");", ProseKind::program), 1);
    is_told(faults_of("/// Tell\n/// a triangle's vertices.", ProseKind::program), 1);
    is_told(faults_of("a = 1\nb = \"Tell a triangle's vertices\"", ProseKind::data), 2);
    is_told(faults_of("true\n# Tell a triangle's vertices\n", ProseKind::script), 2);
    CHECK(faults_of("int tell; a(the);", ProseKind::program).empty());
    CHECK(faults_of("As you will see, tell. A triangle", ProseKind::markdown).empty());
}

TEST_CASE("Words of a phrase, and what is meant as it stands") {
    const StyleGuide style = parse_style("meant = ['by half-way houses']\n[[rule]]\n"
                                    "phrases = ['half-way', 'who|whoever forgets *']\n"
                                    "advice = 'write halfway.'\n",
                                    "a.toml");
    const auto found = [&](std::string_view text) {
        std::string all;
        for (const Fault& fault : style_faults(prose_of(text, ProseKind::markdown), style))
            all += std::to_string(fault.line) + fault.sentence;
        return all;
    };
    CHECK(found("Go half-way.") == "1\"half-way\": write halfway.");
    CHECK(found("Live\nby half-way houses") == "");
    CHECK(found("Whoever\nforgets it") == "1\"whoever forgets it\": write halfway.");
    CHECK(found("Whoever. Forgets it") == "");
    CHECK(found("whoever forgets").empty());
}

TEST_CASE("A file of phrases that is wrong is refused at its line") {
    const auto refused = [](std::string_view text, const std::string& sentence) {
        CHECK_THROWS_WITH(parse_style(text, "a.toml"), ContainsSubstring(sentence));
    };
    refused("meant = []\n[[rule]]\nphrases = ['a  b']\nadvice = 'x'", "a.toml:2");
    refused("meant = []\n[[rule]]\nphrases = ['* b']\nadvice = 'x'", "begins with any word");
    refused("meant = []\n[[rule]]\nphrases = [\n3]\nadvice = 'x'", "a.toml:4");
    refused("meant = []\n[[rule]]\nphrases = ['a']\n", "advice");
    refused("meant = []\n[[rules]]\n", "rules");
    CHECK_THROWS_AS(read_style("/nowhere/style.toml"), AccessError);
}
