// Alpha as scenes and materials of models give it.

#include <string>
#include <vector>

#include "base/error.h"
#include "scene/read_mtl.h"
#include "scene/read_scene.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;

namespace {
namespace alpha_in_files {

Scene scene_with(const std::string& material, const std::string& part) {
    return parse_scene("name = \"s\"\n[points.p]\nA = [0, 0, 1]\nB = [1, 0, 1]\nC = [0, 1, 1]\n"
                       "[materials.glass]\n" +
                           material + "[[part]]\nname = \"q\"\npoints = \"p\"\n" + part +
                           "triangles = [\"A B C\"]\n",
                       "s.toml");
}

std::string refusal(const std::string& material, const std::string& part) {
    try {
        scene_with(material, part);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

struct Mtl {
    ObjReport report;
    std::vector<ObjMaterial> materials;
};

Mtl mtl_of(const std::string& text) {
    Mtl mtl;
    ObjReporter reporter(mtl.report);
    const ReadingWatch none;
    WatchedSteps watched(none);
    parse_mtl("newmtl m\n" + text, "m.mtl", "m.obj", watched, reporter, mtl.materials);
    REQUIRE(mtl.materials.size() == 1);
    return mtl;
}

} // namespace alpha_in_files
} // namespace

TEST_CASE("A part has its alpha, or that of its material, or is opaque") {
    using namespace alpha_in_files;
    CHECK(alpha_of(scene_with("alpha = 0.25\n", "material = \"glass\"\n"), 0) == 0.25f);
    CHECK(alpha_of(scene_with("", "alpha = 0.5\n"), 0) == 0.5f);
    CHECK(alpha_of(scene_with("", ""), 0) == 1.0f);
    CHECK(has_alpha(scene_with("", "alpha = 0\n")));
    CHECK_FALSE(has_alpha(scene_with("alpha = 0.25\n", "")));
    CHECK_THAT(refusal("alpha = 2\n", ""),
               ContainsSubstring("s.toml:7") && ContainsSubstring("alpha"));
    CHECK_THAT(refusal("", "alpha = -1\n"),
               ContainsSubstring("s.toml:10") && ContainsSubstring("alpha"));
}

TEST_CASE("d of a material is its alpha, and Tr is 1 minus it") {
    using namespace alpha_in_files;
    CHECK(mtl_of("d 0.25\n").materials[0].alpha == 0.25f);
    CHECK(mtl_of("Tr 0.25\n").materials[0].alpha == 0.75f);
    CHECK(mtl_of("Tr 0.25\nd 0.5\n").materials[0].alpha == 0.5f);
    CHECK(mtl_of("d 0.5\nTr 0.25\n").materials[0].alpha == 0.5f);
    CHECK(mtl_of("").materials[0].alpha == 1.0f);
    CHECK(mtl_of("d 1\nTr 0\n").report.faults.empty());
    const Mtl halo = mtl_of("d -halo 0.25\n");
    CHECK(halo.materials[0].alpha == 0.25f);
    CHECK(halo.report.faults.empty());
    REQUIRE(halo.report.skipped.size() == 1);
    CHECK(halo.report.skipped[0].statement == "-halo");
}

TEST_CASE("Wrong and doubtful alphas of a material are reported with their line") {
    using namespace alpha_in_files;
    for (const char* line : {"d 1.5\n", "d -0.1\n", "d\n", "Tr x\n", "d -halo\n", "Tr -halo 0.5\n",
                             "d nan\n", "Tr 1\n"}) {
        const Mtl mtl = mtl_of(line);
        INFO(line);
        REQUIRE(mtl.report.faults.size() == 1);
        CHECK(mtl.report.faults[0].line == 2);
        CHECK(mtl.materials[0].alpha == 1.0f);
    }
}
