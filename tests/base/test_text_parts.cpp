#include "base/text_parts.h"

#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("A text is split at each separator, and nothing is lost") {
    CHECK(split("a,b", ',') == std::vector<std::string_view>{"a", "b"});
    CHECK(split(",a,,", ',') == std::vector<std::string_view>{"", "a", "", ""});
    CHECK(split("", ',') == std::vector<std::string_view>{""});
}

TEST_CASE("Parts are taken off a text until it is empty") {
    std::string_view text = "one\n\ntwo";
    CHECK(take_part(text, '\n') == "one");
    CHECK(text == "\ntwo");
    CHECK(take_part(text, '\n').empty());
    CHECK(take_part(text, '\n') == "two");
    CHECK(text.empty());
    CHECK(take_part(text, '\n').empty());
}

TEST_CASE("Lines end with the mark of Unix or of Windows, and the last may have none") {
    CHECK(split_lines("a\r\n\nb") == std::vector<std::string_view>{"a", "", "b"});
    CHECK(split_lines("a\n") == std::vector<std::string_view>{"a"});
    CHECK(split_lines("").empty());
}
