// Model files on the command line: their counts, and what is wrong in them.

#include <string>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "cli/run.h"
#include "opening/opened_view.h"
#include "support/temporary_folder.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string model_text = "s off\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 9\n";
const std::string wrong_face = ":7: 'f' names point 9, but the file has 4; the face is left out.";

} // namespace

TEST_CASE("stats counts what a model file holds, and reports what is left out") {
    const TemporaryFolder folder;
    const std::string path = folder.write("m.obj", model_text);
    const CliRun text = run({"stats", path});
    CHECK(text.exit_code == 0);
    CHECK_THAT(text.out, ContainsSubstring("\nmodel.positions         4\n"));
    CHECK_THAT(text.out, ContainsSubstring("\nmodel.faces             1\n"));
    CHECK_THAT(text.out, ContainsSubstring("\nmodel.triangles         2\n"));
    CHECK_THAT(text.err, ContainsSubstring("rasterwalk: " + path + wrong_face + "\n"));
    CHECK_THAT(text.err,
               ContainsSubstring("rasterwalk: " + path + ":1: 1 statement 's' is skipped: "));
    const nlohmann::json json = nlohmann::json::parse(run({"stats", "--json", path}).out);
    CHECK(json["triangles"] == 2);
    CHECK(json["model"]["counts"]["corners"] == 4);
    CHECK(json["model"]["faults"] == nlohmann::json::array({path + wrong_face}));
    CHECK(json["model"]["skipped"].size() == 1);
    // A scene has no such numbers.
    CHECK(run({"stats"}).out.find("model.") == std::string::npos);
}

TEST_CASE("render and stats point out what is correct in a model but easily overlooked") {
    const TemporaryFolder folder;
    folder.write("m.mtl", "newmtl a\nKd 0 0 0\nd 0\n");
    const std::string path =
        folder.write("m.obj", "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    const std::string black = folder.file("m.mtl") +
                              ":2: the material 'a' is black because its Kd is 0 and it has no "
                              "map_Kd.";
    const std::string clear =
        folder.file("m.mtl") + ":3: the material 'a' is fully transparent because its alpha is 0.";
    const CliRun drawn = run({"render", "--scene", path, "-o", folder.file("m.png")});
    CHECK(drawn.exit_code == 0);
    CHECK(drawn.err == "rasterwalk: " + clear + "\nrasterwalk: " + black + "\n");
    const CliRun counted = run({"stats", "--json", path});
    CHECK_THAT(counted.err, ContainsSubstring(clear) && ContainsSubstring(black));
    CHECK(nlohmann::json::parse(counted.out)["model"]["notes"] ==
          nlohmann::json::array({clear, black}));
}

TEST_CASE("A model with faults opens, and the first fault is shown with it") {
    const TemporaryFolder folder;
    ViewOptions options;
    options.file = folder.write("m.obj", model_text);
    CHECK(open_view(options).notice == options.file + wrong_face);
    options.file = folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    CHECK(open_view(options).notice.empty());
}

TEST_CASE("check and stats end with the documented exit codes for models") {
    const TemporaryFolder folder;
    const std::string wrong = folder.write("m.obj", model_text);
    const CliRun checked = run({"check", wrong});
    CHECK(checked.exit_code == static_cast<int>(ExitCode::difference));
    CHECK(checked.out == wrong + wrong_face + "\n");
    const std::string junk = folder.write("junk.obj", "no model\n");
    const CliRun refused = run({"stats", junk});
    CHECK(refused.exit_code == static_cast<int>(ExitCode::bad_input));
    CHECK_THAT(refused.err,
               ContainsSubstring(junk + ":1: there is no face in this file that can be drawn."));
    CHECK(run({"stats", folder.file("none.obj")}).exit_code ==
          static_cast<int>(ExitCode::no_access));
}
