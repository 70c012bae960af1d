// Whole programs as students hand them in, from their source to what is said about them. Some of
// them always; all of them with STUDENT_PROGRAMS=all, as ./test all has it.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "laboratory/bug.h"
#include "mine/checked_program.h"
#include "mine/compile/student_files.h"
#include "support/catch.h"
#include "support/student_programs.h"
#include "support/temporary_folder.h"

namespace rasterwalk::test {

namespace {

/// Of several styles, right ones among them; those of the second list with their keys held.
constexpr std::array<std::string_view, 8> always_checked{"classic",
                                                         "bristol_vec4",
                                                         "lambdas",
                                                         "several_files",
                                                         "rounded-last-triangle-first",
                                                         "classic-sampled-by-rows",
                                                         "rounded-last-column",
                                                         "bristol-x-y-exchanged"};
constexpr std::array<std::string_view, 4> always_with_keys{
    "over_z_inside", "c_arrays", "rounded-no-bounds", "classic-declared-not-called"};

constexpr std::array<std::string_view, 3> named_by_functions{
    "classic-sampled-by-rows", "rounded-last-column", "bristol-x-y-exchanged"};

template <class Names>
bool is_listed(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_every_program_checked() {
    const char* const wish = std::getenv("STUDENT_PROGRAMS");
    return wish != nullptr && std::string_view(wish) == "all";
}

/// Keeps what is compiled for one run of the tests, and away from the user's cache.
const std::string& cache_of_tests() {
    static const TemporaryFolder folder;
    static const std::string path = folder.file("cache");
    ::setenv("RASTERWALK_CACHE", path.c_str(), 1);
    return path;
}

CheckedProgram checked(const HandIn& program, bool holds_keys) {
    static const LabScenes lab = read_lab_scenes();
    static const std::vector<Bug> bugs = read_bugs();
    REQUIRE_FALSE(cache_of_tests().empty());
    const TemporaryFolder folder;
    for (const HandInSource& source : program.sources)
        folder.write(source.name, source.text);
    CheckProgramOptions options;
    options.hold_keys = holds_keys;
    // Those always checked are right, or named by their functions: nothing is searched for long.
    options.search = is_every_program_checked() ? std::chrono::minutes(5) : std::chrono::seconds(1);
    return check_program(find_student_files(folder.file("")), lab, bugs, options);
}

std::vector<std::string> named_bugs(const CheckedProgram& program) {
    std::vector<std::string> named;
    for (const LikelyMistake& mistake : program.mistakes)
        named.insert(named.end(), mistake.bugs.begin(), mistake.bugs.end());
    return named;
}

/// A right program may be more than can be judged, but it is never called wrong. A wrong one is
/// named first, or nothing is named.
void judge(const HandIn& program, const CheckedProgram& found) {
    INFO(program.name << ", " << program.bug << ": " << program.note);
    std::string said;
    for (const LikelyMistake& mistake : found.mistakes)
        said += '\n' + mistake.sentence;
    INFO(said);
    REQUIRE(found.compiles());
    const std::vector<std::string> named = named_bugs(found);
    if (program.right) {
        CHECK(found.mistakes.empty());
        return;
    }
    for (const FunctionCheck& check : found.functions)
        CHECK(check.state != CheckState::unreadable);
    // What functions show is always named; what only a picture or a key shows may stay unknown.
    if (is_listed(named_by_functions, program.name)) REQUIRE_FALSE(named.empty());
    if (named.empty()) return;
    CHECK_FALSE(found.mistakes.front().bugs.empty());
    CHECK(is_listed(found.mistakes.front().bugs, program.bug));
}

void judge_all(const std::vector<HandIn>& programs) {
    int judged = 0;
    for (const HandIn& program : programs) {
        const bool holds_keys = is_listed(always_with_keys, program.name);
        if (!holds_keys && !is_listed(always_checked, program.name) && !is_every_program_checked())
            continue;
        judge(program, checked(program, holds_keys));
        ++judged;
    }
    CHECK(judged > 0);
}

} // namespace

TEST_CASE("right programs of every style are not called wrong") {
    judge_all(student_styles());
}

TEST_CASE("a known mistake in a program is named, or nothing is") {
    judge_all(student_mistakes());
}

TEST_CASE("what a picture cannot show is found by asking the functions") {
    const std::vector<HandIn> all = student_mistakes();
    const auto sampled = std::find_if(all.begin(), all.end(), [](const HandIn& program) {
        return program.name == "classic-sampled-by-rows";
    });
    REQUIRE(sampled != all.end());
    const CheckedProgram found = checked(*sampled, false);
    REQUIRE_FALSE(found.mistakes.empty());
    CHECK(found.mistakes.front().bugs == std::vector<std::string>{"B5"});
    CHECK_FALSE(found.is_right());
}

} // namespace rasterwalk::test
