// Views as links: written, read back, and refused where they are wrong or hostile.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/files.h"
#include "laboratory/bug.h"
#include "laboratory/quiz.h"
#include "lessons/lesson_list.h"
#include "lessons/lesson_run.h"
#include "opening/command_line_text.h"
#include "opening/view_link.h"
#include "session/bench.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/random_session.h"
#include "tests/support/temporary_folder.h"
#include "view/view_table.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

namespace fs = std::filesystem;

Session session_on(const std::string& scene) {
    return open_session(lessons_folder() + "/" + scene);
}

/// Checks that the link opens the session it was made from.
void check_round_trip(const Session& session) {
    const std::string link = view_link(session);
    INFO(link);
    CHECK(link.starts_with('#'));
    const Session again = open_view(parse_view_link(link));
    check_same_view(again, session);
    CHECK(command_line_words(again) == command_line_words(session));
    CHECK(view_link(again) == link);
}

/// The sentence with which a link is refused; empty if it is not.
std::string refusal(const std::string& fragment) {
    try {
        parse_view_link(fragment);
        return "";
    } catch (const UsageError& fault) {
        return fault.what();
    }
}

std::string refusal_of(const Session& session) {
    try {
        return "made " + view_link(session);
    } catch (const UsageError& fault) {
        return fault.what();
    }
}

/// A copy of the program's lessons, with further files and some that lead out of it.
class LinkedLessons {
  public:
    LinkedLessons() {
        if (const char* named = std::getenv("RASTERWALK_LESSONS")) before_ = named;
        fs::copy(lessons_folder(), path(""), fs::copy_options::recursive);
        fs::create_directories(path("own/deep"));
        fs::create_directories(folder_.file("outside"));
        for (const char* copy : {"own/91-my-lesson.md", "own/deep/92-deep.md"})
            fs::copy_file(path("05-row-table.md"), path(copy));
        fs::copy_file(path("05-row-table.md"), folder_.file("outside/93-out.md"));
        fs::copy_file(path("scenes/fence.toml"), folder_.file("outside/out.toml"));
        fs::create_symlink(folder_.file("outside/93-out.md"), path("93-out.md"));
        fs::create_symlink(folder_.file("outside/out.toml"), path("scenes/out.toml"));
        fs::create_symlink(folder_.file("outside"), path("away"));
        ::setenv("RASTERWALK_LESSONS", path("").c_str(), 1);
    }
    LinkedLessons(const LinkedLessons&) = delete;
    LinkedLessons& operator=(const LinkedLessons&) = delete;
    ~LinkedLessons() {
        if (before_) {
            ::setenv("RASTERWALK_LESSONS", before_->c_str(), 1);
        } else {
            ::unsetenv("RASTERWALK_LESSONS");
        }
    }

    std::string path(const std::string& name) const {
        return folder_.file(name.empty() ? "lessons" : "lessons/" + name);
    }
    std::string outside(const std::string& name) const { return folder_.file("outside/" + name); }

  private:
    TemporaryFolder folder_;
    std::optional<std::string> before_;
};

bool is_below(const std::string& path, const std::string& folder) {
    const fs::path name = fs::canonical(path).lexically_relative(fs::canonical(folder));
    return !name.empty() && *name.begin() != "..";
}

} // namespace

TEST_CASE("A link opens the same view, for many sessions") {
    Random random(23);
    for (int i = 0; i < rounds(300, 60); ++i) {
        INFO("session " << i);
        check_round_trip(random_session(random));
    }
}

TEST_CASE("A link can lead to the first and the last step of every lesson") {
    LessonList list;
    REQUIRE(list.all().size() > 20);
    for (const Lesson& lesson : list.all()) {
        for (const int step : {0, static_cast<int>(lesson.steps.size()) - 1}) {
            Session session = session_on("scenes/fence.toml");
            REQUIRE(open_step(session, lesson, step).empty());
            const std::string said = step == 0 ? "" : "&step=" + std::to_string(step);
            CHECK(view_link(session) == "#lesson=" + lesson.id + said);
            check_round_trip(session);
        }
    }
}

TEST_CASE("A link shows every mistake next to the correct run") {
    for (const Bug& bug : read_bugs()) {
        INFO(bug.id);
        Session session = session_on("scenes/lab-room.toml");
        open_bug(bug, session);
        check_round_trip(session);
        const Session named = open_view(parse_view_link("bug=" + bug.id));
        CHECK(named.b.has_value());
    }
}

TEST_CASE("A link is short and readable") {
    Session session = session_on("scenes/lab-room.toml");
    CHECK(view_link(session) == "#");
    check_round_trip(session);
    set_rounding(session.a.settings, Rounding::floor);
    session.selection.pixel = glm::ivec2(250, 400);
    session.canvas.zoom = 16.0f;
    session.canvas.centre = {250.5f, -3.0f};
    CHECK(view_link(session) == "#set=rounding=floor&pixel=250,400&zoom=16&centre=250.5,-3");
    check_round_trip(session);
    session = session_on("scenes/one-triangle.toml");
    session.cursor = Cursor{0, Phase::edges, 1, 5};
    move_bench_vertex(session, 0, 0, {-10, 4});
    CHECK(view_link(session) ==
          "#scene=scenes/one-triangle.toml&vertices=-10,4/5,10/15,15&to=t0/e1/s5");
    check_round_trip(session);
}

TEST_CASE("A link can contain everything that the options of a view can") {
    CHECK(parse_view_link("") == ViewOptions{});
    CHECK(parse_view_link("#") == ViewOptions{});
    const ViewOptions said = parse_view_link(
        "#lesson=05-row-table&step=3&stage=fill&bug=B9&size=64x48&preset=a&preset=b c&set=x=1"
        "&set=y=a%26b%3dc&set=z==");
    CHECK(said.lesson == "05-row-table");
    CHECK(said.step == "3");
    CHECK(said.stage == "fill");
    CHECK(said.bug == "B9");
    CHECK(said.size == "64x48");
    CHECK(said.presets == std::vector<std::string>{"a", "b c"});
    CHECK(said.assignments == std::vector<std::string>{"x=1", "y=a&b=c", "z=="});
    int fields = 0;
    for (const ViewField& field : view_table()) {
        if (!field.parse) continue;
        ++fields;
        const std::string name(field.option.name);
        INFO(name);
        const std::vector<std::string> odd{"--stage"}; // not an option here
        CHECK(parse_view_link(name + "=--stage").given.at(std::string(field.key)) == odd);
        const std::string twice = name + "=a&" + name + "=b";
        if (field.option.is_repeatable) {
            const std::vector<std::string> both{"a", "b"};
            CHECK(parse_view_link(twice).given.at(std::string(field.key)) == both);
        } else {
            CHECK(refusal(twice) == "the link names '" + name + "' twice.");
        }
    }
    CHECK(fields > 15);
    for (const char* odd : {"{}", "[]", "[a,b]", "%25%25", "'a'", "\"a\"", "@a", "+", "-1", "-h"}) {
        INFO(odd);
        const std::string word = odd == std::string("%25%25") ? "%%" : odd;
        CHECK(parse_view_link(std::string("pixel=") + odd).given.at("pixel") ==
              std::vector<std::string>{word});
        CHECK(parse_view_link(std::string("b=") + odd).given.at("compare") ==
              std::vector<std::string>{word});
    }
    CHECK(parse_view_link("pi%78el=1%2C2").given.at("pixel") == std::vector<std::string>{"1,2"});
    CHECK(parse_view_link("preset=Stra\xc3\x9f%c3%9f").presets.front() == "Stra\xc3\x9f\xc3\x9f");
    const Session session = open_view(parse_view_link("lesson=05-row-table&step=3&row=none"));
    CHECK(session.lesson == "05-row-table");
    CHECK(session.step == 3);
    CHECK_FALSE(session.selection.row);
}

TEST_CASE("Text that is not a link is refused with a sentence") {
    CHECK(refusal("lessn=04-edges") == "a link cannot set 'lessn'. Did you mean 'lesson'?");
    CHECK(refusal("=3") == "a link cannot set ''.");
    CHECK(refusal("--lesson=04-edges") == "a link cannot set '--lesson'. Did you mean 'lesson'?");
    for (const char* name : {"help", "h", "FILE", "file", "output", "o", "version", "json",
                             "config", "time", "polygon", "a", "Lesson", "compare", "cursor"}) {
        INFO(name);
        CHECK_THAT(refusal(std::string(name) + "=x"),
                   Catch::Matchers::ContainsSubstring("a link cannot set '" + std::string(name)));
    }
    const std::string no_pair = "', which is not a name and a value, like step=3.";
    CHECK(refusal("lesson") == "the link has 'lesson" + no_pair);
    CHECK(refusal("render") == "the link has 'render" + no_pair);
    CHECK(refusal("tab=rows&") == "the link has '" + no_pair);
    CHECK(refusal("&tab=rows") == "the link has '" + no_pair);
    CHECK(refusal("tab=rows&&row=3") == "the link has '" + no_pair);
    CHECK(refusal("##tab=rows") == "a link cannot set '#tab'. Did you mean 'tab'?");
    CHECK(refusal("tab=") == "the link names 'tab' without a value.");
    CHECK(refusal("step=3") == "step can only be used with lesson.");
    CHECK(refusal("step=3&scene=scenes/fence.toml") == "step can only be used with lesson.");
    CHECK(refusal("tab=rows&tab=rows") == "the link names 'tab' twice.");
    CHECK(refusal("lesson=04-edges&lesson=05-row-table") == "the link names 'lesson' twice.");
    const std::string no_escape = "', but a % must be followed by two hexadecimal digits, as in "
                                  "%20.";
    CHECK(refusal("tab=%") == "the link has '%" + no_escape);
    CHECK(refusal("tab=%4") == "the link has '%4" + no_escape);
    CHECK(refusal("tab=%g0") == "the link has '%g0" + no_escape);
    CHECK(refusal("tab=%0G") == "the link has '%0G" + no_escape);
    CHECK(refusal("tab=%-1") == "the link has '%-1" + no_escape);
    CHECK(refusal("%=rows") == "the link has '%" + no_escape);
    for (const std::string bad :
         {"%00", "a%00", "%0a", "%0D", "%09", "%1b[2J", "%7f", "%c2%85", "%e2%80%ae", "%ff", "%c3",
          "\xff", "\t", "\n", "%ed%a0%80", "%c0%af", "%f4%90%80%80"}) {
        INFO(bad);
        const std::string rest = "which is not plain UTF-8 text on one line.";
        CHECK_THAT(refusal("preset=" + bad), Catch::Matchers::ContainsSubstring(rest));
        CHECK_THAT(refusal(bad + "=x"), Catch::Matchers::ContainsSubstring(rest));
    }
    CHECK(refusal(std::string("preset=a\0b", 10)) ==
          "the link has 'a\\u0000b', which is not plain UTF-8 text on one line.");
}

TEST_CASE("The length of a link is limited") {
    const std::string name = "preset=";
    const std::string longest = name + std::string(longest_view_link - name.size(), 'x');
    CHECK(parse_view_link(longest).presets.front().size() == longest_view_link - name.size());
    CHECK(parse_view_link("#" + longest).presets.size() == 1);
    CHECK(refusal(longest + "x") == "the link is longer than 8192 bytes.");
    CHECK(refusal(std::string(1 << 20, '%')) == "the link is longer than 8192 bytes.");
}

TEST_CASE("Values that no view can have are refused when the view is opened") {
    for (const char* bad :
         {"stage=dept", "bug=B999", "preset=/etc/passwd", "set=rounding", "set=/etc/passwd=1",
          "tab=../rows", "b=/etc/passwd", "size=9999999x1", "lesson=05-row-table&step=99",
          "vertices=1,2", "to=t0/x", "page=/etc"}) {
        INFO(bad);
        const ViewOptions options = parse_view_link(bad);
        CHECK_THROWS_AS(open_view(options), UsageError);
    }
}

TEST_CASE("A link opens nothing but the page's own files") {
    const LinkedLessons lessons;
    const std::string leads_out = " leads out of the lessons folder.";
    const std::string absent = " in the lessons folder.";
    CHECK(refusal("scene=/etc/passwd") == "'/etc/passwd'" + leads_out);
    CHECK(refusal("scene=%2Fetc%2Fpasswd") == "'/etc/passwd'" + leads_out);
    CHECK(refusal("scene=../outside/out.toml") == "'../outside/out.toml'" + leads_out);
    CHECK(refusal("scene=scenes/%2E%2e/scenes/fence.toml") ==
          "'scenes/../scenes/fence.toml'" + leads_out);
    CHECK(refusal("scene=" + lessons.path("scenes/fence.toml")).ends_with(leads_out));
    CHECK(refusal("scene=scenes/out.toml") == "there is no file 'scenes/out.toml'" + absent);
    CHECK(refusal("scene=away/out.toml") == "there is no file 'away/out.toml'" + absent);
    CHECK(refusal("scene=scenes") == "there is no file 'scenes'" + absent);
    CHECK(refusal("scene=.") == "there is no file '.'" + absent);
    CHECK(refusal("scene=-") == "there is no file '-'" + absent);
    CHECK(refusal("scene=~/x.toml") == "there is no file '~/x.toml'" + absent);
    CHECK(refusal("scene=file:///etc/passwd") == "there is no file 'file:///etc/passwd'" + absent);
    CHECK_FALSE(refusal("scene=" + std::string(8000, 'x')).empty());
    CHECK_FALSE(refusal("scene=" + std::string(8000, '/')).empty());

    CHECK(refusal("lesson=05-row-tabel") ==
          "there is no lesson '05-row-tabel'. Did you mean '05-row-table'?");
    CHECK(refusal("lesson=/etc/passwd") == "'/etc/passwd.md'" + leads_out);
    CHECK(refusal("lesson=../outside/93-out.md") == "'../outside/93-out.md'" + leads_out);
    CHECK(refusal("lesson=..") == "there is no lesson '..'.");
    CHECK(refusal("lesson=" + lessons.outside("93-out.md")).ends_with(leads_out));
    CHECK(refusal("lesson=" + lessons.path("05-row-table.md")).ends_with(leads_out));
    CHECK_THAT(refusal("lesson=93-out"),
               Catch::Matchers::ContainsSubstring("there is no lesson '93-out'."));
    CHECK(refusal("lesson=away/93-out") == "there is no file 'away/93-out.md'" + absent);
    CHECK(refusal("lesson=own/94-none") == "there is no file 'own/94-none.md'" + absent);

    // The same without a path out is opened.
    CHECK(parse_view_link("scene=scenes/fence.toml").scene == lessons.path("scenes/fence.toml"));
    CHECK(parse_view_link("lesson=05-row-table.md").lesson == "05-row-table");
    for (const char* lesson : {"own/91-my-lesson", "own/91-my-lesson.md", "./own/91-my-lesson"}) {
        const ViewOptions options = parse_view_link(std::string("step=2&lesson=") + lesson);
        CHECK(options.lesson == lessons.path("own/91-my-lesson.md"));
        const Session session = open_view(options);
        CHECK(session.lesson == "91-my-lesson");
        CHECK(session.step == 2);
    }
    CHECK_THROWS_AS(open_view(parse_view_link("scene=presets.toml")), InputError);
    CHECK_THROWS_AS(open_view(parse_view_link("lesson=README")), UsageError);
}

TEST_CASE("A file of the same name in the current folder is not used") {
    const TemporaryFolder folder;
    fs::create_directories(folder.file("scenes"));
    folder.write("scenes/fence.toml", "no scene");
    const fs::path before = fs::current_path();
    const std::string expected = fs::canonical(lessons_folder()).string() + "/scenes/fence.toml";
    const ViewOptions options = parse_view_link("scene=scenes/fence.toml");
    fs::current_path(folder.file(""));
    std::string shown, link;
    try {
        const Session session = open_view(options);
        shown = session.scene->path;
        link = view_link(session);
    } catch (const Error& fault) {
        shown = fault.what();
    }
    fs::current_path(before);
    CHECK(is_same_file(shown, expected));
    CHECK(link == "#scene=scenes/fence.toml");
}

TEST_CASE("Files with awkward names can be in a link, and are read again") {
    const LinkedLessons lessons;
    for (const char* name : {"ü & = #%.toml", "it's \"q\" <b> `ls` $HOME.toml", "a+b@c:d,e~f!.toml",
                             "%41%.toml", "--set=rounding=floor.toml", " .toml", "..x.toml"}) {
        INFO(name);
        fs::copy_file(lessons.path("scenes/fence.toml"), lessons.path(name));
        const Session session = open_session(lessons.path(name));
        check_round_trip(session);
        const std::string link = view_link(session);
        CHECK(link.find_first_of(" \"'`<>$\\\xc3\xbc", 1) == std::string::npos);
        CHECK(link.find('#', 1) == std::string::npos);
    }
    fs::copy_file(lessons.path("scenes/fence.toml"), lessons.path("ü & = #.toml"));
    CHECK(view_link(open_session(lessons.path("ü & = #.toml"))) ==
          "#scene=%C3%BC%20%26%20=%20%23.toml");
    fs::copy_file(lessons.path("scenes/fence.toml"), lessons.path("a\nb.toml"));
    CHECK(refusal_of(open_session(lessons.path("a\nb.toml"))) ==
          "'a b.toml' cannot be written in a link; save the view instead.");
}

TEST_CASE("A lesson in a subfolder is named from the folder of the lessons") {
    const LinkedLessons lessons;
    const auto session_in = [&](const std::string& file, int step) {
        Session session = session_on("scenes/fence.toml");
        REQUIRE(open_step(session, read_lesson(lessons.path(file)), step).empty());
        return session;
    };
    const Session own = session_in("own/91-my-lesson.md", 3);
    CHECK(view_link(own) == "#lesson=own/91-my-lesson&step=3");
    check_round_trip(own);
    const Session deep = session_in("own/deep/92-deep.md", 0);
    CHECK(view_link(deep) == "#lesson=own/deep/92-deep");
    check_round_trip(deep);
}

TEST_CASE("Files that are not the page's own have no link") {
    const LinkedLessons lessons;
    const std::string rest =
        " is not one of the page's own files, so a link cannot name it; save the view instead.";
    CHECK(refusal_of(open_session(lessons.outside("out.toml"))) == "the scene 'out.toml'" + rest);
    CHECK(refusal_of(open_session(lessons.path("scenes/out.toml"))) ==
          "the scene 'out.toml'" + rest);
    ViewOptions options;
    options.lesson = lessons.outside("93-out.md");
    CHECK(refusal_of(open_view(options)) == "the lesson '93-out.md'" + rest);
    options.lesson = "93-out";
    CHECK(refusal_of(open_view(options)) == "the lesson '93-out.md'" + rest);
    options.lesson = "05-row-table";
    options.scene = lessons.outside("out.toml");
    CHECK(refusal_of(open_view(options)) == "the scene 'out.toml'" + rest);
}

TEST_CASE("A view that is too long for a link or hidden by a quiz has no link") {
    Session session = session_on("scenes/lab-room.toml");
    REQUIRE(start_quiz(session, read_bugs(), 1));
    CHECK(refusal_of(session) == "the view cannot be copied while a quiz is hiding its settings.");

    const LinkedLessons lessons;
    std::string scene = bytes_of(lessons.path("scenes/one-triangle.toml"));
    const std::string list = "\"A B C\"";
    std::string longer = list;
    constexpr int count = 320;
    for (int i = 1; i < count; ++i)
        longer += ", " + list;
    scene.replace(scene.find(list), list.size(), longer);
    std::ofstream(lessons.path("many.toml")) << scene;
    session = open_session(lessons.path("many.toml"));
    REQUIRE(session.scene->triangle_count() == count);
    check_round_trip(session);
    for (int i = 0; i < count; ++i)
        move_bench_vertex(session, i, 0, {1 + i % 7, 2 + i % 5});
    CHECK(refusal_of(session) ==
          "the link would be longer than 8192 bytes; save the view instead.");
}

TEST_CASE("Any text of a link is read or refused, and opens only permitted files") {
    const LinkedLessons lessons;
    std::vector<std::string> names{"scene", "lesson", "step", "stage", "bug", "preset", "set"};
    for (const ViewField& field : view_table()) {
        if (field.parse) names.emplace_back(field.option.name);
    }
    const std::vector<std::string> values{"scenes/fence.toml",
                                          "scenes/one-triangle.toml",
                                          "05-row-table",
                                          "own/91-my-lesson",
                                          "3",
                                          "fill",
                                          "B9",
                                          "rounding=floor",
                                          "1,2",
                                          "none",
                                          "on",
                                          "depth",
                                          "../x",
                                          "/etc/passwd",
                                          "away/out.toml",
                                          "93-out",
                                          "scenes/out.toml",
                                          "away/93-out",
                                          "{}",
                                          "[]",
                                          "%",
                                          "%00",
                                          "%41",
                                          "%ff",
                                          "\xff",
                                          "--",
                                          "-1",
                                          "",
                                          "=",
                                          "#",
                                          "&",
                                          "+",
                                          "t0/e1/s5",
                                          "0:1,2/3,4/5,6",
                                          "end",
                                          "history",
                                          "own/../05-row-table",
                                          "nan",
                                          "1e99"};
    const std::vector<std::string> good{"scene=scenes/fence.toml",
                                        "lesson=05-row-table",
                                        "lesson=own/91-my-lesson",
                                        "stage=fill",
                                        "bug=B9",
                                        "set=rounding=floor",
                                        "pixel=1,2",
                                        "to=end",
                                        "tab=history",
                                        "b=stage=edges",
                                        "row=none",
                                        "overlay=depth",
                                        "zoom=fit",
                                        "grid=off"};
    Random random(5);
    const auto any_of = [&](const std::vector<std::string>& list) {
        return list[static_cast<std::size_t>(random.integer(0, static_cast<int>(list.size()) - 1))];
    };
    int opened = 0, refused = 0;
    for (int i = 0; i < rounds(10000, 800); ++i) {
        std::string link = random.integer(0, 1) == 0 ? "#" : "";
        for (int pairs = random.integer(0, 3); pairs >= 0; --pairs) {
            const bool is_good = random.integer(0, 2) > 0;
            link += is_good ? any_of(good) : any_of(names) + "=" + any_of(values);
            if (pairs > 0) link += "&";
        }
        for (int bytes = random.integer(0, 3) == 0 ? random.integer(1, 4) : 0; bytes > 0; --bytes) {
            const auto at =
                static_cast<std::size_t>(random.integer(0, static_cast<int>(link.size())));
            link.insert(at, 1, static_cast<char>(random.integer(0, 255)));
        }
        INFO("link " << i << ": " << link);
        ViewOptions options;
        try {
            options = parse_view_link(link);
        } catch (const UsageError& fault) {
            ++refused;
            const std::string sentence = fault.what();
            CHECK((sentence.ends_with('.') || sentence.ends_with('?')));
            continue;
        }
        CHECK(options.file.empty());
        if (!options.scene.empty()) CHECK(is_below(options.scene, lessons.path("")));
        if (options.lesson.find('/') != options.lesson.npos) {
            CHECK(is_below(options.lesson, lessons.path("")));
        }
        try {
            const Session session = open_view(options);
            ++opened;
            CHECK(is_below(session.scene->path, lessons.path("")));
            if (opened % 10 == 0) check_round_trip(session);
        } catch (const UsageError&) { // a value that no view can have
        } catch (const InputError&) {
        }
    }
    CHECK(opened > 50);
    CHECK(refused > 200);
}
