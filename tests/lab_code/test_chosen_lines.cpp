// Lines between #if and #endif, as a compiler's preprocessor chooses them.

#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "lab_code/chosen_lines.h"
#include "tests/support/catch.h"

namespace rasterwalk::test {

namespace {

using Lines = std::vector<std::string>;

/// "odd" is a mistake.
std::vector<ChosenLine> chosen(const std::string& text, const std::set<std::string>& words) {
    std::vector<ChosenLine> lines, right;
    const auto holds = [&](std::string_view word) { return words.count(std::string(word)) > 0; };
    choose_lines(text, "made.cpp", 3, holds, lines);
    choose_lines(
        text, "made.cpp", 3, [&](std::string_view word) { return word != "odd" && holds(word); },
        right);
    mark_mistakes(lines, right);
    return lines;
}

std::string joined(const std::vector<ChosenLine>& lines) {
    std::string text;
    for (const ChosenLine& line : lines)
        text += line.text + "\n";
    return text;
}

std::string fault_of(const std::string& text) {
    try {
        chosen(text, {});
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

} // namespace

TEST_CASE("Lines are chosen by words") {
    const std::string text = "a\n#if one\nb\n#elif two\nc\n#else\nd\n#endif\ne\n";
    CHECK(joined(chosen(text, {"one"})) == "a\nb\ne\n");
    CHECK(joined(chosen(text, {"two"})) == "a\nc\ne\n");
    CHECK(joined(chosen(text, {"one", "two"})) == "a\nb\ne\n");
    CHECK(joined(chosen(text, {})) == "a\nd\ne\n");
    const std::string within =
        "#if one\n#if two\nb\n#endif\nc\n#else\n#if two\nd\n#endif\n#endif\n";
    CHECK(joined(chosen(within, {"one"})) == "c\n");
    CHECK(joined(chosen(within, {"two"})) == "d\n");
    CHECK(joined(chosen(within, {"one", "two"})) == "b\nc\n");
}

TEST_CASE("Conditions are worked out as C++ does") {
    const auto holds = [](const std::string& condition, const std::set<std::string>& words) {
        return !chosen("#if " + condition + "\nx\n#endif\n", words).empty();
    };
    for (int set = 0; set < 8; ++set) {
        const bool a = (set & 1) != 0, b = (set & 2) != 0, c = (set & 4) != 0;
        std::set<std::string> words;
        if (a) words.insert("a");
        if (b) words.insert("b");
        if (c) words.insert("c");
        CHECK(holds("a && b || c", words) == ((a && b) || c));
        CHECK(holds("a || b && c", words) == (a || (b && c)));
        CHECK(holds("!(a || b) && !c", words) == (!(a || b) && !c));
        CHECK(holds("!!a", words) == a);
    }
}

TEST_CASE("A line knows its file and its number, and the usual one in its place") {
    const auto lines = chosen("a\n#if odd\nb\n#else\nc\n#endif\n", {"odd"});
    REQUIRE(lines.size() == 2);
    CHECK(lines[1].file == 3);
    CHECK(lines[1].line == 3);
    CHECK(lines[1].text == "b");
    CHECK(lines[1].usual == Lines{"c"});
    CHECK(lines[0].usual.empty());
    CHECK(chosen("a\n#if odd\nb\n#else\nc\n#endif\n", {})[1].usual.empty());
    // What is just another way is no mistake.
    CHECK(chosen("#if even\nb\n#else\nc\n#endif\n", {"even"})[0].usual.empty());
    CHECK(chosen("#if !odd\nb\n#else\nc\n#endif\n", {})[0].usual.empty());
    // Parts of different lengths: the last line of the mistake knows all right ones.
    const auto longer = chosen("#if odd\nb\nd\n#else\nc\n#endif\n", {"odd"});
    CHECK(longer[0].is_mistake);
    CHECK(longer[0].usual.empty());
    CHECK(longer[1].usual == Lines{"c"});
    const auto shorter = chosen("#if odd\nb\n#else\nb\nc\nd\n#endif\n", {"odd"});
    CHECK(shorter[0].usual == Lines{"c", "d"});
    CHECK(joined(chosen("#if odd\nb\nd\n#else\nd\n#endif\n", {"odd"})) == "b\nd\n");
    CHECK_FALSE(chosen("#if odd\nb\nd\n#else\nd\n#endif\n", {"odd"})[1].is_mistake);
}

TEST_CASE("A line that only a mistake has is known as one") {
    CHECK(chosen("#if odd\na\n#endif\n", {"odd"})[0].is_mistake);
    CHECK(chosen("#if odd && even\na\n#endif\n", {"odd", "even"})[0].is_mistake);
    CHECK_FALSE(chosen("#if even\na\n#endif\n", {"even"})[0].is_mistake);
    // It could be there without it.
    CHECK_FALSE(chosen("#if odd || even\na\n#endif\n", {"odd", "even"})[0].is_mistake);
    CHECK_FALSE(chosen("#if !odd\na\n#endif\n", {})[0].is_mistake);
    // What a mistake leaves out is missing behind a line.
    const auto shorter = chosen("a\n#if !odd\nb\n#endif\nc\n", {"odd"});
    CHECK_FALSE(shorter[0].is_mistake);
    CHECK(shorter[0].usual == Lines{"b"});
    CHECK(shorter[1].usual.empty());
    // Helpers are not what is wrong.
    CHECK_FALSE(chosen("#if odd\na\nb\nc\n#endif\n", {"odd"})[0].is_mistake);
}

TEST_CASE("The right line may depend on other words") {
    const std::string text = "#if odd\na\n#elif even\nb\n#else\n#if two\nc\n#elif three\nd\n#else\n"
                             "e\n#endif\n#endif\n";
    CHECK(chosen(text, {"odd"})[0].usual == Lines{"e"});
    CHECK(chosen(text, {"odd", "two"})[0].usual == Lines{"c"});
    CHECK(chosen(text, {"odd", "three"})[0].usual == Lines{"d"});
    CHECK(chosen(text, {"odd", "two", "three"})[0].usual == Lines{"c"});
    CHECK(joined(chosen(text, {"odd", "two"})) == "a\n");
    CHECK(joined(chosen(text, {"two"})) == "c\n");
    CHECK(chosen(text, {"two"})[0].usual.empty());
    CHECK(chosen(text, {"even", "two"})[0].usual.empty());
    // Two words, one within the right lines of the other.
    const std::string both = "#if odd\na\n#else\n#if two\nb\n#else\nc\n#endif\n#endif\n";
    CHECK(chosen(both, {"odd"})[0].usual == Lines{"c"});
    CHECK(chosen(both, {"odd", "two"})[0].usual == Lines{"b"});
    // What is chosen only within lines that are not is no right line.
    CHECK(chosen("#if odd\na\n#else\n#if two\n#if three\nb\n#endif\n#endif\nc\n#endif\n",
                 {"odd", "three"})[0]
              .usual == Lines{"c"});
}

TEST_CASE("What is not a condition is refused with its line") {
    CHECK(fault_of("a\n#if\n") == "made.cpp:2: Only #if, #elif, #else and #endif are understood.");
    CHECK(fault_of("#include <x>\n") ==
          "made.cpp:1: Only #if, #elif, #else and #endif are understood.");
    CHECK(fault_of("#if a\nb\n") == "made.cpp:1: This #if has no #endif.");
    CHECK(fault_of("#endif\n") == "made.cpp:1: There is no #if before this.");
    CHECK(fault_of("#else\n") == "made.cpp:1: There is no #if before this.");
    CHECK(fault_of("#if a\n#else\n#else\n#endif\n") ==
          "made.cpp:3: #else is the last part of an #if.");
    for (const char* wrong : {"a &", "a b", "(a", "a)", "&& a", "a == b", "!", "()"})
        CHECK(fault_of(std::string("#if ") + wrong + "\n#endif\n") ==
              "made.cpp:1: A condition has words, !, &&, || and parentheses.");
    CHECK(fault_of("#if " + std::string(5000, '(') + "\n#endif\n") ==
          "made.cpp:1: A condition has words, !, &&, || and parentheses.");
}

} // namespace rasterwalk::test
