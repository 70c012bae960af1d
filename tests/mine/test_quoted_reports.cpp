// Lesson 36 quotes what is said about three programs, each with one mistake. The check of those
// programs says it. With STUDENT_PROGRAMS=all; one of them always.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "laboratory/bug.h"
#include "mine/checked_program.h"
#include "mine/compile/kit_files.h"
#include "mine/compile/student_files.h"
#include "support/catch.h"
#include "support/quoted_text.h"
#include "support/student_programs.h"
#include "support/temporary_folder.h"

namespace rasterwalk::test {

namespace {

constexpr const char* quoting_lesson = "36-your-own-program.md";

CheckedProgram check_of_sources(const std::vector<HandInSource>& sources) {
    static const TemporaryFolder cache; // not the user's
    ::setenv("RASTERWALK_CACHE", cache.file("cache").c_str(), 1);
    const TemporaryFolder folder;
    for (const HandInSource& source : sources)
        folder.write(source.name, source.text);
    CheckProgramOptions options;
    options.hold_keys = false;
    options.search = std::chrono::minutes(1);
    return check_program(find_student_files(folder.file("")), read_lab_scenes(), read_bugs(),
                         options);
}

CheckedProgram check_of_hand_in(std::string_view name) {
    const std::vector<HandIn> programs = student_mistakes();
    const auto program = std::find_if(programs.begin(), programs.end(),
                                      [&](const HandIn& one) { return one.name == name; });
    REQUIRE(program != programs.end());
    return check_of_sources(program->sources);
}

/// The program that `mine --new` writes, with other words in place of these.
CheckedProgram check_of_new(const std::string& from, const std::string& to) {
    const std::vector<KitFile>& files = kit_files();
    const auto skeleton = std::find_if(files.begin(), files.end(), [](const KitFile& file) {
        return file.name == "new/skeleton.cpp";
    });
    REQUIRE(skeleton != files.end());
    std::string text(skeleton->text);
    const std::size_t at = text.find(from);
    REQUIRE(at != text.npos);
    return check_of_sources({{"skeleton.cpp", text.replace(at, from.size(), to)}});
}

/// The check of a function of such a program.
const FunctionCheck& check_of_part(const CheckedProgram& program, rasterwalk_kit::Part part) {
    REQUIRE(program.compiles());
    const auto found = std::find_if(program.functions.begin(), program.functions.end(),
                                    [&](const FunctionCheck& check) { return check.part == part; });
    REQUIRE(found != program.functions.end());
    return *found;
}

std::string counted_answers(const FunctionCheck& check, std::string_view word) {
    return fmt::format("{}: {}, {} of {}", check.function, word, check.right, check.asked);
}

void require_quoted_picture(const CheckedProgram& program) {
    REQUIRE(program.picture);
    const PictureCheck& picture = *program.picture;
    require_text(quoting_lesson, fmt::format("{} of {} pixels differ. {}", picture.different,
                                             picture.pixels, picture.diagnosis.verdict));
}

} // namespace

TEST_CASE("Lesson 36 quotes the report on edges sampled by rows", "[mine]") {
    const CheckedProgram program = check_of_hand_in("classic-sampled-by-rows");
    const FunctionCheck& rows = check_of_part(program, rasterwalk_kit::part_polygon_rows);
    CHECK(rows.state == CheckState::wrong);
    require_text(quoting_lesson,
                 fmt::format("right for {} of {} questions", rows.right, rows.asked));
    // The sentence's end is an example of a wrong answer.
    require_text(quoting_lesson, "> " + rows.first.substr(rows.first.find("row 10")));
    const FunctionCheck& drawing = check_of_part(program, rasterwalk_kit::part_draw_rows);
    CHECK(drawing.state == CheckState::right);
    require_text(quoting_lesson, fmt::format("for all {} of its own", drawing.asked));
}

TEST_CASE("Lesson 36 quotes the first message on two programs that do not compile", "[mine]") {
    for (const CheckedProgram& program :
         {check_of_new("float focalLength = 500;", "float focalLength = 500"),
          check_of_new("        Update();", "        Interpolate();")}) {
        REQUIRE_FALSE(program.compiles());
        REQUIRE_FALSE(program.compiled.messages.empty());
        const CompileMessage& first = program.compiled.messages.front();
        INFO(program.compiled.compiler << ": " << first.text);
        if (!program.compiled.compiler.starts_with("g++")) continue; // clang++ has its own words
        require_text(quoting_lesson, fmt::format("> skeleton.cpp:{}: {}", first.line, first.text));
        require_text(quoting_lesson, "> " + first.cause);
    }
}

TEST_CASE("Lesson 36 quotes the reports on its three cases", "[mine]") {
    const char* const wish = std::getenv("STUDENT_PROGRAMS");
    if (wish == nullptr || std::string_view(wish) != "all") return;
    const CheckedProgram unguarded = check_of_hand_in("classic-no-guard-of-rows");
    const FunctionCheck& line = check_of_part(unguarded, rasterwalk_kit::part_interpolate);
    CHECK(line.state == CheckState::right);
    require_text(quoting_lesson, counted_answers(line, "right"));
    // Where nothing else uses the memory before the vector, the program survives.
    const FunctionCheck& rows = check_of_part(unguarded, rasterwalk_kit::part_polygon_rows);
    if (rows.state == CheckState::died) {
        require_text(quoting_lesson, counted_answers(rows, "died"));
        require_text(quoting_lesson, rows.first);
    }

    const CheckedProgram farthest = check_of_hand_in("classic-farthest-wins");
    const FunctionCheck& drawing = check_of_part(farthest, rasterwalk_kit::part_draw_rows);
    CHECK(drawing.state == CheckState::wrong);
    require_text(quoting_lesson, counted_answers(drawing, "wrong"));
    const FunctionCheck& depth = check_of_part(farthest, rasterwalk_kit::part_depth_test);
    CHECK(depth.state == CheckState::wrong);
    require_text(quoting_lesson, counted_answers(depth, "wrong") + ": " + depth.first);
    require_quoted_picture(farthest);

    const CheckedProgram black = check_of_hand_in("classic-depth-reversed");
    const FunctionCheck& unseen = check_of_part(black, rasterwalk_kit::part_depth_test);
    CHECK(unseen.state == CheckState::not_written);
    REQUIRE(unseen.notes.size() == 1);
    require_text(quoting_lesson, unseen.notes.front());

    const CheckedProgram affine = check_of_hand_in("classic-affine");
    for (const FunctionCheck& check : affine.functions) {
        INFO(check.function << ": " << check.first);
        CHECK(check.state == CheckState::right);
    }
    require_quoted_picture(affine);
}

} // namespace rasterwalk::test
