#include <filesystem>

#include "base/files.h"
#include "base/image.h"
#include "laboratory/bug.h"
#include "laboratory/quiz.h"
#include "opening/opened_view.h"
#include "opening/view_link.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/random_session.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "ui/actions/actions.h"
#include "ui/actions/lab.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/view_files.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"
#include "view/state_file.h"

namespace rasterwalk {

namespace {

using test::bytes_of;
using test::check_same_view;
using test::TemporaryFolder;

constexpr Modifiers ctrl{true, false, false};

bool is_up(const Driver& driver) {
    return driver.ui.sheets.files.kind != FileSheet::Kind::closed;
}

/// Saves by keys and a typed path.
void save(Driver& driver, const std::string& path) {
    driver.hand.press('S', ctrl);
    REQUIRE(is_up(driver));
    driver.hand.enter("files.path", path);
}

void open(Driver& driver, const std::string& path) {
    driver.hand.press('O', ctrl);
    REQUIRE(is_up(driver));
    driver.hand.enter("files.path", path);
}

/// A view with a little of everything.
void set_up_view(Driver& driver) {
    driver.hand.click("stage.depth");
    driver.hand.click_picture(250, 400);
    driver.open("history");
    driver.hand.press('C'); // compares
    driver.hand.press(key::comma);
}

} // namespace

TEST_CASE("A view saved by keys and opened again is the same") {
    const TemporaryFolder folder;
    const std::string path = folder.file("mine.walk.toml");
    Driver driver;
    set_up_view(driver);
    save(driver, path);
    CHECK_FALSE(is_up(driver));
    CHECK(driver.ui.session.notice == "Saved as " + path + ".");
    const Session saved = driver.ui.session;

    open_lesson(driver.ui, "05-row-table", 4);
    driver.hand.frames(3);
    const Session between = driver.ui.session;
    REQUIRE(between.scene->path != saved.scene->path);
    open(driver, path);
    CHECK_FALSE(is_up(driver));
    check_same_view(driver.ui.session, saved);
    CHECK(driver.ui.session.lesson.empty());

    SECTION("one undo brings back what was there before") {
        driver.hand.press('Z', ctrl);
        CHECK(driver.ui.session.scene->path == between.scene->path);
        CHECK(driver.ui.session.a.settings == between.a.settings);
        CHECK_FALSE(driver.ui.session.b);
        driver.hand.press('Z', {true, true, false});
        CHECK(driver.ui.session.a.settings == saved.a.settings);
        CHECK(driver.ui.session.b == saved.b);
    }
    SECTION("and Back leads to the place before") {
        driver.hand.press(key::left, {false, false, true});
        CHECK(driver.ui.session.cursor == between.cursor);
    }
}

TEST_CASE("A view with a lesson opens at its step") {
    const TemporaryFolder folder;
    const std::string path = folder.file("step.walk.toml");
    Driver driver;
    open_lesson(driver.ui, "05-row-table", 3);
    driver.hand.frames(3);
    driver.hand.press(key::period);
    const Session saved = driver.ui.session;
    save(driver, path);
    open_lesson(driver.ui, "09-light-per-vertex", 0);
    driver.hand.frames(3);
    open(driver, path);
    check_same_view(driver.ui.session, saved);
    CHECK(driver.hand.is_visible("lesson.next"));
    CHECK(driver.ui.lesson.shown == "05-row-table/3");
}

TEST_CASE("A view remembers which page was read next to the picture") {
    const TemporaryFolder folder;
    const std::string path = folder.file("page.walk.toml");
    for (const char* page : {"stage", "list", "open"}) {
        INFO(page);
        Driver driver;
        open_lesson(driver.ui, "05-row-table", 3);
        driver.hand.frames(3);
        driver.hand.click("lesson." + std::string(page));
        const std::string shown = driver.ui.lesson.shown;
        std::filesystem::remove(path);
        save(driver, path);
        open_lesson(driver.ui, "09-light-per-vertex", 0);
        driver.hand.frames(3);
        REQUIRE(driver.ui.lesson.shown != shown);
        open(driver, path);
        CHECK(driver.ui.lesson.shown == shown);
    }
}

TEST_CASE("A name that is typed at once after the keys arrives whole") {
    const TemporaryFolder folder;
    const std::string name = folder.file("quick");
    for (const std::size_t at_once : {std::size_t{1}, std::size_t{3}, name.size()}) {
        INFO(at_once << " letters a frame");
        std::filesystem::remove(name + ".walk.toml");
        Driver driver;
        ImGuiIO& io = ImGui::GetIO();
        play_modifiers(true, false, false);
        play_key('S', true);
        driver.hand.frames(1);
        play_modifiers(false, false, false);
        play_key('S', false);
        for (std::size_t at = 0; at < name.size(); at += at_once) {
            io.AddInputCharactersUTF8(name.substr(at, at_once).c_str());
            driver.hand.frames(1);
        }
        play_key(key::enter, true);
        driver.hand.frames(1);
        play_key(key::enter, false);
        driver.hand.rest();
        CHECK_FALSE(is_up(driver));
        CHECK(driver.ui.session.notice == "Saved as " + name + ".walk.toml.");
        CHECK(std::filesystem::exists(name + ".walk.toml"));
    }
}

TEST_CASE("A broken file is refused with its line, and nothing changes") {
    const TemporaryFolder folder;
    Driver driver;
    set_up_view(driver);
    const Session before = driver.ui.session;
    const std::string path = folder.write("broken.walk.toml", "scene = \"scenes/fence.toml\"\n"
                                                              "stage = \"depth\"\n");
    open(driver, path);
    CHECK(is_up(driver));
    CHECK(driver.ui.sheets.files.fault.starts_with(path + ":2: the view has no 'stage'"));
    CHECK(driver.hand.is_visible("files.message"));
    check_same_view(driver.ui.session, before);
    driver.hand.press(key::escape);
    CHECK_FALSE(is_up(driver));
    check_same_view(driver.ui.session, before);
    driver.hand.frames(3);
    CHECK_FALSE(driver.hand.is_visible("files.path"));

    const std::string bad_scene = folder.write("bad.toml", "name = \"x\"\n");
    const std::string bad_lesson = folder.write("07-bad.md", "<!-- lesson\nrow = 999\n-->\n# T\n");
    for (const std::string& bad : {bad_scene, bad_lesson, folder.file("absent.walk.toml")}) {
        open(driver, bad);
        CHECK(is_up(driver));
        CHECK(driver.ui.sheets.files.fault.find(bad) != std::string::npos);
        driver.hand.click("files.cancel");
        CHECK_FALSE(is_up(driver));
        check_same_view(driver.ui.session, before);
    }
}

TEST_CASE("A file is not overwritten unasked") {
    const TemporaryFolder folder;
    const std::string path = folder.write("there.walk.toml", "old");
    Driver driver;
    save(driver, path);
    CHECK(is_up(driver));
    CHECK(driver.ui.sheets.files.to_replace == path);
    CHECK(bytes_of(path) == "old");
    SECTION("Cancel leaves it") {
        driver.hand.click("files.cancel");
        CHECK(bytes_of(path) == "old");
    }
    SECTION("Enter once more replaces it") {
        driver.hand.press(key::enter);
        CHECK_FALSE(is_up(driver));
        CHECK(bytes_of(path).starts_with("# A view of Rasterwalk"));
    }
    SECTION("so does the button") {
        driver.hand.click("files.do");
        CHECK_FALSE(is_up(driver));
        CHECK(bytes_of(path) != "old");
    }
    SECTION("a different name is saved at once") {
        driver.hand.enter("files.path", folder.file("other"));
        CHECK_FALSE(is_up(driver));
        CHECK(bytes_of(path) == "old");
        CHECK(std::filesystem::exists(folder.file("other.walk.toml")));
    }
}

TEST_CASE("What cannot be written is reported on the sheet") {
    Driver driver;
    save(driver, "/nowhere/at/all");
    CHECK(is_up(driver));
    CHECK(driver.ui.sheets.files.fault.find("/nowhere/at/all.walk.toml") != std::string::npos);
}

TEST_CASE("The view is copied as a command line") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.hand.click_picture(250, 400);
    driver.hand.press('C', ctrl);
    const std::string copied = ImGui::GetClipboardText();
    CHECK(copied.starts_with("rasterwalk --stage depth --pixel 250,400 --triangle "));
    CHECK(copied.find(" --pixel 250,400") != std::string::npos);
    CHECK(driver.ui.session.notice == "Copied: " + copied);
    CHECK_FALSE(driver.ui.session.b); // C alone compares

    ImGui::SetClipboardText("mine");
    driver.hand.click("tab.settings");
    driver.hand.click("settings.search");
    driver.hand.type_text("light");
    driver.hand.press('C', ctrl); // is the field's
    CHECK(std::string(ImGui::GetClipboardText()) == "light");
}

TEST_CASE("The view is copied as a link") {
    constexpr Modifiers ctrl_shift{true, true, false};
    Driver driver;
    driver.hand.click("stage.depth");
    driver.hand.click_picture(250, 400);
    driver.hand.press('C', ctrl_shift);
    const std::string part = ImGui::GetClipboardText();
    CHECK(part.starts_with("#stage=depth&pixel=250,400&triangle="));
    CHECK(driver.ui.session.notice == "Copied what goes after the address of the page: " + part);
    CHECK_FALSE(is_fault(driver.ui.session));
    check_same_view(open_view(parse_view_link(part)), driver.ui.session);

    driver.ui.host.page = "https://example.org/rasterwalk/";
    driver.hand.press('C', ctrl_shift);
    const std::string link = ImGui::GetClipboardText();
    CHECK(link == "https://example.org/rasterwalk/" + part);
    CHECK(driver.ui.session.notice == "Copied: " + link);

    const TemporaryFolder folder;
    const std::string path =
        folder.write("mine.toml", bytes_of(lessons_folder() + "/scenes/fence.toml"));
    open(driver, path);
    driver.hand.press('C', ctrl_shift);
    CHECK(std::string(ImGui::GetClipboardText()) == link);
    CHECK(driver.ui.session.notice ==
          "the scene 'mine.toml' is not one of the page's own files, so a link cannot name it; "
          "save the view instead.");
    CHECK(is_fault(driver.ui.session));
}

TEST_CASE("A quiz gives nothing away, and ends when a file is opened") {
    const TemporaryFolder folder;
    const std::string path = folder.file("v.walk.toml");
    Driver driver;
    save(driver, path);
    REQUIRE(start_quiz(driver.ui.session, read_bugs(), 1));
    driver.hand.frames(3);
    driver.hand.press('S', ctrl);
    CHECK_FALSE(is_up(driver));
    ImGui::SetClipboardText("mine");
    driver.hand.press('C', ctrl);
    driver.hand.press('C', {true, true, false});
    CHECK(std::string(ImGui::GetClipboardText()) == "mine");
    open(driver, path);
    CHECK_FALSE(driver.ui.session.quiz);
    CHECK(driver.ui.session.a.settings == default_settings(*driver.ui.session.scene));
}

TEST_CASE("Files dropped on the window open by their kind") {
    const TemporaryFolder folder;
    Driver driver;
    const auto drop = [&](const std::string& path) {
        open_dropped(driver.ui, path);
        driver.hand.frames(3);
    };
    drop(lessons_folder() + "/04-edges.md");
    CHECK(driver.ui.session.lesson == "04-edges");
    CHECK(driver.ui.session.step == 0);
    const std::string view = folder.file("v.walk.toml");
    write_view(driver.ui.session, view);
    drop(lessons_folder() + "/scenes/fence.toml");
    CHECK(driver.ui.session.scene->name != "The lab's room");
    CHECK(driver.ui.session.lesson.empty()); // it is about a different scene
    drop(view);
    CHECK(driver.ui.session.lesson == "04-edges");
    CHECK_FALSE(is_up(driver));

    const std::string bad = folder.write("bad.walk.toml", "zoom = 3\n");
    drop(bad);
    CHECK(is_up(driver));
    CHECK(driver.ui.sheets.files.fault == bad + ":1: the view needs 'scene'.");
    CHECK(driver.hand.is_visible("files.entry.v.walk.toml"));
}

TEST_CASE("A lesson of another folder brings its folder's lessons with it, and leaves with it") {
    const TemporaryFolder folder;
    const std::string mine =
        folder.write("07-mine.md", bytes_of(lessons_folder() + "/03-points.md"));
    Driver driver;
    open_dropped(driver.ui, mine);
    driver.hand.frames(3);
    CHECK(driver.ui.session.lesson == "07-mine");
    CHECK(driver.ui.lesson.lessons.all().size() == 1);
    const std::string view = folder.file("v.walk.toml");
    save(driver, view);
    open(driver, lessons_folder() + "/04-edges.md");
    CHECK(driver.ui.lesson.lessons.all().size() > 1);
    open(driver, view);
    CHECK(driver.ui.session.lesson == "07-mine");
    CHECK(driver.ui.lesson.shown == "07-mine/0");
}

TEST_CASE("On the sheet folders are entered and files chosen") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("below"));
    folder.write(".hidden.toml", "");
    folder.write("notes.pdf", "");
    folder.write("a.toml", bytes_of(lessons_folder() + "/scenes/fence.toml"));
    Driver driver;
    driver.hand.press('O', ctrl);
    driver.hand.enter("files.path", folder.file(""));
    CHECK(is_up(driver));
    CHECK(driver.ui.sheets.files.entries.size() == 2);
    driver.hand.click("files.entry.below");
    CHECK(driver.ui.sheets.files.entries.empty());
    CHECK(std::filesystem::equivalent(driver.ui.sheets.files.folder, folder.file("below")));
    driver.hand.click("files.up");
    driver.hand.click("files.entry.a.toml");
    CHECK(driver.ui.sheets.files.path == "a.toml");
    CHECK(is_up(driver));
    driver.hand.double_click("files.entry.a.toml");
    CHECK_FALSE(is_up(driver));
    CHECK(driver.ui.session.scene->path == folder.file("a.toml"));

    // A view of this scene belongs next to it.
    driver.hand.press('S', ctrl);
    CHECK(std::filesystem::equivalent(driver.ui.sheets.files.folder, folder.file("")));
    CHECK(driver.ui.sheets.files.path == "a.walk.toml");
    driver.hand.press(key::enter);
    CHECK(std::filesystem::exists(folder.file("a.walk.toml")));
    driver.hand.press('O', ctrl);
    driver.hand.click("files.own");
    CHECK(driver.hand.is_visible("files.entry.scenes"));
    driver.hand.click("files.here");
    CHECK(std::filesystem::equivalent(driver.ui.sheets.files.folder, "."));
}

TEST_CASE("Under the sheet nothing is reached by keys or clicks") {
    Driver driver;
    driver.hand.press('O', ctrl);
    driver.hand.click("files.here"); // the field no longer has the keyboard
    const Session before = driver.ui.session;
    for (const int code :
         {static_cast<int>(key::comma), static_cast<int>('1'), static_cast<int>('C'),
          static_cast<int>('P'), static_cast<int>('W'), key::home}) {
        driver.hand.press(code);
    }
    driver.hand.click("stage.points");
    check_same_view(driver.ui.session, before);
    CHECK(is_up(driver));
}

TEST_CASE("A result of one's own is chosen from a list of pictures and texts") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("older"));
    write_png({4, 4, std::vector<std::uint8_t>(64, 255)}, folder.file("mine.png"));
    write_file(folder.file("rows##1\n.txt"), "Start: (10,5). End: (10,5).\n");
    write_file(folder.file("room.toml"), "");
    write_file(folder.file("empty.txt"), "");
    for (const char* const name : {"small.JPG", "small.jpeg", "mine.ppm"})
        write_file(folder.file(name), "");
    Driver driver;
    driver.ui.sheets.files.folder = folder.file(".");
    driver.open("lab");
    driver.hand.click("lab.mode.result");
    driver.hand.click("lab.choose");
    REQUIRE(driver.ui.sheets.files.kind == FileSheet::Kind::result);
    for (const char* name : {"older", "mine.png", "mine.ppm", "rows##1\n.txt", "empty.txt"}) {
        INFO(name);
        CHECK(driver.hand.is_visible(std::string("files.entry.") + name));
    }
    // A JPG would be refused.
    for (const char* name : {"room.toml", "small.JPG", "small.jpeg"}) {
        INFO(name);
        CHECK_FALSE(driver.hand.is_visible(std::string("files.entry.") + name));
    }

    // The sheet says what cannot be checked; nothing changes behind it.
    driver.hand.click("files.entry.empty.txt");
    driver.hand.click("files.do");
    REQUIRE(is_up(driver));
    CHECK_FALSE(driver.ui.sheets.files.fault.empty());
    driver.hand.double_click("files.entry.mine.png");
    CHECK_FALSE(is_up(driver));
    driver.hand.rest();
    while (is_diagnosing(driver.ui))
        poll_diagnosis(driver.ui, {});
    driver.hand.rest();
    CHECK(driver.ui.lab.result_path == folder.file("mine.png"));
    CHECK((driver.ui.lab.answer || !driver.ui.lab.result_fault.empty()));

    // The folder is remembered.
    driver.hand.click("lab.choose");
    CHECK(driver.hand.is_visible("files.entry.mine.png"));
}

TEST_CASE("The sheet lists a part of a very large folder, and says so") {
    const TemporaryFolder folder;
    for (int i = 0; i < 12; ++i)
        write_file(folder.file(std::to_string(i) + ".txt"), "");
    FileSheet sheet;
    sheet.kind = FileSheet::Kind::result;
    enter_folder(sheet, folder.file("."), 10);
    CHECK(sheet.is_cut);
    CHECK(sheet.entries.size() == 10);
    enter_folder(sheet, folder.file("."), 12);
    CHECK_FALSE(sheet.is_cut);
    CHECK(sheet.entries.size() == 12);
    // A folder that cannot be read leaves the list unchanged.
    enter_folder(sheet, folder.file("there is none"));
    CHECK_FALSE(sheet.fault.empty());
    CHECK(sheet.entries.size() == 12);
}

TEST_CASE("An image is laid on an open model, saved with the view, and taken away by undo") {
    const TemporaryFolder folder;
    const std::string model = folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\n"
                                                    "vt 0 1\nf 1/1 2/2 3/3\n");
    const std::string image = folder.file("x.png");
    write_png({1, 2, {1, 2, 3, 255, 4, 5, 6, 255}}, image);
    Driver driver;
    open(driver, model);
    driver.hand.rest();
    REQUIRE(driver.ui.session.scene->textures.empty());
    find_action("file.lay_texture").run(driver.ui);
    driver.hand.rest();
    REQUIRE(is_up(driver));
    driver.hand.enter("files.path", folder.file("none.png"));
    CHECK(is_up(driver)); // the fault is on the sheet
    CHECK_FALSE(driver.ui.sheets.files.fault.empty());
    driver.hand.enter("files.path", image);
    CHECK_FALSE(is_up(driver));
    REQUIRE(driver.ui.session.scene->textures.size() == 1);
    CHECK(driver.ui.session.scene->parts[0].texture == 0);
    const std::string view = folder.file("v.walk.toml");
    save(driver, view);
    CHECK(read_view(view).texture == "x.png");
    driver.hand.press('Z', ctrl);
    CHECK(driver.ui.session.scene->textures.empty());
}

} // namespace rasterwalk
