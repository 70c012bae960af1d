#include "mine/check_lines.h"

#include "mine/checked_program.h"
#include "mine/source_lines.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace rasterwalk {

namespace {

FunctionCheck function_check(const char* name, CheckState state, int right, int asked) {
    FunctionCheck check;
    check.function = name;
    check.state = state;
    check.right = right;
    check.asked = asked;
    return check;
}

/// A program that compiled and drew, with two functions.
CheckedProgram compiled_program(CheckState of_rows) {
    CheckedProgram checked;
    checked.compiled.program = "/nowhere/program";
    checked.run.emplace();
    checked.run->recording.progress.frames = 1;
    checked.run->recording.progress.puts = 3;
    checked.run->recording.puts.resize(3);
    checked.functions = {
        function_check("VertexShader", CheckState::right, 90, 90),
        function_check("ComputePolygonRows", of_rows, of_rows == CheckState::right ? 30 : 26, 30)};
    return checked;
}

std::string list_text(const std::vector<CheckLine>& lines) {
    std::string text;
    for (const CheckLine& line : lines)
        text +=
            "rwow"[static_cast<int>(line.state)] +
            (line.state == CheckLineState::waiting ? std::string("aiting ") : std::string(" ")) +
            line.name + (line.count.empty() ? "" : ": ") + line.count + '\n';
    return text;
}

} // namespace

TEST_CASE("The list of a program's checks is in the order of the lab") {
    const CheckedProgram checked = compiled_program(CheckState::wrong);
    const std::vector<CheckLine> lines = check_lines(checked, false);
    CHECK(list_text(lines) == "r compiled\n"
                              "r first frame: 3 pixels put\n"
                              "r VertexShader: 90 of 90\n"
                              "w ComputePolygonRows: 26 of 30\n"
                              "waiting picture\n"
                              "waiting order of pixels\n"
                              "waiting keys held\n");
    CHECK(first_wrong(lines) == 3);
    CHECK(first_wrong(check_lines(compiled_program(CheckState::right), false)) == 4);
    CHECK(first_wrong(check_lines(CheckedProgram{}, true)) == 0);
}

TEST_CASE("A program that does not compile has one line, which is wrong") {
    CheckedProgram checked;
    checked.compiled.messages = {{"a.cpp", 3, 1, true, "expected ';'", ""},
                                 {"a.cpp", 4, 1, false, "unused variable", ""}};
    const std::vector<CheckLine> lines = check_lines(checked, true);
    CHECK(list_text(lines) == "w compiled: 1 error\n");
}

TEST_CASE("What is not written is open, and what died is wrong") {
    CheckedProgram checked = compiled_program(CheckState::died);
    checked.functions[0] = function_check("VertexShader", CheckState::not_written, 0, 0);
    checked.key_faults.emplace_back();
    checked.is_key_tested = true;
    checked.run->recording.puts.clear();
    checked.run->recording.progress.puts = 0;
    CHECK(list_text(check_lines(checked, true)) == "r compiled\n"
                                                   "r first frame: 0 pixels put\n"
                                                   "o VertexShader: not written yet\n"
                                                   "w ComputePolygonRows: 26 of 30\n"
                                                   "w picture: no pixel put\n"
                                                   "o order of pixels: not compared\n"
                                                   "w keys held: 1 fault\n");
}

TEST_CASE("What got worse is said before what got better") {
    CheckedProgram before = compiled_program(CheckState::wrong);
    CheckedProgram now = compiled_program(CheckState::right);
    now.functions[0].state = CheckState::wrong;
    const std::vector<CheckLine> old_lines = check_lines(before, true);
    CHECK(changed_lines(old_lines, check_lines(now, false)) ==
          std::vector<LineChange>{{"VertexShader was right and is wrong now.", false},
                                  {"ComputePolygonRows was wrong and is right now.", true}});
    CHECK(changed_lines(old_lines, old_lines).empty());
    // A line that is not checked yet has not changed.
    CHECK(changed_lines(check_lines(now, true), check_lines(CheckedProgram{}, true)) ==
          std::vector<LineChange>{{"The code was right and is wrong now.", false}});
}

TEST_CASE("The lines around a place are read from the source") {
    const test::TemporaryFolder folder;
    const std::string path =
        folder.write("a.cpp", "one\n\ttwo\r\nthree\x1b[31m\nvoid Draw(int);\nvoid Draw( int n )\n"
                              "{\n}\n");
    const SourceLines lines = source_lines({"", path, 2}, 1, 1);
    CHECK(lines.first == 1);
    CHECK(lines.lines == std::vector<std::string>{"one", "    two", "three\\u001b[31m"});
    CHECK(source_lines({"", path, 7}, 2, 2).lines.size() == 3);
    CHECK(source_lines({"", path, 99}, 2, 2).lines.empty());
    CHECK(source_lines({"", path + "x", 1}, 2, 2).lines.empty());
    StudentFiles files;
    files.folder = folder.file("");
    files.folder.pop_back();
    files.main = path;
    CHECK(definition_of(files, "draw").line == 5);
    CHECK(definition_of(files, "Dra").line == 0);
    CHECK(shown_path(files, path) == "a.cpp");
    CHECK(shown_path(files, "/usr/b.cpp") == "/usr/b.cpp");
}

} // namespace rasterwalk
