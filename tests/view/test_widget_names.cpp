#include "view/widget_names.h"

#include <cstdlib>
#include <filesystem>

#include "base/error.h"
#include "session/content.h"
#include "support/temporary_folder.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// A copy of the program's lessons, as a teacher might have, in place of them.
class OtherLessons {
  public:
    OtherLessons() {
        std::filesystem::copy(lessons_folder(), file("lessons"),
                              std::filesystem::copy_options::recursive);
        ::setenv("RASTERWALK_LESSONS", file("lessons").c_str(), 1);
    }
    OtherLessons(const OtherLessons&) = delete;
    OtherLessons& operator=(const OtherLessons&) = delete;
    ~OtherLessons() { ::unsetenv("RASTERWALK_LESSONS"); }

    std::string file(const std::string& name) const { return folder_.file(name); }

  private:
    TemporaryFolder folder_;
};

} // namespace

TEST_CASE("A widget is known by its whole name") {
    for (const char* name : {"stage.depth", "tab.graph", "setting.light.power", "rows.9",
                             "rows.12.left", "legend.depth", "vertices.v2", "walk.step",
                             "setting.light.position.z", "setting.viewport.size.height"}) {
        INFO(name);
        CHECK_NOTHROW(check_widget_name(name));
    }
    for (const char* name : {"",
                             "stage",
                             "stage.",
                             "stage.deep",
                             "tab.row",
                             "rows.",
                             "rows.9.",
                             "rows.x",
                             "rows.9.middle",
                             "setting.light",
                             "walk.stepp",
                             "walk.ste",
                             "#",
                             "rows.#",
                             "rows.*",
                             "stage.{stage}",
                             "splitter.lesson",
                             "setting.shading.x",
                             "setting.light.position.width",
                             "setting.viewport.size.x",
                             "canvas.cells",
                             "status.show_outside"}) {
        INFO(name);
        CHECK_THROWS_AS(check_widget_name(name), UsageError);
    }
    CHECK_THROWS_WITH(check_widget_name("stage.dept"),
                      "the window has no widget 'stage.dept' that a lesson can point at. Did you "
                      "mean 'stage.depth'?");
}

TEST_CASE("A list of widgets is read line by line") {
    const std::vector<WidgetPattern> patterns =
        parse_widget_patterns("# Rows\n\nrows.#.left\r\n- lab.bug.*\nlegend.{overlay}", "w.txt");
    REQUIRE(patterns.size() == 3);
    CHECK(patterns[0].name == "rows.#.left");
    CHECK(patterns[0].is_for_lessons);
    CHECK(is_named_by(patterns[0], "rows.30.left"));
    CHECK_FALSE(is_named_by(patterns[0], "rows.30.lefts"));
    CHECK_FALSE(patterns[1].is_for_lessons);
    CHECK(is_named_by(patterns[1], "lab.bug.B3"));
    CHECK_FALSE(is_named_by(patterns[1], "lab.bug."));
    CHECK(is_named_by(patterns[2], "legend.depth"));
    CHECK_FALSE(is_named_by(patterns[2], "legend.deep"));
    CHECK_THROWS_WITH(parse_widget_patterns("a\nb.{bug}\n", "w.txt"),
                      "w.txt:2: a widget's name can contain {stage}, {tab}, {setting}, {vector}, "
                      "{size}, {box} and {overlay}, not '{bug}'.");
    CHECK_THROWS_AS(parse_widget_patterns("a.{stage\n", "w.txt"), InputError);
    CHECK_THROWS_AS(parse_widget_patterns("a.}\n", "w.txt"), InputError);
    CHECK_THROWS_WITH(parse_widget_patterns("a.*\n", "w.txt"),
                      "w.txt:1: a widget that lessons can point at must have a name of its own, "
                      "not '*'.");
}

TEST_CASE("Widgets are those of the program, whatever folder the lessons are in") {
    const OtherLessons lessons;
    const std::string lesson = lessons.file("lessons/03-points.md");
    std::filesystem::remove(lessons.file("lessons/widgets.txt"));
    CHECK(run({"check", lesson}).exit_code == 0);
    CHECK_NOTHROW(check_widget_name("walk.step"));
    CHECK_THROWS_AS(check_widget_name("walk.stepp"), UsageError);
}
