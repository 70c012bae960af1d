// The session that the view options give.

#include <string>
#include <vector>

#include "laboratory/bug.h"
#include "lessons/lesson.h"
#include "lessons/lesson_run.h"
#include "picture/view_image.h"
#include "session/content.h"
#include "session/results.h"
#include "session/second_run.h"
#include "settings/setting_table.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Session opened(const std::vector<std::string>& arguments) {
    CliRun result = run(arguments);
    INFO(result.err);
    CHECK(result.exit_code == 0);
    REQUIRE(result.request.open_window);
    return std::move(result.request.session);
}

void refuses(const std::vector<std::string>& arguments, int exit_code,
             const std::string& sentence) {
    const CliRun result = run(arguments);
    CHECK(result.exit_code == exit_code);
    CHECK(result.err == "rasterwalk: " + sentence + "\n");
    CHECK_FALSE(result.request.open_window);
}

std::string lesson_path(const std::string& id) {
    return lessons_folder() + "/" + id + ".md";
}

} // namespace

TEST_CASE("A lesson's step opened from the command line is the same as in the lesson") {
    for (const char* id : {"05-row-table", "11-perspective", "13-reading-a-bug"}) {
        const Lesson lesson = read_lesson(lesson_path(id));
        for (int step = 0; step < static_cast<int>(lesson.steps.size()); ++step) {
            INFO(id << " step " << step);
            Session expected = open_session(lessons_folder() + "/scenes/lab-room.toml");
            REQUIRE(open_step(expected, lesson, step).empty());
            const Session session = opened({"--lesson", id, "--step", std::to_string(step)});
            CHECK(session.lesson == id);
            CHECK(session.step == step);
            CHECK(session.lesson_folder.empty());
            CHECK(session.scene->path == expected.scene->path);
            CHECK(session.a.settings == expected.a.settings);
            CHECK(session.b == expected.b);
            CHECK(session.cursor == expected.cursor);
            CHECK(session.selection == expected.selection);
            CHECK(session.view == expected.view);
            CHECK(session.overlays == expected.overlays);
            CHECK(session.canvas == expected.canvas);
            CHECK(session.tab == expected.tab);
        }
    }
}

TEST_CASE("A lesson's file can be named by its path, and as FILE") {
    const std::string path = lesson_path("04-edges");
    for (const auto& arguments : {std::vector<std::string>{path}, {"--lesson", path}}) {
        const Session session = opened(arguments);
        CHECK(session.lesson == "04-edges");
        CHECK(session.step == 0);
    }
}

TEST_CASE("A lesson from another folder remembers its folder") {
    const TemporaryFolder folder;
    const std::string path = folder.write("03-mine.md", bytes_of(lesson_path("03-points")));
    const Session session = opened({path, "--step", "1"});
    CHECK(session.lesson == "03-mine");
    CHECK(session.lesson_folder == std::filesystem::path(path).parent_path().string());
}

TEST_CASE("Options given with a lesson override it") {
    const std::vector<std::string> lesson{"--lesson", "05-row-table", "--step", "3"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), lesson.begin(), lesson.end());
        return opened(more);
    };
    const Session plain = opened(lesson);
    CHECK(with({"--to", "t0/e2/s1"}).cursor == Cursor{0, Phase::edges, 2, 1});
    CHECK(common_rounding(with({"--set", "rounding=floor"}).a.settings) == Rounding::floor);
    CHECK(with({"--set", "rounding=floor"}).a.settings.stage == plain.a.settings.stage);
    CHECK(with({"--tab", "graph"}).tab == "graph");
    CHECK(with({"--view", "depth"}).view == View::depth);
    CHECK(with({"--row", "9"}).selection.row == 9);
    CHECK(with({"--row", "none"}).selection.row == std::nullopt);
    const Session elsewhere = with({"--scene", "scenes/fence.toml"});
    CHECK(elsewhere.scene->path == lessons_folder() + "/scenes/fence.toml");
    CHECK(elsewhere.lesson == "05-row-table");
}

TEST_CASE("The argument after a view option's value is the file") {
    const std::string room = lessons_folder() + "/scenes/lab-room.toml";
    CHECK(opened({"--tab", "rows", room}).tab == "rows");
    CHECK(opened({"--view", "depth", room}).view == View::depth);
    CHECK(opened({"--overlay", "owner", room}).overlays.has(Overlay::owner));
    CHECK(opened({"--triangle", "21", "--row", "9", room}).selection.triangle == 21);
}

TEST_CASE("Selection, canvas, overlays and comparison on the command line") {
    const Session s = opened({"--pixel",
                              "250,131",
                              "--triangle",
                              "21",
                              "--row",
                              "9",
                              "--vertex",
                              "1",
                              "--zoom",
                              "16",
                              "--centre",
                              "250.5,-3",
                              "--overlay",
                              "depth",
                              "--overlay",
                              "wireframe",
                              "--b",
                              "stage=fill",
                              "--b",
                              "light.power=3",
                              "--compare-view",
                              "wipe",
                              "--wipe",
                              "0.25",
                              "--grid",
                              "off",
                              "--row-table",
                              "off",
                              "--fates",
                              "off",
                              "--cell-numbers",
                              "depth",
                              "--canvas",
                              "both",
                              "--outside",
                              "0.5,-0.25",
                              "--view",
                              "depth",
                              "--depth-range",
                              "0.2,0.8"});
    CHECK(s.selection.pixel == glm::ivec2(250, 131));
    CHECK(s.selection.triangle == 21);
    CHECK(s.selection.row == 9);
    CHECK(s.selection.vertex == 1);
    CHECK(s.canvas.zoom == 16.0f);
    CHECK(s.canvas.centre == glm::vec2(250.5f, -3.0f));
    CHECK_FALSE(s.canvas.grid);
    CHECK_FALSE(s.canvas.row_table);
    CHECK_FALSE(s.canvas.fates);
    CHECK(s.canvas.numbers == CellNumbers::depth);
    CHECK(s.canvas.shows == CanvasShows::both);
    CHECK(s.canvas.outside.yaw == 0.5f);
    CHECK(s.canvas.outside.pitch == -0.25f);
    CHECK(s.canvas.outside.distance == 0.0f);
    CHECK(s.overlays.has(Overlay::depth));
    CHECK(s.overlays.has(Overlay::wireframe));
    CHECK(s.overlays.count() == 2);
    REQUIRE(s.b);
    CHECK(run_differences(s).size() == 2);
    CHECK(s.b->settings.stage == Stage::fill);
    CHECK(s.compare_view == CompareView::wipe);
    CHECK(s.wipe == 0.25f);
    CHECK(s.depth_range == DepthInterval{0.2f, 0.8f});
}

TEST_CASE("A second run comes from the command line, the lesson or the bug") {
    const Session bug = opened({"--bug", "B9"});
    REQUIRE(bug.b);
    CHECK(bug.b->settings.spans == Spans::inclusive);
    CHECK(is_on(bug, "B9"));
    CHECK_FALSE(opened({"--bug", "B9", "--b", "none"}).b);
    const Session other = opened({"--bug", "B9", "--b", "stage=edges"});
    REQUIRE(other.b);
    CHECK(other.b->settings.spans == other.a.settings.spans);
}

TEST_CASE("The vertices of a bench can be given") {
    const std::vector<std::string> bench{"--scene", "scenes/one-triangle.toml"};
    const auto placed = [&](const std::string& text) {
        const Session session = opened({"--scene", "scenes/one-triangle.toml", "--vertices", text});
        return corners_of(*session.scene, 0);
    };
    CHECK(placed("1,2/3.5,4/-5,6,2")[0].position == glm::vec3(1, 2, 1));
    CHECK(placed("1,2/3.5,4/-5,6,2")[1].position == glm::vec3(3.5f, 4, 1));
    CHECK(placed("0: 1,2/3.5,4/-5,6,2")[2].position == glm::vec3(-5, 6, 2));
    refuses({"--scene", "scenes/one-triangle.toml", "--vertices", "1:1,2/3,4/5,6"}, 2,
            "there is no triangle 1 to move; the triangles are 0 to 0.");
    refuses({"--vertices", "1,2/3,4/5,6"}, 2,
            "only the vertices of a scene in pixels can be moved, and 'The lab's room' is not such "
            "a scene.");
    for (const char* bad :
         {"1,2", "1,2/3,4", "1,2/3,4/5", "1,2/3,4/5,6/7,8", "1,2/3,4/5,6,0", "1,2/3,4/5,1e9",
          "1,2/3,4/5,nan", "-1:1,2/3,4/5,6", "1,2/3,4/5,6,1,1", "x:1,2/3,4/5,6", "/", "1,2/3,4/"}) {
        INFO(bad);
        CHECK(run({"--scene", "scenes/one-triangle.toml", "--vertices", bad}).exit_code == 2);
    }
}

TEST_CASE("Values that a view cannot have are refused with a sentence") {
    refuses({"--lesson", "05-row-tabel"}, 2,
            "there is no lesson '05-row-tabel'. Did you mean '05-row-table'? 'rasterwalk lessons' "
            "lists them.");
    refuses({"--lesson", "05-row-table", "--step", "99"}, 2,
            "--step must be a number from 0 to 8 in lesson '05-row-table', not '99'.");
    refuses({"--lesson", "../05-row-table"}, 2,
            "'../05-row-table' is not a lesson: the name of a lesson is two digits, a hyphen, a "
            "name and .md.");
    refuses({"--step", "2"}, 2, "--step can only be used with --lesson.");
    refuses({lesson_path("04-edges"), "--lesson", "04-edges"}, 2,
            "the lesson is named twice, as FILE and by --lesson.");
    refuses({"--triangle", "99"}, 2, "there is no triangle 99: the triangles are 0 to 29.");
    refuses({"--triangle", "-1"}, 2, "there is no triangle -1: the triangles are 0 to 29.");
    refuses({"--pixel", "500,1"}, 2, "the pixel 500,1 is outside the picture of 500 x 500 pixels.");
    refuses({"--pixel", "x"}, 2,
            "--pixel must be a column and a row, like 250,131, or none, not 'x'.");
    refuses({"--zoom", "65"}, 2, "--zoom must be a number from 0.25 to 64 or fit, not '65'.");
    refuses({"--zoom", "nan"}, 2, "--zoom must be a number from 0.25 to 64 or fit, not 'nan'.");
    refuses({"--centre", "1e9,0"}, 2,
            "--centre must be a position in the picture, like 250,131.5, not '1e9,0'.");
    refuses({"--b", "stage=dept"}, 2,
            "stage cannot be 'dept': it takes points, edges, rows, fill, depth, vertex_light or "
            "pixel_light.");
    refuses(
        {"--compare-view", "wip"}, 2,
        "--compare-view must be run_a, run_b, difference, side_by_side, wipe or blink, not 'wip'. "
        "Did you mean 'wipe'?");
    refuses({"--grid", "yes"}, 2, "--grid must be off or on, not 'yes'.");
    refuses({"--canvas", "outsid"}, 2,
            "--canvas must be picture, outside or both, not 'outsid'. Did you mean 'outside'?");
    refuses(
        {"--outside", "1"}, 2,
        "--outside must be camera, or yaw and pitch like -0.75,-0.4, or yaw, pitch, distance and "
        "target like -0.75,-0.4,5,0,0,1, not '1'.");
    refuses({"--wipe", "2"}, 2, "--wipe must be a number from 0 to 1, not '2'.");
    refuses(
        {"--depth-range", "0.8,0.2"}, 2,
        "--depth-range must be a range of depths, the smaller first, like 0.2,0.8, or none, not "
        "'0.8,0.2'.");
}

TEST_CASE("A saved view is opened, and options given with it override it") {
    const TemporaryFolder folder;
    const std::string path = folder.write("v.walk.toml", "scene = \"scenes/one-triangle.toml\"\n"
                                                         "set = [\"rounding=floor\"]\n"
                                                         "cursor = \"t0/e1/s5\"\n"
                                                         "row = 9\n"
                                                         "compare = [\"rounding=truncate\"]\n");
    const Session plain = opened({path});
    CHECK(common_rounding(plain.a.settings) == Rounding::floor);
    CHECK(plain.cursor == Cursor{0, Phase::edges, 1, 5});
    REQUIRE(plain.b);
    CHECK(common_rounding(plain.b->settings) == Rounding::truncate);
    const Session changed =
        opened({path, "--to", "end", "--row", "none", "--b", "none", "--stage", "fill"});
    CHECK(common_rounding(changed.a.settings) == Rounding::floor);
    CHECK(changed.a.settings.stage == Stage::fill);
    CHECK(changed.cursor == cursor_end);
    CHECK_FALSE(changed.selection.row);
    CHECK_FALSE(changed.b);
    refuses({path, "--lesson", "04-edges"}, 2,
            "a saved view has its own lesson, so it cannot be combined with --lesson.");
    CHECK(run({"check", path}).exit_code == 0);
    const std::string bad =
        folder.write("bad.walk.toml", "scene = \"scenes/fence.toml\"\nrow = -1\n");
    refuses({bad}, 3, bad + ":2: a whole number between 0 and 4096 is needed here.");
    CHECK(run({"check", bad}).exit_code == 1);
}

TEST_CASE("A fault in the lesson itself is bad input, with its line") {
    const TemporaryFolder folder;
    const std::string path = folder.write("20-broken.md", "<!-- lesson\n"
                                                          "title = \"T\"\n"
                                                          "section = \"S\"\n"
                                                          "minutes = 5\n"
                                                          "about = \"A.\"\n"
                                                          "program = \"P\"\n"
                                                          "triangle = 99\n"
                                                          "-->\n"
                                                          "# T\n\nText.\n");
    refuses({path}, 3, path + ":7: there is no triangle 99: the triangles are 0 to 29.");
    CHECK(opened({path, "--triangle", "3"}).selection.triangle == 3);
    const std::string elsewhere = folder.write("22-odd.md", "<!-- lesson\nrow = 9999\n-->\n# T\n");
    CHECK(opened({elsewhere}).notice.starts_with(elsewhere + ":1: "));
    refuses({folder.file("21-absent.md")}, 4,
            "cannot read '" + folder.file("21-absent.md") + "': No such file or directory.");
}
