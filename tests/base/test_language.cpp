#include "base/language.h"

#include <filesystem>

#include "base/error.h"
#include "support/project_root.h"
#include "tests/support/catch.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

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

TEST_CASE("A language that is not one is refused with its line") {
    const auto refused = [](const std::string& text) {
        try {
            parse_language(text, "sv/texts.toml");
        } catch (const InputError& fault) {
            return std::string(fault.what());
        }
        return std::string("read");
    };
    CHECK(refused("name = \"Svenska\"\n[texts]\n\"Step\" = 3\n") ==
          "sv/texts.toml:3: the translation of 'Step' must be a text.");
    CHECK(refused("[texts]\n").starts_with("sv/texts.toml:1: "));
    CHECK(refused("name = \" \"\n[texts]\n") ==
          "sv/texts.toml:1: the name must have letters, and no control characters.");
    CHECK(refused("name = \"Svenska\"\n") == "sv/texts.toml:1: the language has no [texts].");
    CHECK(refused("name = \"Svenska\"\ntexts = 3\n").starts_with("sv/texts.toml:2: "));
    CHECK(refused("name = \"S\"\nwords = {}\n[texts]\n").starts_with("sv/texts.toml:2: "));
}

TEST_CASE("The code of a language never leads out of the folder of languages") {
    CHECK(is_language_code("sv"));
    CHECK(is_language_code("pt-br"));
    for (const char* const code : {"", "..", "../sv", "/etc", "SV", "sv/", "sv.toml", "abcdefghi"})
        CHECK_FALSE(is_language_code(code));
    CHECK_THROWS_AS(read_language("lessons", "../lessons"), UsageError);
}

TEST_CASE("A translated lesson is found from inside its folder") {
    const fs::path before = fs::current_path();
    fs::current_path(project_root() + "/lessons/languages/sv");
    const std::string from_language = lessons_folder_of("05-row-table.md");
    fs::current_path("..");
    const std::string from_languages = lessons_folder_of("sv/05-row-table.md");
    CHECK(is_list_of_texts("texts.toml"));
    CHECK_FALSE(is_list_of_texts("sv/texts.toml"));
    fs::current_path("..");
    const std::string from_lessons = lessons_folder_of("languages/sv/05-row-table.md");
    fs::current_path("..");
    const std::string from_root = lessons_folder_of("lessons/languages/sv/05-row-table.md");
    fs::current_path(before);
    CHECK(from_language == "../..");
    CHECK(from_languages == "..");
    CHECK(from_lessons == ".");
    CHECK(from_root == "lessons");
}

TEST_CASE("A translated lesson belongs to the folder of the English ones") {
    const std::string lessons = project_root() + "/lessons";
    CHECK(lessons_folder_of(lessons + "/05-row-table.md") == lessons);
    CHECK(lessons_folder_of(lessons + "/languages/sv/05-row-table.md") == lessons);
    CHECK(lessons_folder_of("05-row-table.md").empty());
    // Of a course on languages.
    CHECK(lessons_folder_of("/course/languages/cpp/05-loops.md") == "/course/languages/cpp");
    CHECK(translated_lesson("lessons", "sv", "05-row-table.md") ==
          "lessons/languages/sv/05-row-table.md");
}

} // namespace rasterwalk
