#include "ui/canvas/square_marks.h"

#include <algorithm>
#include <array>

#include "pipeline/square_steps.h"
#include "ui/canvas/marks.h"

namespace rasterwalk {

namespace {

/// Squares narrower than this are not marked, design pixels.
constexpr float least_square = 4.0f;

struct SquareBox {
    ImVec2 low, high;
};
SquareBox square_on_screen(const Marks& m, const Rectangle& pixels) {
    const ImVec2 origin = m.run.place.origin;
    const auto at = [&](int column, int row) {
        return ImVec2{origin.x + m.scale * static_cast<float>(column),
                      origin.y + m.scale * static_cast<float>(row)};
    };
    return {at(pixels.left, pixels.top), at(pixels.right, pixels.bottom)};
}

bool is_in_view(const Marks& m, const SquareBox& box) {
    return box.low.x < m.high.x && box.high.x > m.low.x && box.low.y < m.high.y &&
           box.high.y > m.low.y;
}

/// The lines along which a square is divided.
void draw_division(const Marks& m, const Rectangle& pixels) {
    std::array<Rectangle, 4> parts;
    const int count = divide(pixels, parts);
    const SquareBox box = square_on_screen(m, pixels);
    const SquareBox last =
        square_on_screen(m, parts[static_cast<std::size_t>(std::max(count - 1, 0))]);
    const float half = 0.5f * m.u;
    const ImU32 line = m.colour(Meaning::current, 0.55f);
    if (last.low.x > box.low.x)
        m.list->AddRectFilled({last.low.x - half, box.low.y}, {last.low.x + half, box.high.y},
                              line);
    if (last.low.y > box.low.y)
        m.list->AddRectFilled({box.low.x, last.low.y - half}, {box.high.x, last.low.y + half},
                              line);
}

} // namespace

void draw_squares(const Marks& m) {
    const WarnockSquares* const squares = m.run.frame.squares.get();
    if (squares == nullptr || !m.run.done || m.run.cursor == cursor_end) return;
    const int end = square_at(*squares, m.run.cursor);
    for (int n = 0; n < end && m.has_room();) {
        const WarnockSquare& square = (*squares)[n];
        const SquareBox box = square_on_screen(m, square.pixels);
        const float side = std::min(box.high.x - box.low.x, box.high.y - box.low.y);
        // Its parts are half as wide.
        const bool is_marked = side >= 2.0f * least_square * m.u && is_in_view(m, box);
        if (is_marked && square.reason == SquareReason::divide) draw_division(m, square.pixels);
        n = is_marked ? n + 1 : squares->after(n);
    }
    const SquareBox box = square_on_screen(m, (*squares)[end - 1].pixels);
    const float out = 1.0f * m.u;
    m.list->AddRect({box.low.x - out, box.low.y - out}, {box.high.x + out, box.high.y + out},
                    dark_casing, 0.0f, 0, 4.5f * m.u);
    m.list->AddRect({box.low.x - out, box.low.y - out}, {box.high.x + out, box.high.y + out},
                    m.colour(Meaning::current), 0.0f, 0, 2.5f * m.u);
}

} // namespace rasterwalk
