// Files that other files name: where they are looked for, and where they never are.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/image.h"
#include "scene/companion_file.h"
#include "scene/read_obj.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
namespace fs = std::filesystem;

namespace {

/// A typical archive of a model: project/source/model.obj, project/textures/..., and files outside
/// the project that it must not read.
struct Archive {
    Archive() {
        for (const char* const of : {"project/source/art/deep", "project/textures", "private"})
            fs::create_directories(folder.file(of));
        for (const char* const of :
             {"project/source/art/deep/Bark.png", "project/textures/wood.png",
              "project/textures/oak leaf.png", "project/above.png", "private/secret.png"})
            write_png(test::many_colours(2, 2), folder.file(of));
    }
    std::string model() const { return folder.file("project/source/model.obj"); }

    test::TemporaryFolder folder;
};

/// The result for a name: the file that is read, without its folders; "" if none is.
std::string found_as(const Archive& archive, const std::string& name) {
    CompanionFiles files({archive.model()});
    const CompanionFile file = files.find(name);
    CHECK(file.problem.empty() != file.path.empty());
    return fs::path(file.path).filename().string();
}

} // namespace

TEST_CASE("A file is found in, below and next to the folder of the one that names it") {
    const Archive archive;
    for (const auto& [name, file] : std::vector<std::array<std::string, 2>>{
             {"../textures/wood.png", "wood.png"},
             {"..\\textures\\wood.png", "wood.png"},
             {"../above.png", "above.png"},
             {"wood.png", "wood.png"},
             {"WOOD.PNG", "wood.png"},
             {"C:\\Users\\me\\textures\\Wood.png", "wood.png"},
             {"/home/me/textures/wood.png", "wood.png"},
             {"../../../elsewhere/wood.png", "wood.png"},
             {"textures/Oak Leaf.png", "oak leaf.png"},
             {"bark.PNG", "Bark.png"},
             {"secret.png", ""},
             {"../../private/secret.png", ""},
             {"../textures/../../private/secret.png", ""},
             {"above.png", ""}, // only folders next to its own are searched
             {"wood", ""}}) {
        INFO(name);
        CHECK(found_as(archive, name) == file);
    }
}

TEST_CASE("A file found under a different name from the one given is reported") {
    const Archive archive;
    CompanionFiles files({archive.model()});
    CHECK(files.find("../textures/wood.png").remark.empty());
    const CompanionFile file = files.find("Textures/WOOD.png");
    CHECK(file.remark == fmt::format("there is no file 'Textures/WOOD.png'; '{}' is used",
                                     fs::path(file.path).lexically_normal().string()));
    CHECK(files.find("none.png").problem == "there is no file 'none.png'");
    CHECK(files.find("/etc/none.png").problem ==
          "there is no file '/etc/none.png' in its folder, below it or in a folder next to it");
}

TEST_CASE("Links do not lead out of the parent folder") {
    const Archive archive;
    fs::create_directory_symlink(archive.folder.file("private"),
                                 archive.folder.file("project/linked"));
    fs::create_symlink(archive.folder.file("private/secret.png"),
                       archive.folder.file("project/textures/hidden.png"));
    for (const char* const name : {"../linked/secret.png", "secret.png", "../textures/hidden.png",
                                   "Hidden.png", "linked/secret.png", "near.png", "Near.png"}) {
        INFO(name);
        CHECK(found_as(archive, name).empty());
    }
}

TEST_CASE("Of several files with a name, the one in a folder of the given name is taken") {
    const Archive archive;
    fs::create_directories(archive.folder.file("project/a"));
    write_png(test::many_colours(2, 2), archive.folder.file("project/a/wood.png"));
    CompanionFiles files({archive.model()});
    CHECK(fs::path(files.find("D:\\Textures\\Wood.png").path).parent_path().filename() ==
          "textures");
    CHECK(fs::path(files.find("Wood.png").path).parent_path().filename() == "a");
}

TEST_CASE("No more names are looked at than allowed") {
    const Archive archive;
    const int count = static_cast<int>(most_names_checked) + 200;
    for (int i = 0; i < count; ++i)
        archive.folder.write(fmt::format("project/source/{}.txt", i), "");
    CompanionFiles files({archive.model()});
    int found = 0;
    for (int i = 0; i < count; ++i)
        found += files.find(fmt::format("{}.TXT", i)).problem.empty();
    CHECK(found > 0);
    CHECK(found <= static_cast<int>(most_names_checked));
    // The name as written costs no search.
    CHECK(files.find("../textures/wood.png").remark.empty());
    CHECK(files.find("wood.png").path.empty());
}

TEST_CASE("An image is found whatever options, quotes and comments surround its name") {
    const Archive archive;
    for (const char* const said :
         {"map_Kd wood.png # oak", "map_Kd \"wood.png\"", "map_Kd 'wood.png'",
          "map_Kd -colorspace sRGB wood.png", "map_Kd -unheard-of 3 of wood.png",
          "map_Kd -clamp on -s 2 2 1 wood.png", "map_Kd -o 0.5 0 -mm 0 1 \"wood.png\" # oak",
          "map_Kd wood.png -bm 1", "map_kd -flag \"oak leaf.png\"", "MAP_KD oak leaf.png"}) {
        INFO(said);
        archive.folder.write("project/source/m.mtl", "newmtl a\n" + std::string(said) + "\n");
        archive.folder.write("project/source/model.obj",
                             "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
                             "f 1/1 2/1 3/1\n");
        const ObjModel model = read_obj(archive.model());
        CHECK(model.textures.size() == 1);
        // Found elsewhere, or under a part of the text there, which is reported with file and line.
        REQUIRE(model.report.notes.size() == 1);
        CHECK(model.report.notes[0].line == 2);
        CHECK_THAT(model.report.notes[0].sentence, Catch::Matchers::EndsWith("' is used."));
    }
    archive.folder.write("project/source/model.obj",
                         "mtllib M.MTL\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
                         "f 1/1 2/1 3/1\n");
    archive.folder.write("project/source/m.mtl", "newmtl a\nmap_Kd ../textures/wood.png\n");
    const ObjModel model = read_obj(archive.model());
    CHECK(model.textures.size() == 1);
    REQUIRE(model.report.notes.size() == 1);
    CHECK(fault_line(model.report.notes[0]) ==
          fmt::format("{0}:1: 'mtllib': there is no file 'M.MTL'; '{1}' is used.", archive.model(),
                      archive.folder.file("project/source/m.mtl")));
}
