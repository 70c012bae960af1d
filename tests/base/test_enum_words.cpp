#include "base/enum_words.h"

#include <cstdint>
#include <string>

#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

enum class Pair : std::uint8_t { one, two };
enum class Single : std::uint8_t { ndc_32 };

int answer() {
    return 42;
}

} // namespace

TEST_CASE("The words of an enum are the names of its values, in their order") {
    CHECK(word_of(Pair::one) == "one");
    CHECK(word_of(Pair::two) == "two");
    CHECK(enum_words<Pair>.size() == 2);
    CHECK(enum_words<Single>.size() == 1);
    CHECK(word_of(Single::ndc_32) == "ndc_32");
}

TEST_CASE("A word is a text that ends with 0") {
    CHECK(std::string(enum_words<Pair>[0].data()) == "one");
    CHECK(std::string(enum_words<Single>[0].data()) == "ndc_32");
}

TEST_CASE("A value is found by its word") {
    CHECK(value_of_word<Pair>("two") == Pair::two);
    CHECK_FALSE(value_of_word<Pair>("three").has_value());
    CHECK_FALSE(value_of_word<Pair>("").has_value());
}

TEST_CASE("A function is spelled as in the program") {
    CHECK(spelling<answer>() == "answer");
}
