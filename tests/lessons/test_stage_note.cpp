#include "lessons/stage_note.h"

#include <filesystem>

#include "base/error.h"
#include "facts/facts.h"
#include "lessons/lesson_link.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "session/results.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

namespace {

Session open_room() {
    return open_session(lessons_folder() + "/scenes/lab-room.toml");
}

Frame frame_of(const Session& session) {
    return prepare_frame(*session.scene, session.a.settings);
}

/// The sentence with which a link is refused; empty if it is followed.
std::string refusal(Session& session, std::string_view target) {
    try {
        follow_lesson_link(session, frame_of(session), parse_lesson_link(target));
    } catch (const UsageError& fault) {
        return fault.what();
    }
    return {};
}

} // namespace

TEST_CASE("Each stage has its note, and a bench has one for all stages") {
    Session session = open_room();
    Session bench = open_session(lessons_folder() + "/scenes/one-triangle.toml");
    for (const StageInfo& info : stage_list()) {
        INFO(info.name);
        set_step(session.a.settings, info.step);
        set_step(bench.a.settings, info.step);
        CHECK(note_name(session) == info.name);
        CHECK(note_name(bench) == "bench");
    }
}

TEST_CASE("What the page about the bench says is true wherever it is shown") {
    StageNotes notes;
    REQUIRE(notes.find("bench").text.find("One triangle on a grid of 20 by 20 pixels") !=
            std::string::npos);
    int benches = 0, others = 0;
    for (const auto& file : std::filesystem::directory_iterator(lessons_folder() + "/scenes")) {
        if (file.path().extension() != ".toml") continue; // the folder of textures
        const Session session = open_session(file.path().string());
        if (session.scene->space != SceneSpace::pixels) continue;
        INFO(file.path());
        const StageNote& note = notes.find(note_name(session));
        CHECK(note.fault.empty());
        const bool is_bench = note_name(session) == "bench";
        if (is_bench) {
            CHECK(session.scene->triangle_count() == 1);
            CHECK(session.a.settings.viewport == Viewport{20, 20});
        }
        (is_bench ? benches : others) += 1;
    }
    CHECK(benches == 1);
    CHECK(others > 5);
}

TEST_CASE("Every note can be read and begins with its title") {
    StageNotes notes;
    for (const StageInfo& info : stage_list()) {
        const StageNote& note = notes.find(std::string(info.name));
        INFO(note.path);
        CHECK(note.fault.empty());
        CHECK(note.text.substr(0, note.text.find('\n')) == "# " + std::string(info.title));
    }
    CHECK(notes.find("bench").text.starts_with("# The bench\n"));
    CHECK(notes.find("pixels").text.starts_with("# A scene in pixels\n"));
}

TEST_CASE("A note that is missing, a folder or too large has a fault in its place") {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder.file("stages/edges.md"));
    folder.write("stages/rows.md", std::string(largest_note + 1, 'a'));
    const std::string path = folder.file("");
    const StageNote missing = read_stage_note(path, "points");
    CHECK(missing.text.empty());
    CHECK_THAT(missing.fault, Catch::Matchers::ContainsSubstring("points.md") &&
                                  Catch::Matchers::ContainsSubstring("No such file"));
    CHECK_THAT(read_stage_note(path, "edges").fault,
               Catch::Matchers::ContainsSubstring("Is a directory"));
    CHECK_THAT(read_stage_note(path, "rows").fault,
               Catch::Matchers::ContainsSubstring("larger than 1 MB"));
}

TEST_CASE("A note that is changed while the program runs is read again") {
    const test::TemporaryFolder folder;
    folder.write("presets.toml", "");
    std::filesystem::create_directories(folder.file("stages"));
    const char* const before = std::getenv("RASTERWALK_LESSONS");
    const std::string kept = before != nullptr ? before : "";
    setenv("RASTERWALK_LESSONS", folder.file("").c_str(), 1);
    StageNotes notes;
    CHECK_FALSE(notes.find("fill").fault.empty());
    folder.write("stages/fill.md", "one");
    CHECK(notes.find("fill").text == "one");
    CHECK(notes.find("fill").text == "one");
    folder.write("stages/fill.md", "and two");
    CHECK(notes.find("fill").text == "and two");
    std::filesystem::remove(folder.file("stages/fill.md"));
    CHECK_FALSE(notes.find("fill").fault.empty());
    if (before != nullptr) {
        setenv("RASTERWALK_LESSONS", kept.c_str(), 1);
    } else {
        unsetenv("RASTERWALK_LESSONS");
    }
}

TEST_CASE("A link sets a setting") {
    Session session = open_room();
    CHECK(refusal(session, "set:interpolation=affine").empty());
    CHECK(session.a.settings.interpolation == Interpolation::affine);
    CHECK(refusal(session, "set:light.power=14").empty());
    CHECK(session.a.settings.light.power == glm::vec3(14.0f));
}

TEST_CASE("A link goes to a moment, stops the play and shows the triangle that is drawn") {
    Session session = open_room();
    session.selection.triangle = 3;
    session.play.running = true;
    CHECK(refusal(session, "cursor:t20/e1/s4").empty());
    CHECK(session.cursor == Cursor{20, Phase::edges, 1, 4});
    CHECK_FALSE(session.play.running);
    CHECK_FALSE(session.selection.triangle);
    CHECK(refusal(session, "cursor:end").empty());
    CHECK(session.cursor == cursor_end);
}

TEST_CASE("A link that cannot be followed is answered by a sentence and changes nothing") {
    Session session = open_room();
    session.a.settings.stage = Stage::points;
    session.selection.triangle = 3;
    const Settings settings = session.a.settings;
    const std::pair<std::string, std::string> cases[] = {
        {"", "leads nowhere"},
        {"https://example.org", "leads nowhere"},
        {"../../etc/passwd", "leads nowhere"},
        {"set:", "is not complete"},
        {"cursor:", "is not complete"},
        {"show:", "is not complete"},
        {"set", "is not complete"},
        {"set:stage", "is not of the form name=value"},
        {"set:stages=rows", "Did you mean 'stage'?"},
        {"set:stage=row", "stage cannot be 'row'"},
        {"set:light.power=nan", "light.power cannot be 'nan'"},
        {"cursor:t0/x1", "is not of the form"},
        {"cursor:t0/p99/s99", "there is no moment t0/p99/s99: no plane cuts triangle t0"},
        {"cursor:t0/k", "there is no moment t0/k: no triangle is culled"},
        {"cursor:t99", "there is no moment t99: the scene has the triangles t0 to t29"},
        {"cursor:t0/e1/s4", "in the points stage a triangle has no edges"},
        {"cursor:t2147483647/r2147483647/c2147483647", "there is no moment"},
        {std::string("set:\0\n=\x01", 8), "there is no setting"},
        {std::string(100'000, 'a'), "leads nowhere"},
    };
    for (const auto& [target, answer] : cases) {
        INFO(target.substr(0, 80));
        const std::string sentence = refusal(session, target);
        CHECK_THAT(sentence, Catch::Matchers::ContainsSubstring(answer));
        CHECK(sentence.ends_with(answer.ends_with('?') ? '?' : '.'));
        CHECK(sentence.find('\n') == std::string::npos);
        CHECK(sentence.size() < 300);
        CHECK(session.a.settings == settings);
        CHECK(session.cursor == cursor_end);
        CHECK(session.selection.triangle == 3);
    }
}

TEST_CASE("A link that only points at a widget leaves the session alone") {
    Session session = open_room();
    const LessonLink link = parse_lesson_link("show:tab.rows");
    CHECK(link.kind == LessonLink::Kind::show);
    CHECK(link.argument == "tab.rows");
    const Settings before = session.a.settings;
    follow_lesson_link(session, frame_of(session), link);
    CHECK(session.a.settings == before);
}

TEST_CASE("A note gives the numbers of what is shown, and nothing about what is not there") {
    const FactReader fact = [](std::string_view name) -> Value {
        if (name == "pixel.zinv") return 2.5;
        return {};
    };
    const std::string text =
        "# Title\n\nA {pixel.zinv} and {pixel.zinv + 1:2}.\n\nNo {pixel.z} here.\n\n"
        "`{code}` stays.\n\nNo {sense at all.\n";
    CHECK(note_about(text, fact) == "# Title\n\nA 2.5 and 3.50.\n\n`{code}` stays.\n\n"
                                    "No {sense at all.\n");
    CHECK(note_about("", fact).empty());
    CHECK(note_about("{pixel.z}", fact).empty());
    CHECK(note_about("{no.such_name}", fact) == "{no.such_name}");
    CHECK(note_about("as it is\n", fact) == "as it is\n");
}

TEST_CASE("The numbers of every note are understood, and are those of the session") {
    StageNotes notes;
    Session session = open_room();
    session.selection.pixel = {250, 400};
    for (const StageInfo& info : stage_list()) {
        INFO(info.name);
        set_step(session.a.settings, info.step);
        Results results;
        update(session, results);
        const std::string text =
            note_about(notes.find(note_name(session)).text, Facts(session, results));
        for (const char* const expression : {"{pixel", "{vertex", "{row"})
            CHECK(text.find(expression) == std::string::npos);
        if (info.step.stage != Stage::depth || strip_place(info.step) != 4) continue;
        CHECK(text.find(
                  "pixel (250,\u00a0400): 5 in all, of which 3 fail the test. The one that stays "
                  "has 1/z\u00a0=\u00a00.4170.") != std::string::npos);
    }
}
