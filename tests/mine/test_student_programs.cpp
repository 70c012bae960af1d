// The programs of students that the other tests compile: whether each can be made, and what is
// claimed of it can be true.

#include "support/student_programs.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "laboratory/bug.h"
#include "support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

std::string whole_text(const HandIn& program) {
    std::string text;
    for (const HandInSource& source : program.sources)
        text += source.text;
    return text;
}

} // namespace

TEST_CASE("There are nine styles, and each is a program of its own", "[mine]") {
    const std::vector<HandIn> styles = student_styles();
    CHECK(styles.size() == 9);
    for (const HandIn& style : styles) {
        INFO(style.name);
        const std::string text = whole_text(style);
        CHECK(text.find("int main(") != std::string::npos);
        CHECK(text.find("LoadTestModel(") != std::string::npos);
        CHECK(std::count(text.begin(), text.end(), '\n') >= 150);
    }
}

TEST_CASE("Each program with a mistake differs from its style and from all others", "[mine]") {
    std::map<std::string, std::string> texts;
    for (const HandIn& style : student_styles()) {
        texts[style.name] = whole_text(style);
    }
    std::set<std::string> seen;
    std::set<std::string> names;
    for (const HandIn& program : student_mistakes()) {
        INFO(program.name);
        const std::string text = whole_text(program);
        CHECK(text != texts.at(program.style));
        CHECK(seen.insert(text).second);
        CHECK(names.insert(program.name).second);
        CHECK(texts.count(program.name) == 0);
    }
}

TEST_CASE("The mistakes of students are those of the laboratory, or none", "[mine]") {
    const std::vector<Bug> bugs = read_bugs();
    std::set<std::string> styles;
    std::set<std::string> ids;
    int right = 0;
    int wrong = 0;
    for (const HandIn& program : student_mistakes()) {
        INFO(program.name);
        styles.insert(program.style);
        if (program.right) {
            CHECK(program.bug.empty());
            ++right;
            continue;
        }
        ++wrong;
        if (program.bug.empty()) continue;
        CHECK(bug_of_id(bugs, program.bug) != nullptr);
        ids.insert(program.bug);
    }
    CHECK(right >= 5);
    CHECK(wrong >= 44);
    CHECK(ids.size() >= 40);
    CHECK(styles.size() == student_styles().size());
}

TEST_CASE("Ten programs are written from the handout alone", "[mine]") {
    const std::vector<std::string> paths = {
        "handout/01-points.cpp",    "handout/02-wireframe.cpp", "handout/03-edges",
        "handout/04-triangles.cpp", "handout/05-triangles.cpp", "handout/06-depth.cpp",
        "handout/07-classes.cpp",   "handout/08-perpixel.cpp",  "handout/09-lab3",
        "handout/10-everything.cpp"};
    for (const std::string& path : paths) {
        INFO(path);
        const std::vector<HandInSource> sources = student_sources(path);
        const bool has_main =
            std::any_of(sources.begin(), sources.end(), [](const HandInSource& source) {
                return source.text.find("int main(") != std::string::npos;
            });
        CHECK(has_main);
    }
}
