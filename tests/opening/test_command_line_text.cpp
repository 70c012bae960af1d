#include <array>
#include <cstdio>
#include <string>

#include "base/error.h"
#include "laboratory/bug.h"
#include "laboratory/quiz.h"
#include "lessons/lesson_run.h"
#include "opening/command_line_text.h"
#include "session/bench.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/random_session.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Session opened_again(const Session& session) {
    std::vector<std::string> words = command_line_words(session);
    REQUIRE(words.front() == "rasterwalk");
    words.erase(words.begin());
    CliRun result = run(words);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    REQUIRE(result.request.open_window);
    return std::move(result.request.session);
}

std::string own_scene(const char* name) {
    return lessons_folder() + "/scenes/" + name;
}

/// The words that a real shell splits a line into, one per line.
std::string words_of_shell(const std::string& line) {
    const std::string command = "printf '%s\\n' " + line;
    FILE* const pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string out;
    std::array<char, 4096> part;
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe))
        out.append(part.data(), count);
    CHECK(pclose(pipe) == 0);
    return out;
}

} // namespace

TEST_CASE("A copied command line opens the same view, for many sessions") {
    Random random(11);
    for (int i = 0; i < test::rounds(300, 60); ++i) {
        const Session session = random_session(random);
        INFO("session " << i << "\n" << command_line_text(session));
        check_same_view(opened_again(session), session);
    }
}

TEST_CASE("A command line contains only what differs") {
    Session session = open_session(own_scene("lab-room.toml"));
    CHECK(command_line_text(session) == "rasterwalk");
    session.a.settings.stage = Stage::depth;
    session.selection.pixel = glm::ivec2(250, 400);
    session.tab = "graph";
    CHECK(command_line_text(session) == "rasterwalk --stage depth --pixel 250,400 --tab graph");
    session.tab = "history"; // which suits the stage
    CHECK(command_line_text(session) == "rasterwalk --stage depth --pixel 250,400");
    session = open_session(own_scene("one-triangle.toml"));
    session.cursor = Cursor{0, Phase::edges, 1, 5};
    move_bench_vertex(session, 0, 0, {10, 4});
    CHECK(command_line_text(session) == "rasterwalk --scene scenes/one-triangle.toml --vertices "
                                        "10,4/5,10/15,15 --to t0/e1/s5");
    const Lesson lesson = read_lesson(lessons_folder() + "/05-row-table.md");
    REQUIRE(open_step(session, lesson, 3).empty());
    CHECK(command_line_text(session) == "rasterwalk --lesson 05-row-table --step 3");
    set_rounding(session.a.settings, Rounding::floor);
    CHECK(command_line_text(session) ==
          "rasterwalk --lesson 05-row-table --step 3 --set rounding=floor");
}

TEST_CASE("A mistake compared with the correct run is copied with both runs") {
    Session session = open_session(own_scene("lab-room.toml"));
    for (const Bug& bug : read_bugs()) {
        INFO(bug.id);
        open_bug(bug, session);
        check_same_view(opened_again(session), session);
    }
}

TEST_CASE("Two equal runs without light are copied as they are") {
    Session session = open_session(own_scene("lab-room.toml"));
    set_from_text(session.a.settings, "shading=unlit");
    session.b = session.a;
    const Session again = opened_again(session);
    REQUIRE(again.b);
    CHECK(again.a.settings == session.a.settings);
    CHECK(again.b->settings == session.a.settings);
}

TEST_CASE("Files with awkward names are quoted for the shell") {
    const TemporaryFolder folder;
    const std::string path =
        folder.write("it's $HOME `ls` \"q\" \\ ü.toml", bytes_of(own_scene("fence.toml")));
    const Session session = open_session(path);
    CHECK(words_of_shell(command_line_text(session)) == "rasterwalk\n--scene\n" + path + "\n");
    check_same_view(opened_again(session), session);
    CHECK(shell_quoted("") == "''");
    CHECK(shell_quoted("a b") == "'a b'");
    CHECK(shell_quoted("t0/e1/s5") == "t0/e1/s5");
}

TEST_CASE("A quiz gives nothing away in a command line") {
    Session session = open_session(own_scene("lab-room.toml"));
    REQUIRE(start_quiz(session, read_bugs(), 1));
    CHECK_THROWS_AS(command_line_text(session), UsageError);
}
