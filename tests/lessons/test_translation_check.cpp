#include "lessons/translation_check.h"

#include <filesystem>

#include "base/error.h"
#include "base/files.h"
#include "lessons/lesson_list.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

const std::string lesson = R"(<!-- lesson
title = "Rows"
section = "Filled triangles"
minutes = 10
about = "About rows."
scene = "scenes/one-triangle.toml"
-->
# Rows

Take [one step](show:walk.step).

## More rows

<!-- task
id = "see-rows"
done = "stage >= rows"
recipe = ["set:stage=rows"]
-->
> **Task.** Show the rows.
)";

std::string with(std::string text, const std::string& is, const std::string& becomes) {
    const std::size_t at = text.find(is);
    REQUIRE(at != text.npos);
    return text.replace(at, is.size(), becomes);
}

/// A folder of lessons with one lesson, and a language.
class Folder {
  public:
    Folder() {
        fs::create_directories(path("languages/sv"));
        write("07-rows.md", lesson);
        write("08-fill.md", lesson);
        write("languages/texts.toml",
              "name = \"English\"\n[texts]\n\"Step\" = \"\"\n\"row {}\" = \"\"\n\"Edge\" = \"\"\n");
    }
    std::string path(const std::string& name) const { return folder_.file(name); }
    void write(const std::string& name, const std::string& text) const {
        write_file(path(name), text);
    }
    /// What a translation of the lesson has differently, as sentences.
    std::vector<std::string> differences(const std::string& text) const {
        write("languages/sv/07-rows.md", text);
        std::vector<std::string> sentences;
        for (const Fault& fault :
             differences_from_english(read_lesson(path("languages/sv/07-rows.md"))))
            sentences.push_back(std::to_string(fault.line) + ": " + fault.sentence);
        return sentences;
    }

  private:
    test::TemporaryFolder folder_;
};

} // namespace

TEST_CASE("A translated lesson may differ in words, and in nothing else") {
    const Folder folder;
    using List = std::vector<std::string>;
    CHECK(folder.differences(with(lesson, "one step", "ett steg")).empty());
    CHECK(folder.differences(with(lesson, "show:walk.step", "show:walk.back")) ==
          List{"8: this step lacks a link to 'show:walk.step' of the English one.",
               "8: the English step does not have a link to 'show:walk.back'."});
    CHECK(folder.differences(with(lesson, "id = \"see-rows\"", "id = \"se-rader\"")) ==
          List{"12: this step lacks the task 'see-rows' of the English one.",
               "12: the English step does not have the task 'se-rader'."});
    CHECK(folder.differences(with(lesson, "## More rows\n", "")) ==
          List{"1: the lesson has 1 part, with its opening; the English one has 2 parts."});
    folder.write("languages/sv/09-new.md", lesson);
    CHECK(differences_from_english(read_lesson(folder.path("languages/sv/09-new.md"))).size() == 1);
}

TEST_CASE("Texts that the program does not have, or with other places, are faults") {
    const Folder folder;
    const std::string path = folder.path("languages/sv/texts.toml");
    write_file(path, "name = \"Svenska\"\n[texts]\n\"Step\" = \"Steg\"\n\"row {}\" = \"rad\"\n"
                     "\"Walk\" = \"Gå\"\n");
    CHECK(text_faults(path) ==
          std::vector<Fault>{
              {4, "the translation of 'row {}' needs '{}', in this order, and no other braces or "
                  "#."},
              {5, "the program has no text 'Walk'."}});
}

TEST_CASE("A check says what a translation lacks") {
    const Folder folder;
    folder.write("languages/sv/texts.toml",
                 "name = \"Svenska\"\n[texts]\n\"Step\" = \"Steg\"\n\"Edge\" = \"\"\n");
    folder.write("languages/sv/07-rows.md", with(lesson, "one step", "ett steg"));
    const TranslationGaps gaps = translation_gaps(folder.path("."), "sv");
    CHECK(gaps.texts == std::vector<std::string>{"Edge", "row {}"});
    CHECK(gaps.all_texts == 3);
    CHECK(gaps.lessons == std::vector<std::string>{"08-fill.md"});
    CHECK(gaps.all_lessons == 2);
}

TEST_CASE("A translated lesson takes the place of the English one, and keeps its folder") {
    const Folder folder;
    folder.write("languages/sv/07-rows.md", with(lesson, "title = \"Rows\"", "title = \"Rader\""));
    LessonList list;
    list.read_folder(folder.path("."));
    CHECK(list.find("07-rows")->title == "Rows");
    list.set_language("sv");
    CHECK(list.all().size() == 2);
    CHECK(list.find("07-rows")->title == "Rader");
    CHECK(list.find("08-fill")->title == "Rows");
    CHECK(fs::equivalent(list.find("07-rows")->folder, list.find("08-fill")->folder));
    list.set_language("");
    CHECK(list.find("07-rows")->title == "Rows");
}

} // namespace rasterwalk
