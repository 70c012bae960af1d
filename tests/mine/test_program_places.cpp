#include "mine/program_places.h"

#include <algorithm>
#include <string>
#include <vector>

#include "support/catch.h"

using namespace rasterwalk;

namespace {

/// What addr2line -a -f -i -C (binutils 2.40) prints for four addresses: in a function with another
/// one inlined in it, in a loop, in the C library, and in no function at all.
const std::string printed = "0x0000000000001a2c\n"
                            "glm::vec<3, float, (glm::qualifier)0>::operator[](int)\n"
                            "/usr/include/glm/detail/type_vec3.inl:196\n"
                            "DrawPolygonRows(std::vector<Pixel, std::allocator<Pixel> > const&)\n"
                            "/home/ada/lab/skeleton.cpp:142 (discriminator 2)\n"
                            "0x0000000000001b00\n"
                            "main\n"
                            "/home/ada/lab/skeleton.cpp:61\n"
                            "0x0000000000002000\n"
                            "__libc_start_main\n"
                            "??:?\n"
                            "0x0000000000002fff\n"
                            "??\n"
                            "??:0\n";

} // namespace

TEST_CASE("What addr2line prints is read, with functions that are inlined") {
    const auto places = parse_places(printed);
    REQUIRE(places.size() == 4);
    REQUIRE(places[0].size() == 2);
    CHECK(places[0][0] == ProgramPlace{"glm::vec<3, float, (glm::qualifier)0>::operator[](int)",
                                       "/usr/include/glm/detail/type_vec3.inl", 196});
    CHECK(places[0][1] ==
          ProgramPlace{"DrawPolygonRows(std::vector<Pixel, std::allocator<Pixel> > const&)",
                       "/home/ada/lab/skeleton.cpp", 142});
    REQUIRE(places[1].size() == 1);
    CHECK(places[1][0] == ProgramPlace{"main", "/home/ada/lab/skeleton.cpp", 61});
    REQUIRE(places[2].size() == 1);
    CHECK(places[2][0] == ProgramPlace{"__libc_start_main", "", 0});
    REQUIRE(places[3].size() == 1);
    CHECK(places[3][0] == ProgramPlace{});
}

TEST_CASE("A file whose line is not known has none") {
    const auto places = parse_places("0x10\nmain\n/home/ada/lab/skeleton.cpp:?\n");
    REQUIRE(places.size() == 1);
    REQUIRE(places[0].size() == 1);
    CHECK(places[0][0] == ProgramPlace{"main", "/home/ada/lab/skeleton.cpp", 0});
}

TEST_CASE("A folder may have blanks, parentheses and colons in its name") {
    const auto places =
        parse_places("0x10\nmain\n/home/ada/My lab (1): new/main.cpp:7 (discriminator 3)\n"
                     "0x20\nmain\n/home/ada/My lab (1): new/main.cpp:8\n");
    REQUIRE(places.size() == 2);
    CHECK(places[0] ==
          std::vector<ProgramPlace>{{"main", "/home/ada/My lab (1): new/main.cpp", 7}});
    CHECK(places[1] ==
          std::vector<ProgramPlace>{{"main", "/home/ada/My lab (1): new/main.cpp", 8}});
}

TEST_CASE("Text that is cut off or makes no sense gives no place") {
    CHECK(parse_places("").empty());
    CHECK(parse_places("addr2line: 'program': No such file\n").empty());
    const auto cut = parse_places("0x10\nmain");
    REQUIRE(cut.size() == 1);
    REQUIRE(cut[0].size() == 1);
    CHECK(cut[0][0] == ProgramPlace{"main", "", 0});
    CHECK(parse_places("0x10").size() == 1);
    const auto large = parse_places("0x10\nmain\n/a.cpp:99999999999999999999\n");
    REQUIRE(large.size() == 1);
    CHECK(large[0][0].line == 0);
}

TEST_CASE("The innermost place in the student's folder is taken") {
    const auto places = parse_places(printed);
    const ProgramPlace* place = innermost_in(places, "/home/ada/lab");
    REQUIRE(place != nullptr);
    CHECK(place->line == 142);
    const auto outer = std::vector(places.begin() + 1, places.end());
    place = innermost_in(outer, "/home/ada/lab");
    REQUIRE(place != nullptr);
    CHECK(place->line == 61);
    CHECK(innermost_in(places, "/home/bob") == nullptr);
    CHECK(innermost_in({}, "/home/ada/lab") == nullptr);
    // A place without a line says nothing.
    CHECK(innermost_in(parse_places("0x10\nmain\n/home/ada/lab/a.cpp:?\n"), "/home/ada/lab") ==
          nullptr);
}

TEST_CASE("A folder whose name begins like the student's is another folder") {
    const auto places = parse_places("0x10\nmain\n/home/ada/lab2/main.cpp:7\n");
    CHECK(innermost_in(places, "/home/ada/lab") == nullptr);
    CHECK(innermost_in(places, "/home/ada/lab2") != nullptr);
    CHECK(innermost_in(places, "/home/ada/lab2/") != nullptr);
    CHECK(innermost_in(places, "/home/ada/lab2/main.cpp") != nullptr);
}

TEST_CASE("A program that is not there has no places") {
    const std::vector<std::uint64_t> addresses{0x10};
    CHECK(places_of("/nonexistent/program", addresses).empty());
    CHECK(places_of("/nonexistent/program", {}).empty());
}
