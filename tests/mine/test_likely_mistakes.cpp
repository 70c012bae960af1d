// What is listed as a mistake, from evidence that is made here.

#include <string>
#include <vector>

#include "mine/checked_program.h"
#include "support/catch.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;

namespace {

FunctionCheck function_check(const std::string& name, rasterwalk_kit::Part part, CheckState state) {
    FunctionCheck check;
    check.function = name;
    check.part = part;
    check.state = state;
    check.asked = 200;
    check.right = state == CheckState::right ? 200 : 150;
    check.fed = "200 lines";
    if (state == CheckState::wrong) check.first = "Line 3: sample 7 is at (4, 9).";
    return check;
}

/// A program that has drawn its frame, and whose functions are all right and called.
CheckedProgram sound_program() {
    CheckedProgram checked;
    checked.compiled.program = "/somewhere/program";
    checked.run.emplace();
    checked.run->recording.progress.frames = 1;
    struct Written {
        const char* name;
        rasterwalk_kit::Part part;
    };
    for (const Written written : {Written{"VertexShader", rasterwalk_kit::part_vertex_shader},
                                  Written{"Interpolate", rasterwalk_kit::part_interpolate},
                                  Written{"ComputePolygonRows", rasterwalk_kit::part_polygon_rows},
                                  Written{"DrawPolygonRows", rasterwalk_kit::part_draw_rows},
                                  Written{"PixelShader", rasterwalk_kit::part_pixel_shader}}) {
        checked.functions.push_back(function_check(written.name, written.part, CheckState::right));
        checked.run->calls.push_back({written.name, 30});
        checked.defined.push_back(written.name);
    }
    checked.picture.emplace();
    checked.picture->is_right = true;
    checked.picture->reference.stage = Stage::shade;
    checked.picture->pixels = 250000;
    return checked;
}

Candidate likely(const std::vector<std::string>& ids) {
    Candidate candidate;
    candidate.mistakes.push_back({ids, std::vector<std::string>(ids.size(), "a mistake")});
    candidate.is_likely = true;
    candidate.explained = 1.0;
    return candidate;
}

void make_picture_wrong(CheckedProgram& checked, const std::vector<std::string>& ids) {
    checked.picture->is_right = false;
    checked.picture->different = 1234;
    checked.picture->diagnosis.different = 1234;
    checked.picture->diagnosis.place = "They are in rows 3 to 9.";
    if (!ids.empty()) checked.picture->diagnosis.candidates.push_back(likely(ids));
}

void make_wrong(FunctionCheck& check, const std::vector<std::string>& bugs) {
    check = function_check(check.function, check.part, CheckState::wrong);
    check.bugs = bugs;
}

void forget_call_of(CheckedProgram& checked, const std::string& function) {
    std::vector<FunctionCalls> kept;
    for (const FunctionCalls& calls : checked.run->calls)
        if (calls.function != function) kept.push_back(calls);
    checked.run->calls = kept;
}

using Ids = std::vector<std::string>;

} // namespace

TEST_CASE("A sound program has no mistake") {
    const CheckedProgram checked = sound_program();
    CHECK(likely_mistakes(checked).empty());
    CHECK(checked.is_right());
}

TEST_CASE("A program that does not compile has no mistake of its functions") {
    CheckedProgram checked;
    CHECK(likely_mistakes(checked).empty());
    CHECK_FALSE(checked.is_right());
}

TEST_CASE("A wrong function is named with its mistake and its first difference") {
    CheckedProgram checked = sound_program();
    make_wrong(checked.functions[1], {"B5"});
    const std::vector<LikelyMistake> mistakes = likely_mistakes(checked);
    REQUIRE(mistakes.size() == 1);
    CHECK(mistakes[0].bugs == Ids{"B5"});
    CHECK(mistakes[0].sentence == "Interpolate is wrong for 50 of 200 questions (200 lines). Line "
                                  "3: sample 7 is at (4, 9).");
    CHECK_FALSE(checked.is_right());
}

TEST_CASE("Mistakes that only together explain a function are named together") {
    CheckedProgram checked = sound_program();
    make_wrong(checked.functions[1], {});
    checked.functions[1].together = {"B5", "B92"};
    checked.functions[1].causes = {"It also counts from 1."};
    const std::vector<LikelyMistake> mistakes = likely_mistakes(checked);
    REQUIRE(mistakes.size() == 1);
    CHECK(mistakes[0].bugs == Ids{"B5", "B92"});
    CHECK_THAT(mistakes[0].sentence, ContainsSubstring("It also counts from 1."));
}

TEST_CASE("A picture that shows the mistake of a function again is not listed again") {
    CheckedProgram checked = sound_program();
    make_wrong(checked.functions[1], {"B5"});
    SECTION("the same mistake") {
        make_picture_wrong(checked, {"B5"});
        CHECK(likely_mistakes(checked).size() == 1);
    }
    SECTION("one of several that look the same") {
        make_picture_wrong(checked, {"B12", "B5"});
        CHECK(likely_mistakes(checked).size() == 1);
    }
    SECTION("another mistake") {
        make_picture_wrong(checked, {"B20a"});
        const std::vector<LikelyMistake> mistakes = likely_mistakes(checked);
        REQUIRE(mistakes.size() == 2);
        CHECK(mistakes[0].bugs == Ids{"B5"});
        CHECK(mistakes[1].bugs == Ids{"B20a"});
        CHECK_THAT(mistakes[1].sentence, ContainsSubstring("1234 pixels of the picture differ"));
        CHECK_THAT(mistakes[1].sentence, ContainsSubstring("They are in rows 3 to 9."));
    }
    SECTION("nothing that is known") {
        make_picture_wrong(checked, {});
        const std::vector<LikelyMistake> mistakes = likely_mistakes(checked);
        REQUIRE(mistakes.size() == 2);
        CHECK(mistakes[1].bugs.empty());
    }
}

TEST_CASE("A candidate that is not likely is not named") {
    CheckedProgram checked = sound_program();
    make_picture_wrong(checked, {"B3"});
    checked.picture->diagnosis.candidates.front().is_likely = false;
    const std::vector<LikelyMistake> mistakes = likely_mistakes(checked);
    REQUIRE(mistakes.size() == 1);
    CHECK(mistakes[0].bugs.empty());
}

TEST_CASE("A function that is written but not called is named, only the first of them") {
    CheckedProgram checked = sound_program();
    checked.picture.reset();
    forget_call_of(checked, "PixelShader");
    forget_call_of(checked, "DrawPolygonRows");
    const std::vector<LikelyMistake> mistakes = likely_mistakes(checked);
    REQUIRE(mistakes.size() == 2);
    CHECK_THAT(mistakes[0].sentence, ContainsSubstring("DrawPolygonRows is written, but"));
    CHECK_THAT(mistakes[0].sentence, ContainsSubstring("`void DrawPolygonRows(...);`"));
    CHECK(mistakes[1].sentence == "Your program puts no pixel on the screen.");
    for (const LikelyMistake& mistake : mistakes)
        CHECK(mistake.bugs.empty());
}

TEST_CASE("A function that the picture does not need may stay uncalled") {
    CheckedProgram checked = sound_program();
    make_picture_wrong(checked, {});
    forget_call_of(checked, "DrawPolygonRows");
    forget_call_of(checked, "PixelShader");
    SECTION("points and edges need no rows") {
        checked.picture->reference.stage = Stage::edges;
        CHECK(likely_mistakes(checked).size() == 1);
    }
    SECTION("filled triangles need rows") {
        checked.picture->reference.stage = Stage::fill;
        const std::vector<LikelyMistake> mistakes = likely_mistakes(checked);
        REQUIRE(mistakes.size() == 2);
        CHECK_THAT(mistakes[0].sentence, ContainsSubstring("DrawPolygonRows is written"));
    }
    SECTION("a right picture needs nothing more") {
        checked.picture->is_right = true;
        CHECK(likely_mistakes(checked).empty());
    }
    SECTION("calls may not be known") {
        checked.run->calls.clear();
        CHECK(likely_mistakes(checked).size() == 1);
    }
    SECTION("what is not written cannot be called") {
        checked.functions[3].state = CheckState::not_written;
        checked.functions[4].state = CheckState::not_asked;
        CHECK(likely_mistakes(checked).size() == 1);
    }
}

TEST_CASE("A fault is listed with its place, and without a frame the picture is not") {
    CheckedProgram checked = sound_program();
    checked.picture.reset();
    checked.run->recording.progress.frames = 0;
    ProgramFault fault;
    fault.sentence = "It was ended by a segmentation fault.";
    fault.place = {"DrawPolygonRows", "/home/ada/lab/skeleton.cpp", 142};
    checked.run->faults.push_back(fault);
    const std::vector<LikelyMistake> mistakes = likely_mistakes(checked);
    REQUIRE(mistakes.size() == 1);
    CHECK(mistakes[0].sentence == fault.sentence);
    CHECK(mistakes[0].place == fault.place);
    CHECK_FALSE(checked.is_right());
}

TEST_CASE("A fault while a key is held says which key, and comes last") {
    CheckedProgram checked = sound_program();
    make_wrong(checked.functions[0], {"B24"});
    KeyFault held;
    held.key = {"UP", 0x40000052};
    held.frame = 3;
    held.fault.sentence = "It divides by zero.";
    held.fault.place = {"Update", "/home/ada/lab/skeleton.cpp", 12};
    KeyFault first = held;
    first.key = {};
    first.frame = 0;
    checked.key_faults = {first, held};
    const std::vector<LikelyMistake> mistakes = likely_mistakes(checked);
    REQUIRE(mistakes.size() == 3);
    CHECK(mistakes[0].bugs == Ids{"B24"});
    CHECK(mistakes[1].sentence == "In the first frame: It divides by zero.");
    CHECK(mistakes[2].sentence == "While the key UP is held, in frame 3: It divides by zero.");
    CHECK(mistakes[2].place == held.fault.place);
    CHECK_FALSE(checked.is_right());
}

TEST_CASE("Why a picture is not judged is said as it is") {
    CheckedProgram checked = sound_program();
    make_picture_wrong(checked, {});
    Image& theirs = checked.picture->theirs;
    theirs = Image{2, 1, {0, 0, 0, 255, 9, 0, 0, 255}};
    checked.picture->right = theirs;
    CHECK_THAT(std::string(not_judged_words(checked)), ContainsSubstring("too little is known"));
    theirs.rgba[4] = 0;
    CHECK_THAT(std::string(not_judged_words(checked)), ContainsSubstring("A black picture"));
    make_wrong(checked.functions[0], {});
    CHECK_THAT(std::string(not_judged_words(checked)), ContainsSubstring("a function is wrong"));
}
