#include "base/language_files.h"

#include <filesystem>

#include "base/error.h"
#include "support/project_root.h"
#include "tests/support/catch.h"

namespace rasterwalk {

namespace fs = std::filesystem;

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
