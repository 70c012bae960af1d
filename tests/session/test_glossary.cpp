#include "base/error.h"
#include "session/content.h"
#include "session/glossary.h"
#include "tests/support/catch.h"

namespace rasterwalk {

TEST_CASE("The glossary that comes with the program has the words of the lab, each a sentence") {
    const std::vector<Term> terms = read_glossary(lessons_folder() + "/glossary.toml");
    CHECK(terms.size() >= 30);
    for (const Term& term : terms) {
        INFO(term.word);
        CHECK(term.sentence.back() == '.');
        CHECK_FALSE(term.section.empty());
    }
}

TEST_CASE("Sections of the lab are labelled as such, and those beyond it are not") {
    CHECK(section_words("Drawing edges") == "lab: Drawing edges");
    CHECK(section_words("Beyond the lab: textures") == "Beyond the lab: textures");
}

TEST_CASE("A glossary out of order or with a term twice names the line") {
    const char* const text = "[[term]]\nword = \"b\"\nsentence = \"B.\"\nsection = \"s\"\n"
                             "[[term]]\nword = \"a\"\nsentence = \"A.\"\nsection = \"s\"\n";
    try {
        parse_glossary(text, "words.toml");
        FAIL("was accepted");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).substr(0, 13) == "words.toml:5:");
    }
}

TEST_CASE("A term of the glossary may be marked as everyday English") {
    const std::string edge = "[[term]]\nword = \"edge\"\nsentence = \"A side.\"\nsection = \"s\"\n";
    CHECK_FALSE(parse_glossary(edge, "g").at(0).is_everyday);
    CHECK_FALSE(parse_glossary(edge + "everyday = false\n", "g").at(0).is_everyday);
    CHECK(parse_glossary(edge + "everyday = true\n", "g").at(0).is_everyday);
    CHECK_THROWS_WITH(parse_glossary(edge + "everyday = 1\n", "g"),
                      "g:5: 'everyday' must be true or false.");
}

} // namespace rasterwalk
