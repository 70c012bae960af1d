#include "ui/actions/picture_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "session/canvas_view.h"
#include "ui/actions/compare.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The least share of its size that a fitting picture keeps to be a whole multiple.
constexpr float share_kept = 0.95f;

/// On the sides of a numbered picture that have no numbers, design pixels.
constexpr float numbered_border = 6.0f;

/// A picture with longer sides is always fitted whole.
constexpr int longest_small_side = 64;

/// A pixel smaller than this is hard to look at, design pixels.
constexpr float readable_pixel = 16.0f;

/// Kept free on each side of the picture.
struct Margins {
    float left, top, right, bottom;
};

/// Do edge functions tint the pixels that they have tested? The tints are explained at every zoom.
bool has_tints(const Ui& ui) {
    return !is_comparing(ui) && tests_pixels(ui.results.a.frame.stages);
}

Margins plain_margins(const Ui& ui) {
    const float border = picture_border * ui.options.text_scale;
    return {border, border, border, border + (has_tints(ui) ? cell_key_height(ui) : 0.0f)};
}

Margins numbered_margins(const Ui& ui) {
    const float border = std::ceil(numbered_border * ui.options.text_scale);
    const ImVec2 ruler = ruler_size(ui);
    return {ruler.x, ruler.y, border, border + (wants_cell_key(ui) ? cell_key_height(ui) : 0.0f)};
}

ImVec2 room_within(const Margins& m, ImVec2 low, ImVec2 high) {
    return {std::max(high.x - low.x - m.left - m.right, 1.0f),
            std::max(high.y - low.y - m.top - m.bottom, 1.0f)};
}

float scale_in(const PicturePart& part, ImVec2 room) {
    const float scale =
        std::min(room.x / (part.right - part.left), room.y / (part.bottom - part.top));
    // Whole multiples keep all pixels equally large and sharp: used where they cost next to
    // nothing.
    const float whole = std::floor(scale);
    return whole >= share_kept * scale ? whole : std::max(scale, 0.01f);
}

PicturePlace place_in(const Ui& ui, const PicturePart& part, ImVec2 low, ImVec2 high) {
    // Numbers that have no room next to the picture would lie on it.
    const Margins plain = plain_margins(ui);
    const bool is_large = scale_in(part, room_within(plain, low, high)) >= grid_zoom;
    const Margins m = is_large ? numbered_margins(ui) : plain;
    const ImVec2 room = room_within(m, low, high);
    PicturePlace place;
    place.scale = scale_in(part, room);
    const auto origin = [&](float from, float space, float first, float last) {
        const float middle = from + 0.5f * (space - place.scale * (last - first));
        // Never under the numbers, even by a fraction of a screen pixel.
        return std::max(std::round(middle), std::ceil(from)) - std::round(place.scale * first);
    };
    place.origin = {origin(low.x + m.left, room.x, part.left, part.right),
                    origin(low.y + m.top, room.y, part.top, part.bottom)};
    return place;
}

/// The part of the picture that the triangles cover; all of it if they cover nothing.
PicturePart drawn_part(const Frame& frame) {
    const Viewport size = frame.settings.viewport;
    const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    constexpr float infinite = std::numeric_limits<float>::infinity();
    PicturePart part{infinite, infinite, -infinite, -infinite};
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t)) continue;
        for (const ScreenVertex& vertex : frame.triangle_vertices(t)) {
            const auto column = static_cast<float>(vertex.column);
            const auto row = static_cast<float>(vertex.row);
            part = {std::min(part.left, column), std::min(part.top, row),
                    std::max(part.right, column + 1.0f), std::max(part.bottom, row + 1.0f)};
        }
    }
    part = {std::max(part.left, 0.0f), std::max(part.top, 0.0f), std::min(part.right, width),
            std::min(part.bottom, height)};
    const bool is_empty = !(part.left < part.right && part.top < part.bottom);
    return is_empty ? PicturePart{0.0f, 0.0f, width, height} : part;
}

/// With this many columns and rows around it, as far as the picture has them.
PicturePart with_border(const PicturePart& part, const PicturePart& whole, float columns,
                        float rows) {
    return {std::max(part.left - columns, whole.left), std::max(part.top - rows, whole.top),
            std::min(part.right + columns, whole.right),
            std::min(part.bottom + rows, whole.bottom)};
}

} // namespace

ImVec2 ruler_size(const Ui& ui) {
    const float u = ui.options.text_scale;
    const ImFont* const font = ui.fonts.small;
    const int last_row = std::max(ui.results.a.frame.settings.viewport.height - 1, 10);
    const float width = text_width(font, std::to_string(last_row));
    return {std::ceil(width + 10.0f * u), std::ceil(font->FontSize + 8.0f * u)};
}

bool wants_cell_key(const Ui& ui) {
    const Settings& settings = ui.results.a.frame.settings;
    const bool has_tests = has_fragments(settings.stage) && depth_rule(settings) != DepthTest::off;
    const CanvasView& canvas = ui.session.canvas;
    return !is_comparing(ui) &&
           (canvas.numbers != CellNumbers::none || (canvas.fates && has_tests) || has_tints(ui));
}

float cell_key_height(const Ui& ui) {
    return std::ceil(ui.fonts.small->FontSize + 8.0f * ui.options.text_scale);
}

PictureFit fit_part(const Ui& ui, const PicturePart& part, ImVec2 low, ImVec2 high) {
    const float least = row_table_zoom(ui);
    const std::vector<RowTableLayout> tables = row_table_layouts(ui, high.x - low.x);
    for (const RowTableLayout& table : tables) {
        const PicturePlace place = place_in(ui, part, low, {high.x - table.width, high.y});
        if (place.scale >= least) return {place, table};
    }
    return {place_in(ui, part, low, high), {}};
}

PicturePart part_that_fits(Ui& ui, ImVec2 low, ImVec2 high) {
    const Frame& frame = ui.results.a.frame;
    const Viewport size = frame.settings.viewport;
    const PicturePart whole{0.0f, 0.0f, static_cast<float>(size.width),
                            static_cast<float>(size.height)};
    if (std::max(size.width, size.height) > longest_small_side || is_comparing(ui)) return whole;
    const ImVec2 room = room_within(numbered_margins(ui), low, high);
    const bool has_table = has_row_table_for_inspector(ui);
    const float readable = readable_pixel * ui.options.text_scale;
    const float least = has_table ? std::max(readable, large_row_table_zoom(ui)) : readable;
    if (scale_in(whole, room) >= least) return whole;
    DrawnPart& drawn = ui.canvas.drawn;
    if (drawn.frame_number != ui.results.a.frame_number)
        drawn = {ui.results.a.frame_number, drawn_part(frame)};
    const PicturePart part = with_border(drawn.part, whole, 1.0f, 1.0f);
    if (!has_table) return part;
    // The row above and the row below are given up if the table has room only then.
    const PicturePart rows = with_border(drawn.part, whole, 1.0f, 0.0f);
    const float line = large_row_table_zoom(ui);
    return scale_in(part, room) < line && scale_in(rows, room) >= line ? rows : part;
}

} // namespace rasterwalk
