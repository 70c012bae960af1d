#include "support/hinted_models.h"

#include <cstdint>
#include <vector>

#include "base/image.h"
#include "scene/model_scene.h"
#include "scene/read_obj.h"
#include "support/temporary_folder.h"

namespace rasterwalk::test {

Scene box(bool is_inward) {
    const std::string corners = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
                                "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
    const std::string inward = "f 5 6 2 1\nf 4 3 7 8\nf 6 5 8 7\nf 5 1 4 8\nf 2 6 7 3\nf 1 2 3 4\n";
    const std::string outward =
        "f 1 2 6 5\nf 8 7 3 4\nf 7 8 5 6\nf 8 4 1 5\nf 3 7 6 2\nf 4 3 2 1\n";
    const TemporaryFolder folder;
    return scene_of_model(
        read_obj(folder.write("box.obj", corners + (is_inward ? inward : outward))));
}

Scene sheet(bool shows_back) {
    const TemporaryFolder folder;
    return scene_of_model(
        read_obj(folder.write("sheet.obj", std::string("v -1 -1 0\nv 1 -1 0\nv 0 1 0\n") +
                                               (shows_back ? "f 3 2 1\n" : "f 1 2 3\n"))));
}

namespace {

/// A folder with the image and these materials.
Scene with_materials(const std::string& materials, const std::string& model) {
    const TemporaryFolder folder;
    folder.write("m.mtl", materials);
    Image clear{2, 2, std::vector<std::uint8_t>(16, 255)};
    for (std::size_t i = 3; i < clear.rgba.size(); i += 4)
        clear.rgba[i] = 100; // below 1/2
    write_png(clear, folder.file("clear.png"));
    write_png({1, 1, {0, 0, 0, 255}}, folder.file("black.png"));
    const std::string corners = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
    return scene_of_model(read_obj(folder.write("m.obj", "mtllib m.mtl\n" + corners + model)));
}

} // namespace

Scene sheet_of(const std::string& material) {
    return with_materials("newmtl m\n" + material, "usemtl m\nf 1/1 2/2 3/3\n");
}

Scene two_sheets(const std::string& left, const std::string& right) {
    return with_materials("newmtl l\n" + left + "newmtl r\n" + right,
                          "usemtl l\nf 1/1 2/2 3/3\nusemtl r\nf 2/1 4/2 3/3\n");
}

} // namespace rasterwalk::test
