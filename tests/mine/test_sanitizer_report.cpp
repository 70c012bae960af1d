// What sanitizers really print: g++ 12.2 and clang++ 14.0, cut off where nothing new follows.

#include "mine/sanitizer_report.h"

#include <string>

#include "support/catch.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string folder = "/home/ada/lab";

/// A vector that is written beyond its end; the second stack is where it was made.
const std::string overflow_of_gcc = R"(some output of the program
=================================================================
==26170==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x604000000040 at pc 0x5639b88063a4 bp 0x7fffb318e640 sp 0x7fffb318e638
WRITE of size 4 at 0x604000000040 thread T0
    #0 0x5639b88063a3 in std::vector<Pixel, std::allocator<Pixel> >::operator[](unsigned long) /usr/include/c++/12/bits/stl_vector.h:1123
    #1 0x5639b88063a3 in fill /home/ada/lab/faults.cpp:6
    #2 0x5639b8806854 in main /home/ada/lab/faults.cpp:16
    #3 0x7f7766245249 in __libc_start_call_main ../sysdeps/nptl/libc_start_call_main.h:58
    #4 0x5639b8806230 in _start (/home/ada/lab/program+0x5230)

0x604000000040 is located 0 bytes to the right of 48-byte region [0x604000000010,0x604000000040)
allocated by thread T0 here:
    #0 0x7f77670b94c8 in operator new(unsigned long) ../../../../src/libsanitizer/asan/asan_new_delete.cpp:95
    #1 0x5639b880788f in std::_Vector_base<Pixel, std::allocator<Pixel> >::_M_allocate(unsigned long) /usr/include/c++/12/bits/stl_vector.h:378
    #2 0x5639b880681a in main /home/ada/lab/faults.cpp:15

SUMMARY: AddressSanitizer: heap-buffer-overflow /home/ada/lab/faults.cpp:6 in fill
)";

const std::string overflow_of_clang =
    R"(=================================================================
==26240==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x6040000000c0 at pc 0x5588c55c8e54 bp 0x7ffe9e1c4590 sp 0x7ffe9e1c4588
WRITE of size 4 at 0x6040000000c0 thread T0
    #0 0x5588c55c8e53 in fill(std::vector<Pixel, std::allocator<Pixel> >&, int) /home/ada/lab/faults.cpp:6:16
    #1 0x5588c55c87f8 in main /home/ada/lab/faults.cpp:16:21
    #2 0x7feeb2765249 in __libc_start_call_main csu/../sysdeps/nptl/libc_start_call_main.h:58:16
    #3 0x5588c5508360 in _start (/home/ada/lab/program+0x23360) (BuildId: 101a6a1146b15f9c8537262c8d68b9a867f32feb)

0x6040000000c0 is located 0 bytes to the right of 48-byte region [0x604000000090,0x6040000000c0)
allocated by thread T0 here:
    #0 0x5588c55c5f7d in operator new(unsigned long) (/home/ada/lab/program+0xe0f7d) (BuildId: 101a6a1146b15f9c8537262c8d68b9a867f32feb)
    #1 0x5588c55c87be in main /home/ada/lab/faults.cpp:15:24
)";

const std::string endless_of_gcc = R"(AddressSanitizer:DEADLYSIGNAL
=================================================================
==26188==ERROR: AddressSanitizer: stack-overflow on address 0x7ffc391d8ffc (pc 0x56268449e3c5 bp 0x7ffc391d9190 sp 0x7ffc391d8ff0 T0)
    #0 0x56268449e3c5 in endless /home/ada/lab/faults.cpp:8
    #1 0x56268449e5ab in endless /home/ada/lab/faults.cpp:11
    #2 0x56268449e5ab in endless /home/ada/lab/faults.cpp:11
)";

/// A null pointer: the check of undefined behaviour sees it first, then the signal comes.
const std::string null_of_clang =
    R"(/home/ada/lab/faults.cpp:20:77: runtime error: member access within null pointer of type 'Pixel'
SUMMARY: UndefinedBehaviorSanitizer: undefined-behavior /home/ada/lab/faults.cpp:20:77 in 
AddressSanitizer:DEADLYSIGNAL
=================================================================
==26264==ERROR: AddressSanitizer: SEGV on unknown address 0x000000000004 (pc 0x55f060eddb67 bp 0x7ffddf923060 sp 0x7ffddf922e80 T0)
==26264==The signal is caused by a READ memory access.
==26264==Hint: address points to the zero page.
    #0 0x55f060eddb67 in main /home/ada/lab/faults.cpp:21:77
)";

SanitizerFault fault_in(const std::string& printed, const std::string& where = folder) {
    const std::optional<SanitizerFault> fault = parse_sanitizer_report(printed, where);
    REQUIRE(fault.has_value());
    return *fault;
}

std::string with_folder(std::string text, const std::string& other) {
    for (std::size_t at = text.find(folder); at != std::string::npos;
         at = text.find(folder, at + other.size()))
        text.replace(at, folder.size(), other);
    return text;
}

} // namespace

TEST_CASE("A program that prints no fault has none") {
    CHECK_FALSE(parse_sanitizer_report("", folder).has_value());
    CHECK_FALSE(parse_sanitizer_report("Render time: 120 ms.\n#0 in main\n", folder).has_value());
    CHECK_FALSE(parse_sanitizer_report("ERROR: could not read the file\n", folder).has_value());
}

TEST_CASE("A vector written beyond its end: the place is where it was written") {
    const SanitizerFault gcc = fault_in(overflow_of_gcc);
    CHECK(gcc.kind == "heap-buffer-overflow");
    CHECK(gcc.place == ProgramPlace{"fill", "/home/ada/lab/faults.cpp", 6});
    CHECK_THAT(gcc.sentence, ContainsSubstring("beyond the end of a vector"));

    const SanitizerFault clang = fault_in(overflow_of_clang);
    CHECK(clang.kind == "heap-buffer-overflow");
    CHECK(clang.place == ProgramPlace{"fill(std::vector<Pixel, std::allocator<Pixel> >&, int)",
                                      "/home/ada/lab/faults.cpp", 6});
    CHECK(clang.sentence == gcc.sentence);
}

TEST_CASE("Calls without an end: the place is the innermost call") {
    const SanitizerFault fault = fault_in(endless_of_gcc);
    CHECK(fault.kind == "stack-overflow");
    CHECK(fault.place.line == 8);
    CHECK(fault.place.function == "endless");
    CHECK_THAT(fault.sentence, ContainsSubstring("a function calls itself without an end"));
}

TEST_CASE("The first fault counts, not what follows from it") {
    const SanitizerFault fault = fault_in(null_of_clang);
    CHECK(fault.kind == "member access within null pointer of type 'Pixel'");
    CHECK(fault.place == ProgramPlace{"", "/home/ada/lab/faults.cpp", 20});
    CHECK(fault.sentence == "It uses a pointer that leads nowhere.");
}

TEST_CASE("Undefined arithmetic is named in plain words") {
    struct Expected {
        std::string printed, kind, part;
    };
    for (const Expected& expected :
         {Expected{"18:48: runtime error: signed integer overflow: 2147483647 + 2 cannot be "
                   "represented in type 'int'",
                   "signed integer overflow: 2147483647 + 2 cannot be represented in type 'int'",
                   "more than an int can hold"},
          Expected{"18:73: runtime error: 2e+20 is outside the range of representable values of "
                   "type 'int'",
                   "2e+20 is outside the range of representable values of type 'int'",
                   "a number that is too large for one, or of NaN"},
          Expected{"18:73: runtime error: -nan is outside the range of representable values of "
                   "type 'int'",
                   "-nan is outside the range of representable values of type 'int'", "NaN"},
          Expected{"18:55: runtime error: division by zero", "division by zero",
                   "It divides by zero."},
          Expected{"18:9: runtime error: index 400 out of bounds for type 'float [400]'",
                   "index 400 out of bounds for type 'float [400]'",
                   "an index that the array does not have"},
          Expected{"18:9: runtime error: load of value 190, which is not a valid value for type "
                   "'bool'",
                   "load of value 190, which is not a valid value for type 'bool'",
                   "does not define"}}) {
        CAPTURE(expected.printed);
        const SanitizerFault fault =
            fault_in("frame 1\n/home/ada/lab/faults.cpp:" + expected.printed + "\nmore\n");
        CHECK(fault.kind == expected.kind);
        CHECK_THAT(fault.sentence, ContainsSubstring(expected.part));
        CHECK(fault.place.line == 18);
        CHECK(fault.place.file == "/home/ada/lab/faults.cpp");
    }
}

TEST_CASE("Only places in the student's folder are named") {
    CHECK(fault_in(overflow_of_gcc, "/home/bob/lab").place == ProgramPlace{});
    CHECK(fault_in(overflow_of_gcc, "/home/ada/la").place == ProgramPlace{});
    CHECK(fault_in("/usr/include/glm/x.inl:7:3: runtime error: division by zero\n").place ==
          ProgramPlace{});
    CHECK(fault_in(null_of_clang, "/home/ada/la").place == ProgramPlace{});
}

TEST_CASE("A fault in a library is the student's line that called it") {
    const SanitizerFault fault =
        fault_in("/usr/include/c++/12/bits/stl_vector.h:1123:34: runtime error: reference binding "
                 "to null pointer of type 'Pixel'\n"
                 "    #0 0x55f0 in std::vector<Pixel>::operator[](unsigned long) "
                 "/usr/include/c++/12/bits/stl_vector.h:1123\n"
                 "    #1 0x55f1 in DrawPolygonRows(std::vector<Pixel> const&) "
                 "/home/ada/lab/faults.cpp:33\n");
    CHECK(fault.place == ProgramPlace{"DrawPolygonRows(std::vector<Pixel> const&)",
                                      "/home/ada/lab/faults.cpp", 33});
}

TEST_CASE("A folder may have blanks and parentheses in its name") {
    const std::string other = "/home/ada/My lab in C (1)";
    for (const std::string& text : {overflow_of_gcc, overflow_of_clang}) {
        const SanitizerFault fault = fault_in(with_folder(text, other), other);
        CHECK(fault.place.file == other + "/faults.cpp");
        CHECK(fault.place.line == 6);
        CHECK(fault.place.function.starts_with("fill"));
    }
    const SanitizerFault fault = fault_in(with_folder(null_of_clang, other), other);
    CHECK(fault.place == ProgramPlace{"", other + "/faults.cpp", 20});
}
