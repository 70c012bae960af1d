// The text in the cells of the picture where they are large.

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "inspect/pixel_history.h"
#include "pipeline/draw.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_number.h"
#include "ui/canvas/cells.h"
#include "ui/canvas/marks.h"
#include "ui/canvas/vertex_labels.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

bool is_sign(const ScreenText& text) {
    return text.words.find("✓") != text.words.npos || text.words.find("✗") != text.words.npos;
}

/// The texts in the cells, one by one.
std::vector<ScreenText> cell_texts() {
    std::vector<ScreenText> texts;
    for (const ScreenText& text : screen_text(0.15f)) {
        if (text.window.find("/cells ") != text.window.npos) texts.push_back(text);
    }
    return texts;
}

glm::ivec2 cell_of(const Driver& driver, const ScreenText& text) {
    const PicturePlace& place = driver.ui.canvas.place;
    return {std::floor((0.5f * (text.low.x + text.high.x) - place.origin.x) / place.scale),
            std::floor((0.5f * (text.low.y + text.high.y) - place.origin.y) / place.scale)};
}

/// The pixels whose cells can be seen as a whole and are not under the name of a vertex.
std::vector<glm::ivec2> whole_cells(const Driver& driver) {
    const Ui& ui = driver.ui;
    const WidgetPlace canvas = ui.widgets.at("canvas");
    const PicturePlace& place = ui.canvas.place;
    ImVec2 low = canvas.top_left, high = canvas.bottom_right;
    if (ui.canvas.row_table) {
        if (ui.canvas.row_table->is_at_left) {
            low.x = ui.canvas.row_table->right;
        } else {
            high.x = ui.canvas.row_table->left;
        }
    }
    if (const auto key = ui.widgets.find("canvas.cells"); key != ui.widgets.end())
        high.y = key->second.top_left.y;
    const ShownRun run = run_a(ui);
    const Marks marks{ui, run, nullptr, low, high, ui.options.text_scale, place.scale};
    low = corner_of_cells(marks);
    const std::vector<CanvasLabel> labels = vertex_labels(marks);
    std::vector<glm::ivec2> cells;
    const Viewport size = run.frame.settings.viewport;
    for (int row = 0; row < size.height; ++row) {
        for (int column = 0; column < size.width; ++column) {
            const ImVec2 a =
                marks.at(static_cast<float>(column) - 0.5f, static_cast<float>(row) - 0.5f);
            const ImVec2 b{a.x + place.scale, a.y + place.scale};
            if (a.x < low.x || a.y < low.y || b.x > high.x || b.y > high.y) continue;
            const bool is_free = std::none_of(labels.begin(), labels.end(), [&](const auto& l) {
                return a.x < l.high.x && b.x > l.low.x && a.y < l.high.y && b.y > l.low.y;
            });
            if (is_free) cells.emplace_back(column, row);
        }
    }
    return cells;
}

void look_close(Driver& driver, float zoom, glm::vec2 centre) {
    driver.ui.session.canvas.zoom = zoom;
    driver.ui.session.canvas.centre = centre;
    driver.hand.rest();
    driver.hand.leave();
}

/// The number that belongs in a cell, from the framebuffer of a redrawn frame; empty: none.
std::string expected_number(const Framebuffer& picture, CellNumbers numbers, glm::ivec2 pixel) {
    const std::size_t at = picture.at(pixel.x, pixel.y);
    if (numbers == CellNumbers::owner)
        return picture.owner[at] >= 0 ? "t" + std::to_string(picture.owner[at]) : "";
    return picture.overdraw[at] > 0 ? std::to_string(picture.overdraw[at]) : "";
}

} // namespace

TEST_CASE("The numbers seen in the cells are those of the frame, each in its own cell") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.ui.session.selection.triangle = 22;
    driver.ui.session.canvas.fates = false;
    look_close(driver, 32.0f, {250.0f, 300.0f});
    const Framebuffer picture = draw_frame(driver.ui.results.a.frame);
    for (const CellNumbers numbers : {CellNumbers::owner, CellNumbers::overdraw}) {
        driver.ui.session.canvas.numbers = numbers;
        driver.hand.rest();
        std::map<std::pair<int, int>, std::string> seen;
        for (const ScreenText& text : cell_texts()) {
            const glm::ivec2 cell = cell_of(driver, text);
            CHECK(text.size >= 12.0f);
            seen[{cell.x, cell.y}] += text.words;
        }
        int count = 0;
        for (const glm::ivec2& cell : whole_cells(driver)) {
            const std::string expected = expected_number(picture, numbers, cell);
            CAPTURE(cell.x, cell.y);
            CHECK(seen[{cell.x, cell.y}] == expected);
            count += expected.empty() ? 0 : 1;
        }
        CHECK(count > 100);
    }
}

TEST_CASE("1/z in the cells is that of the depth buffer, as far as its digits go") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.ui.session.canvas.fates = false;
    driver.ui.session.canvas.row_table = false;
    driver.ui.session.canvas.numbers = CellNumbers::depth;
    const float least = numbers_zoom(driver.ui, CellNumbers::depth);
    const Framebuffer picture = draw_frame(driver.ui.results.a.frame);
    for (const float zoom : {least, 64.0f}) {
        look_close(driver, zoom, {250.0f, 300.0f});
        int count = 0;
        for (const ScreenText& text : cell_texts()) {
            const glm::ivec2 cell = cell_of(driver, text);
            const double digits = static_cast<double>(text.words.size() - text.words.find('.') - 1);
            const auto depth = static_cast<double>(picture.depth[picture.at(cell.x, cell.y)]);
            CAPTURE(text.words, cell.x, cell.y);
            CHECK(std::abs(number_in(text.words) - depth) <= 0.5001 * std::pow(10.0, -digits));
            ++count;
        }
        CHECK(count > 50);
    }
    look_close(driver, least - 1.0f, {250.0f, 300.0f});
    CHECK(cell_texts().empty());
}

TEST_CASE("The ends of rows are written in the cells where they lie") {
    Driver driver("one-triangle.toml");
    driver.ui.session.canvas.numbers = CellNumbers::ends;
    look_close(driver, 32.0f, {12.0f, 10.0f});
    const PolygonRows& rows = driver.ui.results.a.rows.rows;
    std::map<std::pair<int, int>, std::string> seen;
    for (const ScreenText& text : cell_texts()) {
        const glm::ivec2 cell = cell_of(driver, text);
        seen[{cell.x, cell.y}] += text.words;
    }
    CHECK(seen.size() > 12);
    for (const auto& [cell, text] : seen) {
        const auto i = static_cast<std::size_t>(cell.second - rows.first_row);
        CAPTURE(cell.first, cell.second);
        REQUIRE(i < rows.left.size());
        const bool is_end = cell.first == rows.left[i].column || cell.first == rows.right[i].column;
        CHECK(is_end);
        CHECK(text == std::to_string(cell.first));
    }
}

TEST_CASE("There are no numbers below the zoom with room for them, and none too small above it") {
    for (const float text_scale : {1.0f, 1.5f, 2.0f}) {
        Driver driver("lab-room.toml", {1600, 1000}, text_scale);
        driver.hand.click("stage.depth");
        for (const CellNumbersInfo& info : cell_numbers_list()) {
            driver.ui.session.canvas.numbers = info.numbers;
            for (const float zoom : {8.0f, 16.0f, 23.0f, 24.0f, 36.0f, 64.0f}) {
                look_close(driver, zoom, {250.0f, 300.0f});
                const float scale = driver.ui.canvas.place.scale;
                for (const ScreenText& text : cell_texts()) {
                    CAPTURE(info.name, zoom, text_scale, text.words);
                    CHECK(zoom >= 24.0f);
                    CHECK(text.size >= 12.0f * text_scale);
                    if (is_sign(text)) continue;
                    CHECK(text.high.x - text.low.x <= scale);
                    // It is in one cell.
                    const glm::ivec2 cell = cell_of(driver, text);
                    const float left =
                        driver.ui.canvas.place.origin.x + scale * static_cast<float>(cell.x);
                    CHECK(text.low.x >= left - 0.5f);
                    CHECK(text.high.x <= left + scale + 0.5f);
                }
            }
        }
    }
}

TEST_CASE("The signs in the cells show the depth test's verdict on the triangle's fragments") {
    Driver driver;
    driver.hand.click("stage.depth");
    const Frame& frame = driver.ui.results.a.frame;
    const Framebuffer picture = draw_frame(frame);
    int passed = 0, failed = 0;
    for (const int triangle : {0, 9, 20, 22, 25}) {
        if (!frame.is_drawn(triangle)) continue;
        PolygonRows rows;
        compute_rows(frame, triangle, rows);
        const int i = rows.size() / 2;
        const int column = (rows.left[static_cast<std::size_t>(i)].column +
                            rows.right[static_cast<std::size_t>(i)].column) /
                           2;
        driver.ui.session.selection.triangle = triangle;
        look_close(driver, 40.0f,
                   {std::clamp(column, 10, 489), std::clamp(rows.first_row + i, 10, 489)});
        std::map<std::pair<int, int>, std::string> seen;
        for (const ScreenText& text : cell_texts()) {
            if (!is_sign(text)) continue;
            const glm::ivec2 cell = cell_of(driver, text);
            seen[{cell.x, cell.y}] += text.words;
        }
        for (const glm::ivec2& cell : whole_cells(driver)) {
            std::string expected;
            for (const PixelEntry& entry : pixel_history(frame, cell).entries) {
                if (entry.cursor.triangle != triangle) continue;
                const bool is_written = entry.fate == Fate::written;
                expected = is_written ? "✓" : "✗";
                ++(is_written ? passed : failed);
            }
            CAPTURE(triangle, cell.x, cell.y);
            CHECK(seen[{cell.x, cell.y}] == expected);
        }
    }
    CHECK(passed > 100);
    CHECK(failed > 100);
    driver.ui.session.canvas.fates = false;
    driver.hand.rest();
    for (const ScreenText& text : cell_texts())
        CHECK_FALSE(is_sign(text));
}

TEST_CASE("Signs stand for what is drawn at the cursor, and without a depth test there are none") {
    Driver driver("one-triangle.toml");
    driver.ui.session.a.settings.stage = Stage::depth;
    look_close(driver, 32.0f, {12.0f, 10.0f});
    const auto count_signs = [] {
        const std::vector<ScreenText> texts = cell_texts();
        return std::count_if(texts.begin(), texts.end(), is_sign);
    };
    const auto all = count_signs();
    CHECK(all > 20);
    driver.ui.session.cursor = *parse_cursor("t0/r5/c1");
    driver.hand.rest();
    const auto some = count_signs();
    CHECK(some > 0);
    CHECK(some < all);
    driver.ui.session.cursor = cursor_end;
    driver.ui.session.a.settings.stage = Stage::fill;
    driver.hand.rest();
    CHECK(count_signs() == 0);
}

TEST_CASE("The picked pixel shows the fates of all its fragments so far") {
    Driver driver;
    driver.hand.click("stage.depth");
    const glm::ivec2 pixel(240, 300);
    driver.hand.click_picture(pixel.x, pixel.y);
    look_close(driver, 64.0f, {pixel.x, pixel.y});
    const PixelHistory history = pixel_history(driver.ui.results.a.frame, pixel);
    REQUIRE(history.entries.size() == 3);
    for (std::size_t drawn = 0; drawn <= history.entries.size(); ++drawn) {
        driver.ui.session.cursor =
            drawn < history.entries.size() ? history.entries[drawn].cursor : cursor_end;
        driver.hand.rest();
        std::string expected, seen;
        for (std::size_t i = 0; i < drawn; ++i)
            expected += history.entries[i].fate == Fate::written ? "✓" : "✗";
        for (const ScreenText& text : cell_texts()) {
            if (is_sign(text) && cell_of(driver, text) == pixel) seen += text.words;
        }
        std::erase(seen, ' ');
        CAPTURE(drawn);
        CHECK(seen == expected);
    }
}

TEST_CASE("A line below the cells says what their signs and their numbers belong to") {
    Driver driver;
    driver.hand.click("stage.depth");
    CHECK(driver.ui.widgets.count("canvas.cells") == 0);
    const glm::ivec2 pixel(240, 300);
    driver.hand.click_picture(pixel.x, pixel.y);
    const int triangle = *driver.ui.results.a.triangle;
    driver.ui.session.canvas.numbers = CellNumbers::depth;
    look_close(driver, 64.0f, {pixel.x, pixel.y});
    std::string picked = "(240, 300):";
    for (const PixelEntry& entry : pixel_history(driver.ui.results.a.frame, pixel).entries) {
        picked += std::string(picked.ends_with(":") ? " " : ", ") + "t" +
                  std::to_string(entry.cursor.triangle) +
                  (entry.fate == Fate::written ? " ✓" : " ✗");
    }
    const std::string text = shown_text(driver, "canvas.cells");
    CAPTURE(text);
    CHECK(text.find("number: 1/z in the depth buffer") != text.npos);
    CHECK(text.find(picked) != text.npos);
    CHECK(text.find("triangles[" + std::to_string(triangle) + "]") != text.npos);
    // It is drawn as far as there is room.
    const WidgetPlace key = driver.hand.find("canvas.cells");
    const std::vector<ScreenText> texts = screen_text(3.0f);
    CHECK(std::any_of(texts.begin(), texts.end(), [&](const ScreenText& line) {
        return line.low.y >= key.top_left.y && line.high.y <= key.bottom_right.y &&
               line.high.x <= key.bottom_right.x && line.words.starts_with("number: 1/z");
    }));
    look_close(driver, 16.0f, {pixel.x, pixel.y});
    CHECK(driver.ui.widgets.count("canvas.cells") == 0);
}

TEST_CASE("Where a cell cannot hold the signs of all fragments it says that there are more") {
    Driver driver;
    driver.hand.click("stage.depth");
    const glm::ivec2 pixel(240, 300);
    driver.hand.click_picture(pixel.x, pixel.y);
    const PixelHistory history = pixel_history(driver.ui.results.a.frame, pixel);
    REQUIRE(history.entries.size() == 3);
    bool had_more = false;
    for (float zoom = 24.0f; zoom <= 64.0f; zoom += 4.0f) {
        look_close(driver, zoom, {pixel.x, pixel.y});
        std::string seen;
        for (const ScreenText& text : cell_texts()) {
            if (cell_of(driver, text) == pixel) seen += text.words;
        }
        std::erase(seen, ' ');
        CAPTURE(zoom, seen);
        const bool has_more = seen.starts_with("…");
        std::string last;
        for (std::size_t i = has_more ? 2 : 0; i < 3; ++i)
            last += history.entries[i].fate == Fate::written ? "✓" : "✗";
        // A single sign is that of the last fragment.
        const bool is_single = seen == "✓" || seen == "✗";
        if (is_single) {
            CHECK(seen == (history.entries[2].fate == Fate::written ? "✓" : "✗"));
        } else {
            CHECK(seen == (has_more ? "…" : "") + last);
        }
        had_more = had_more || has_more;
    }
    CHECK(had_more);
}

TEST_CASE("The ink of a number has enough contrast on every ground") {
    const auto linear = [](int byte) {
        const double share = byte / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    for (int red = 0; red < 256; red += 15) {
        for (int green = 0; green < 256; green += 5) {
            for (int blue = 0; blue < 256; blue += 17) {
                const double ground =
                    0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
                const bool dark =
                    has_dark_ink({static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                                  static_cast<std::uint8_t>(blue)});
                const double contrast = dark ? (ground + 0.05) / 0.05 : 1.05 / (ground + 0.05);
                if (contrast < 4.5) {
                    CAPTURE(red, green, blue);
                    CHECK(contrast >= 4.5);
                }
            }
        }
    }
}

TEST_CASE("Numbers are chosen in the list of layers, one kind at a time") {
    Driver driver("one-triangle.toml");
    driver.ui.session.a.settings.coverage = Coverage::edge_functions; // so that all are offered
    for (const CellNumbersInfo& info : cell_numbers_list()) {
        driver.hand.click("canvas.overlays");
        driver.hand.click("layers.numbers." + std::string(info.name));
        driver.hand.press(key::escape);
        CHECK(driver.ui.session.canvas.numbers == info.numbers);
    }
}

TEST_CASE("The button of the layers says how many are on, and which") {
    Driver driver;
    driver.hand.click("stage.depth");
    driver.ui.session.overlays.set(Overlay::wireframe, true);
    driver.ui.session.canvas.numbers = CellNumbers::depth;
    driver.hand.rest();
    driver.hand.hover("canvas.overlays");
    driver.hand.frames(90);
    CHECK(shows_words("layers: 2 on"));
    CHECK(shows_words("in the cells: 1/z"));
}

} // namespace rasterwalk
