#include "ui/canvas/cells.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/element_names.h"
#include "base/numbers.h"
#include "picture/view_image.h"
#include "settings/settings.h"
#include "ui/actions/compare.h"
#include "ui/canvas/marks.h"
#include "ui/canvas/test_marks.h"
#include "ui/widgets/swatch.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Dark and light ink: the one that can be read on a cell.
constexpr ImU32 dark_ink = IM_COL32(0, 0, 0, 255);
constexpr ImU32 light_ink = IM_COL32(255, 255, 255, 255);

/// A colour of the screen, 0..255 a channel.
struct Shade {
    float red = 0.0f, green = 0.0f, blue = 0.0f;

    void add(float r, float g, float b, float opacity) {
        red += opacity * (r - red);
        green += opacity * (g - green);
        blue += opacity * (b - blue);
    }
    glm::vec<3, std::uint8_t> bytes() const {
        return {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                static_cast<std::uint8_t>(blue)};
    }
};

/// The sign of a fragment's fate in a cell.
struct CellFate {
    glm::ivec2 pixel;
    std::optional<Fate> fate; ///< none: stands for fragments that the cell has no room for
    int place;                ///< from the left, where a cell has several
};

/// The sign for more fragments.
constexpr const char* more_sign = "…";

/// From one sign to the next in a cell, screen pixels.
float fate_step(const Ui& ui) {
    return text_width(ui.fonts.small, passed_sign) + 2.0f * ui.options.text_scale;
}

/// The fates of the shown triangle's fragments in a part of the picture, and of all fragments of
/// the picked pixel, as far as they are drawn at the cursor; row by row.
std::vector<CellFate> shown_fates(Ui& ui, const Rectangle& part) {
    const RunResults& a = ui.results.a;
    std::vector<CellFate> fates;
    const std::optional<PixelHistory>& history = ui.results.history;
    if (a.triangle) {
        for (const FragmentFate& found :
             ui.canvas.fates.find(a.frame, a.frame_number, *a.triangle, part)) {
            const bool is_picked = history && history->pixel == found.pixel;
            if (found.cursor < a.cursor && !is_picked)
                fates.push_back({found.pixel, found.fate, 0});
        }
    }
    if (history) {
        const auto first = history->entries.begin();
        const auto last = std::partition_point(first, history->entries.end(),
                                               [&](const auto& e) { return e.cursor < a.cursor; });
        const int room =
            static_cast<int>((ui.canvas.place.scale - ui.options.text_scale) / fate_step(ui));
        // Where a cell cannot hold all of them, the last ones.
        auto entry = last - std::min<std::ptrdiff_t>(last - first, std::max(room, 1));
        int place = 0;
        if (entry != first && last - entry > 1) {
            fates.push_back({history->pixel, std::nullopt, place++});
            ++entry;
        }
        for (; entry != last; ++entry)
            fates.push_back({history->pixel, entry->fate, place++});
    }
    std::stable_sort(fates.begin(), fates.end(), [](const CellFate& one, const CellFate& other) {
        return one.pixel.y < other.pixel.y;
    });
    return fates;
}

/// The ends of the shown triangle's row in this row of the picture.
struct Ends {
    int left, right;
    int left_edge, right_edge; ///< the edges that wrote them
};

std::optional<Ends> ends_of(const Ui& ui, int row) {
    const RowHistory& history = ui.results.a.rows;
    const int i = row - history.rows.first_row;
    if (ui.results.a.frame.settings.stage < Stage::edges || i < 0 || i >= history.rows.size() ||
        !history.left_by[i].is_set()) {
        return std::nullopt;
    }
    return Ends{history.rows.left[i].column, history.rows.right[i].column, history.left_by[i].edge,
                history.right_by[i].edge};
}

/// A depth in few letters: with as many digits as the room has for a number below 1.
std::string depth_number(float depth, float room, float letter) {
    const int letters = static_cast<int>(room / letter);
    for (int digits = std::min(letters - 2, 4); digits >= 0; --digits) {
        std::string text = fixed(static_cast<double>(depth), digits);
        if (static_cast<int>(text.size()) <= letters) return text;
    }
    return {};
}

/// A depth needs its point and this many digits after it.
constexpr const char* shortest_depth = "0.00";

ImFont* number_font(const Ui& ui) {
    return ui.fonts.mono_small;
}

float letter_width(const Ui& ui) {
    return text_width(number_font(ui), "0");
}

/// Between a number and the border of its cell, design pixels.
constexpr float number_margin = 2.5f;

/// What the cells are drawn with.
struct Cells {
    Ui& ui;
    Marks marks;
    Pane visible_part; ///< of the canvas, without the numbers of columns and rows
    const std::vector<CanvasLabel>& labels;       ///< on the picture: nothing is drawn under them
    std::vector<std::pair<ImVec2, ImVec2>> lines; ///< the edges of the triangle shown

    ImVec2 corner(int column, int row) const {
        return marks.at(static_cast<float>(column) - 0.5f, static_cast<float>(row) - 0.5f);
    }
    /// Part of a number would be a different number.
    bool is_cut(ImVec2 low, ImVec2 high) const {
        return low.x < visible_part.low.x || low.y < visible_part.low.y ||
               high.x > visible_part.high.x || high.y > visible_part.high.y;
    }
};

/// The colour of a cell as the canvas shows it, without the marks on single places of it.
Shade shade_of(const Ui& ui, glm::ivec2 pixel) {
    const Results& results = ui.results;
    const Image& ground = results.ground.rgba.empty() ? results.a.picture : results.ground;
    const auto at = 4 * results.a.framebuffer->at(pixel.x, pixel.y);
    Shade shade;
    const auto add = [&](const Image& image) {
        if (at + 3 >= image.rgba.size()) return;
        shade.add(image.rgba[at], image.rgba[at + 1], image.rgba[at + 2],
                  static_cast<float>(image.rgba[at + 3]) / 255.0f);
    };
    add(ground);
    add(results.overlay.image);
    const std::optional<Ends> ends = ends_of(ui, pixel.y);
    if (!ends || (pixel.x != ends->left && pixel.x != ends->right)) return shade;
    if (results.a.frame.settings.stage == Stage::rows) shade = {12.0f, 13.0f, 16.0f};
    const ImVec4 tint = colour_of(
        edge_meaning(pixel.x == ends->left ? ends->left_edge : ends->right_edge), Theme::dark);
    shade.add(255.0f * tint.x, 255.0f * tint.y, 255.0f * tint.z, row_end_tint);
    return shade;
}

void draw_number(const Cells& cells, glm::ivec2 pixel) {
    const Marks& m = cells.marks;
    const std::string text = cell_number(cells.ui, pixel, m.scale);
    if (text.empty()) return;
    ImFont* const font = number_font(cells.ui);
    const float width = text_width(font, text);
    const ImVec2 corner = cells.corner(pixel.x, pixel.y);
    // In the lower part of the cell: the sample's dot is in its middle.
    const ImVec2 low{std::round(corner.x + 0.5f * (m.scale - width)),
                     std::round(corner.y + m.scale - font->FontSize - m.u)};
    const ImVec2 high{low.x + width, low.y + font->FontSize};
    if (cells.is_cut(low, high) || is_under_label(low, high, cells.labels)) return;
    const glm::vec<3, std::uint8_t> ground = shade_of(cells.ui, pixel).bytes();
    const bool is_struck =
        std::any_of(cells.lines.begin(), cells.lines.end(),
                    [&](const auto& line) { return crosses(line.first, line.second, low, high); });
    // A line makes room for the number.
    if (is_struck)
        m.list->AddRectFilled({low.x - m.u, low.y}, {high.x + m.u, high.y},
                              IM_COL32(ground.r, ground.g, ground.b, 255), 2.0f * m.u);
    m.list->AddText(font, font->FontSize, low, has_dark_ink(ground) ? dark_ink : light_ink,
                    text.c_str());
}

/// What edge functions say about a pixel, where nothing else is written.
void draw_tests(const Cells& cells, glm::ivec2 pixel) {
    const Marks& m = cells.marks;
    const ImVec2 low = cells.corner(pixel.x, pixel.y);
    const ImVec2 high{low.x + m.scale, low.y + m.scale};
    if (cells.is_cut(low, high) || is_under_label(low, high, cells.labels)) return;
    draw_test_numbers(m, pixel, low, cells.lines);
}

/// The sign of a fate in the upper left corner of a cell.
void draw_fate(const Cells& cells, const CellFate& of) {
    const Marks& m = cells.marks;
    ImFont* const font = cells.ui.fonts.small;
    const bool has_passed = of.fate == Fate::written;
    const char* const sign = !of.fate ? more_sign : has_passed ? passed_sign : failed_sign;
    const ImU32 colour = !of.fate ? packed(palette(Theme::dark).text)
                                  : m.colour(has_passed ? Meaning::pass : Meaning::fail);
    const float size = font->FontSize;
    const float width = text_width(font, sign);
    const ImVec2 corner = cells.corner(of.pixel.x, of.pixel.y);
    const ImVec2 low{
        std::round(corner.x + 2.0f * m.u + static_cast<float>(of.place) * fate_step(cells.ui)),
        std::round(corner.y + m.u)};
    const ImVec2 high{low.x + width, low.y + 0.85f * size};
    if (cells.is_cut(low, high) || is_under_label(low, high, cells.labels)) return;
    m.list->AddRectFilled({low.x - m.u, low.y}, {high.x + m.u, high.y}, IM_COL32(12, 13, 16, 170),
                          2.0f * m.u);
    m.list->AddText(font, size, {low.x, low.y - 0.1f * size}, colour, sign);
}

/// Which samples the fragment covers that has just been drawn, and in which pixel; none if the last
/// moment was something else.
struct FragmentAtWork {
    glm::ivec2 pixel;
    SampleMask covered;
};

std::optional<FragmentAtWork> fragment_at_work(const RunResults& run) {
    if (!run.done || run.done->phase != Phase::rows) return std::nullopt;
    const Timeline timeline(run.frame);
    const PolygonRows& rows = timeline.moments(run.done->triangle).rows;
    const int index = run.done->index;
    const int column = rows.left[static_cast<std::size_t>(index)].column + run.done->step;
    return FragmentAtWork{{column, rows.first_row + index}, covered_samples(rows, index, column)};
}

/// The samples of a pixel where they are, in their colours. Of the pixel at work, those that the
/// fragment covers have a ring, and the others are hollow.
void draw_samples(const Cells& cells, glm::ivec2 pixel,
                  const std::optional<FragmentAtWork>& at_work) {
    const Marks& m = cells.marks;
    const ImVec2 low = cells.corner(pixel.x, pixel.y);
    const ImVec2 high{low.x + m.scale, low.y + m.scale};
    if (cells.is_cut(low, high) || is_under_label(low, high, cells.labels)) return;
    const RunResults& a = cells.ui.results.a;
    if (a.framebuffer->overdraw[a.framebuffer->at(pixel.x, pixel.y)] == 0) return; // all are black
    const SampleColours& colours =
        a.framebuffer->sample_colour[a.framebuffer->at(pixel.x, pixel.y)];
    const ImU32 ink = has_dark_ink(shade_of(cells.ui, pixel).bytes()) ? dark_ink : light_ink;
    const float radius = std::clamp(0.08f * m.scale, 2.0f * m.u, 7.0f * m.u);
    for (int sample = 0; sample < sample_count; ++sample) {
        const GridPoint place = a.frame.stages.sample_place(sample);
        const auto part = [&](std::int64_t of) {
            return (0.5f + static_cast<float>(of) / static_cast<float>(grid_parts)) * m.scale;
        };
        const ImVec2 centre{low.x + part(place.x), low.y + part(place.y)};
        const bool is_here = at_work && at_work->pixel == pixel;
        const bool is_covered = is_here && has_sample(at_work->covered, sample);
        const glm::vec3& colour = colours[static_cast<std::size_t>(sample)];
        if (!is_here || is_covered)
            m.list->AddCircleFilled(centre, radius, screen_colour(cells.ui, colour));
        m.list->AddCircle(centre, radius, is_covered ? m.colour(Meaning::current) : ink, 0,
                          (is_covered ? 2.0f : 1.0f) * m.u);
    }
}

/// The edges that lie on the cells.
void find_lines(Cells& cells) {
    const Marks& m = cells.marks;
    const RunResults& a = cells.ui.results.a;
    if (!a.triangle || !a.frame.is_drawn(*a.triangle)) return;
    const PolygonCorners vertices = a.frame.triangle_vertices(*a.triangle);
    for (std::size_t v = 0; v < vertices.size(); ++v)
        cells.lines.emplace_back(m.at(vertices[v]), m.at(vertices[(v + 1) % vertices.size()]));
}

} // namespace

std::string cell_number(const Ui& ui, glm::ivec2 pixel, float room) {
    const Framebuffer& framebuffer = *ui.results.a.framebuffer;
    if (!framebuffer.contains(pixel.x, pixel.y)) return {};
    const std::size_t at = framebuffer.at(pixel.x, pixel.y);
    const float letter = letter_width(ui);
    const float inner = room - 2.0f * number_margin * ui.options.text_scale;
    std::string text;
    switch (ui.session.canvas.numbers) {
    case CellNumbers::none:
        break;
    case CellNumbers::ends:
        if (const std::optional<Ends> ends = ends_of(ui, pixel.y)) {
            if (pixel.x == ends->left || pixel.x == ends->right) text = std::to_string(pixel.x);
        }
        break;
    case CellNumbers::depth: {
        const float depth = stored_depth(framebuffer, pixel.x, pixel.y);
        const bool is_empty = depth == framebuffer.rules.depth_clear;
        if (!is_empty && room >= numbers_zoom(ui, CellNumbers::depth))
            text = depth_number(depth, inner, letter);
        break;
    }
    case CellNumbers::owner:
        if (framebuffer.owner[at] >= 0) text = short_triangle_name(framebuffer.owner[at]);
        break;
    case CellNumbers::overdraw:
        if (framebuffer.overdraw[at] > 0) text = std::to_string(framebuffer.overdraw[at]);
        break;
    case CellNumbers::edge_values:
    case CellNumbers::weights:
        break; // three of them: draw_test_numbers()
    }
    return letter * static_cast<float>(text.size()) <= inner ? text : std::string();
}

bool shows_fates(const Ui& ui) {
    const Settings& settings = ui.results.a.frame.settings;
    // Three numbers leave no room for a sign.
    return ui.session.canvas.fates && !shows_test_numbers(ui) && has_fragments(settings.stage) &&
           depth_rule(settings) != DepthTest::off && ui.canvas.place.scale >= fates_zoom(ui);
}

bool shows_test_numbers(const Ui& ui) {
    const CellNumbers numbers = ui.session.canvas.numbers;
    return is_of_tests(numbers) && !is_comparing(ui) && tests_pixels(ui.results.a.frame.stages) &&
           ui.canvas.place.scale >= numbers_zoom(ui, numbers);
}

float fates_zoom(const Ui& ui) {
    // A number has room below the sign.
    return std::max(cell_zoom, std::ceil(1.6f * ui.fonts.small->FontSize));
}

float numbers_zoom(const Ui& ui, CellNumbers numbers) {
    const float u = ui.options.text_scale;
    const auto room_for = [&](std::size_t letters) {
        return std::ceil(letter_width(ui) * static_cast<float>(letters) + 2.0f * number_margin * u);
    };
    const Frame& frame = ui.results.a.frame;
    float needed = number_font(ui)->FontSize;
    switch (numbers) {
    case CellNumbers::none:
        return 0.0f;
    case CellNumbers::ends:
        needed = room_for(std::to_string(frame.settings.viewport.width - 1).size());
        break;
    case CellNumbers::depth:
        needed = room_for(std::string_view(shortest_depth).size());
        break;
    case CellNumbers::owner:
        needed = room_for(short_triangle_name(std::max(frame.triangle_count() - 1, 0)).size());
        break;
    case CellNumbers::overdraw:
        break;
    case CellNumbers::edge_values:
    case CellNumbers::weights:
        needed = test_numbers_zoom(ui);
        break;
    }
    return std::max(cell_zoom, needed);
}

void draw_cells(Ui& ui, const Pane& visible_part, const std::vector<CanvasLabel>& labels) {
    const float scale = ui.canvas.place.scale;
    const CanvasView& canvas = ui.session.canvas;
    // A preview has no numbers.
    if (scale < cell_zoom || ui.results.a.preview.is_shown) return;
    const ShownRun run = run_a(ui);
    Cells cells{
        ui,
        {ui, run, nullptr, visible_part.low, visible_part.high, ui.options.text_scale, scale},
        {},
        labels,
        {}};
    const Pane inner{corner_of_cells(cells.marks), visible_part.high};
    cells.visible_part = inner;
    const Framebuffer& framebuffer = *ui.results.a.framebuffer;
    const ImVec2 origin = ui.canvas.place.origin;
    const VisibleRange columns =
        visible(origin.x, scale, inner.low.x, inner.high.x, framebuffer.size.width);
    const VisibleRange rows =
        visible(origin.y, scale, inner.low.y, inner.high.y, framebuffer.size.height);
    if (columns.first >= columns.last || rows.first >= rows.last) return;
    const Rectangle part{columns.first, rows.first, columns.last, rows.last};
    std::vector<CellFate> fates;
    if (shows_fates(ui)) fates = shown_fates(ui, part);
    const bool has_samples = !framebuffer.sample_colour.empty() && !is_comparing(ui);
    if (fates.empty() && canvas.numbers == CellNumbers::none && !has_samples) return;
    const std::optional<FragmentAtWork> at_work =
        has_samples ? fragment_at_work(ui.results.a) : std::nullopt;
    find_lines(cells);

    // As many rows together as fit in a draw list with their corners, whatever is in the cells.
    const bool has_tests = shows_test_numbers(ui);
    const int most_cells = has_tests || has_samples ? 400 : 1200;
    const int step = std::max(most_cells / (columns.last - columns.first), 1);
    auto next_fate = fates.begin();
    int band = 0;
    for (int first = rows.first; first < rows.last; first += step) {
        const int last = std::min(first + step, rows.last);
        const float top = std::max(cells.corner(0, first).y, inner.low.y);
        const float bottom = std::min(cells.corner(0, last).y, inner.high.y);
        if (bottom - top < 1.0f || inner.high.x - inner.low.x < 1.0f) continue;
        ImGui::SetCursorScreenPos({inner.low.x, top});
        ImGui::BeginChild(("cells " + std::to_string(band++)).c_str(),
                          {inner.high.x - inner.low.x, bottom - top}, false,
                          ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBackground |
                              ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoNav);
        cells.marks.list = ImGui::GetWindowDrawList();
        for (; next_fate != fates.end() && next_fate->pixel.y < last; ++next_fate)
            draw_fate(cells, *next_fate);
        for (int row = first; row < last && has_samples; ++row) {
            for (int column = columns.first; column < columns.last; ++column)
                draw_samples(cells, {column, row}, at_work);
        }
        for (int row = first; row < last && canvas.numbers != CellNumbers::none; ++row) {
            for (int column = columns.first; column < columns.last; ++column) {
                if (has_tests)
                    draw_tests(cells, {column, row});
                else
                    draw_number(cells, {column, row});
            }
        }
        ImGui::EndChild();
    }
}

} // namespace rasterwalk
