// What comes from a student's program, changed: its source, what the compiler and the program say,
// and what it answers and prints; and the program of the lab.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <sstream>
#include <string>

#include "code/code_machine.h"
#include "laboratory/printed_rows.h"
#include "mine/compile/compile_messages.h"
#include "mine/compile/source_text.h"
#include "mine/compile/student_files.h"
#include "mine/functions/function_checks.h"
#include "mine/program_places.h"
#include "mine/sanitizer_report.h"
#include "pipeline/event_file.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "support/changed_formats.h"

namespace rasterwalk::test {

namespace {

FileOutcome rows_outcome(const std::string& bytes, const TemporaryFolder&) {
    return text_outcome([&]() -> std::string {
        const std::size_t rows = parse_printed_rows(bytes, "x").size();
        return rows >= 1 && rows <= most_printed_rows ? "" : "its rows are none, or too many.";
    });
}

FileOutcome recording_outcome(const std::string& bytes, const TemporaryFolder&) {
    return text_outcome([&] {
        const std::string text = recording_text(parse_recording(bytes, "x"));
        return problem_of_copy(text, recording_text(parse_recording(text, "x")));
    });
}

FileOutcome source_outcome(const std::string& bytes, const TemporaryFolder&) {
    defines_main(bytes);
    function_names(bytes);
    for (const Include& include : includes_of(bytes))
        if (include.begin > include.end || include.end > bytes.size())
            return {true, "an #include is outside of it."};
    const auto lines = [](const std::string& text) {
        return std::count(text.begin(), text.end(), '\n');
    };
    for (const std::string& left : {without_comments(bytes), bare_code(bytes)})
        if (left.size() != bytes.size() || lines(left) != lines(bytes))
            return {true, "what is left of it has moved."};
    return {true, ""};
}

FileOutcome program_outcome(const std::string& bytes, const TemporaryFolder&) {
    return text_outcome([&]() -> std::string {
        const auto program = std::make_shared<const CodeProgram>(compile_code(bytes, "x"));
        CodeMachine machine(program);
        machine.allow(20'000);
        machine.allow_words(1'000'000);
        CodeEnd end = machine.begin();
        const int function = program->find_function("f");
        if (end == CodeEnd::done && function >= 0 &&
            program->functions[static_cast<std::size_t>(function)].parameters.empty()) {
            machine.call(function);
            end = machine.run();
        }
        for (const CodeCall& call : machine.calls()) {
            machine.variables(call);
            machine.line_values(call);
        }
        return end == CodeEnd::failed ? problem_of_refusal(machine.fault().sentence, true) : "";
    });
}

FileOutcome compiler_outcome(const std::string& bytes, const TemporaryFolder&) {
    const std::vector<SaidMessage> said = read_compile_messages(bytes);
    for (const SaidMessage& one : said)
        likely_cause(one.message.text);
    likely_cause(bytes);
    return {true, said.size() <= most_messages ? "" : "too many messages are kept."};
}

FileOutcome sanitizer_outcome(const std::string& bytes, const TemporaryFolder&) {
    const auto fault = parse_sanitizer_report(bytes, "/home/ada/lab");
    parse_places(bytes);
    if (!fault) return {true, ""};
    return {true, problem_of_refusal(fault->sentence, fault->place.line >= 0)};
}

const Questions& questions_of_lab() {
    static const Questions questions = [] {
        const Scene room = read_scene(lessons_folder() + "/scenes/lab-room.toml");
        const BenchTriangle bench{glm::vec3(3, 2, 1), glm::vec3(9, 14, 1), glm::vec3(21, 5, 1)};
        return make_questions(room, std::span(&bench, 1),
                              {room.camera, room.light, room.viewport, false, {}});
    }();
    return questions;
}

/// The numbers of an answer, written with blanks between them.
FileOutcome answer_outcome(const std::string& bytes, const TemporaryFolder&) {
    std::vector<double> numbers;
    std::istringstream words(bytes);
    for (std::string word; words >> word;)
        numbers.push_back(std::strtod(word.c_str(), nullptr));
    const Questions& questions = questions_of_lab();
    const Answers answers = read_answers(numbers, questions);
    check_functions(questions, answers);
    bool is_read = true;
    const auto look_at = [&](const auto& part) {
        is_read = is_read && part.end != PartEnd::unreadable;
    };
    look_at(answers.globals);
    look_at(answers.vertices);
    look_at(answers.lines);
    look_at(answers.polygons);
    look_at(answers.rows);
    look_at(answers.depths);
    look_at(answers.points);
    if (!answers.globals.answers.empty()) {
        const KnownProgram known =
            known_program(answers.globals.answers.front(), questions.program);
        const auto is_side = [](int side) { return side >= 1 && side <= 4096; };
        if (!is_side(known.viewport.width) || !is_side(known.viewport.height))
            return {is_read, "no picture has that size."};
    }
    return {is_read, ""};
}

/// What globals answer, and then a part that the program has died in.
std::vector<std::string> answer_seeds() {
    const std::string globals =
        "1 0 0 3 0 0 -3.001 1 9 1 0 0 0 1 0 0 0 1 3 1 500 5 1 14 7 2 500 500 -1 ";
    const std::string pixel = "15 250 240 0.5 0 0 1 1 1 1 ";
    return {globals + "2 0 " + pixel + "1 " + pixel,
            globals + "2 -2 -1 3 0 2 " + pixel + pixel + "1 0 ",
            globals + "4 0 2 1 " + pixel + pixel + pixel,
            globals + "3 -3 -1 5 0 2 3 4 1 1 1 4 4 0.5 0 0 ",
            globals + "6 0 1 0 1 0 ",
            globals + "7 0 1 3 4 0.5 0.5 0.5 1 0 "};
}

const std::string source_seed =
    "#include <vector>\n#include \"a.h\" // b\n#if 0\nint n\n#endif\nusing namespace std;\n"
    "struct P { int x; float z; };\nvoid f(const P& a, vector<int>& b);\n"
    "/* c\n*/ int A::g() const { return '\"' + \"}\\\"\"[0]; }\nauto r = R\"x(main())x\";\n"
    "int main(int argc, char** argv) { for (;;) { f({1, 2}, v); } return 0; }\n";

const std::string program_seed =
    "struct P { int x; float z; };\nconst int n = 3;\nvector<P> all;\nfloat sum = 0;\n"
    "int twice(int a) { return 2 * a; }\nvoid add(vector<P>& to, const P& p) {\n"
    "    to.push_back(p);\n}\nvoid f() {\n    int table[3];\n    vec3 v(1, 2, 3);\n"
    "    for (int i = 0; i < n; ++i) {\n        table[i] = twice(i) % 2;\n        P p;\n"
    "        p.x = table[i] + int(v.x);\n        p.z = glm::dot(v, v) / 2.0f;\n"
    "        add(all, p);\n    }\n    while (all.size() > 1 && sum < 9) {\n"
    "        all.resize(all.size() - 1);\n        sum += max(all[0].z, 1.0f);\n    }\n"
    "    if (!(sum == 3)) sum = -sum; else return;\n}\n";

const std::string compiler_seed =
    "In file included from a.cpp:1:\nb.h: In function 'int f()':\n"
    "a.cpp:7:38: error: 'focl' was not declared in this scope; did you mean 'focal'?\n"
    "    7 | focl\n      | ^~~~\na.cpp:8:2: error: cannot convert 'glm::vec3' {aka "
    "'glm::vec<3, float>'} to 'int'\na.cpp:9:1: note: candidate: 'void g(int)'\n"
    "a.cpp:9:1: warning: unused variable 'x' [-Wunused]\n/usr/bin/ld: a.o: in function `main':\n"
    "a.cpp:(.text+0x1): undefined reference to `f(int)'\n"
    "a.cpp:3:1: error: expected ';' before '}' token\ncollect2: error: ld returned 1\n";

const std::string sanitizer_seed =
    "0x1f\nfill(int)\n/home/ada/lab/a.cpp:6 (discriminator 2)\n??\n??:0\n=====\n"
    "==26170==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x6040 at pc 0x56 bp 0x7f\n"
    "WRITE of size 4 at 0x604000000040 thread T0\n"
    "    #0 0x5639 in std::vector<P>::operator[](unsigned long) /usr/include/c++/12/vector.h:1123\n"
    "    #1 0x563a in fill /home/ada/lab/faults.cpp:6:16\n\n"
    "0x604000000040 is located 0 bytes to the right of 48-byte region\n"
    "/home/ada/lab/a.cpp:9:5: runtime error: signed integer overflow: 2147483647 + 1 cannot be "
    "represented in type 'int'\n    #0 0x1 in g(int) /home/ada/lab/a.cpp:9\n";

const std::vector<std::string> source_words{
    "\"",      "'",        "/*",         "*/",   "//",     "\\\n",       "\\",
    "#if 0\n", "#endif\n", "#include <", "{",    "}",      "(",          ")",
    ";",       "::",       "R\"a(",      ")a\"", "main",   "<",          ">",
    "\n",      "\r\n",     "\x80",       "#",    "class ", "operator()", "template <",
    "[",       "#else\n",  "=",          "~",    "int ",   "&",          std::string(1, '\0')};

const std::vector<std::string> program_words{"(",
                                             ")",
                                             "{",
                                             "}",
                                             ";",
                                             "[",
                                             "]",
                                             "*",
                                             "&",
                                             " / 0",
                                             "%",
                                             "++",
                                             "--",
                                             "+=",
                                             "int ",
                                             "float ",
                                             "vector<",
                                             ">",
                                             "vec3",
                                             "1e999",
                                             "if (",
                                             "for (;;) ",
                                             "while (1) ",
                                             "return ",
                                             "f();",
                                             "twice(",
                                             "0.5f",
                                             "99999999999",
                                             ".x",
                                             "resize(-1)",
                                             "resize(2000000000)",
                                             "struct ",
                                             "const ",
                                             "?",
                                             ":",
                                             "!",
                                             "all[-1]",
                                             "mat3 ",
                                             "double ",
                                             "//",
                                             "/*",
                                             "\x80",
                                             "-2147483648",
                                             "int(1e30f)"};

const std::vector<std::string> message_words{":",
                                             "'",
                                             "`",
                                             "\n",
                                             "error: ",
                                             "warning: ",
                                             "note: ",
                                             "-1",
                                             "#0 0x1",
                                             " in ",
                                             " {aka '",
                                             "'}",
                                             "(",
                                             ")",
                                             "0x",
                                             "a.cpp:",
                                             "==1==ERROR: AddressSanitizer: ",
                                             "stack-overflow",
                                             "??:0",
                                             "99999999999",
                                             "no match for 'operator",
                                             "undefined reference to `",
                                             "candidate",
                                             "std::",
                                             "is not a member of 'std'",
                                             "requires ",
                                             ", but ",
                                             "has no member named '",
                                             "\x80",
                                             "runtime error: ",
                                             "DEADLYSIGNAL",
                                             "SEGV on unknown address",
                                             "/home/ada/lab/"};

} // namespace

std::vector<ChangedFormat> program_formats() {
    const std::string events = recording_text(
        {VertexEvent{{0, Phase::vertices, 0, 0}, {}, {}}, ClipEvent{{0, Phase::clip, 1, 0}, {}},
         CullEvent{{0, Phase::cull, 0, 0}, {}}, SampleEvent{{0, Phase::edges, 1, 2}, {}},
         TestEvent{{0, Phase::tests, 3, 4}, {}}, FragmentEvent{{0, Phase::rows, 5, 6}, {}}});
    return {
        {"rows",
         {"Start: (10,5). End: (10,5).\nStart: (9,6). End: (-12,6).\nv: 3\n"},
         {"Start: ", "End: ", "(", ")", ",", ".", "\n", "-", "\r", "2147483648", "-2147483648",
          " "},
         rows_outcome},
        {"recording",
         {events},
         {"\t", "\n", "=", "at=", "t0/e1/s2", "nan", "inf", "-1", "1e999", ",", "end\n", "vertex",
          "fragment", "fate=", "2147483648", "\x80", "p1:t0"},
         recording_outcome},
        {"source", {source_seed}, source_words, source_outcome, false},
        {"program", {program_seed}, program_words, program_outcome},
        {"compiler", {compiler_seed}, message_words, compiler_outcome, false},
        {"sanitizer", {sanitizer_seed}, message_words, sanitizer_outcome, false},
        {"answers",
         answer_seeds(),
         {" ", " nan ", " inf ", " -1 ", " -2 ", " -3 ", " 1e300 ", " 9007199254740993 ", " 8192 ",
          " 0 ", " 15 ", "-", "e", " 0.5 "},
         answer_outcome},
    };
}

} // namespace rasterwalk::test
