// The row table next to the rows of the picture that it describes.

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "session/tabs.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_colours.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/row_table_layout.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

struct BothEnds {
    int left = INT_MAX, right = -INT_MAX;
};

/// The finished row table as the lab's text has it, from the vertices of the bench alone: each edge
/// in as many equal steps as its longer side has pixels, added up in float, cut to int.
std::map<int, BothEnds> table_by_hand(const Scene& scene) {
    std::map<int, BothEnds> rows;
    for (int e = 0; e < 3; ++e) {
        const glm::vec3 a = scene.corner(0, e).position;
        const glm::vec3 b = scene.corner(0, (e + 1) % 3).position;
        const int steps = static_cast<int>(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)));
        const float dx = (b.x - a.x) / static_cast<float>(std::max(steps, 1));
        const float dy = (b.y - a.y) / static_cast<float>(std::max(steps, 1));
        float x = a.x, y = a.y;
        for (int i = 0; i <= steps; ++i) {
            BothEnds& row = rows[static_cast<int>(y)];
            row.left = std::min(row.left, static_cast<int>(x));
            row.right = std::max(row.right, static_cast<int>(x));
            x += dx;
            y += dy;
        }
    }
    return rows;
}

std::string line_name(int row) {
    return "canvas.rows." + std::to_string(row);
}

bool is_shown(const Driver& driver) {
    return driver.ui.widgets.count("canvas.rows") > 0;
}

void look_at(Driver& driver, float zoom, glm::vec2 centre) {
    driver.ui.session.canvas.zoom = zoom;
    driver.ui.session.canvas.centre = centre;
    driver.hand.rest();
}

void switch_layer(Driver& driver, const std::string& name) {
    driver.hand.click("canvas.overlays");
    driver.hand.click(name);
    driver.hand.press(key::escape);
    driver.hand.leave();
}

/// Where lines of the table are not next to their rows; empty if nowhere.
std::string misplaced_lines(const Driver& driver) {
    const PolygonRows& rows = driver.ui.results.a.rows.rows;
    const PicturePlace& place = driver.ui.canvas.place;
    int whole = 0;
    for (int i = 0; i < rows.size(); ++i) {
        const int row = rows.first_row + i;
        const auto found = driver.ui.widgets.find(line_name(row));
        if (found == driver.ui.widgets.end()) continue;
        const ImVec2 low = found->second.top_left, high = found->second.bottom_right;
        const float top = place.origin.y + place.scale * static_cast<float>(row);
        // One that is cut off by the canvas is within its row.
        const bool is_whole = high.y - low.y > place.scale - 0.5f;
        if (low.y < top - 0.01f || (is_whole && low.y > top + 0.01f))
            return line_name(row) + " begins elsewhere";
        if (high.y > top + place.scale + 0.01f || (is_whole && high.y < top + place.scale - 0.01f))
            return line_name(row) + " ends elsewhere";
        whole += is_whole ? 1 : 0;
    }
    return whole > 0 ? "" : "no line is whole";
}

/// A row of the triangle that has a pixel under the table; empty if none has.
std::string covered_row(const Driver& driver) {
    const auto& table = driver.ui.canvas.row_table;
    if (!table) return "";
    const WidgetPlace& canvas = driver.ui.widgets.at("canvas");
    const PicturePlace& place = driver.ui.canvas.place;
    for (const auto& [row, ends] : table_by_hand(*driver.ui.session.scene)) {
        const float top = place.origin.y + place.scale * static_cast<float>(row);
        if (top + place.scale < canvas.top_left.y + 30.0f || top > canvas.bottom_right.y) continue;
        const float left = place.origin.x + place.scale * static_cast<float>(ends.left);
        const float right = place.origin.x + place.scale * static_cast<float>(ends.right + 1);
        if (left < table->right - 0.01f && right > table->left + 0.01f &&
            left < canvas.bottom_right.x && right > canvas.top_left.x) {
            return "row " + std::to_string(row);
        }
    }
    return "";
}

/// The texts of the table's window.
std::vector<ScreenText> table_texts() {
    std::vector<ScreenText> texts;
    for (const ScreenText& text : screen_text()) {
        if (text.window.find("row table") != text.window.npos) texts.push_back(text);
    }
    return texts;
}

/// Is a text of these words drawn within the widget?
bool stands_in(const std::vector<ScreenText>& texts, const WidgetPlace& place,
               const std::string& words) {
    return std::any_of(texts.begin(), texts.end(), [&](const ScreenText& text) {
        return text.words == words && text.low.x >= place.top_left.x - 1.0f &&
               text.high.x <= place.bottom_right.x + 1.0f &&
               text.low.y >= place.top_left.y - 1.0f && text.high.y <= place.bottom_right.y + 1.0f;
    });
}

} // namespace

TEST_CASE("Every line of the table is next to its row of pixels, at every zoom and place") {
    for (const char* const scene : {"one-triangle.toml", "lab-room.toml"}) {
        Driver driver(scene);
        driver.ui.session.a.settings.stage = Stage::depth;
        driver.ui.session.selection.triangle = std::string(scene) == "lab-room.toml" ? 22 : 0;
        driver.hand.rest();
        const PolygonRows& rows = driver.ui.results.a.rows.rows;
        REQUIRE(rows.size() > 5);
        const int middle_row = rows.first_row + rows.size() / 2;
        const glm::vec2 middle(rows.left[static_cast<std::size_t>(rows.size() / 2)].column,
                               middle_row);
        int looks = 0;
        for (const float zoom : {24.0f, 31.5f, 46.0f, 64.0f}) {
            for (const glm::vec2 pan :
                 {glm::vec2(0, 0), glm::vec2(-1.3f, 4.7f), glm::vec2(-4, -4)}) {
                look_at(driver, zoom, middle + pan);
                CAPTURE(scene, zoom, pan.x, pan.y);
                if (!is_shown(driver)) continue;
                ++looks;
                CHECK(misplaced_lines(driver) == "");
            }
        }
        CHECK(looks >= 8);
        look_at(driver, 23.0f, middle);
        CHECK_FALSE(is_shown(driver));
        look_at(driver, 24.0f, middle);
        CHECK(is_shown(driver));
    }
}

TEST_CASE("The table has the numbers of a table worked out by hand, and they can be read") {
    for (const float text_scale : {1.0f, 1.5f}) {
        Driver driver("one-triangle.toml", {1600, 1000}, text_scale);
        driver.hand.press('X');
        REQUIRE(is_shown(driver));
        driver.hand.leave();
        const std::vector<ScreenText> texts = table_texts();
        REQUIRE_FALSE(texts.empty());
        for (const ScreenText& text : texts) {
            CAPTURE(text.words, text_scale);
            CHECK(text.size >= 12.0f * text_scale);
        }
        const std::map<int, BothEnds> rows = table_by_hand(*driver.ui.session.scene);
        REQUIRE(rows.size() == 11);
        for (const auto& [row, ends] : rows) {
            CAPTURE(row, text_scale);
            const WidgetPlace line = driver.hand.find(line_name(row));
            if (!line.is_whole) continue;
            CHECK(shown_text(driver, line_name(row) + ".left") == std::to_string(ends.left));
            CHECK(shown_text(driver, line_name(row) + ".right") == std::to_string(ends.right));
            const std::string entry = "[" + std::to_string(row - rows.begin()->first) + "]";
            CHECK(stands_in(texts, line, entry));
        }
    }
}

TEST_CASE("Numbers and texts of the table do not overlap") {
    for (const ImVec2 window : {ImVec2{1600, 1000}, ImVec2{1024, 640}}) {
        for (const char* const moment : {"end", "t0/e1/s4"}) {
            Driver driver("one-triangle.toml", window);
            if (std::string(moment) != "end") driver.ui.session.cursor = *parse_cursor(moment);
            for (const float zoom : {24.0f, 30.0f, 46.0f}) {
                look_at(driver, zoom, {10.0f, 10.0f});
                if (!is_shown(driver)) continue;
                const std::vector<ScreenText> texts = table_texts();
                for (std::size_t i = 0; i < texts.size(); ++i) {
                    for (std::size_t j = 0; j < i; ++j) {
                        const ScreenText &a = texts[i], &b = texts[j];
                        const float across =
                            std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x);
                        // Letters leave some room above and below.
                        const float down = std::min(a.high.y, b.high.y) -
                                           std::max(a.low.y, b.low.y) - 0.25f * a.size;
                        // What is under the header is not seen.
                        if (a.low.y < driver.hand.find("canvas").top_left.y + 24.0f ||
                            b.low.y < driver.hand.find("canvas").top_left.y + 24.0f) {
                            continue;
                        }
                        CAPTURE(zoom, a.words, b.words);
                        CHECK_FALSE((across > 0.5f && down > 0.5f));
                    }
                }
            }
        }
    }
}

TEST_CASE("Ends that no sample has reached are grey and show the arrays' first values") {
    Driver driver("one-triangle.toml");
    driver.hand.click("walk.first");
    driver.hand.leave();
    REQUIRE(is_shown(driver));
    const std::vector<ScreenText> texts = table_texts();
    const ImU32 grey = packed(palette(Theme::dark).dim);
    for (int row = 5; row <= 15; ++row) {
        CAPTURE(row);
        const WidgetPlace left = driver.hand.find(line_name(row) + ".left");
        CHECK(stands_in(texts, left, "+INT_MAX"));
        CHECK(stands_in(texts, driver.hand.find(line_name(row) + ".right"), "−INT_MAX"));
        CHECK(shown_colours(left).count(grey) == 1);
    }
}

TEST_CASE("The moment's row has a white bar, and a box is around what the moment wrote") {
    Driver driver("one-triangle.toml");
    driver.ui.session.cursor = *parse_cursor("t0/e1/s5"); // edge 1, line[4] is just entered
    driver.hand.rest();
    driver.hand.leave();
    REQUIRE(is_shown(driver));
    const ImU32 white = packed(colour_of(Meaning::current, Theme::dark));
    const ImU32 amber = packed(palette(Theme::dark).changed);
    const EdgeSample& last = *driver.ui.results.a.rows.last;
    REQUIRE(last.write.left);
    for (int row = 5; row <= 15; ++row) {
        CAPTURE(row);
        const bool is_now = row == last.fragment.row;
        CHECK((shown_colours(driver.hand.find(line_name(row))).count(white) > 0) == is_now);
        for (const bool left : {true, false}) {
            const auto colours =
                shown_colours(driver.hand.find(line_name(row) + (left ? ".left" : ".right")));
            // Edge 0 has the same amber; a box has more than the letters of its own cell.
            const bool is_changed = is_now && (left ? last.write.left : last.write.right);
            if (is_now) CHECK((colours.count(amber) > 0) == is_changed);
        }
    }
}

TEST_CASE("A click on a line selects its row, one on an end leads to the sample that wrote it") {
    Driver driver("one-triangle.toml");
    REQUIRE(is_shown(driver));
    // Next to the numbers, on the entry.
    const WidgetPlace line = driver.hand.find("canvas.rows.9");
    play_pointer({line.top_left.x + 12.0f, 0.5f * (line.top_left.y + line.bottom_right.y)});
    driver.hand.frames(2);
    CHECK(driver.ui.canvas.hovered_row == 9);
    play_mouse_button(0, true);
    driver.hand.frames(2);
    play_mouse_button(0, false);
    driver.hand.frames(3);
    CHECK(driver.ui.session.selection.row == 9);
    CHECK(driver.ui.session.cursor == cursor_end);
    CHECK_FALSE(driver.ui.session.selection.pixel);

    driver.hand.click("canvas.rows.12.left");
    CHECK(driver.ui.session.selection.row == 12);
    REQUIRE(driver.ui.results.a.rows.last);
    CHECK(driver.ui.results.a.rows.last->fragment.row == 12);
    CHECK(driver.ui.results.a.rows.last->write.left);
    CHECK(to_text(driver.ui.results.a.cursor) == "t0/e1/s5");
}

TEST_CASE("A row pointed at in the table, the tab or the picture lights up in the table") {
    Driver driver("one-triangle.toml");
    const ImU32 lit = packed(palette(Theme::dark).row_lit);
    driver.hand.hover("canvas.rows.9");
    CHECK(driver.ui.canvas.hovered_row == 9);
    CHECK_FALSE(driver.ui.canvas.hovered_pixel);
    CHECK(shown_colours(driver.hand.find("canvas.rows.9")).count(lit) > 0);
    driver.hand.hover("rows.12");
    CHECK_FALSE(driver.ui.canvas.hovered_row);
    CHECK(shown_colours(driver.hand.find("canvas.rows.12")).count(lit) > 0);
    driver.hand.hover_picture(8, 11);
    CHECK_FALSE(driver.ui.canvas.hovered_row);
    CHECK(shown_colours(driver.hand.find("canvas.rows.11")).count(lit) > 0);
    driver.hand.leave();
    CHECK(shown_colours(driver.hand.find("canvas.rows.11")).count(lit) == 0);
}

TEST_CASE("A bench that fits is next to the table, and all of it can be grabbed") {
    Driver driver("one-triangle.toml");
    REQUIRE(driver.ui.canvas.row_table);
    const PicturePlace& place = driver.ui.canvas.place;
    CHECK(place.scale >= 24.0f);
    CHECK(place.origin.x + place.scale * 20.0f <= driver.ui.canvas.row_table->left);
    driver.hand.drag_picture(15, 15, 19, 18);
    CHECK(driver.ui.session.scene->corner(0, 2).position.x == 19.0f);
}

TEST_CASE("The table takes the edge of the canvas where the triangle is not") {
    Driver driver("one-triangle.toml");
    // The triangle reaches from column 5 to 15.
    for (const float zoom : {24.0f, 30.0f}) {
        look_at(driver, zoom, {18.0f, 10.0f}); // it is in the left half
        REQUIRE(driver.ui.canvas.row_table);
        CHECK_FALSE(driver.ui.canvas.row_table->is_at_left);
        look_at(driver, zoom, {3.0f, 10.0f}); // in the right one
        REQUIRE(driver.ui.canvas.row_table);
        CHECK(driver.ui.canvas.row_table->is_at_left);
        const float first = driver.ui.canvas.place.origin.x + zoom * 5.0f;
        CHECK(driver.ui.canvas.row_table->right <= first);
        // The numbers of the rows are next to it, not under it.
        driver.hand.leave();
        for (const ScreenText& text : screen_text()) {
            if (text.window != "canvas" || text.low.y < driver.hand.find("canvas").top_left.y)
                continue;
            CAPTURE(text.words);
            CHECK(text.low.x >= driver.ui.canvas.row_table->right);
        }
    }
}

TEST_CASE(
    "The table can be switched off and on in the list of layers, and is saved with the view") {
    Driver driver("one-triangle.toml");
    REQUIRE(is_shown(driver));
    switch_layer(driver, "layers.row_table");
    CHECK_FALSE(driver.ui.session.canvas.row_table);
    CHECK_FALSE(is_shown(driver));
    switch_layer(driver, "layers.row_table");
    CHECK(is_shown(driver));
}

TEST_CASE("There is no table without rows: for points, and for a triangle left out") {
    Driver driver("one-triangle.toml");
    driver.ui.session.a.settings.stage = Stage::points;
    driver.hand.rest();
    CHECK_FALSE(is_shown(driver));
}

TEST_CASE("Small windows and large text show the table whole or not at all") {
    for (const ImVec2 window :
         {ImVec2{320, 200}, ImVec2{800, 600}, ImVec2{1024, 640}, ImVec2{2560, 1440}}) {
        for (const float text_scale : {0.75f, 1.0f, 1.5f, 2.5f}) {
            Driver driver("one-triangle.toml", window, text_scale);
            for (const float zoom : {0.0f, 24.0f, 40.0f, 64.0f}) {
                look_at(driver, zoom, {10.0f, 10.0f});
                CAPTURE(window.x, window.y, text_scale, zoom);
                if (!is_shown(driver)) continue;
                const WidgetPlace table = driver.ui.widgets.at("canvas.rows");
                CHECK(table.is_whole);
                const WidgetPlace canvas = driver.hand.find("canvas");
                CHECK(table.bottom_right.x - table.top_left.x <
                      0.6f * (canvas.bottom_right.x - canvas.top_left.x));
                CHECK(misplaced_lines(driver) == "");
            }
        }
    }
}

TEST_CASE("However the picture is zoomed and moved by hand, the table covers none of the rows") {
    int shown = 0, left_out = 0;
    for (const SmallWindow& window :
         {SmallWindow{{1600, 1000}, 1.0f}, SmallWindow{{1024, 640}, 1.0f},
          SmallWindow{{800, 600}, 1.5f}}) {
        for (const bool is_lesson : {false, true}) {
            Driver driver("one-triangle.toml", window.size, window.text_scale);
            if (is_lesson) open_lesson(driver.ui, "05-row-table", 3);
            driver.hand.rest();
            for (int i = 0; i < 14; ++i) {
                if (i % 2 == 0) {
                    driver.hand.wheel("canvas", i < 6 ? 1.0f : -1.0f);
                } else {
                    driver.hand.drag("canvas", i % 4 == 1 ? 140.0f : -170.0f,
                                     i % 3 == 0 ? 60.0f : -40.0f);
                }
                driver.hand.leave();
                CAPTURE(window.size.x, window.text_scale, is_lesson, i);
                CAPTURE(driver.ui.session.canvas.zoom);
                REQUIRE(driver.ui.session.canvas.zoom > 0.0f);
                CHECK(covered_row(driver) == "");
                if (driver.ui.canvas.place.scale >= row_table_zoom(driver.ui))
                    ++(is_shown(driver) ? shown : left_out);
            }
        }
    }
    CHECK(shown > 5);
    CHECK(left_out > 5);
}

TEST_CASE("A table without room next to the triangle is left out, and is in the Rows tab") {
    Driver driver("one-triangle.toml");
    REQUIRE(is_shown(driver));
    driver.hand.wheel_picture(10, 10, 3.0f);
    driver.hand.leave();
    REQUIRE(driver.ui.canvas.place.scale >= 24.0f);
    CHECK_FALSE(is_shown(driver));
    driver.open("rows");
    CHECK(driver.hand.is_visible("rows.9"));
    driver.hand.click("canvas.overlays");
    driver.hand.hover("layers.row_table");
    CHECK_THAT(words_in("Tooltip"), Catch::Matchers::ContainsSubstring("Rows tab"));
    driver.hand.press(key::escape);
    driver.hand.press('F');
    driver.hand.leave();
    CHECK(is_shown(driver));
}

TEST_CASE("Turning the wheel over the table enlarges the picture, and its lines with it") {
    Driver driver("one-triangle.toml");
    const float before = driver.ui.canvas.place.scale;
    driver.hand.wheel("canvas.rows.9", 1.0f);
    CHECK(driver.ui.canvas.place.scale > before);
    REQUIRE(is_shown(driver));
    CHECK(misplaced_lines(driver) == "");
}

TEST_CASE("1/z is not in the table where it is the same for all") {
    Driver bench("one-triangle.toml");
    look_at(bench, 46.0f, {16.0f, 10.0f});
    const std::vector<ScreenText> texts = table_texts();
    REQUIRE_FALSE(texts.empty());
    for (const ScreenText& text : texts)
        CHECK(text.words.find("1/z") == text.words.npos);
}

TEST_CASE("1/z is in the table of a triangle of the room") {
    Driver room;
    room.hand.click("stage.depth");
    room.ui.session.selection.triangle = 22;
    room.hand.rest();
    const PolygonRows& rows = room.ui.results.a.rows.rows;
    const RowEnd& left = rows.left[static_cast<std::size_t>(rows.size() / 2)];
    look_at(room, 46.0f, {left.column - 1, rows.first_row + rows.size() / 2});
    CHECK(shows_words("1/z", "row table"));
}

TEST_CASE("1/z is also in the table where no samples have written the ends") {
    Driver room;
    room.hand.click("stage.depth");
    room.ui.session.a.settings.coverage = Coverage::scan_conversion;
    room.ui.session.selection.triangle = 22;
    room.hand.rest();
    const PolygonRows& rows = room.ui.results.a.rows.rows;
    const RowEnd& left = rows.left[static_cast<std::size_t>(rows.size() / 2)];
    REQUIRE(left.column != empty_left);
    look_at(room, 46.0f, {left.column - 1, rows.first_row + rows.size() / 2});
    REQUIRE(is_shown(room));
    CHECK(shows_words(fixed(static_cast<double>(left.inv_w), 4), "row table"));
    // If pixels are tested one by one, there are no ends to put into a table.
    room.ui.session.a.settings.coverage = Coverage::edge_functions;
    room.hand.rest();
    CHECK_FALSE(is_shown(room));
}

TEST_CASE("A line of the table that is cut off has no text, rather than half of it") {
    Driver driver("one-triangle.toml");
    for (float y = 9.0f; y < 10.0f; y += 0.1f) {
        look_at(driver, 40.0f, {15.0f, y});
        REQUIRE(is_shown(driver));
        driver.hand.leave();
        const WidgetPlace header = driver.hand.find("canvas.rows.header.entry");
        const WidgetPlace table = driver.hand.find("canvas.rows");
        int entries = 0;
        for (const ScreenText& text : table_texts()) {
            if (text.words[0] != '[') continue;
            CAPTURE(y, text.words);
            CHECK(text.low.y >= header.bottom_right.y - 0.5f);
            CHECK(text.high.y <= table.bottom_right.y + 0.5f);
            ++entries;
        }
        CHECK(entries >= 10);
    }
}

TEST_CASE(
    "At the end of the bench the card speaks of the row that is lit, and outside is said once") {
    Driver driver("one-triangle.toml");
    driver.hand.click("walk.last");
    driver.hand.leave();
    REQUIRE(is_shown(driver));
    std::string inspector;
    int outside = 0;
    for (const ScreenText& text : screen_text()) {
        if (text.window.find("inspector") != text.window.npos) inspector += text.words + "\n";
        outside += text.words.find("samples outside") != text.words.npos ? 1 : 0;
    }
    CAPTURE(inspector);
    const ImU32 white = packed(colour_of(Meaning::current, Theme::dark));
    CHECK(shown_colours(driver.hand.find(line_name(15))).count(white) > 0);
    CHECK(inspector.find("row 15, entry [10] of 11") != inspector.npos);
    CHECK(inspector.find("last sample") == inspector.npos);
    CHECK(outside == 1);
}

TEST_CASE("In a lecture about rows the table takes the inspector's place, large and only once") {
    struct Case {
        ImVec2 window;
        float text;
        bool is_beside;
        bool is_low = false; ///< are the picture's rows low, and the table's letters small?
    };
    // Where the rows of the picture are too low for letters read from a distance, the Rows tab
    // has the table.
    for (const Case& c : {Case{{1600, 1000}, 1.0f, true}, Case{{1024, 640}, 1.0f, true},
                          Case{{1920, 1080}, 1.0f, true}, Case{{1024, 640}, 1.5f, true, true},
                          Case{{800, 600}, 1.0f, true}, Case{{1024, 600}, 1.5f, false}}) {
        INFO(c.window.x << " x " << c.window.y << ", text " << c.text);
        Driver driver("lab-room.toml", c.window, c.text);
        open_lesson(driver.ui, "05-row-table", 4);
        driver.hand.press(key::f5);
        driver.hand.leave();
        REQUIRE(tab_below(driver.ui.session) == "rows");
        CHECK(is_shown(driver) == c.is_beside);
        // "rows.5" is a line of the Rows tab.
        CHECK((driver.ui.widgets.count("rows.5") > 0) != c.is_beside);
        if (!c.is_beside) continue;
        CHECK(misplaced_lines(driver).empty());
        const WidgetPlace table = driver.ui.widgets.at("canvas.rows");
        const WidgetPlace canvas = driver.ui.widgets.at("canvas");
        CHECK(table.top_left.x >= canvas.bottom_right.x);
        CHECK(table.bottom_right.x - table.top_left.x >= 0.35f * c.window.x);
        const PolygonRows& rows = driver.ui.results.a.rows.rows;
        for (int row = rows.first_row; row < rows.first_row + rows.size(); ++row) {
            INFO(line_name(row));
            REQUIRE(driver.ui.widgets.count(line_name(row)) == 1);
            CHECK(driver.ui.widgets.at(line_name(row)).is_whole);
        }
        // The numbers are as large as others in a lecture, on lines high enough to separate them.
        const Fonts& fonts = driver.ui.fonts;
        const float letters = c.is_low ? fonts.mono_small->FontSize : fonts.mono->FontSize;
        int numbers = 0;
        for (const ScreenText& text : screen_text()) {
            if (text.window.find("row table") == std::string::npos) continue;
            CHECK(text.size >= least_lecture_letters(c.window) - 0.5f);
            numbers += text.size >= letters - 0.5f ? 1 : 0;
        }
        CHECK(numbers >= rows.size());
        CHECK(driver.ui.canvas.place.scale >= 1.1f * letters);
        // All of the triangle is next to its table.
        const WidgetPlace& seen = driver.ui.widgets.at("canvas");
        CHECK(driver.ui.canvas.place.origin.y + driver.ui.canvas.place.scale * 5.0f >=
              seen.top_left.y - 0.01f);
        CHECK(driver.ui.canvas.place.origin.y + driver.ui.canvas.place.scale * 16.0f <=
              seen.bottom_right.y + 0.01f);
        // A click leads to the sample, as everywhere.
        driver.hand.click(line_name(7) + ".left");
        REQUIRE(driver.ui.results.a.done);
        CHECK(driver.ui.results.a.done->step == 2);
        CHECK(is_shown(driver));
        // Zoomed out the rows have no lines: then the tab has them.
        driver.hand.leave();
        driver.ui.session.canvas.zoom = 10.0f;
        driver.ui.session.canvas.centre = {10.0f, 10.0f};
        driver.hand.rest();
        CHECK_FALSE(is_shown(driver));
        CHECK(driver.ui.widgets.count("rows.7") > 0);
    }
}

TEST_CASE("A lesson that points at something below the row table has the Rows tab in a lecture") {
    Driver driver("lab-room.toml", {1600, 1000});
    open_lesson(driver.ui, "05-row-table", 4);
    driver.hand.press(key::f5);
    driver.hand.leave();
    REQUIRE(is_shown(driver));
    point_at_widget(driver.ui, "rows.values", true);
    driver.hand.rest();
    CHECK_FALSE(is_shown(driver));
    CHECK(driver.hand.is_visible("rows.values"));
}

} // namespace rasterwalk
