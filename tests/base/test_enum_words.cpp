#include "base/enum_words.h"

#include <cstdint>

#include "tests/support/catch.h"

namespace rasterwalk {

namespace {

enum class Right : std::uint8_t { one, two };
enum class TooShort : std::uint8_t { one, two, three };
enum class TooLong : std::uint8_t { one };
enum class Swapped : std::uint8_t { one, two };
enum class Wordless : std::uint8_t { one };

} // namespace

template <>
inline constexpr auto enum_words<Right> = word_list("one", "two");
template <>
inline constexpr auto enum_words<TooShort> = word_list("one", "two");
template <>
inline constexpr auto enum_words<TooLong> = word_list("one", "two");
template <>
inline constexpr auto enum_words<Swapped> = word_list("two", "one");

// What must not compile when asserted next to an enum.
static_assert(words_match<Right>);
static_assert(!words_match<TooShort>);
static_assert(!words_match<TooLong>);
static_assert(!words_match<Swapped>);
static_assert(!words_match<Wordless>);

} // namespace rasterwalk

using namespace rasterwalk;

TEST_CASE("A value of an enum has the word at its position in the list") {
    CHECK(word_of(Right::one) == "one");
    CHECK(word_of(Right::two) == "two");
}
