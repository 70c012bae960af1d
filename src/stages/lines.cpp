#include "stages/lines.h"

#include <algorithm>
#include <cstdlib>

#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

int sign(int value) {
    return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0);
}

/// The current pixel of a walk in whole pixels.
struct Pixel {
    int x = 0, y = 0;
};

void put_place(const Pixel& pixel, LineSample& sample) {
    sample.x = static_cast<float>(pixel.x);
    sample.y = static_cast<float>(pixel.y);
    sample.fragment.column = pixel.x;
    sample.fragment.row = pixel.y;
}

void take_step(const LineFrame& line, PixelStep step, Pixel& pixel) {
    const bool is_diagonal = step == PixelStep::diagonal;
    pixel.x += is_diagonal ? line.diagonal_x : line.straight_x;
    pixel.y += is_diagonal ? line.diagonal_y : line.straight_y;
}

/// The step decided at a sample; the last one has nowhere to go.
template <class Number>
void note(Number before, Number after, PixelStep step, std::size_t i,
          std::span<LineDecision> decisions) {
    if (decisions.empty()) return;
    const bool is_last = i + 1 == decisions.size();
    decisions[i] = {static_cast<double>(before), static_cast<double>(is_last ? before : after),
                    is_last ? PixelStep::none : step};
}

} // namespace

LineFrame line_frame(const LineEnd& a, const LineEnd& b) {
    const int dx = static_cast<int>(b.x) - static_cast<int>(a.x);
    const int dy = static_cast<int>(b.y) - static_cast<int>(a.y);
    const bool is_steep = std::abs(dy) > std::abs(dx);
    LineFrame line;
    line.is_steep = is_steep;
    line.longer = std::abs(is_steep ? dy : dx);
    line.shorter = std::abs(is_steep ? dx : dy);
    line.straight_x = is_steep ? 0 : sign(dx);
    line.straight_y = is_steep ? sign(dy) : 0;
    line.diagonal_x = sign(dx);
    line.diagonal_y = sign(dy);
    return line;
}

void line_by_interpolate(const LineEnd& a, const LineEnd& b, const LinePart& part,
                         const Stages& stages, std::span<LineSample> result,
                         std::span<LineDecision>) {
    const LineStep step = call<line_step>(stages.line_step, a, b, part);
    call<interpolate>(stages.interpolate, a, b, step, part, result);
}

void line_by_bresenham(const LineEnd& a, const LineEnd& b, const LinePart& part, const Stages&,
                       std::span<LineSample> result, std::span<LineDecision> decisions) {
    mix_ends(a, b, part, result);
    const LineFrame line = line_frame(a, b);
    const int after_straight = 2 * line.shorter;
    const int after_diagonal = 2 * (line.shorter - line.longer);
    Pixel pixel{static_cast<int>(a.x), static_cast<int>(a.y)};
    int d = 2 * line.shorter - line.longer;
    for (std::size_t i = 0; i < result.size(); ++i) {
        put_place(pixel, result[i]);
        const PixelStep step = d < 0 ? PixelStep::straight : PixelStep::diagonal;
        const int next = d + (d < 0 ? after_straight : after_diagonal);
        note(d, next, step, i, decisions);
        take_step(line, step, pixel);
        d = next;
    }
}

void line_by_midpoint(const LineEnd& a, const LineEnd& b, const LinePart& part, const Stages&,
                      std::span<LineSample> result, std::span<LineDecision> decisions) {
    mix_ends(a, b, part, result);
    const LineFrame line = line_frame(a, b);
    // Double holds whole and half numbers exactly.
    const double longer = line.longer, shorter = line.shorter;
    Pixel pixel{static_cast<int>(a.x), static_cast<int>(a.y)};
    double d = shorter - longer * 0.5;
    for (std::size_t i = 0; i < result.size(); ++i) {
        put_place(pixel, result[i]);
        const PixelStep step = d <= 0.0 ? PixelStep::straight : PixelStep::diagonal;
        const double next = d + (d <= 0.0 ? shorter : shorter - longer);
        note(d, next, step, i, decisions);
        take_step(line, step, pixel);
        d = next;
    }
}

void line_by_dda(const LineEnd& a, const LineEnd& b, const LinePart& part, const Stages&,
                 std::span<LineSample> result, std::span<LineDecision> decisions) {
    mix_ends(a, b, part, result);
    const LineFrame line = line_frame(a, b);
    const float steps = static_cast<float>(std::max(line.longer, 1));
    const float slope = (line.is_steep ? b.x - a.x : b.y - a.y) / steps;
    Pixel pixel{static_cast<int>(a.x), static_cast<int>(a.y)};
    float place = line.is_steep ? a.x : a.y;
    for (std::size_t i = 0; i < result.size(); ++i) {
        // Along the shorter axis the sample is where the float is, along the longer on its pixel.
        (line.is_steep ? pixel.x : pixel.y) = to_pixel(place, Rounding::round);
        put_place(pixel, result[i]);
        (line.is_steep ? result[i].x : result[i].y) = place;
        const float next = place + slope;
        const bool stays = to_pixel(next, Rounding::round) == to_pixel(place, Rounding::round);
        note(place, next, stays ? PixelStep::straight : PixelStep::diagonal, i, decisions);
        take_step(line, PixelStep::straight, pixel);
        place = next;
    }
}

} // namespace rasterwalk
