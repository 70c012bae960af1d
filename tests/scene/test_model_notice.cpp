// Models that would be invisible, or all black: what is drawn, and what the notice says.

#include <string>
#include <vector>

#include "base/image.h"
#include "scene/model_notice.h"
#include "scene/model_scene.h"
#include "scene/read_obj.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using Catch::Matchers::StartsWith;

namespace {
namespace unseen_models {

/// A square of two triangles, one of the material a and one of b; it has texture coordinates.
const std::string two_triangles = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\n"
                                  "usemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 1/1 3/1 4/1\n";

struct Folder {
    test::TemporaryFolder folder;

    Folder() { write_png(test::many_colours(2, 2), folder.file("p.png")); }
    ObjModel model_with(const std::string& materials) const {
        folder.write("m.mtl", materials);
        return read_obj(folder.write("m.obj", two_triangles));
    }
    std::vector<std::string> with_path(std::vector<std::string> lines) const {
        for (std::string& line : lines)
            line = folder.file("m.mtl") + line;
        return lines;
    }
};

} // namespace unseen_models
} // namespace

TEST_CASE("Kd 0 counts as 1 where an image is named, and is black where none is") {
    using namespace unseen_models;
    const Folder folder;
    const std::string counts = " 'Kd' 0 would make map_Kd invisible, so it counts as 1.";
    for (const std::string black : {"Kd 0 0 0\n", "Kd 0\n", "Kd 0.00 0.000 0e0\n", "Kd 1e-9\n"}) {
        INFO(black);
        const ObjModel model = folder.model_with("newmtl a\n" + black + "map_Kd p.png\nnewmtl b\n" +
                                                 "map_Kd p.png\n" + black);
        CHECK(model.mesh.corner(0, 0).reflectance == glm::vec3(1));
        CHECK(model.mesh.corner(1, 0).reflectance == glm::vec3(1));
        CHECK(model.parts[0].texture == 0);
        CHECK(fault_lines(model.report) == folder.with_path({":2:" + counts, ":6:" + counts}));
    }
    const ObjModel missing =
        folder.model_with("newmtl a\nKd 0 0 0\nmap_Kd none.png\nnewmtl b\nKd 0 0 0\n");
    CHECK(missing.mesh.corner(0, 0).reflectance == glm::vec3(1));
    CHECK(missing.mesh.corner(1, 0).reflectance == glm::vec3(0));
    CHECK(fault_lines(missing.report) ==
          folder.with_path({":3: 'map_Kd': there is no file 'none.png'; the image is left out.",
                            ":2:" + counts}));
    CHECK(remark_lines(missing.report) ==
          folder.with_path({":5: the material 'b' is black because its Kd is 0 and it has no "
                            "map_Kd."}));
    // A dark colour is one.
    CHECK(
        folder.model_with("newmtl a\nKd 0 0 0.01\nmap_Kd p.png\n").mesh.corner(0, 0).reflectance ==
        glm::vec3(0, 0, 0.01f));
}

TEST_CASE(
    "A model that is black all over gets a notice above the picture, one black in parts does not") {
    using namespace unseen_models;
    const Folder folder;
    const auto notice = [&](const std::string& materials) {
        return model_notice(scene_of_model(folder.model_with(materials)));
    };
    CHECK_THAT(notice("newmtl a\nKd 0 0 0\nnewmtl b\nKd 0\n"),
               StartsWith("This whole model is black (Kd 0)"));
    CHECK(notice("newmtl a\nKd 0 0 0\nnewmtl b\nKd 1\n").empty());
    CHECK(notice("newmtl a\nKd 0 0 0\nKs 1 1 1\nnewmtl b\nKd 0\nKs 1\n").empty());
}

TEST_CASE("A material that is wholly transparent is reported with its line") {
    using namespace unseen_models;
    const Folder folder;
    for (const std::string d : {"d 0\n", "d 0.0\n", "d 0.001\n", "Tr 0.9999\n", "d 0\nTr 0\n"}) {
        INFO(d);
        const Scene scene = scene_of_model(
            folder.model_with("newmtl a\nKd 1 1 1\n" + d + "newmtl b\nKd 1 1 1\n" + d));
        CHECK(model_notice(scene).empty()); // the picture is what says it
        REQUIRE(remark_lines(*scene.model_report).size() == 2);
        CHECK(remark_lines(*scene.model_report)[0] ==
              folder.folder.file("m.mtl") +
                  ":3: the material 'a' is fully transparent because its alpha is 0.");
    }
    const Scene half =
        scene_of_model(folder.model_with("newmtl a\nKd 1 1 1\nd 0\nnewmtl b\nKd 1 1 1\n"));
    CHECK(model_notice(half).empty());
    CHECK(half.model_report->notes.size() == 1);
    // Tr 1 is taken to be opaque, and that is reported.
    const ObjModel opaque = folder.model_with("newmtl a\nTr 1\nnewmtl b\nTr 1\n");
    CHECK(opaque.report.faults.size() == 2);
    CHECK(opaque.materials[0].alpha == 1.0f);
}
