#include "cli/cli.h"

#include <string>

#include "cli/json.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using test::CliRun;
using test::run;

TEST_CASE("code shows the line that comes next, and who called") {
    const CliRun result =
        run({"code", "--scene", "scenes/one-triangle.toml", "--stage", "rows", "--to", "t0/e1/s4"});
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK(result.out.find("t0/e1/s4: this line comes next.\nComputePolygonRows at rows.cpp:33\n"
                          "    int row = line[k].y - ymin;\nDrawPolygon at draw.cpp:") == 0);
    CHECK(result.out.find("\nk = 4\n") != std::string::npos);
}

TEST_CASE("code --json has the function, the file, the line and the values") {
    const CliRun result = run({"code", "--to", "t12/e1/s7", "--lines", "1", "--json"});
    REQUIRE(result.exit_code == 0);
    const Json answer = Json::parse(result.out);
    CHECK(answer.at("cursor") == "t12/e1/s7");
    CHECK(answer.at("lines") == 1);
    const Json& inner = answer.at("calls").at(0);
    CHECK(inner.at("function") == "ComputePolygonRows");
    CHECK(inner.at("file") == "rows.cpp");
    CHECK(inner.at("text") == "if (row < 0 || row >= rows)");
    CHECK(inner.at("values").at("k") == "7");
    CHECK(answer.at("calls").size() == 3);
}

TEST_CASE("code has the right line next to that of a mistake") {
    const CliRun result =
        run({"code", "--stage", "depth", "--set", "depth_test=reversed", "--to", "t12/r7/c3"});
    CHECK(result.out.find("    if (p.zinv < depthBuffer[p.y][p.x])\n"
                          "    right: if (p.zinv > depthBuffer[p.y][p.x])\n") != std::string::npos);
}

TEST_CASE("code --json has the right lines of a mistake, and none where it has added one") {
    const CliRun reversed = run({"code", "--stage", "depth", "--set", "depth_test=reversed", "--to",
                                 "t12/r7/c3", "--json"});
    REQUIRE(reversed.exit_code == 0);
    const Json line = Json::parse(reversed.out).at("calls").at(0);
    CHECK(line.at("right") == Json::array({"if (p.zinv > depthBuffer[p.y][p.x])"}));
    const CliRun right = run({"code", "--stage", "depth", "--to", "t12/r7/c3", "--json"});
    CHECK_FALSE(Json::parse(right.out).at("calls").at(0).contains("right"));
    // A line that the right program does not have.
    const CliRun clamped = run(
        {"code", "--set", "outside_picture=clamped", "--to", "t0/v0", "--lines", "10", "--json"});
    REQUIRE(clamped.exit_code == 0);
    const Json added = Json::parse(clamped.out).at("calls").at(0);
    CHECK(added.at("text").get<std::string>().find("clamp(p.") != std::string::npos);
    CHECK(added.at("right") == Json::array());
}

TEST_CASE("code says what it has no lines for") {
    const CliRun result = run({"code", "--set", "stage=depth", "--set", "depth_test=raced"});
    CHECK(result.exit_code == 2);
    CHECK(
        result.err.find("there is no code yet for this picture: \"Depth test: by two threads\".") !=
        std::string::npos);
}
