#include "base/toml_input.h"

#include <algorithm>

#include "base/error.h"
#include "laboratory/bug.h"
#include "lessons/lesson.h"
#include "lessons/progress.h"
#include "scene/read_scene.h"
#include "session/glossary.h"
#include "settings/preset.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "view/state_file.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;

namespace {

std::string repeated(std::string_view text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i)
        result += text;
    return result;
}

const std::string sentence =
    "this is nested too deeply: a key has more than 32 dots, or more than 32 brackets are nested.";

std::string fault_of(const std::string& text) {
    try {
        parse_toml(text, "x.toml");
        return "none";
    } catch (const InputError& fault) {
        return fault.what();
    }
}

} // namespace

TEST_CASE("Keys of 30000 parts are refused with their line wherever TOML is read") {
    const std::string deep = "\n" + repeated("a.", 30'000) + "a = 1\n";
    const test::TemporaryFolder folder;
    const std::string path = folder.write("deep.toml", deep);
    const std::string said = path + ":2: " + sentence;
    CHECK_THROWS_WITH(read_progress(path), said);
    CHECK_THROWS_WITH(read_scene(path), said);
    CHECK_THROWS_WITH(read_view(path), said);
    CHECK_THROWS_WITH(read_presets(path), said);
    CHECK_THROWS_WITH(read_glossary(path), said);
    CHECK_THROWS_WITH(read_bugs(path), said);
    // No line of a lesson can be as long as that.
    const std::string long_line = "\n" + repeated("a.", 1'900) + "a = 1\n";
    const Lesson lesson =
        read_lesson(folder.write("01-deep.md", "<!-- lesson" + long_line + "-->\n# Deep\n"));
    CHECK(std::count(lesson.faults.begin(), lesson.faults.end(), Fault{2, sentence}) == 1);
}

TEST_CASE("Everything that nests tables is limited") {
    CHECK(fault_of("[" + repeated("a.", 30'000) + "a]") == "x.toml:1: " + sentence);
    CHECK(fault_of("[[" + repeated("a.", 30'000) + "a]]") == "x.toml:1: " + sentence);
    CHECK(fault_of("b = 1\n'x'=2\n" + repeated("\"q\" . ", 30'000) + "a = 1") ==
          "x.toml:3: " + sentence);
    CHECK(fault_of("a = " + repeated("[\n", 40)) == "x.toml:33: " + sentence);
    const std::string key = repeated("a.", 32) + "a";
    CHECK(fault_of(key + " = " + repeated("{ " + key + " = ", 40)) == "x.toml:1: " + sentence);
    // The greatest depth allowed: this is read and freed.
    CHECK(fault_of("[" + key + "]\n" + key + " = " + repeated("{ " + key + " = ", 32) + "1" +
                   repeated(" }", 32)) == "none");
}

TEST_CASE("Dots and brackets in strings, comments and numbers do not count as nesting") {
    const std::string dots(100, '.'), brackets(100, '[');
    for (const std::string& text : {
             "# " + dots + brackets + "\na = 1",
             "a = \"" + dots + "\\\"" + brackets + "\"",
             "a = '" + dots + "\\' # " + brackets,
             "'" + dots + brackets + "' = 1",
             "a = \"\"\"\n" + dots + "\\\"\"\" \"" + brackets + "\"\"\"\"\"\nb = 1",
             "a = '''\n" + dots + "'' " + brackets + "''''\nb = ''",
             "a = [" + repeated("1.5, ", 100) + "]",
             repeated("a1 = 1.5 # .\n", 1),
         }) {
        INFO(text);
        CHECK_THAT(fault_of(text), !ContainsSubstring(sentence));
    }
    // A string that has ended hides nothing.
    for (const std::string& start :
         {std::string("\"\" = 1\n"), std::string("a = \"\\\\\"\n"), std::string("a = 'x\\'\n"),
          std::string("a = \"\"\"x\"\"\"\"\"\n"), std::string("a = ''''''\n"),
          std::string("# \"\n")}) {
        INFO(start);
        CHECK(fault_of(start + repeated("b.", 100)) == "x.toml:2: " + sentence);
    }
}
