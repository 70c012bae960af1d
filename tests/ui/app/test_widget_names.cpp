#include "view/widget_names.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "base/files.h"
#include "facts/facts.h"
#include "picture/overlay.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "session/second_run.h"
#include "session/tabs.h"
#include "settings/setting_table.h"
#include "support/hinted_models.h"
#include "support/program_drawings.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "tests/ui/many_walls.h"
#include "tests/ui/situations.h"
#include "ui/actions/lab.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/measure.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// Names of all widgets that are seen while the window is used.
class Tour {
  public:
    std::set<std::string> seen;

    void all() {
        for (const Situation& situation : workplace_situations()) {
            Driver driver(situation.scene);
            bring_about(driver, situation);
            look(driver);
        }
        settings_and_mistakes();
        coarse_depths();
        small_triangle();
        interval();
        small_window();
        groups();
        large_frame();
        hinted_model();
        diagnosed();
        ladder_measured();
        program_compared();
    }

  private:
    void look(Driver& driver) {
        driver.hand.rest();
        for (const auto& [name, place] : driver.ui.widgets)
            seen.insert(name);
    }

    void settings_and_mistakes() {
        Driver driver;
        for (const char* mode : {"lab.mode.quiz", "lab.mode.result", "lab.mode.bugs"}) {
            follow_link(driver.ui, "tab:lab");
            look(driver);
            driver.hand.click(mode);
            look(driver);
        }
        open_lesson(driver.ui, "04-edges", 1);
        look(driver);
        // Each setting in turn is what the panel shows.
        follow_link(driver.ui, "tab:settings");
        for (const Setting& setting : setting_table()) {
            driver.ui.inspector.setting_search = std::string(setting.name);
            look(driver);
        }
    }

    void coarse_depths() {
        Driver driver;
        driver.hand.click("stage.depth");
        follow_link(driver.ui, "set:depth_format=ndc_16");
        follow_link(driver.ui, "pixel:250,400");
        follow_link(driver.ui, "tab:history");
        look(driver);
    }

    void small_triangle() {
        Driver driver("one-triangle.toml");
        follow_link(driver.ui, "pixel:5,10");
        follow_link(driver.ui, "tab:history");
        look(driver);
        follow_link(driver.ui, "tab:rows");
        look(driver);
        driver.ui.session.canvas.numbers = CellNumbers::ends;
        look(driver);
        driver.hand.click("bench.examples");
        driver.hand.click("bench.example.A sample outside");
        look(driver);
    }

    void interval() {
        Driver driver("one-triangle.toml");
        follow_link(driver.ui, "set:coverage=edge_functions&box_walk=interval&stage=fill");
        driver.hand.frames(1); // the moment is one of the frame that is drawn with them
        follow_link(driver.ui, "cursor:t0/b4/c7");
        follow_link(driver.ui, "tab:rows");
        look(driver);
    }

    void small_window() {
        for (const auto& [window, text_scale] :
             {std::pair{ImVec2{1024, 640}, 1.0f}, {ImVec2{800, 600}, 1.5f}}) {
            Driver driver("lab-room.toml", window, text_scale);
            look(driver);
            driver.hand.click("lesson.whole");
            look(driver);
            driver.hand.click("menu");
            look(driver);
            driver.hand.press(key::escape);
            driver.hand.press(key::f5);
            look(driver);
        }
    }

    /// One that is drawn only on request, and one that is hardly in the picture.
    void large_frame() {
        {
            Driver driver;
            follow_link(driver.ui, "set:camera.position=0,0,-1.05");
            look(driver);
        }
        Driver driver(session_of(many_walls()));
        look(driver);
        driver.hand.click("canvas.draw_it");
        for (const auto& [name, place] : driver.ui.widgets)
            seen.insert(name);
    }

    /// A model whose faces mostly face away.
    void hinted_model() {
        Driver driver(session_of(test::box(true)));
        driver.ui.session.a.settings.stage = Stage::shade;
        driver.hand.frames(20);
        look(driver);
    }

    /// A picture while it is checked, with a likely mistake, and with none; and no file at all.
    void diagnosed() {
        const test::TemporaryFolder folder;
        Driver driver;
        const std::string path = folder.file("mine.png");
        const auto check = [&](const Image& picture) {
            write_png(picture, path);
            diagnose_file(driver.ui, path);
            driver.hand.frames(3);
            for (const auto& [name, place] : driver.ui.widgets)
                seen.insert(name);
            while (is_diagnosing(driver.ui))
                poll_diagnosis(driver.ui, {});
            look(driver);
        };
        Settings wrong = default_settings(*driver.ui.session.scene);
        for (const char* set : {"viewport.size=100x100", "camera.focal_length=100", "stage=fill",
                                "spans=last_dropped"})
            set_from_text(wrong, set);
        const Frame frame = prepare_frame(*driver.ui.session.scene, wrong);
        Image picture = view_image(draw_frame(frame), View::colour);
        check(picture);
        std::fill_n(picture.rgba.begin(), picture.rgba.size() / 2, std::uint8_t{255});
        check(picture);
        diagnose_file(driver.ui, path);
        driver.hand.frames(3);
        stop_diagnosis(driver.ui);
        while (is_diagnosing(driver.ui))
            poll_diagnosis(driver.ui, {});
        look(driver);
        diagnose_file(driver.ui, folder.file("nothing.png"));
        look(driver);
    }

    /// The ladder while it is measured.
    void ladder_measured() {
        Driver driver;
        driver.ui.ladder.maker = StepMaker::advance;
        follow_link(driver.ui, "set:stage=pixel_light");
        follow_link(driver.ui, "tab:speed");
        driver.hand.rest();
        driver.hand.click("speed.measure");
        look(driver);
        driver.hand.click("speed.stop");
        for (std::size_t i = 0; i < wrong_turnings().size(); ++i)
            driver.hand.click("speed.turning." + std::to_string(i));
        if (driver.ui.widgets.contains("speed.race")) driver.hand.click("speed.race");
        while (is_racing(driver.ui))
            driver.hand.frames(1);
        look(driver);
        driver.hand.click("speed.rung." + std::to_string(ladder().size() - 1));
        look(driver);
    }

    /// A student's program that lacks the last pixel.
    void program_compared() {
        const ProgramDrawing right = test::right_room_drawing(StripStep{Stage::fill});
        std::vector<ProgramPut> puts = right.puts;
        puts.pop_back();
        Driver driver;
        compare_with_program(driver.ui.session, std::make_shared<const ProgramDrawing>(
                                                    test::with_puts(right, std::move(puts))));
        follow_link(driver.ui, "tab:compare");
        look(driver);
        driver.ui.session.selection.pixel = right.puts.front().pixel;
        follow_link(driver.ui, "tab:history");
        look(driver);
    }

    /// A tab chosen by the student or by a lesson, and what a lesson hides.
    void groups() {
        Driver driver;
        for (std::size_t i = 0; i < tab_group_count; ++i) {
            const std::string group(word_of(static_cast<TabGroup>(i)));
            driver.hand.click("group." + group);
            look(driver);
        }
        driver.open("mine"); // before a program is chosen
        look(driver);
        open_lesson(driver.ui, "01-pinhole-camera", 0);
        look(driver);
        open_lesson(driver.ui, "01-pinhole-camera", 3); // with a control of its own
        look(driver);
    }
};

using Names = std::set<std::string>;

bool is_seen(const Names& seen, const WidgetPattern& pattern) {
    return std::any_of(seen.begin(), seen.end(),
                       [&](const std::string& name) { return is_named_by(pattern, name); });
}

/// The widgets seen that the file does not name, as patterns.
Names missing_names(const Names& seen, const std::vector<WidgetPattern>& patterns) {
    Names missing;
    for (const std::string& name : seen) {
        const bool is_known =
            std::any_of(patterns.begin(), patterns.end(),
                        [&](const WidgetPattern& pattern) { return is_named_by(pattern, name); });
        if (!is_known) missing.insert(std::regex_replace(name, std::regex("[0-9]+"), "#"));
    }
    return missing;
}

/// The file of patterns, without those that match nothing seen, and with the missing ones.
std::string rewritten(const std::string& text, const Names& seen) {
    std::string kept;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::vector<WidgetPattern> pattern = parse_widget_patterns(line, "");
        if (pattern.empty() || is_seen(seen, pattern[0])) kept += line + "\n";
    }
    for (const std::string& name : missing_names(seen, parse_widget_patterns(kept, "")))
        kept += name + "\n";
    return kept;
}

} // namespace

TEST_CASE("Every widget of the window is listed for the lessons, and the list names no other") {
    Tour tour;
    tour.all();
    if (std::getenv("RASTERWALK_REWRITE_WIDGETS") != nullptr) {
        write_file(widgets_file(), rewritten(read_file(widgets_file()), tour.seen));
    }
    const std::vector<WidgetPattern> patterns = read_widget_patterns();
    const Names missing = missing_names(tour.seen, patterns);
    Names extra;
    for (const WidgetPattern& pattern : patterns) {
        if (!is_seen(tour.seen, pattern)) extra.insert(pattern.name);
    }
    INFO("Widgets that are in the window and not in lessons/widgets.txt, and those that are in it "
         "and nowhere seen:");
    CHECK(missing == Names{});
    CHECK(extra == Names{});
}

TEST_CASE("Rewriting the list of widgets drops what is gone and adds what is new") {
    const std::string text = "# Rows\nrows.#\nold.#\n- lab.*\n\nstage.{stage}\n";
    const Names seen{"rows.7", "stage.depth", "lab.B3", "new.12.left", "new.3.left", "walk"};
    CHECK(rewritten(text, seen) == "# Rows\nrows.#\n- lab.*\n\nstage.{stage}\nnew.#.left\nwalk\n");
    CHECK(rewritten(rewritten(text, seen), seen) == rewritten(text, seen));
}

} // namespace rasterwalk
