#include <filesystem>
#include <string>

#include "base/error.h"
#include "laboratory/bug.h"
#include "laboratory/quiz.h"
#include "opening/opened_view.h"
#include "session/content.h"
#include "session/tabs.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/random_session.h"
#include "tests/support/temporary_folder.h"
#include "view/state_file.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

namespace fs = std::filesystem;

Session opened_file(const std::string& path) {
    ViewOptions options;
    options.file = path;
    return open_view(options);
}

std::string scene_of_program(const char* name) {
    return lessons_folder() + "/scenes/" + name;
}

/// The message when this text is opened as a view; "" if it can be.
std::string complaint(const TemporaryFolder& folder, const std::string& text) {
    const std::string path = folder.write("v.walk.toml", text);
    try {
        opened_file(path);
        return "";
    } catch (const InputError& fault) {
        const std::string sentence = fault.what();
        const std::string start = folder.file("");
        INFO(sentence);
        CHECK(sentence.starts_with(start));
        return sentence.substr(std::min(start.size(), sentence.size()));
    }
}

const std::string head = "scene = \"scenes/lab-room.toml\"\n";

} // namespace

TEST_CASE("A view that is saved and opened again is the same, for many sessions") {
    const TemporaryFolder folder;
    Random random(2026);
    for (int i = 0; i < rounds(300, 60); ++i) {
        const Session session = random_session(random);
        const std::string path = folder.file("view.walk.toml");
        write_view(session, path);
        INFO("session " << i << "\n" << bytes_of(path));
        const Session again = opened_file(path);
        check_same_view(again, session);
        CHECK(again.notice.empty());
        CHECK(view_text(again, path) == bytes_of(path));
    }
}

TEST_CASE("A saved view reads well") {
    Session session = open_session(scene_of_program("one-triangle.toml"));
    session.cursor = Cursor{0, Phase::edges, 1, 5};
    set_rounding(session.a.settings, Rounding::floor);
    session.selection.row = 9;
    session.canvas.zoom = 16.0f;
    session.canvas.centre = {8.5f, 10.0f};
    session.overlays.set(Overlay::wireframe, true);
    session.lesson = "05-row-table";
    session.step = 3;
    compare_with(session, session.a.settings);
    move_bench_vertex(session, 0, 1, {4, 12});
    CHECK(view_text(session, "/tmp/x.walk.toml") ==
          "# A view of Rasterwalk, to be opened with it.\n"
          "scene = 'scenes/one-triangle.toml'\n"
          "lesson = '05-row-table'\n"
          "step = 3\n"
          "set = [\n"
          "    'rounding=floor',\n"
          "]\n"
          "cursor = 't0/e1/s5'\n"
          "row = 9\n"
          "tab = 'rows'\n"
          "overlays = [\n"
          "    'wireframe',\n"
          "]\n"
          "zoom = 16\n"
          "centre = '8.5,10'\n"
          "compare = []\n"
          "vertices = [\n"
          "    '10,5/4,12/15,15',\n"
          "]\n");
}

TEST_CASE("The program's own scenes are named the same wherever the view is saved") {
    const Session session = open_session(scene_of_program("fence.toml"));
    for (const char* place : {"/../v.walk.toml", "/v.walk.toml", "/scenes/v.walk.toml"}) {
        INFO(place);
        CHECK(view_text(session, lessons_folder() + place).find("scene = 'scenes/fence.toml'\n") !=
              std::string::npos);
    }
}

TEST_CASE("Scene and lesson of a view are found relative to its folder") {
    const TemporaryFolder folder;
    fs::create_directory(folder.file("below"));
    const std::string scene =
        folder.write("below/mine.toml", bytes_of(scene_of_program("fence.toml")));
    folder.write("07-mine.md", bytes_of(lessons_folder() + "/03-points.md"));
    Session session = open_session(scene);
    session.lesson = "07-mine";
    session.lesson_folder = fs::path(folder.file("x")).parent_path().string();
    session.step = 2;
    const std::string path = folder.file("v.walk.toml");
    write_view(session, path);
    CHECK(bytes_of(path).find("scene = 'below/mine.toml'\nlesson = '07-mine.md'") !=
          std::string::npos);
    check_same_view(opened_file(path), session);

    SECTION("elsewhere it cannot be saved") {
        CHECK_THROWS_WITH(view_text(session, folder.file("below/v.walk.toml")),
                          Catch::Matchers::ContainsSubstring("in the folder of its lesson"));
        const TemporaryFolder other;
        CHECK_THROWS_WITH(view_text(session, other.file("v.walk.toml")),
                          Catch::Matchers::ContainsSubstring("in the folder of its scene"));
    }
    SECTION("without its lesson it still opens, and says so") {
        fs::remove(folder.file("07-mine.md"));
        const Session again = opened_file(path);
        CHECK(again.lesson.empty());
        CHECK(again.notice.find("The lesson of this view is missing") == 0);
    }
}

TEST_CASE("A tab that the student chose against the lesson is still theirs when a view is opened") {
    const TemporaryFolder folder;
    const std::string path = folder.file("own.walk.toml");
    ViewOptions options;
    options.lesson = "05-row-table";
    options.step = "3";
    Session session = open_view(options);
    const std::string of_lesson = session.tab_guide.of_step;
    REQUIRE(of_lesson == "rows");
    REQUIRE_FALSE(session.tab_guide.is_own);
    write_view(session, path);
    CHECK_FALSE(opened_file(path).tab_guide.is_own);
    choose_tab(session, "graph");

    SECTION("and going back leads to the lesson's") {
        write_view(session, path);
        Session again = opened_file(path);
        CHECK(again.tab == "graph");
        CHECK(again.tab_guide.is_own);
        CHECK(view_text(again, path) == bytes_of(path));
        follow_guide(again);
        CHECK(again.tab == of_lesson);
        CHECK_FALSE(again.tab_guide.is_own);
    }
    SECTION("below the settings too") {
        choose_tab(session, settings_tab);
        write_view(session, path);
        Session again = opened_file(path);
        CHECK(again.tab == settings_tab);
        CHECK(view_text(again, path) == bytes_of(path));
        close_settings(again);
        CHECK(again.tab == "graph");
        CHECK(again.tab_guide.is_own);
    }
    SECTION("but not if the command line names another") {
        write_view(session, path);
        ViewOptions with_tab;
        with_tab.file = path;
        with_tab.given["tab"] = {"history"};
        const Session again = open_view(with_tab);
        CHECK(again.tab == "history");
        CHECK_FALSE(again.tab_guide.is_own);
    }
    SECTION("nor if its lesson is gone") {
        const std::string text = "lesson = \"99-gone\"\ntab = \"graph\"\nown_tab = \"graph\"\n";
        const Session again = opened_file(folder.write("gone.walk.toml", head + text));
        CHECK(again.tab == "graph");
        CHECK(again.lesson.empty());
    }
}

TEST_CASE("A view is not saved in a quiz, nor without a scene file") {
    Session session = open_session(scene_of_program("lab-room.toml"));
    Session made = session;
    REQUIRE(start_quiz(session, read_bugs(), 1));
    CHECK_THROWS_AS(view_text(session, "/tmp/x.walk.toml"), UsageError);
    Scene scene = *made.scene;
    scene.path.clear();
    set_scene(made, scene);
    CHECK_THROWS_AS(view_text(made, "/tmp/x.walk.toml"), UsageError);
}

TEST_CASE("Faults in a saved view are reported with their line") {
    const TemporaryFolder folder;
    const auto says = [&](const std::string& text, const std::string& sentence) {
        INFO(text);
        CHECK(complaint(folder, text) == sentence);
    };
    says("", "v.walk.toml:1: the view needs 'scene'.");
    says(head, "");
    says(head + "[\n", complaint(folder, head + "[\n")); // any sentence, with a line
    CHECK(complaint(folder, head + "[\n").starts_with("v.walk.toml:2"));
    CHECK(complaint(folder, head + "sett = []\n")
              .starts_with("v.walk.toml:2: the view has no 'sett'; it has: "));
    CHECK(complaint(folder, head + "point_at = \"x\"\n") ==
          "v.walk.toml:2: the view has no 'point_at'.");
    says(head + "\nzoom = nan\n", "v.walk.toml:3: the zoom must be a finite number.");
    says(head + "zoom = 65\n", "v.walk.toml:2: the zoom must be between 0 and 64.");
    says(head + "zoom = 0.1\n", "v.walk.toml:2: the zoom must be 0.25 to 64, or 0 to fit.");
    says(head + "zoom = 2\ncentre = \"1e9,1\"\n",
         "v.walk.toml:3: this position is too far outside the picture.");
    says(head + "centre = \"inf,1\"\n",
         "v.walk.toml:2: a position in the picture is needed here, like \"250,131\".");
    says(head + "wipe = 2\n", "v.walk.toml:2: the position of the divider must be between 0 and "
                              "1.");
    says(head + "grid = 1\n", "v.walk.toml:2: the grid must be true or false.");
    says(
        head + "outside = \"1,2,3\"\n",
        "v.walk.toml:2: the view from outside must be camera, or yaw and pitch like -0.75,-0.4, or "
        "yaw, pitch, distance and target like -0.75,-0.4,5,0,0,1.");
    says(head + "depth_range = \"2,1\"\n",
         "v.walk.toml:2: a range of depths is needed here, the smaller first, like \"0.2,0.8\".");
    says(head + "set = [\n\"light.power=1e9\",\n]\n",
         "v.walk.toml:3: light.power cannot be '1e9': it takes one number or three, each from 0 "
         "to 10000.");
    says(head + "set = \"x=1\"\n", "v.walk.toml:2: a list of strings is needed here: [\"...\"].");
    says(head + "triangle = 30\n",
         "v.walk.toml:2: there is no triangle 30: the triangles are 0 to 29.");
    CHECK(complaint(folder, head + "cursor = \"t0/r999\"\n").starts_with("v.walk.toml:2: "));
    says(head + "row = 500\n", "v.walk.toml:2: there is no row 500: the rows are 0 to 499.");
    says(head + "vertices = [\"1,2/3,4/5,6\"]\n",
         "v.walk.toml:2: only the vertices of a scene in pixels can be moved, and 'The lab's room' "
         "is not such a scene.");
    says(head + "compare = [\"stage=x\"]\n",
         "v.walk.toml:2: stage cannot be 'x': it takes points, edges, rows, fill, depth, "
         "vertex_light or pixel_light.");
    says(head + "step = 1\n", "v.walk.toml:2: 'step' needs a 'lesson', but there is none.");
    says(head + "own_tab = \"rows\"\n",
         "v.walk.toml:2: 'own_tab' needs a 'lesson', but there is none.");
    says(head + "lesson = \"05-row-table\"\nown_tab = \"settings\"\n",
         "v.walk.toml:3: there is no tab 'settings'.");
    says(head + "lesson = \"05-row-table\"\nstep = -1\n",
         "v.walk.toml:3: 'step' of the view must be a whole number between 0 and 64.");
    says("scene = 5\n", "v.walk.toml:1: 'scene' of the view must be text in quotes.");
    says("\nscene = \"absent.toml\"\n",
         "v.walk.toml:2: there is no file 'absent.toml' in the folder of this view or among the "
         "program's own.");
}

TEST_CASE("A view never reads a file outside its folder") {
    const TemporaryFolder folder;
    const TemporaryFolder other;
    const std::string outside = other.write("s.toml", bytes_of(scene_of_program("fence.toml")));
    for (const std::string& scene : {std::string("/etc/passwd"), std::string("../s.toml"), outside,
                                     std::string("scenes/../../s.toml"), std::string("/dev/zero"),
                                     std::string("."), std::string("scenes")}) {
        INFO(scene);
        CHECK(complaint(folder, "scene = \"" + scene + "\"\n")
                  .starts_with("v.walk.toml:1: there is"));
    }
    fs::create_symlink(outside, folder.file("link.toml"));
    CHECK(complaint(folder, "scene = \"link.toml\"\n").starts_with("v.walk.toml:1: there is"));
    // The lesson is left out, and the view opens.
    for (const char* lesson : {"../03-x.md", "/etc/03-x.md", "../../etc/passwd", "x"}) {
        folder.write("v.walk.toml", head + "lesson = \"" + lesson + "\"\n");
        CHECK(opened_file(folder.file("v.walk.toml")).lesson.empty());
    }
}

TEST_CASE("Hostile view files are refused, whatever they contain") {
    const TemporaryFolder folder;
    CHECK(complaint(folder, head + "#" + std::string(largest_view_file, 'x'))
              .starts_with("v.walk.toml: "));
    CHECK_FALSE(complaint(folder, head + "set = " + std::string(5000, '[')).empty());
    CHECK_FALSE(complaint(folder, std::string(1000, '\0')).empty());
    std::string many = head + "vertices = [";
    for (int i = 0; i < 1001; ++i)
        many += "\"1,2/3,4/5,6\",";
    CHECK_FALSE(complaint(folder, many + "]\n").empty());

    Random random(7);
    for (int i = 0; i < 20; ++i) {
        const std::string path = folder.file("v.walk.toml");
        const std::string good = view_text(random_session(random), path);
        for (int k = 0; k < 25; ++k) {
            std::string bad = good;
            for (int n = random.integer(1, 4); n > 0 && !bad.empty(); --n) {
                const auto at =
                    static_cast<std::size_t>(random.integer(0, static_cast<int>(bad.size()) - 1));
                if (random.integer(0, 2) == 0) {
                    bad.erase(at, static_cast<std::size_t>(random.integer(1, 9)));
                } else {
                    bad[at] = static_cast<char>(random.integer(0, 255));
                }
            }
            complaint(folder, bad); // opens, or is an InputError; nothing else
        }
    }
}

TEST_CASE("A view is not saved if it could not write the name of its scene") {
    const TemporaryFolder folder;
    const std::string scene =
        folder.write("caf\xe9.toml", bytes_of(scene_of_program("lab-room.toml")));
    ViewOptions options;
    options.scene = scene;
    const Session session = open_view(options);
    const std::string path = folder.file("view.walk.toml");
    CHECK_THROWS_WITH(write_view(session, path),
                      "the view cannot be saved, because it names its scene, and 'caf\\xe9.toml' "
                      "is not UTF-8 text; rename the file.");
    CHECK_FALSE(fs::exists(path));
    // Names with other letters, or with terminal commands, are found again.
    for (const char* name : {"café.toml", "\x1b[31m.toml", "a \"b\" \u202e.toml"}) {
        options.scene = folder.write(name, bytes_of(scene_of_program("lab-room.toml")));
        write_view(open_view(options), path);
        CHECK(opened_file(path).scene->path == options.scene);
    }
}
