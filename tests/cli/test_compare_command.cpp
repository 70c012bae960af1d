#include "base/image.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;
using test::CliRun;
using test::run;

namespace {

CliRun compare(std::vector<std::string> more) {
    more.insert(more.begin(), {"compare", "--size", "60x50"});
    return run(more);
}

} // namespace

TEST_CASE("Two runs that are the same are reported as the same, exit code 0") {
    const CliRun result = compare({"--a", "interpolation=affine", "--b", "interpolation=affine"});
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK_THAT(result.out, ContainsSubstring("different_pixels    0 of 3000\n"));
    CHECK_THAT(result.out, ContainsSubstring("first_divergence    none\n"));
    const CliRun json = compare({"--json"});
    CHECK(json.exit_code == 0);
    CHECK_THAT(json.out, ContainsSubstring("\"different_pixels\" : 0,"));
    CHECK_THAT(json.out, ContainsSubstring("\"divergences\" : [],"));
    CHECK_THAT(json.out, ContainsSubstring("\"first_divergence\" : null,\n"));
    CHECK(json.out.ends_with("\"cause_beyond_rounding\" : null\n}\n"));
}

TEST_CASE("A difference is exit code 1, with its place, its cause and its size") {
    const CliRun result = compare({"--json", "--stage", "fill", "--b", "rounding=floor"});
    CHECK(result.exit_code == 1);
    CHECK(result.err.empty());
    CHECK_THAT(result.out, ContainsSubstring("\"first_divergence\" : \"t0/v0\""));
    CHECK_THAT(result.out, ContainsSubstring("\"cause\" : \"vertices[0]: in A projected to ("));
    CHECK_THAT(result.out, ContainsSubstring("\"rounding=truncate\""));
    CHECK_THAT(result.out, ContainsSubstring("\"rounding=floor\""));
    CHECK_THAT(result.out, ContainsSubstring("\"kind\" : \"other\""));
    CHECK_THAT(result.out, !ContainsSubstring("null"));
    const CliRun text = compare({"--stage", "fill", "--b", "rounding=floor"});
    CHECK(text.exit_code == 1);
    CHECK_THAT(text.out, StartsWith("A: rounding=truncate\nB: rounding=floor\n"));
    CHECK_THAT(
        text.out,
        ContainsSubstring("first_divergence    t0/v0\n    different value, floor: vertices[0]:"));
}

TEST_CASE("A run of the fast engine is compared by its picture") {
    const CliRun result = compare({"--b", "engine=fast"});
    CHECK(result.exit_code == 1);
    CHECK_THAT(result.out, StartsWith("A: engine=steps\nB: engine=fast\n"));
    CHECK_THAT(result.out, ContainsSubstring("Run B is drawn by the fast engine; only the steps"));
    const CliRun begun = compare({"--b", "engine=fast", "--to", "t12"});
    CHECK(begun.exit_code == 0);
    CHECK_THAT(begun.out, ContainsSubstring("divergences         0\n"));
}

TEST_CASE("A run that its engine refuses is named, since the steps draw it") {
    const CliRun result = compare({"--a", "engine=fast", "--set", "hidden=painter"});
    CHECK_THAT(result.out,
               ContainsSubstring("A: the fast engine does not support any removal of hidden "
                                 "surfaces except the depth buffer, so the steps draw\n"));
    const CliRun json = compare({"--a", "engine=rays", "--set", "hidden=painter", "--json"});
    CHECK_THAT(json.out, ContainsSubstring("\"refusals\""));
    CHECK_THAT(json.out, ContainsSubstring("A: rays do not support any removal"));
}

TEST_CASE("A bug of the laboratory is compared with the correct run") {
    const CliRun result = run({"compare", "--bug", "B9"});
    CHECK(result.exit_code == 1);
    CHECK_THAT(result.out, StartsWith("A: spans=last_dropped\nB: spans=inclusive\n"));
}

TEST_CASE("Runs are compared up to a moment") {
    const CliRun result =
        compare({"--stage", "fill", "--to", "t0", "--b", "rounding=floor", "--json"});
    CHECK(result.exit_code == 0);
}

TEST_CASE("The difference is written as a picture") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("difference.png");
    CHECK(compare({"--stage", "fill", "--b", "rounding=floor", "-o", path}).exit_code == 1);
    const Image image = read_image(path);
    CHECK(image.width == 60);
    CHECK(image.height == 50);
}

TEST_CASE("Runs that cannot be compared give a sentence and exit code 2") {
    const CliRun sizes = compare({"--b", "viewport.size=20x20"});
    CHECK(sizes.exit_code == 2);
    CHECK_THAT(sizes.err, ContainsSubstring("different sizes"));
    const CliRun name = compare({"--b", "interpolatoin=affine"});
    CHECK(name.exit_code == 2);
    CHECK_THAT(name.err, ContainsSubstring("Did you mean 'interpolation'?"));
}
