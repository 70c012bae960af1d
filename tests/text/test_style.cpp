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

/// "1 one two / 3 three": lines, and a slash where a text ends.
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
    CHECK(program("f(\"name_of_it\", \"in words\");") == "1 {} / in words");
    CHECK(program("int a; // One two\n    // three.\nint b = 4; // Five\n") ==
          "1 one two 2 three / 3 five");
    CHECK(program("f(\"Say \" // not said\n  \"it\");") == "1 say / not said / 2 {}");
    CHECK(program("f(\"Say \"\n  \"it \\\"so\\\", {} times\");") == "1 say 2 it so / {} times");
    CHECK(program("/// @param a the `code` here\n/* and\n this */") ==
          "1 param a the {} here / 2 and 3 this");
    CHECK(program("#include \"no/prose.h\"\nchar c = '\"'; int n = 1'000; auto s = \"yes\";") ==
          "2 {}");
    CHECK(program("char c = '\\''; auto s = R\"x(raw \"text\")x\";") == "1 raw / text");
    CHECK(program("f(\"the value is \"\n  \"shown.\");") == "1 the value is 2 shown");
    CHECK(program("/* if (x) { */ g(\"a b\"); }") == "1 if / x / a b");
    CHECK(program("f(\"{\"); g(\"in words\"); h(\"}\");") == "1 {} / in words / {}");
    CHECK(program("c = '\\x41'; d = '\"'; // Why\n e = 1'000; // One") == "1 why / 2 one");
    CHECK(program("ERROR\"abc\" (x); // After") == "1 {} / after");
    CHECK(program("#define NAME \"in words\"") == "1 in words");
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
    CHECK(page("<!-- task\nid = \"cut\"\nset = 1\n-->\nText") == "2 {} / 5 text");
    CHECK(page("Cut \xE2\x80\nHere") == "1 cut / \x80 2 here");
    CHECK(page("<!-- 5\" wide -->\nAfter it") == "1 wide / 2 after it");
    CHECK(page("Some `code\nover` lines") == "1 some {} 2 {} lines");
    CHECK(page("It is {outline.fan_area} large \xE2\x80\x94 it\xE2\x80\x99s so.") ==
          "1 it is {} large / it's so");
}

TEST_CASE("The prose of data and of scripts") {
    CHECK(listed("# The words\n# of it\n[[a]]\nkey = \"Some text\" # why\n", ProseKind::data) ==
          "1 the words 2 of it / 4 some text / why");
    CHECK(listed("a = 'C:\\'\nb = 'two words'", ProseKind::data) == "1 {} / 2 two words");
    CHECK(listed("#!/bin/bash\nrun \"no prose\"\n  # but this\n", ProseKind::script) ==
          "1 bin / bash / 3 but this");
    CHECK(prose_kind("a/b.cpp") == ProseKind::program);
    CHECK(prose_kind("tests/CMakeLists.txt") == ProseKind::script);
    CHECK(prose_kind("ui/page.js") == ProseKind::program);
    CHECK(prose_kind("tidy.py") == ProseKind::script);
    CHECK_FALSE(prose_kind("picture.png"));
}

TEST_CASE("The time to read hostile text grows with its length alone") {
    for (const std::string part : {"{", "](a", "a`b", "'", "R\"x", "<!--", "\"", "/*", "\\"}) {
        std::string text = "R\"";
        while (text.size() < 1'000'000)
            text += part;
        for (const ProseKind kind :
             {ProseKind::markdown, ProseKind::program, ProseKind::data, ProseKind::script})
            CHECK(prose_of(text, kind).size() <= text.size());
    }
}

TEST_CASE("A phrase that reads as if translated is a fault in each kind of file") {
    // In two parts, or the check would find it here.
    const std::string planted = std::string("Tell") + " a triangle's vertices";
    const auto finds = [](const std::string& text, ProseKind kind, int line) {
        const std::vector<Fault> faults = faults_of(text, kind);
        REQUIRE(faults.size() == 1);
        CHECK(faults.front().line == line);
        CHECK_THAT(faults.front().sentence,
                   ContainsSubstring("\"tell") && ContainsSubstring("prints"));
    };
    finds("\n\n" + planted + ".\n", ProseKind::markdown, 3);
    finds("<!-- step\nabout = \"" + planted + "\"\n-->", ProseKind::markdown, 2);
    finds("add(\"triangle\",\n    \"" + planted + "\");", ProseKind::program, 2);
    const std::string rest = "a triangle's vertices";
    finds("add(\"Say it. Tell \"\n    \"" + rest + "\");", ProseKind::program, 1);
    finds("// Tell\n// " + rest + ".", ProseKind::program, 1);
    finds("a = 1\nb = \"" + planted + "\"", ProseKind::data, 2);
    finds("true\n# " + planted + "\n", ProseKind::script, 2);
    CHECK(faults_of("int tell; a(the);", ProseKind::program).empty());
    CHECK(faults_of("As you will see, tell. A triangle", ProseKind::markdown).empty());
}

TEST_CASE("Phrases match word by word, except where they are meant") {
    const StyleGuide guide = parse_style("meant = ['by sidewise houses']\n[[rule]]\n"
                                         "phrases = ['sidewise', 'cat|dog forgets *']\n"
                                         "advice = 'write askew.'\n",
                                         "a.toml");
    const auto found = [&](std::string_view text) {
        std::string all;
        for (const Fault& fault : style_faults(prose_of(text, ProseKind::markdown), guide))
            all += std::to_string(fault.line) + fault.sentence;
        return all;
    };
    CHECK(found("Go sidewise.") == "1\"sidewise\": write askew.");
    CHECK(found("Live\nby sidewise houses").empty());
    CHECK(found("A dog\nforgets it") == "1\"dog forgets it\": write askew.");
    CHECK(found("A dog. Forgets it").empty());
    CHECK(found("A dog forgets").empty());
}

TEST_CASE("A faulty file of phrases is refused with its line") {
    const auto refused = [](std::string_view text, const std::string& sentence) {
        CHECK_THROWS_WITH(parse_style(text, "a.toml"), ContainsSubstring(sentence));
    };
    refused("meant = []\n[[rule]]\nphrases = ['a  b']\nadvice = 'x'", "a.toml:2");
    refused("meant = []\n[[rule]]\nphrases = ['a B']\nadvice = 'x'", "'a B' has a capital");
    refused("meant = []\n[[rule]]\nphrases = ['a|* b']\nadvice = 'x'", "begins with '*'");
    refused("meant = []\n[[rule]]\nphrases = ['* b']\nadvice = 'x'", "begins with '*'");
    refused("meant = []\n[[rule]]\nphrases = [\n3]\nadvice = 'x'", "a.toml:4");
    refused("meant = []\n[[rule]]\nphrases = ['a']\n", "advice");
    refused("meant = []\n[[rules]]\n", "rules");
    CHECK_THROWS_AS(read_style("/nowhere/style.toml"), AccessError);
}
