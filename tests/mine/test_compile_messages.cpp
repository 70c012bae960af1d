#include "mine/compile/compile_messages.h"

#include <string>

#include "support/catch.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;

namespace {

/// What g++ 12 and clang++ 14 say about the same source, and what the cause must name.
struct Said {
    const char* gcc;
    const char* clang;
    const char* cause;
};

std::string cause_in(const std::string& output) {
    const std::vector<SaidMessage> said = read_compile_messages(output);
    return said.empty() ? "no message" : said.front().message.cause;
}

} // namespace

TEST_CASE("The usual mistakes of beginners have a likely cause") {
    const Said all[] = {
        {"a.cpp:8:2: error: expected ',' or ';' before 'x'",
         "a.cpp:7:23: error: expected ';' at end of declaration", "semicolon is missing"},
        {"a.cpp:7:20: error: expected ';' after struct definition",
         "a.cpp:7:20: error: expected ';' after struct", "struct, class or enum ends with"},
        {"a.cpp:7:38: error: 'focl' was not declared in this scope; did you mean 'focal'?",
         "a.cpp:7:38: error: use of undeclared identifier 'focl'; did you mean 'focal'?",
         "similar name focal is"},
        {"a.cpp:7:23: error: 'Draw' was not declared in this scope",
         "a.cpp:7:79: error: use of undeclared identifier 'Draw'", "Nothing named Draw is known"},
        {"a.cpp:7:14: error: 'cout' was not declared in this scope; did you mean 'std::cout'?",
         "a.cpp:7:14: error: use of undeclared identifier 'cout'; did you mean 'std::cout'?",
         "write std::cout"},
        {"a.cpp:7:14: error: 'vec3' does not name a type",
         "a.cpp:7:14: error: unknown type name 'vec3'", "vec3 belongs to GLM"},
        {"a.cpp:7:36: error: expected '}' at end of input",
         "a.cpp:8:1: error: expected '}'\na.cpp:7:24: note: to match this '{'", "never closed"},
        {"a.cpp:7:26: error: expected declaration before '}' token",
         "a.cpp:7:26: error: extraneous closing brace ('}')", "brace too many"},
        {"a.cpp:7:63: error: invalid initialization of reference of type 'const glm::vec3&' {aka "
         "'const glm::vec<3, float, glm::packed_highp>&'} from expression of type 'glm::ivec2' "
         "{aka 'glm::vec<2, int, glm::packed_highp>'}",
         "a.cpp:7:61: error: no matching function for call to 'V'\na.cpp:7:6: note: candidate "
         "function not viable: no known conversion from 'vec<2, int, [...]>' to 'const vec<3, "
         "float, [...]>' for 1st argument",
         "type vec3 is needed here, and this is of type ivec2"},
        {"a.cpp:7:71: error: invalid initialization of reference of type 'glm::ivec2&' {aka "
         "'glm::vec<2, int, glm::packed_highp>&'} from expression of type 'Pixel'",
         "a.cpp:7:66: error: no matching function for call to 'V'\na.cpp:7:6: note: candidate "
         "function not viable: no known conversion from 'Pixel' to 'glm::ivec2 &' (aka 'vec<2, "
         "int, defaultp> &') for 2nd argument",
         "type ivec2 is needed here, and this is of type Pixel"},
        {"a.cpp:7:64: error: invalid conversion from 'const char*' to 'int' [-fpermissive]",
         "a.cpp:7:60: error: cannot initialize a variable of type 'int' with an lvalue of type "
         "'const char[3]'",
         "type int is needed here, and this is of type const char"},
        {"/usr/bin/ld: /tmp/ccVb3h1i.o: in function `main':\n/home/s/a.cpp:7: undefined reference "
         "to `VertexShader(glm::vec<3, float, (glm::qualifier)0> const&, Pixel&)'\ncollect2: "
         "error: ld returned 1 exit status",
         "/usr/bin/ld: /tmp/a-c6ce09.o: in function `main':\n/home/s/a.cpp:7: undefined reference "
         "to `VertexShader(glm::vec<3, float, (glm::qualifier)0> const&, Pixel&)'\nclang: error: "
         "linker command failed with exit code 1 (use -v to see invocation)",
         "VertexShader is declared and called, but never defined"},
        {"(.text+0x17): undefined reference to `main'",
         "(.text+0x17): undefined reference to `main'", "defines main()"},
        {"a.cpp:7:27: error: redefinition of 'int f()'\na.cpp:7:5: note: 'int f()' previously "
         "defined here",
         "a.cpp:7:27: error: redefinition of 'f'\na.cpp:7:5: note: previous definition is here",
         "already has a definition"},
        {"a.cpp:1:10: fatal error: nothing.h: No such file or directory\ncompilation terminated.",
         "a.cpp:1:10: fatal error: 'nothing.h' file not found", "no file of this name"},
        {"a.cpp:7:42: error: no match for 'operator*' in 'd * v' (operand types are 'double' and "
         "'glm::vec3' {aka 'glm::vec<3, float, glm::packed_highp>'})",
         "a.cpp:7:42: error: invalid operands to binary expression ('double' and 'glm::vec3' (aka "
         "'vec<3, float, defaultp>'))",
         "between double and vec3: vectors of GLM go with floats only"},
        {"a.cpp:7:119: error: no match for 'operator<<' in 'std::cout << p' (operand types are "
         "'std::ostream' {aka 'std::basic_ostream<char>'} and 'Pixel')",
         "a.cpp:7:119: error: invalid operands to binary expression ('std::ostream' (aka "
         "'basic_ostream<char>') and 'Pixel')",
         "cannot print a Pixel"},
        {"a.cpp:7:35: error: cannot bind non-const lvalue reference of type 'glm::vec3&' to an "
         "rvalue of type 'glm::vec3'",
         "a.cpp:7:33: error: no matching function for call to 'V'\na.cpp:7:6: note: candidate "
         "function not viable: expects an lvalue for 1st argument",
         "temporary value"},
        {"a.cpp:7:46: error: binding reference of type 'glm::vec3&' to 'const glm::vec3' discards "
         "qualifiers",
         "a.cpp:7:44: error: no matching function for call to 'W'\na.cpp:7:6: note: candidate "
         "function not viable: 1st argument ('const glm::vec3' (aka 'const vec<3, float, "
         "defaultp>')) would lose const qualifier",
         "argument is const"},
        {"a.cpp:7:89: error: assignment of read-only variable 'c'",
         "a.cpp:7:89: error: cannot assign to variable 'c' with const-qualified type 'const int'",
         "This is const"},
        {"a.cpp:7:1: error: ISO C++ forbids declaration of 'Draw' with no type [-fpermissive]",
         "a.cpp:7:1: error: C++ requires a type specifier for all declarations", "type is missing"},
        {"a.cpp:7:25: error: 'glm::ivec2' {aka 'struct glm::vec<2, int, glm::packed_highp>'} has "
         "no member named 'zinv'",
         "a.cpp:7:25: error: no member named 'zinv' in 'glm::vec<2, int, glm::packed_highp>'",
         "ivec2 has no zinv"},
        {"a.cpp:7:46: error: 'struct Pixel' has no member named 'zin'; did you mean 'zinv'?",
         "a.cpp:7:46: error: no member named 'zin' in 'Pixel'; did you mean 'zinv'?",
         "Pixel has no zin, but it has zinv"},
        {"a.cpp:7:49: error: too few arguments to function 'void V(glm::vec3&, int)'",
         "a.cpp:7:48: error: no matching function for call to 'V'\na.cpp:7:6: note: candidate "
         "function not viable: requires 2 arguments, but 1 was provided",
         "more parameters than"},
        {"a.cpp:7:55: error: too many arguments to function 'void V(glm::vec3&, int)'",
         "a.cpp:7:54: error: no matching function for call to 'V'\na.cpp:7:6: note: candidate "
         "function not viable: requires 2 arguments, but 3 were provided",
         "fewer parameters than"},
        {"a.cpp:7:31: warning: suggest parentheses around assignment used as truth value "
         "[-Wparentheses]",
         "a.cpp:7:31: warning: using the result of an assignment as a condition without "
         "parentheses [-Wparentheses]",
         "== compares"},
        {"a.cpp:7:27: error: extended character \xe2\x80\x9c is not valid in an identifier",
         "a.cpp:7:27: error: unexpected character <U+201C>", "Typographic quotes"},
        {"a.cpp:7:51: error: duplicate case value", "a.cpp:7:56: error: duplicate case value '1'",
         "Two cases"},
        {"a.cpp:7:26: error: 'a' cannot be used as a function",
         "a.cpp:7:26: error: called object type 'int' is not a function or function pointer",
         "brackets call a function"},
        {"a.cpp:8:11: error: a function-definition is not allowed here before '{' token",
         "a.cpp:8:11: error: function definition is not allowed here", "inside another one"},
        {"a.cpp:7:26: error: request for member 'x' in 'p', which is of pointer type 'Pixel*' "
         "(maybe you meant to use '->' ?)",
         "a.cpp:7:25: error: member reference type 'Pixel *' is a pointer; did you mean to use "
         "'->'?",
         "reached with ->"},
        {"a.cpp:7:16: warning: no return statement in function returning non-void [-Wreturn-type]",
         "a.cpp:7:16: warning: non-void function does not return a value [-Wreturn-type]",
         "promises a value"},
        {"a.cpp:7:61: warning: empty parentheses were disambiguated as a function declaration "
         "[-Wvexing-parse]",
         "a.cpp:7:61: warning: empty parentheses interpreted as a function declaration "
         "[-Wvexing-parse]",
         "only declares a function"},
        {"a.cpp:4:14: error: reference to 'size' is ambiguous",
         "a.cpp:4:14: error: reference to 'size' is ambiguous", "two things of this name"},
        {"a.cpp:1: error: unterminated #if", "a.cpp:1:2: error: unterminated conditional directive",
         "has no #endif"},
        {"a.cpp:1:80: error: 'strng' is not a member of 'std'",
         "a.cpp:1:80: error: no type named 'strng' in namespace 'std'", "std has no strng"},
    };
    for (const Said& said : all) {
        CAPTURE(said.gcc, said.clang);
        CHECK_THAT(cause_in(said.gcc), ContainsSubstring(said.cause));
        CHECK_THAT(cause_in(said.clang), ContainsSubstring(said.cause));
    }
}

TEST_CASE("What has several causes is given none") {
    for (const char* said :
         {"a.cpp:7:40: error: expected ';' before '<' token",
          "a.cpp:7:34: error: expected primary-expression before 'q'",
          "a.cpp:7:34: error: expected expression",
          // Which of the two was meant is not known.
          "a.cpp:7:61: error: no matching function for call to 'V'\na.cpp:7:6: note: candidate "
          "function not viable: no known conversion from 'int' to 'Pixel' for 1st argument\n"
          "a.cpp:8:6: note: candidate function not viable: requires 2 arguments, but 1 was "
          "provided",
          "a.cpp:3:1: error: something new"}) {
        CAPTURE(said);
        CHECK(cause_in(said).empty());
    }
}

TEST_CASE("A message has its place, and its notes belong to it") {
    const std::vector<SaidMessage> said =
        read_compile_messages("In file included from /home/s/a.cpp:3:\n"
                              "/home/s/a b:2.cpp: In function 'int main()':\n"
                              "/home/s/a b:2.cpp:7:69: error: redeclaration of 'int a'\n"
                              "/home/s/a b:2.cpp:6:62: note: 'int a' previously declared here\n"
                              "/usr/include/x.h:1:2: note: of no use\n"
                              "/home/s/b.cpp:12: warning: it is odd: error: or not [-Wodd]\r\n"
                              "cc1plus: error: out of memory\n"
                              "2 errors generated.\n");
    REQUIRE(said.size() == 3);
    CHECK(said[0].message.file == "/home/s/a b:2.cpp");
    CHECK(said[0].message.line == 7);
    CHECK(said[0].message.column == 69);
    CHECK(said[0].message.is_error);
    CHECK(said[0].message.text == "redeclaration of 'int a'\nline 6: 'int a' previously declared "
                                  "here");
    CHECK(said[0].notes.size() == 2);
    CHECK(said[1].message.file == "/home/s/b.cpp");
    CHECK(said[1].message.line == 12);
    CHECK(said[1].message.column == 0);
    CHECK_FALSE(said[1].message.is_error);
    CHECK(said[1].message.text == "it is odd: error: or not");
    CHECK(said[2].message.file.empty());
    CHECK(said[2].message.line == 0);
    CHECK(said[2].message.text == "out of memory");
}

TEST_CASE("An error in a template knows who used it") {
    const std::vector<SaidMessage> gcc =
        read_compile_messages("/usr/include/c++/12/x.h: In instantiation of 'void f() [with T]':\n"
                              "/usr/include/c++/12/y.h:5:6:   required from 'g'\n"
                              "/home/s/a.cpp:9:3:   required from here\n"
                              "/usr/include/c++/12/x.h:5:6: error: no type\n"
                              "/home/s/a.cpp:12:3: error: another\n");
    REQUIRE(gcc.size() == 2);
    REQUIRE(gcc[0].through.size() == 2);
    CHECK(gcc[0].through[0].file == "/home/s/a.cpp");
    CHECK(gcc[0].through[0].line == 9);
    CHECK(gcc[1].through.empty());
    const std::vector<SaidMessage> clang = read_compile_messages(
        "/usr/include/c++/12/x.h:5:6: error: no type\n"
        "/home/s/a.cpp:9:3: note: in instantiation of function template specialization 'f'\n");
    REQUIRE(clang.size() == 1);
    REQUIRE(clang[0].through.size() == 1);
    CHECK(clang[0].through[0].line == 9);
}

TEST_CASE("Each name that the linker misses is listed once") {
    const std::vector<SaidMessage> said = read_compile_messages(
        "/usr/bin/ld: /home/s/a.cpp:7: undefined reference to `Draw(int)'\n"
        "/usr/bin/ld: /home/s/a.cpp:9: undefined reference to `Draw(int)'\n"
        "/usr/bin/ld: /home/s/c.cpp:4:(.text+0xa): undefined reference to `Show()'\n"
        "/usr/bin/ld: /tmp/b.o:/home/s/b.cpp:2: multiple definition of `size'; "
        "/tmp/a.o:/home/s/a.cpp:3: first defined here\n");
    REQUIRE(said.size() == 3);
    CHECK(said[0].message.line == 7);
    CHECK(said[1].message.file == "/home/s/c.cpp");
    CHECK(said[1].message.line == 4);
    CHECK(said[2].message.file == "/home/s/b.cpp");
    CHECK(said[2].message.line == 2);
    CHECK_THAT(said[2].message.cause, ContainsSubstring("size is defined in two sources"));
}

TEST_CASE("Any output can be read") {
    for (const char* output :
         {"", "\n", ": error: ", "a.cpp:: error: ", "x:99999999999999999999:1: error: y",
          "a:1: note: alone", "undefined reference to ", "undefined reference to `'",
          "a:1:1: error: ' has no member named '", "a:1: error: did you mean '",
          "a:1: error: no match for 'operator", "a:1: error: {aka '", "a:1: error: (aka ' {aka '}",
          "a:1: error: is not a member of 'std'", "a:1: error: requires 2147483648 , but x"}) {
        CAPTURE(output);
        CHECK_NOTHROW(read_compile_messages(output));
    }
}
