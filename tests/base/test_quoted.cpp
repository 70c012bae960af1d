#include "base/quoted.h"

#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("Bytes that a terminal would obey are shown as escapes") {
    CHECK(visible("\x1b[31mred\x1b]0;title\x07") == "\\u001b[31mred\\u001b]0;title\\u0007");
    CHECK(visible(std::string("\0\x01\x1f\x7f", 4)) == "\\u0000\\u0001\\u001f\\u007f");
    CHECK(visible("\r\b\v\f") == "\\u000d\\u0008\\u000b\\u000c");
    // C1, as UTF-8 and as bytes.
    CHECK(visible("\u0080\u009b31m\u009f") == "\\u0080\\u009b31m\\u009f");
    CHECK(visible("\x9b"
                  "31m") == "\\x9b31m");
    for (const char* const turn : {"\u061c", "\u200e", "\u200f", "\u202a", "\u202e", "\u2066",
                                   "\u2069", "\u2028", "\u2029", "\ufeff"}) {
        CHECK(visible(turn).starts_with("\\u"));
    }
    CHECK(visible("cut \xe2\x82") == "cut \\xe2\\x82");
    CHECK(visible("\xc0\x9b \xed\xa0\x80") == "\\xc0\\x9b \\xed\\xa0\\x80");
}

TEST_CASE("All other text stays as it is") {
    for (const std::string text :
         {"", "a\n\tb", "z = −3.001 · π ≤ é 日本 🙂", "\u00a0\u200d"}) {
        CHECK(visible(text) == text);
        CHECK(is_utf8(text));
    }
    CHECK(visible_line("a\nb\tc") == "a\\u000ab\tc");
    CHECK_FALSE(is_utf8("\x9b"));
}

TEST_CASE("A name in quotes is short, visible and on one line") {
    CHECK(in_quotes("a\nb\x1b[0m") == "'a b\\u001b[0m'");
    CHECK(in_quotes(std::string(100, 'x')) == "'" + std::string(60, 'x') + "...'");
}
