#include "ui/canvas/test_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "base/numbers.h"
#include "explain/test_formulas.h"
#include "inspect/pixel_tests.h"
#include "ui/actions/compare.h"
#include "ui/canvas/cells.h"
#include "ui/canvas/marks.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Under the numbers, whatever the picture shows there.
constexpr ImU32 number_ground = IM_COL32(12, 13, 16, 225);

/// Digits have nothing below the baseline: they need only this share of a line's height.
constexpr float digit_height = 0.92f;

/// Width of the band along an edge, design pixels.
constexpr float band_width = 5.0f;

/// Radius of the dot that takes the place of a tint, as a share of a cell.
constexpr float dot_share = 0.12f;

/// Letters of a number that fits in a cell: a sign and three digits.
constexpr std::size_t fitting_letters = 4;

/// The polygon of the triangle shown; null if the run does not test its pixels.
const TestedPolygon* tested_polygon(const Marks& m) {
    const std::optional<int>& triangle = m.ui.results.a.triangle;
    const Frame& frame = m.run.frame;
    if (!triangle || !frame.is_drawn(*triangle) || !tests_pixels(frame.stages)) return nullptr;
    return &m.run.rows.rows.tested;
}

/// Is the piece of work that was just done a test of the triangle shown?
bool is_at_test(const ShownRun& run, const std::optional<int>& triangle) {
    return run.done && run.cursor != cursor_end && run.done->phase == Phase::tests &&
           run.done->triangle == triangle;
}

/// A pixel's upper left corner on the screen.
ImVec2 corner_of_pixel(const Marks& m, int column, int row) {
    return m.at(static_cast<float>(column) - 0.5f, static_cast<float>(row) - 0.5f);
}

/// Do these overlays colour the cells themselves? Two tints would mix.
bool has_coloured_cells(const Marks& m) {
    const OverlaySet& overlays = m.ui.session.overlays;
    return overlays.has(Overlay::edge_field) || overlays.has(Overlay::weights);
}

void dot_run(const Marks& m, const TestedRun& run, int row) {
    const VisibleRange columns =
        visible(m.at(-0.5f, 0.0f).x, m.scale, m.low.x, m.high.x, run.last + 1);
    for (int column = std::max(run.first, columns.first); column < columns.last; ++column) {
        if (!m.has_room()) return;
        m.list->AddCircleFilled(m.at(static_cast<float>(column), static_cast<float>(row)),
                                dot_share * m.scale,
                                m.colour(run.is_inside ? Meaning::pass : Meaning::fail), 12);
    }
}

void tint_run(const Marks& m, const TestedRun& run, int row, bool has_numbers) {
    ImVec2 low = corner_of_pixel(m, run.first, row);
    ImVec2 high = corner_of_pixel(m, run.last + 1, row + 1);
    low.x = std::max(low.x, m.low.x);
    high.x = std::min(high.x, m.high.x);
    if (low.x >= high.x) return;
    if (has_numbers) m.list->AddRectFilled(low, high, number_ground);
    m.list->AddRectFilled(low, high,
                          run.is_inside ? m.colour(Meaning::pass, inside_tint)
                                        : m.colour(Meaning::fail, outside_tint));
}

/// A point of the grid on the screen.
ImVec2 on_screen(const Marks& m, const GridPoint& point) {
    constexpr float parts = static_cast<float>(grid_parts);
    return m.at(static_cast<float>(point.x) / parts - 0.5f,
                static_cast<float>(point.y) / parts - 0.5f);
}

/// A band along an edge, on the side where its function is positive.
void draw_inner_side(const Marks& m, const EdgeFunction& edge) {
    const ImVec2 a = on_screen(m, edge.from);
    const ImVec2 b =
        on_screen(m, {edge.from.x + edge.direction.dx, edge.from.y + edge.direction.dy});
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    if (length < 1.0f) return;
    const float width = band_width * m.u;
    const ImVec2 in{-(b.y - a.y) / length * width, (b.x - a.x) / length * width};
    const bool is_inner = edge.number < 0;
    const Meaning meaning = is_inner ? Meaning::current : edge_meaning(edge.number);
    m.list->AddQuadFilled(a, b, {b.x + in.x, b.y + in.y}, {a.x + in.x, a.y + in.y},
                          m.colour(meaning, is_inner ? 0.2f : 0.4f));
    if (is_inner) m.list->AddLine(a, b, m.colour(Meaning::current, 0.5f), m.u);
}

/// One of the numbers of a cell.
struct CellTest {
    std::string text;
    int edge = 0;         ///< of the polygon, whose colour it has; -1: an inner one
    bool is_zero = false; ///< of an edge function: the centre lies on the edge
    bool passes = false;
};

/// With as many digits as fit; dots if not even the whole part does.
std::string number_in_room(double value, float room, const ImFont* font) {
    for (int digits = 3; digits >= 0; --digits) {
        std::string text = decimals_without_zeros(value, digits);
        // A value rounded to 0 would say that the centre lies on the edge.
        if (value != 0.0 && (text == "0" || text == "-0")) break;
        text = with_minus_signs(text);
        if (text_width(font, text) <= room) return text;
    }
    const std::string sign = value < 0.0 ? "−…" : "…";
    return sign;
}

/// The numbers of a cell, from the top; an empty text where one is left out.
std::array<CellTest, edge_function_count> numbers_of(const Marks& m, const PixelTest& test,
                                                     float room) {
    const bool has_weights = m.ui.session.canvas.numbers == CellNumbers::weights;
    ImFont* const font = m.ui.fonts.mono_small;
    std::array<CellTest, edge_function_count> numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::size_t e = has_weights ? edge_of_weight(i, m.run.frame.settings.weight_edge) : i;
        CellTest& number = numbers[i];
        number.edge = test.edges[e];
        number.is_zero = test.e[e] == 0 && !has_weights;
        number.passes = test.passes[e];
        const bool keeps_out = has_weights ? test.weights[i] < 0.0f : !test.passes[e];
        if (!test.is_inside && !keeps_out) continue;
        number.text = number_in_room(has_weights ? static_cast<double>(test.weights[i])
                                                 : in_square_pixels(test.e[e]),
                                     room, font);
    }
    return numbers;
}

} // namespace

bool shows_tests(const Ui& ui) {
    const RunResults& a = ui.results.a;
    return tests_pixels(a.frame.stages) &&
           (shows_test_numbers(ui) || (a.triangle && is_at_test(run_a(ui), a.triangle)));
}

void draw_tested_pixels(const Marks& m) {
    const TestedPolygon* const polygon = tested_polygon(m);
    if (polygon == nullptr) return;
    const int triangle = *m.ui.results.a.triangle;
    const bool has_numbers = shows_test_numbers(m.ui), is_dotted = has_coloured_cells(m);
    if (!has_numbers && !is_at_test(m.run, triangle)) return;
    const Viewport size = m.run.frame.settings.viewport;
    const VisibleRange rows =
        visible(m.run.place.origin.y, m.scale, m.low.y, m.high.y, size.height);
    for (int row = rows.first; row < rows.last && m.has_room(); ++row) {
        for (TestedRun run : tested_runs(*polygon, triangle, row, m.run.cursor)) {
            run.first = std::max(run.first, 0);
            run.last = std::min(run.last, size.width - 1);
            if (run.first > run.last) continue;
            if (is_dotted)
                dot_run(m, run, row);
            else
                tint_run(m, run, row, has_numbers);
        }
    }
}

void draw_tested_box(const Marks& m) {
    const TestedPolygon* const polygon = tested_polygon(m);
    if (polygon == nullptr) return;
    const int triangle = *m.ui.results.a.triangle;
    if (!shows_test_numbers(m.ui) && !is_at_test(m.run, triangle)) return;
    const int now = fan_triangle_in_test(*polygon, triangle, m.run.cursor);
    if (now < 0) return;
    const TestedTriangle& of = polygon->triangles[static_cast<std::size_t>(now)];
    for (const EdgeFunction& edge : of.edges)
        draw_inner_side(m, edge);
    const ImVec2 low = corner_of_pixel(m, of.box.left, of.box.top);
    const ImVec2 high = corner_of_pixel(m, of.box.right, of.box.bottom);
    m.list->AddRect(low, high, dark_casing, 0.0f, 0, 3.6f * m.u);
    m.list->AddRect(low, high, m.colour(Meaning::current, 0.8f), 0.0f, 0, 1.6f * m.u);
}

void draw_test_numbers(const Marks& m, glm::ivec2 pixel, ImVec2 low,
                       std::span<const std::pair<ImVec2, ImVec2>> lines) {
    const TestedPolygon* const polygon = tested_polygon(m);
    if (polygon == nullptr) return;
    const std::optional<PixelTest> test = test_of_pixel(*polygon, *m.ui.results.a.triangle, pixel.x,
                                                        pixel.y, m.run.cursor, m.run.frame.stages);
    if (!test) return;
    ImFont* const font = m.ui.fonts.mono_small;
    const float line = digit_height * font->FontSize, margin = 2.5f * m.u;
    float y = std::round(low.y + 0.5f * (m.scale - 3.0f * line));
    for (const CellTest& number : numbers_of(m, *test, m.scale - 2.0f * margin)) {
        const float width = text_width(font, number.text);
        const ImVec2 at{std::round(low.x + m.scale - margin - width),
                        y - 0.5f * (font->FontSize - line)};
        y += line;
        if (number.text.empty()) continue;
        const Meaning meaning = number.edge < 0 ? Meaning::current : edge_meaning(number.edge);
        ImU32 ink = m.colour(meaning);
        const float around = band_width * m.u;
        const bool is_struck = std::any_of(lines.begin(), lines.end(), [&](const auto& edge) {
            return crosses(edge.first, edge.second, {at.x - around, y - line - around},
                           {at.x + width + around, y + around});
        });
        // A line makes room for the number.
        if (is_struck)
            m.list->AddRectFilled({at.x - m.u, y - line}, {at.x + width + m.u, y}, number_ground,
                                  2.0f * m.u);
        if (number.is_zero) {
            const ImVec2 from{at.x - 2.0f * m.u, y - line}, to{at.x + width + 1.5f * m.u, y};
            if (number.passes) {
                m.list->AddRectFilled(from, to, ink, 2.0f * m.u);
                ink = IM_COL32(0, 0, 0, 255);
            } else {
                m.list->AddRect(from, to, ink, 2.0f * m.u, 0, m.u);
            }
        }
        m.list->AddText(font, font->FontSize, at, ink, number.text.c_str());
    }
}

float test_numbers_zoom(const Ui& ui) {
    ImFont* const font = ui.fonts.mono_small;
    const float u = ui.options.text_scale;
    const float width = static_cast<float>(fitting_letters) * text_width(font, "0") + 5.0f * u;
    return std::ceil(std::max(width, 3.0f * digit_height * font->FontSize + u));
}

} // namespace rasterwalk
