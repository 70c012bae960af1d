// What edge functions have tested, on the picture.

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "support/samples.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/canvas/cells.h"
#include "ui/canvas/test_marks.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

/// A second way: whole numbers in half pixels, the corners in the middle of their pixels.
struct HalfPoint {
    int x, y;
};
int e_by_halves(HalfPoint a, HalfPoint b, HalfPoint p) {
    return ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / 4;
}
HalfPoint middle_of_cell(int column, int row) {
    return {2 * column + 1, 2 * row + 1};
}

constexpr int corners_of_sketch[3][2] = {{2, 1}, {14, 1}, {5, 10}};

int e_of(int edge, int column, int row) {
    const auto& a = corners_of_sketch[edge];
    const auto& b = corners_of_sketch[(edge + 1) % 3];
    return e_by_halves(middle_of_cell(a[0], a[1]), middle_of_cell(b[0], b[1]),
                       middle_of_cell(column, row));
}

void show_sketch(Driver& driver, const char* moment, FillRule rule = FillRule::top_left) {
    Session& session = driver.ui.session;
    set_scene(session, test::pixel_scene({{{{2, 1, 1}, {14, 1, 1}, {5, 10, 1}}}}, {20, 16}));
    session.a.settings.coverage = Coverage::edge_functions;
    session.a.settings.fill_rule = rule;
    session.a.settings.stage = Stage::fill;
    session.cursor = *parse_cursor(moment);
    session.canvas.row_table = false;
    session.canvas.zoom = 40.0f;
    session.canvas.centre = {8.0f, 6.0f};
    driver.hand.leave();
    driver.hand.rest();
}

/// The words in each cell, one after the other.
std::map<std::pair<int, int>, std::string> words_of_cells(const Driver& driver) {
    const PicturePlace& place = driver.ui.canvas.place;
    std::map<std::pair<int, int>, std::string> words;
    for (const ScreenText& text : screen_text(0.15f)) {
        if (text.window.find("/cells ") == text.window.npos) continue;
        const auto cell = [&](float low, float high, float origin) {
            return static_cast<int>(std::floor((0.5f * (low + high) - origin) / place.scale));
        };
        words[{cell(text.low.x, text.high.x, place.origin.x),
               cell(text.low.y, text.high.y, place.origin.y)}] += text.words + " ";
    }
    return words;
}

/// The pixels of this row whose cells are tinted in a colour.
std::set<int> tinted(const Driver& driver, Meaning meaning, float opacity, int row, int columns) {
    const PicturePlace& place = driver.ui.canvas.place;
    const ImU32 colour = packed(colour_of(meaning, Theme::dark), opacity);
    const float y = place.origin.y + place.scale * (static_cast<float>(row) + 0.5f);
    std::set<int> found;
    const ImDrawData* const data = ImGui::GetDrawData();
    for (int i = 0; i < data->CmdListsCount; ++i) {
        const ImVector<ImDrawVert>& corners = data->CmdLists[i]->VtxBuffer;
        for (int k = 0; k + 3 < corners.Size; ++k) {
            // A filled rectangle is four corners: the first and the third are opposite.
            const ImVec2 a = corners[k].pos, b = corners[k + 2].pos;
            if (corners[k].col != colour || corners[k + 2].col != colour) continue;
            if (a.x != corners[k + 3].pos.x || a.y > y || b.y < y) continue;
            for (int c = 0; c < columns; ++c) {
                const float x = place.origin.x + place.scale * (static_cast<float>(c) + 0.5f);
                if (a.x < x && x < b.x) found.insert(c);
            }
        }
    }
    return found;
}

} // namespace

TEST_CASE("The pixels tested so far are tinted by their result, and no others are") {
    Driver driver("one-triangle.toml");
    show_sketch(driver, "t0/b4/c6"); // (7, 5) in column 6 - 1 of the box has just been tested
    for (int row = 0; row < 12; ++row) {
        const std::set<int> inside = tinted(driver, Meaning::pass, inside_tint, row, 20);
        const std::set<int> outside = tinted(driver, Meaning::fail, outside_tint, row, 20);
        for (int column = 0; column < 20; ++column) {
            CAPTURE(row, column);
            // The box is columns 2 to 14, rows 1 to 10.
            const bool in_box = column >= 2 && column <= 14 && row >= 1 && row <= 10;
            const bool is_tested = in_box && (row < 5 || (row == 5 && column < 8));
            const int e0 = e_of(0, column, row), e1 = e_of(1, column, row),
                      e2 = e_of(2, column, row);
            // Edge 0 is a top edge, edge 2 a left one; edge 1 gives its points away.
            const bool is_in = e0 >= 0 && e1 > 0 && e2 >= 0;
            CHECK((inside.count(column) > 0) == (is_tested && is_in));
            CHECK((outside.count(column) > 0) == (is_tested && !is_in));
        }
    }
    CHECK(driver.hand.is_visible("canvas.cells"));
    // After the tests the picture is seen unchanged.
    driver.ui.session.cursor = cursor_end;
    driver.hand.leave();
    CHECK(tinted(driver, Meaning::pass, inside_tint, 3, 20).empty());
}

TEST_CASE("At 40x each tested cell holds its edge functions; outside, those that keep it out") {
    Driver driver("one-triangle.toml");
    driver.ui.session.canvas.numbers = CellNumbers::edge_values;
    show_sketch(driver, "t0/b4/c6");
    CHECK(numbers_zoom(driver.ui, CellNumbers::edge_values) <= 40.0f);
    const auto words = words_of_cells(driver);
    int whole = 0, outside = 0;
    for (int row = 1; row <= 6; ++row) {
        for (int column = 3; column <= 13; ++column) {
            const bool is_tested = row < 5 || (row == 5 && column < 8);
            std::string expected;
            const bool is_in =
                e_of(0, column, row) >= 0 && e_of(1, column, row) > 0 && e_of(2, column, row) >= 0;
            for (int edge = 0; is_tested && edge < 3; ++edge) {
                const int e = e_of(edge, column, row);
                const bool passes = edge == 1 ? e > 0 : e >= 0;
                if (!is_in && passes) continue;
                expected += (e < 0 ? "−" : "") + std::to_string(std::abs(e)) + " ";
            }
            const auto found = words.find({column, row});
            const std::string shown = found == words.end() ? std::string() : found->second;
            if (shown.empty() && !expected.empty() && row == 1) continue; // under a vertex's name
            CAPTURE(column, row);
            CHECK(shown == expected);
            whole += is_in && is_tested ? 1 : 0;
            outside += !is_in && is_tested ? 1 : 0;
        }
    }
    CHECK(whole > 20);
    CHECK(outside > 5);
}

TEST_CASE("The weights in a cell are shares of the area, in the order of the corners") {
    Driver driver("one-triangle.toml");
    driver.ui.session.canvas.numbers = CellNumbers::weights;
    show_sketch(driver, "end");
    const auto words = words_of_cells(driver);
    // (7, 5): the opposite edges have 27, 33 and 48 of 108.
    REQUIRE(words.count({7, 5}) > 0);
    CHECK(words.at({7, 5}) == "0.25 0.306 0.444 ");
    // (9, 9) is beyond edge 1 only, which is opposite v0.
    CHECK(e_of(1, 9, 9) == -27);
    CHECK(words.at({9, 9}) == "−0.25 ");
}

TEST_CASE("A 0 on an edge is filled where it is kept and framed where it is given away") {
    for (const FillRule rule : {FillRule::top_left, FillRule::exclusive}) {
        Driver driver("one-triangle.toml");
        driver.ui.session.canvas.numbers = CellNumbers::edge_values;
        show_sketch(driver, "end", rule);
        // (6, 1) is on edge 0, the top edge.
        REQUIRE(e_of(0, 6, 1) == 0);
        const PicturePlace& place = driver.ui.canvas.place;
        const ImU32 black = IM_COL32(0, 0, 0, 255);
        bool has_dark_ink_there = false;
        const ImDrawData* const data = ImGui::GetDrawData();
        for (int i = 0; i < data->CmdListsCount; ++i) {
            for (const ImDrawVert& corner : data->CmdLists[i]->VtxBuffer) {
                const float column = (corner.pos.x - place.origin.x) / place.scale;
                const float row = (corner.pos.y - place.origin.y) / place.scale;
                has_dark_ink_there |= corner.col == black && column > 6.0f && column < 7.0f &&
                                      row > 1.0f && row < 2.0f;
            }
        }
        CHECK(has_dark_ink_there == (rule == FillRule::top_left));
    }
}

TEST_CASE("The numbers of tests are offered only where there are tests") {
    Driver driver("one-triangle.toml");
    driver.hand.click("canvas.overlays");
    CHECK_FALSE(driver.hand.is_visible("layers.numbers.edge_values"));
    driver.hand.press(key::escape);
    driver.ui.session.a.settings.coverage = Coverage::edge_functions;
    driver.hand.click("canvas.overlays");
    driver.hand.click("layers.numbers.edge_values");
    CHECK(driver.ui.session.canvas.numbers == CellNumbers::edge_values);
}

} // namespace rasterwalk
