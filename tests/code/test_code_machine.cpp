#include <bit>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "code/code_machine.h"
#include "tests/support/catch.h"

namespace rasterwalk::test {

namespace {

std::shared_ptr<const CodeProgram> program_of(const std::string& source,
                                              const std::vector<CodeStop>& stops = {}) {
    return std::make_shared<const CodeProgram>(compile_code(source, "lab.cpp", stops));
}

/// A machine that is about to carry out f().
CodeMachine machine_of(const std::string& source, const std::vector<CodeStop>& stops = {}) {
    const auto program = program_of(source, stops);
    CodeMachine machine(program);
    REQUIRE(machine.begin() == CodeEnd::done);
    const int function = program->find_function("f");
    REQUIRE(function >= 0);
    machine.call(function);
    return machine;
}

/// The whole number in `result` after the body of f() has been carried out.
int result_of(const std::string& body, const std::string& before = {}) {
    INFO(body);
    CodeMachine machine = machine_of("int result = 0;\n" + before + "void f() {\n" + body + "\n}");
    machine.allow(100'000);
    REQUIRE(machine.run() == CodeEnd::done);
    return std::bit_cast<int>(machine.global("result")[0]);
}

float real_of(const std::string& expression) {
    INFO(expression);
    CodeMachine machine =
        machine_of("float result = 0;\nvoid f() {\nresult = " + expression + ";\n}");
    REQUIRE(machine.run() == CodeEnd::done);
    return std::bit_cast<float>(machine.global("result")[0]);
}

CodeFault fault_of(const std::string& body) {
    INFO(body);
    CodeMachine machine =
        machine_of("int none = 0;\nvector<int> all;\nint table[3];\nvoid f() {\n" + body + "\n}");
    machine.allow(100'000);
    REQUIRE(machine.run() == CodeEnd::failed);
    return machine.fault();
}

std::string refusal_of(const std::string& source) {
    INFO(source);
    try {
        compile_code(source, "lab.cpp");
    } catch (const InputError& fault) {
        return fault.what();
    }
    return "understood";
}

} // namespace

TEST_CASE("whole numbers are computed as in C++") {
    CHECK(result_of("result = 2 + 3 * 4;") == 14);
    CHECK(result_of("result = (2 + 3) * 4;") == 20);
    CHECK(result_of("result = -7 / 2;") == -3);
    CHECK(result_of("result = -7 % 3;") == -1);
    CHECK(result_of("result = 10 - 4 - 3;") == 3);
    CHECK(result_of("int i = 5; result = i++ * 10 + i;") == 56);
    CHECK(result_of("int i = 5; result = ++i * 10 + i;") == 66);
    CHECK(result_of("result = 3; result += 4; result *= 2; result -= 1; result /= 3;") == 4);
    CHECK(result_of("result = int(-2.7f) * 100 + int(2.7);") == -198);
    CHECK(result_of("result = true ? 4 : 5;") == 4);
    CHECK(result_of("result = INT_MAX;") == 2147483647);
    CHECK(result_of("result = max(3, 8) - min(3, 8) + abs(-4);") == 9);
}

TEST_CASE("floats and doubles are computed in their own precision") {
    CHECK(real_of("0.1f + 0.2f") == 0.1f + 0.2f);
    CHECK(real_of("0.1 + 0.2f") == static_cast<float>(0.1 + 0.2f));
    CHECK(real_of("1 / 3") == 0.0f);
    CHECK(real_of("1 / 3.0f") == 1.0f / 3.0f);
    CHECK(real_of("glm::dot(vec3(1, 2, 3), vec3(4, 5, 6))") == 32.0f);
    CHECK(real_of("(vec3(1, 2, 3) * 0.5f + vec3(1)).z") == 2.5f);
    CHECK(real_of("(vec3(0, 0, 2) * mat3(vec3(0, 0, 1), vec3(0, 1, 0), vec3(1, 0, 0))).x") == 2.0f);
    CHECK(real_of("normalize(vec3(3, 0, 4)).x") == 0.6f);
    CHECK(real_of("sqrt(2)") == 1.4142135f);
}

TEST_CASE("both sides of && and || are looked at only if they matter") {
    CHECK(result_of("int zero = 0; if (zero != 0 && 1 / zero > 0) result = 1; else result = 2;") ==
          2);
    CHECK(result_of("int zero = 0; if (zero == 0 || 1 / zero > 0) result = 1;") == 1);
}

TEST_CASE("loops, breaks and functions") {
    CHECK(result_of("for (int i = 0; i < 5; ++i) { if (i == 3) continue; result += i; }") == 7);
    CHECK(result_of("for (int i = 0; ; ++i) { if (i == 3) break; result += i; }") == 3);
    CHECK(result_of("int i = 0; while (i < 4) { i += 2; result += i; }") == 6);
    CHECK(result_of("result = twice(4) + twice(1);", "int twice(int a) { return 2 * a; }\n") == 10);
    CHECK(result_of("int a = 3; grow(a); grow(a); result = a;",
                    "void grow(int& a) { a *= 2; }\n") == 12);
    CHECK(result_of("result = down(5);",
                    "int down(int n) { if (n == 0) return 0; return n + down(n - 1); }\n") == 15);
}

TEST_CASE("vectors keep their own elements") {
    CHECK(
        result_of("vector<int> a(3, 7); vector<int> b = a; b[1] = 1; result = a[1] * 10 + b[1];") ==
        71);
    CHECK(
        result_of("vector<int> a; a.push_back(4); a.push_back(6); result = a.size() * a.back();") ==
        12);
    CHECK(result_of("vector<int> a{1, 2, 3}; for (const int& x : a) result += x;") == 6);
    CHECK(result_of("vector<int> a(2); for (int& x : a) x += 5; result = a[0] + a[1];") == 10);
    CHECK(result_of("vector<int> a(2); fill(a); result = a.size() * 10 + a[2];",
                    "void fill(vector<int>& a) { a.resize(3); a[2] = 9; }\n") == 39);
    CHECK(result_of("vector<int> a = made(); result = a[1];",
                    "vector<int> made() { vector<int> a(2); a[1] = 8; return a; }\n") == 8);
}

TEST_CASE("structs, arrays and references") {
    const std::string pixel = "struct Pixel { int x, y; float zinv; vec3 pos; };\n";
    CHECK(result_of("Pixel p; p.x = 3; Pixel q = p; q.x = 4; result = p.x * 10 + q.x;", pixel) ==
          34);
    CHECK(result_of("Pixel p = {1, 2, 0.5f}; result = p.x + p.y + int(p.zinv * 4);", pixel) == 5);
    CHECK(result_of(
              "vector<Pixel> all(2); Pixel& p = all[1]; p.pos.z = 6; result = int(all[1].pos.z);",
              pixel) == 6);
    CHECK(result_of("table[1][2] = 5; result = table[1][2] + table[2][1];",
                    "const int W = 2 + 1;\nint table[3][W];\n") == 5);
}

TEST_CASE("what a program does wrong is said with its line") {
    const CodeFault above = fault_of("all.resize(3);\nall[3] = 1;");
    CHECK(above.line == 6);
    CHECK(above.sentence == "There is no element [3]: they are [0] to [2].");
    CHECK(fault_of("all[0] = 1;").sentence == "There is no element [0]: the vector is empty.");
    CHECK(fault_of("int i = -1; table[i] = 1;").sentence ==
          "There is no element [-1]: they are [0] to [2].");
    CHECK(fault_of("none = 1 / none;").sentence == "A whole number is divided by 0.");
    CHECK(fault_of("all.resize(-1);").sentence == "A vector cannot have -1 elements.");
    CHECK(fault_of("all.resize(2000000000);").sentence ==
          "The vectors need more memory than there is.");
}

TEST_CASE("a loop without an end is stopped") {
    CodeMachine machine = machine_of("void f() { while (true) ; }");
    machine.allow(1000);
    CHECK(machine.run() == CodeEnd::too_long);
    CodeMachine deep = machine_of("void f() { f(); }");
    CHECK(deep.run() == CodeEnd::failed);
    CHECK(deep.fault().sentence == "The functions call each other too deeply.");
}

TEST_CASE("what is not understood is said with its line") {
    CHECK(refusal_of("void f() {\n  int a = 1\n}") == "lab.cpp:2: `;` is missing before `}`.");
    CHECK(refusal_of("void f() {\n  lenght = 1;\n}\nint length;") ==
          "lab.cpp:2: `lenght` is not declared here. Did you mean 'length'?");
    CHECK(refusal_of("void f() { int a; int a; }") ==
          "lab.cpp:1: There is a variable `a` here already.");
    CHECK(refusal_of("void f() { const int a = 1; a = 2; }") ==
          "lab.cpp:1: This is const, so nothing can be assigned to it.");
    CHECK(refusal_of("void f() { vec3 a = 2.0 * vec3(1); }") ==
          "lab.cpp:1: There is no double * vec3: a number like 2.0f is a float.");
    CHECK(refusal_of("void f() { int* p; }") == "lab.cpp:1: Pointers are not understood here.");
    CHECK(refusal_of("/* \n\n") == "lab.cpp:1: This comment does not end: */ is missing.");
    CHECK(refusal_of("void f() { g(1); }\nvoid g(int a, int b) {}") ==
          "lab.cpp:1: g takes 2, not 1.");
    CHECK(refusal_of("void f() { " + std::string(5000, '(')) ==
          "lab.cpp:1: This is nested too deeply.");
}

TEST_CASE("what needs too much room is refused, or ends") {
    const std::string big = "struct Big { vec4 a; vec4 b; vec4 c; vec4 d; };\n"
                            "struct Huge { Big a; Big b; Big c; Big d; Big e; Big f; };\n";
    std::string parameters = "Huge p0";
    for (int i = 1; i < 300; ++i)
        parameters += ", Huge p" + std::to_string(i);
    CHECK(refusal_of(big + "void f(" + parameters + ") {\n}\n") ==
          "lab.cpp:3: The parameters of f need too much room.");
    std::string nested = "struct S0 { vec4 a; };\n";
    for (int i = 1; i < 60; ++i)
        nested += "struct S" + std::to_string(i) + " { S" + std::to_string(i - 1) + " a; S" +
                  std::to_string(i - 1) + " b; };\n";
    CHECK(refusal_of(nested).find("need too much room.") != std::string::npos);
    CHECK(refusal_of("struct E { };\n") == "lab.cpp:1: A struct needs members: E has none.");
    CHECK(refusal_of("void f() {\nfloat a = 1e39f;\n}") ==
          "lab.cpp:2: The number 1e39f is too large.");

    // Memory counts as lines do.
    CodeMachine greedy = machine_of("void f() {\nwhile (true) {\nvector<int> v(1000000);\n}\n}");
    greedy.allow(1'000'000);
    CHECK(greedy.run() == CodeEnd::too_long);
    CHECK(greedy.lines() < 1000);
    CodeMachine endless(program_of("int f() {\nwhile (true) {\n}\nreturn 1;\n}\nint g = f();\n"));
    CHECK(endless.begin() == CodeEnd::too_long);
}

TEST_CASE("the machine pauses before lines, and shows what they computed") {
    const std::string source = "int total = 0;\n"
                               "void add(int a) {\n"
                               "    total += a;\n"
                               "}\n"
                               "void f() {\n"
                               "    for (int i = 0; i < 3; ++i)\n"
                               "        add(10 * i);\n"
                               "}\n";
    CodeMachine machine = machine_of(source);
    const std::vector<int> lines{6, 7, 3, 4, 6, 7, 3, 4, 6, 7, 3, 4, 6, 8};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        INFO("step " << i);
        REQUIRE(machine.step_line() == CodeEnd::paused);
        CHECK(machine.calls().back().line == lines[i]);
    }
    CHECK(machine.step_line() == CodeEnd::done);
    CHECK(machine.lines() == static_cast<std::int64_t>(lines.size()));

    CodeMachine again = machine_of(source);
    again.pause_at(8);
    REQUIRE(again.run() == CodeEnd::paused);
    REQUIRE(again.calls().size() == 2);
    CHECK(again.calls()[0].line == 7);
    CHECK(again.calls()[1].line == 4);
    const std::vector<CodeLineValue> values = again.line_values(again.calls()[1]);
    REQUIRE(values.size() == 1);
    CHECK(values[0].line == 3);
    CHECK(values[0].text == "10");
    const std::vector<CodeShown> variables = again.variables(again.calls()[0]);
    REQUIRE(variables.size() == 1);
    CHECK(variables[0].name == "i");
    CHECK(variables[0].value == "1");
}

TEST_CASE("a condition of a line stops the machine there") {
    CodeMachine machine = machine_of("void f() {\n"
                                     "    for (int y = 3; y > -3; --y) {\n"
                                     "        int z = y * y;\n"
                                     "    }\n"
                                     "}\n",
                                     {{3, "y < 0"}});
    REQUIRE(machine.run() == CodeEnd::paused);
    CHECK(machine.calls().back().line == 3);
    CHECK(machine.variables(machine.calls().back())[0].value == "-1");
    REQUIRE(machine.run() == CodeEnd::paused);
    CHECK(machine.variables(machine.calls().back())[0].value == "-2");
    CHECK(machine.run() == CodeEnd::done);
}

TEST_CASE("marks lead to a round of a loop, and rounds before it can be skipped") {
    const std::string source = "void f() {\n"
                               "    for (int i = 0; i < 100; ++i) {\n"
                               "        int a = 2 * i; //@ each row i\n"
                               "        int b = a + 1;\n"
                               "    }\n"
                               "}\n";
    for (const bool skips : {false, true}) {
        INFO(skips);
        CodeMachine machine = machine_of(source);
        if (skips) machine.skip_to(0, 40);
        machine.pause_when([](std::size_t, std::span<const int> marks) { return marks[0] == 40; });
        REQUIRE(machine.run() == CodeEnd::paused);
        CHECK(machine.calls().back().line == 3);
        CHECK(machine.lines() == (skips ? 41 : 121));
        REQUIRE(machine.step_line() == CodeEnd::paused);
        CHECK(machine.line_values(machine.calls().back())[1].text == "80");
    }
}

} // namespace rasterwalk::test
