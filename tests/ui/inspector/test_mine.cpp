#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "engines/program_drawing.h"
#include "mine/checked_program.h"
#include "tests/support/catch.h"
#include "tests/support/student_programs.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/mine.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/view_files.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// Saves a source as an editor does, so that its state changes even within a clock tick.
void save_source(const std::string& path, const std::string& text) {
    const auto before = std::filesystem::exists(path) ? std::filesystem::last_write_time(path)
                                                      : std::filesystem::file_time_type{};
    std::ofstream(path) << text;
    std::filesystem::last_write_time(path, before + std::chrono::seconds(2));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != text.npos);
    return text.replace(at, from.size(), to);
}

void finish_mine(Driver& driver) {
    finish_program_check(driver.ui);
    driver.hand.rest();
}

std::string mine_text(Driver& driver, const std::string& widget) {
    INFO(widget);
    REQUIRE(driver.ui.widgets.count(widget) == 1);
    return driver.ui.widgets.at(widget).text;
}

/// A student's program that is saved again and again, and its window.
struct SavedProgram {
    SavedProgram() {
        cache_before =
            std::getenv("RASTERWALK_CACHE") == nullptr ? "" : std::getenv("RASTERWALK_CACHE");
        ::setenv("RASTERWALK_CACHE", folder.file("cache").c_str(), 1);
        driver->ui.mine.look_pause = {}; // a frame sees what was saved before it
    }
    ~SavedProgram() {
        driver.reset(); // its threads read the environment
        if (cache_before.empty()) {
            ::unsetenv("RASTERWALK_CACHE");
        } else {
            ::setenv("RASTERWALK_CACHE", cache_before.c_str(), 1);
        }
    }
    SavedProgram(const SavedProgram&) = delete;
    SavedProgram& operator=(const SavedProgram&) = delete;

    /// Saves it with another text in place of this one, and waits until it is checked.
    void save_with(const std::string& from, const std::string& to) {
        text = replaced(text, from, to);
        save_source(path, text);
        driver->hand.frames(1);
        REQUIRE(is_checking_program(driver->ui));
        finish_mine(*driver);
    }

    test::TemporaryFolder folder;
    std::string cache_before;
    std::string path = folder.file("skeleton.cpp");
    std::string text = test::student_sources("styles/classic.cpp").front().text;
    std::optional<Driver> driver{std::in_place};
};

// What three mistakes of the laboratory change in tests/mine/styles/classic.cpp.
const std::string right_vertex = "vec3 pos = ( v.position - cameraPos ) * R;";
const std::string wrong_vertex = "vec3 pos = ( v.position + cameraPos ) * R;";
const std::string right_count = "int n = max( abs( a.x - b.x ), abs( a.y - b.y ) ) + 1;";
const std::string wrong_count = "int n = abs( a.y - b.y ) + 1;";
const std::string right_depth = "if( p.zinv > depthBuffer[p.y][p.x] )";
const std::string wrong_depth = "if( p.zinv < depthBuffer[p.y][p.x] )";

} // namespace

TEST_CASE("Three mistakes are found and mended one after the other, by the window alone") {
    SavedProgram program;
    Driver& driver = *program.driver;
    program.text = replaced(program.text, right_vertex, wrong_vertex);
    program.text = replaced(program.text, right_count, wrong_count);
    program.text = replaced(program.text, right_depth, wrong_depth);
    save_source(program.path, program.text);
    open_dropped(driver.ui, program.path);
    CHECK(driver.ui.session.tab == "mine");
    REQUIRE(is_checking_program(driver.ui));
    driver.hand.frames(2);
    CHECK(driver.hand.is_visible("mine.stop"));
    finish_mine(driver);
    REQUIRE(driver.ui.mine.fault == "");
    // One mistake fails one line, because the input of each function is ours.
    CHECK(mine_text(driver, "mine.line.VertexShader").starts_with("0 of"));
    CHECK(driver.hand.is_visible("mine.first")); // the first line that is wrong is shown
    CHECK_THAT(mine_text(driver, "mine.known"), Catch::Matchers::StartsWith("B70 "));

    program.save_with(wrong_vertex, right_vertex);
    CHECK(mine_text(driver, "mine.change.0") == "VertexShader was wrong and is right now.");
    CHECK_THAT(mine_text(driver, "mine.known"), Catch::Matchers::StartsWith("B5 "));
    CHECK(driver.hand.is_visible("mine.rows")); // both row tables

    program.save_with(wrong_count, right_count);
    CHECK(mine_text(driver, "mine.change.0") == "ComputePolygonRows was wrong and is right now.");
    // Of a program that draws nothing the functions behind cannot be told apart.
    CHECK(mine_text(driver, "mine.picture") == "Your program puts no pixel on the screen.");
    CHECK_THAT(mine_text(driver, "mine.nothing.4"), Catch::Matchers::ContainsSubstring("B17a"));

    program.save_with(wrong_depth, right_depth);
    CHECK(mine_text(driver, "mine.right") == right_words);
    CHECK(mine_text(driver, "mine.line.picture") == "same as ours");
    CHECK(mine_text(driver, "mine.line.keys_held") == "nothing found");
}

TEST_CASE("A compile error is shown with its line, and mended") {
    SavedProgram program;
    Driver& driver = *program.driver;
    program.text = replaced(program.text, right_count, "int n = max( abs( a.x - b.x ) + 1;");
    save_source(program.path, program.text);
    check_my_program(driver.ui, program.path);
    finish_mine(driver);
    const std::string place = mine_text(driver, "mine.place");
    CHECK_THAT(place, Catch::Matchers::StartsWith("skeleton.cpp:"));
    CHECK(mine_text(driver, "mine.source." + place.substr(place.find(':') + 1)) ==
          "        int n = max( abs( a.x - b.x ) + 1;");
    program.save_with("int n = max( abs( a.x - b.x ) + 1;", right_count);
    CHECK(mine_text(driver, "mine.change.0") == "The code was wrong and is right now.");
    CHECK(mine_text(driver, "mine.right") == right_words);
}

TEST_CASE("A header that is missing is noticed once it is made") {
    SavedProgram program;
    Driver& driver = *program.driver;
    program.text.insert(0, "#include \"mine.h\"\n");
    save_source(program.path, program.text);
    check_my_program(driver.ui, program.path);
    finish_mine(driver);
    CHECK_THAT(mine_text(driver, "mine.message.0.text"),
               Catch::Matchers::ContainsSubstring("mine.h"));
    program.folder.write("mine.h", "");
    driver.ui.mine.next_listing = {}; // it looks once a second
    driver.hand.frames(1);
    REQUIRE(is_checking_program(driver.ui));
    finish_mine(driver);
    CHECK(mine_text(driver, "mine.line.compiled").empty());
}

TEST_CASE("Both programs are walked to where they part, and a mended one replaces its picture") {
    SavedProgram program;
    Driver& driver = *program.driver;
    program.text = replaced(program.text, right_count, wrong_count);
    save_source(program.path, program.text);
    check_my_program(driver.ui, program.path);
    finish_mine(driver);
    driver.hand.click("mine.line.picture");
    driver.hand.click("mine.walk");
    driver.hand.rest();
    finish(driver.ui.session, driver.ui.results);
    driver.hand.rest();
    const Session& session = driver.ui.session;
    REQUIRE(session.b);
    REQUIRE(session.b->program);
    const std::shared_ptr<const ProgramDrawing> before = session.b->program;
    REQUIRE(before->parting);
    CHECK(session.cursor == moment_of_parting(*before));
    // Up to there both pictures are the same; in the end they are not.
    CHECK(driver.ui.results.comparison.pixels.shown == 0);
    driver.hand.press(key::end);
    driver.hand.rest();
    CHECK(driver.ui.results.comparison.pixels.shown > 1000);
    // Only run B becomes another one: where the student looks stays.
    driver.hand.click("tab.compare");
    driver.ui.session.selection.triangle = 3;
    driver.hand.rest();
    const std::shared_ptr<const Scene> scene = session.scene;
    program.save_with(wrong_count, right_count);
    driver.hand.rest();
    CHECK(session.scene == scene);
    CHECK(session.tab == "compare");
    CHECK(session.selection.triangle == 3);
    REQUIRE(session.b);
    REQUIRE(session.b->program);
    CHECK(session.b->program != before);
    CHECK_FALSE(session.b->program->parting);
    CHECK(driver.ui.results.comparison.pixels.shown == 0);
    // Compared while the next check runs, it is the picture known so far, and then the next one.
    program.text = replaced(program.text, right_count, wrong_count);
    save_source(program.path, program.text);
    driver.hand.frames(1);
    REQUIRE(is_checking_program(driver.ui));
    compare_my_program(driver.ui, false);
    REQUIRE(session.b->program);
    CHECK_FALSE(session.b->program->parting);
    finish_mine(driver);
    CHECK(session.b->program->parting);
}

TEST_CASE("A check is stopped, and what is not a program is said") {
    SavedProgram program;
    Driver& driver = *program.driver;
    save_source(program.path, program.text);
    check_my_program(driver.ui, program.path);
    driver.hand.frames(2);
    driver.hand.click("mine.stop");
    CHECK_FALSE(is_checking_program(driver.ui));
    driver.hand.frames(1);
    CHECK_THAT(mine_text(driver, "mine.state"), Catch::Matchers::StartsWith("Stopped."));
    const std::string other = program.folder.write("rows.cpp", "int Rows() { return 1; }\n");
    check_my_program(driver.ui, other);
    finish_mine(driver);
    CHECK_THAT(mine_text(driver, "mine.fault"), Catch::Matchers::ContainsSubstring("main"));
    CHECK(driver.ui.widgets.count("mine.line.compiled") == 0);
}

TEST_CASE("No view, lesson or link starts a program") {
    const test::TemporaryFolder folder;
    const std::string program = folder.write("skeleton.cpp", "int main() {}\n");
    Driver driver;
    driver.ui.options.program = program; // as it was the last time
    follow_link(driver.ui, "tab:mine");
    driver.hand.rest();
    CHECK(driver.ui.session.tab == "mine");
    CHECK(driver.hand.is_visible("mine.last"));
    open_lesson(driver.ui, "36-your-own-program", 1);
    driver.hand.rest();
    follow_link(driver.ui, "show:" + program);
    follow_link(driver.ui, program);
    driver.hand.rest();
    CHECK_FALSE(is_checking_program(driver.ui));
    driver.open("mine");
    CHECK_FALSE(is_checking_program(driver.ui));
    CHECK(driver.hand.is_visible("mine.choose"));
    driver.hand.click("mine.choose");
    driver.hand.frames(2);
    CHECK(driver.ui.sheets.files.kind == FileSheet::Kind::result);
    CHECK_FALSE(is_checking_program(driver.ui));
}

} // namespace rasterwalk
