// --texture: an image that is laid on a model, and where it is kept.

#include <string>
#include <vector>

#include "base/error.h"
#include "cli/run.h"
#include "opening/command_line_text.h"
#include "opening/opened_view.h"
#include "opening/view_link.h"
#include "scene/applied_texture.h"
#include "support/temporary_folder.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"
#include "view/state_file.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Two squares; only the first has texture coordinates.
const std::string half_painted = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                                 "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                 "o first\nf 1/1 2/2 3/3 4/4\no second\nf 2 5 6 3\n";

struct ModelWithImage {
    ModelWithImage() {
        options.scene = folder.write("m.obj", half_painted);
        options.texture = folder.file("x.png");
        write_png(image, options.texture);
    }
    Image image = many_colours(3, 2);
    TemporaryFolder folder;
    ViewOptions options;
};

} // namespace

TEST_CASE("--texture lays an image on the parts that have texture coordinates") {
    const ModelWithImage of;
    const Session session = open_view(of.options);
    const Scene& scene = *session.scene;
    REQUIRE(scene.parts.size() == 2);
    CHECK(scene.parts[0].texture == 0);
    CHECK(scene.parts[1].texture == -1);
    REQUIRE(scene.textures.size() == 1);
    CHECK(*scene.textures[0] == make_texture("x.png", of.image));
    CHECK(open_view({.scene = of.options.scene}).scene->textures.empty());
}

TEST_CASE("Another image replaces the one laid on a model") {
    const ModelWithImage of;
    const Image other = many_colours(2, 2);
    write_png(other, of.folder.file("y.png"));
    const Scene first = *open_view(of.options).scene;
    const Scene second = with_texture(first, of.folder.file("y.png"));
    REQUIRE(second.textures.size() == 1);
    CHECK(*second.textures[0] == make_texture("y.png", other));
    CHECK(second.parts[0].texture == 0);
    CHECK(second.applied_texture == of.folder.file("y.png"));
}

TEST_CASE("A part that has an image keeps it") {
    const ModelWithImage of;
    write_png(many_colours(2, 2), of.folder.file("own.png"));
    of.folder.write("m.mtl", "newmtl a\nmap_Kd own.png\n");
    of.folder.write("m.obj", "mtllib m.mtl\nusemtl a\n" + half_painted +
                                 "usemtl\nusemtl b\no third\nf 1/1 3/3 4/4\n");
    const Session session = open_view(of.options);
    const Scene& scene = *session.scene;
    CHECK((*scene.textures.at(0)).name == "own.png");
    CHECK(scene.parts.front().texture == 0);
    CHECK(scene.parts.back().texture == 1);
}

TEST_CASE("An image that cannot be laid on a model is refused with the documented exit code") {
    const ModelWithImage of;
    const auto code = [&](const std::string& model, const std::string& texture) {
        return run({"stats", model, "--texture", texture}).exit_code;
    };
    const std::string none = of.folder.file("none.png"), text = of.folder.write("t.png", "text");
    const std::string bare = of.folder.write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    CHECK(code(of.options.scene, of.options.texture) == static_cast<int>(ExitCode::done));
    CHECK(code(of.options.scene, none) == static_cast<int>(ExitCode::no_access));
    CHECK(code(of.options.scene, text) == static_cast<int>(ExitCode::bad_input));
    CHECK(code(bare, of.options.texture) == static_cast<int>(ExitCode::bad_input));
    CHECK_THAT(run({"stats", bare, "--texture", of.options.texture}).err,
               ContainsSubstring("no part of the scene can show the image"));
}

TEST_CASE("A copied command line and a saved view keep the image that is laid on the model") {
    const ModelWithImage of;
    const Session session = open_view(of.options);
    const std::vector<std::string> words = command_line_words(session);
    CHECK(words == std::vector<std::string>{"rasterwalk", "--scene", of.options.scene, "--texture",
                                            of.options.texture});
    const std::string view = of.folder.file("v.walk.toml");
    write_view(session, view);
    ViewOptions again;
    again.file = view;
    CHECK(open_view(again).scene->parts == session.scene->parts);
    CHECK(*open_view(again).scene->textures.at(0) == *session.scene->textures.at(0));
    std::filesystem::remove(of.options.texture);
    CHECK_THROWS_WITH(open_view(again),
                      ContainsSubstring("there is no file 'x.png' in the folder of this view"));
}

TEST_CASE("A link names no image from elsewhere") {
    const ModelWithImage of;
    CHECK_THROWS_AS(parse_view_link("#texture=" + of.options.texture), UsageError);
    CHECK_THROWS_AS(view_link(open_view(of.options)), UsageError);
}
