// The texts of the panels are whole in every window: where there is little room, they are shorter.

#include <algorithm>
#include <string>
#include <vector>

#include "session/second_run.h"
#include "session/tabs.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"

namespace rasterwalk {

namespace {

/// Lines with an ellipsis in the windows whose names begin with one of these.
std::vector<std::string> shortened_lines(const std::vector<std::string>& names) {
    std::vector<std::string> lines;
    for (const ScreenText& text : screen_text()) {
        const bool is_meant = std::any_of(names.begin(), names.end(), [&](const auto& name) {
            return text.window.starts_with(name);
        });
        if (is_meant && text.words.find("…") != std::string::npos) lines.push_back(text.words);
    }
    return lines;
}

const std::vector<std::string> nothing;

/// All text in the windows whose names begin with this.
std::string all_words(const std::string& name) {
    std::string words;
    for (const ScreenText& text : screen_text()) {
        if (text.window.starts_with(name)) words += text.words + "\n";
    }
    return words;
}

/// Words of which this tab shows at least one, however little room there is; empty if none are
/// required.
std::vector<std::string> said_by(std::string_view tab) {
    if (tab == "history" || tab == "fragment") return {"(250, 400)"};
    if (tab == "graph") return {"column ", "\nx "};
    return {};
}

} // namespace

TEST_CASE("No panel shortens what it says, nor does the line below the time line") {
    for (const SmallWindow& window : all_windows()) {
        CAPTURE(window.size.x, window.size.y, window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        driver.ui.session.selection.pixel = glm::ivec2(250, 400);
        driver.ui.session.selection.triangle = 10;
        for (const char* tab : {"vertices", "clip", "rows", "microscope", "fragment", "history",
                                "graph", "compare", "lab", "speed"}) {
            CAPTURE(tab);
            driver.open(tab);
            driver.hand.leave();
            CHECK(shortened_lines({"inspector", "transport"}) == nothing);
            // And it does not leave out its subject.
            const std::string words = "\n" + all_words("inspector");
            const std::vector<std::string> said = said_by(tab);
            INFO(words);
            CHECK((said.empty() ||
                   std::any_of(said.begin(), said.end(), [&](const std::string& form) {
                       return words.find(form) != std::string::npos;
                   })));
        }
    }
}

TEST_CASE("The Fragment tab names its columns and its pixel in whole words") {
    for (const SmallWindow& window : all_windows()) {
        for (const Interpolation way : all_interpolations) {
            CAPTURE(window.size.x, window.size.y, window.text_scale, word_of(way));
            Driver driver("lab-room.toml", window.size, window.text_scale);
            driver.ui.session.a.settings.interpolation = way;
            for (const CanvasShows shows : {CanvasShows::picture, CanvasShows::both}) {
                driver.ui.session.canvas.shows = shows;
                driver.open("fragment"); // without a pixel: of the fragment drawn last
                driver.hand.leave();
                CHECK(shortened_lines({"inspector"}) == nothing);
                CHECK_THAT(all_words("inspector"), Catch::Matchers::ContainsSubstring(": pixel ("));
                CHECK(driver.hand.find("fragment.z_world").bottom_right.x <=
                      driver.hand.find("fragment.z_world.affine").top_left.x);
                CHECK(driver.hand.find("fragment.z_world").is_whole);
                const std::string right = shown_text(driver, "fragment.header.perspective");
                const std::string wrong = shown_text(driver, "fragment.header.affine");
                const bool is_right = way == Interpolation::perspective;
                CHECK(right.starts_with("● ") == is_right);
                CHECK(wrong.starts_with("● ") == !is_right);
                CHECK((right.ends_with("perspective") || right.ends_with("persp.")));
                const bool is_twice =
                    way == Interpolation::zinv_twice || way == Interpolation::divided_twice;
                if (way == Interpolation::undivided)
                    CHECK((wrong.ends_with("undivided") || wrong.ends_with("undiv.")));
                else
                    CHECK(wrong.ends_with(is_twice                      ? "twice"
                                          : way == Interpolation::mixed ? "mixed"
                                                                        : "affine"));
                // At the usual size nothing need be short.
                if (window.size.x / window.text_scale >= 1600.0f) {
                    CHECK(right.ends_with("perspective"));
                    CHECK_THAT(all_words("inspector"),
                               Catch::Matchers::ContainsSubstring("Last fragment: pixel ("));
                }
            }
        }
    }
}

TEST_CASE("While two runs are compared no text about them is shortened") {
    for (const SmallWindow& window : all_windows()) {
        CAPTURE(window.size.x, window.size.y, window.text_scale);
        Driver driver("lab-room.toml", window.size, window.text_scale);
        driver.ui.session.selection.pixel = glm::ivec2(200, 350);
        driver.hand.press('C');
        for (const CompareViewInfo& view : compare_view_list()) {
            CAPTURE(view.name);
            driver.ui.session.compare_view = view.view;
            driver.hand.leave();
            CHECK(shortened_lines({"canvas", "inspector", "transport"}) == nothing);
            // At 800x600 and large text only the tab has room for it.
            if (window.size.x / window.text_scale < 640.0f) continue;
            CHECK_FALSE(shown_text(driver, "compare.counts").empty());
        }
    }
}

} // namespace rasterwalk
