#include "base/language.h"

#include "base/language_files.h"

#include "tests/support/catch.h"

namespace rasterwalk {

namespace {

const std::string small = R"(name = "Svenska"

[texts]
"Step" = "Steg"
"step {} of {}" = "steg {} av {}"
"{} of {}" = "{} av {:d}"
"frame in {:g} s" = "{0}"
"row {}" = "rad {} }"
"Edge" = ""
"edge #" = "kant"
"sample #" = "sampel #"
)";

} // namespace

TEST_CASE("A text in a language is found by the English one, and is English without it") {
    const Language language = parse_language(small, "texts.toml");
    CHECK(language.name == "Svenska");
    CHECK(tr("Step", language) == "Steg");
    CHECK(tr("Edge", language) == "Edge");
    CHECK(tr("Row", language) == "Row");
    CHECK(tr("Step", english()) == "Step");
    CHECK(tr(language, "step {} of {}", 3, 9) == "steg 3 av 9");
}

TEST_CASE("A translation with other places for values than the English text is not used") {
    const Language language = parse_language(small, "texts.toml");
    CHECK(tr(language, "{} of {}", 3, 9) == "3 of 9");
    CHECK(tr(language, "frame in {:g} s", 1.5) == "frame in 1.5 s");
    CHECK(tr(language, "row {}", 4) == "row 4");
    CHECK(tr("edge #", language) == "edge #");
    CHECK(tr("sample #", language) == "sampel #");
    CHECK(places_in("triangles[#]") == "#");
    CHECK(places_in("a {} b {:.3f} c") == "{}{:.3f}");
    CHECK(places_in("} {") == "}{");
}

TEST_CASE("A translation that cannot be drawn is not used") {
    CHECK(can_be_drawn("Alla", "All"));
    CHECK(can_be_drawn("\nNu", "\nNow"));
    for (const char* const text : {"", " ", "\n", "\r", "Alla\n", "a\tb", "\x1b[0m"})
        CHECK_FALSE(can_be_drawn(text, "All"));
    CHECK_FALSE(can_be_drawn(std::string_view("\0Alla", 5), "All"));
    const Language language =
        parse_language("name = \"S\"\n[texts]\n\"All\" = \"\\n\"\n", "texts.toml");
    CHECK(tr("All", language) == "All");
}

} // namespace rasterwalk
