#include "base/element_names.h"

#include "tests/support/catch.h"

using namespace rasterwalk;

TEST_CASE("The pieces of a frame are named as a C++ program counts them, from 0") {
    CHECK(triangle_name(0) == "triangles[0]");
    CHECK(triangle_name(29) == "triangles[29]");
    CHECK(vertex_name(2) == "vertices[2]");
    CHECK(edge_name(1) == "edge 1");
    CHECK(sample_name(1, 4) == "edge 1, line[4]");
    CHECK(element_name(entry_form, 7) == "entry [7]");
    CHECK(element_name("sign of the area", 7) == "sign of the area");
    CHECK(short_triangle_name(29) == "t29");
    CHECK(short_vertex_name(0) == "v0");
}

TEST_CASE("The total is given only after brackets, where it cannot seem to count from 1") {
    CHECK(element_name_of(sample_form, 4, 11) == "line[4] of 11");
    CHECK(element_name_of(triangle_form, 29, 30) == "triangles[29] of 30");
    CHECK(element_name_of(edge_form, 1, 3) == "edge 1");
    CHECK(element_name_of("sign of the area", 0, 1) == "sign of the area");
}
