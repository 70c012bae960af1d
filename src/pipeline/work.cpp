#include "pipeline/work.h"

#include <algorithm>
#include <cmath>

#include <glm/vec2.hpp>

#include "pipeline/square_steps.h"
#include "stages/fan.h"

namespace rasterwalk {

namespace {

/// The cost of an edge sample, and of a triangle itself, relative to a fragment.
constexpr double sample_work = 2;
constexpr double triangle_work = 20;

/// The extra cost of a fragment that sends a ray to the lamp.
constexpr double shadow_ray_work = 15;

/// The cost of a square itself, and of a fragment to the left of it, over which its row is walked.
constexpr double square_work = 2;
constexpr double skipped_work = 0.3;

/// The cost of a fragment of a pixel with several samples, of which the shader runs once or for
/// each, and of resolving a pixel.
constexpr double multisampled_work = 10;
constexpr double supersampled_work = 16;
constexpr double resolve_work = 0.5;

/// The cost of estimating a triangle.
constexpr double estimate_work = 10;

/// Triangles of more work than this are divided by rows.
constexpr double large_triangle = 5'000;

struct Box {
    double left, top, right, bottom;

    double width() const { return std::max(right - left, 0.0); }
    double height() const { return std::max(bottom - top, 0.0); }
    double area() const { return width() * height(); }
};

Box box_of(const Frame& frame, int triangle) {
    const Rectangle box = frame.stages.polygon_box(frame.triangle_vertices(triangle),
                                                   edge_rules(frame.settings), frame.stages);
    return {static_cast<double>(box.left), static_cast<double>(box.top),
            static_cast<double>(box.right), static_cast<double>(box.bottom)};
}

Box part_in(const Box& box, const Rectangle& area) {
    return {std::max(box.left, static_cast<double>(area.left)),
            std::max(box.top, static_cast<double>(area.top)),
            std::min(box.right, static_cast<double>(area.right)),
            std::min(box.bottom, static_cast<double>(area.bottom))};
}

Box in_picture(const Box& box, Viewport picture) {
    return part_in(box, {0, 0, picture.width, picture.height});
}

/// For a polygon without dents, as a fan of triangles about its first corner.
double twice_the_area(PolygonCorners v) {
    double area = 0.0;
    for_each_fan_corners(v.size(), [&](std::size_t a, std::size_t b, std::size_t c) {
        const glm::dvec2 p(v[b].column - v[a].column, v[b].row - v[a].row);
        const glm::dvec2 q(v[c].column - v[a].column, v[c].row - v[a].row);
        area += std::abs(p.x * q.y - p.y * q.x);
    });
    return area;
}

double samples_of(const Box& box) {
    return 2.0 * std::max(box.width(), box.height());
}

/// The fragments of a drawn triangle. Its box is assumed to be filled evenly.
FragmentEstimate fragments_of(const Frame& frame, int triangle) {
    if (!has_fragments(frame.settings.stage)) return {};
    const PolygonCorners v = frame.triangle_vertices(triangle);
    const Viewport& picture = frame.settings.viewport;
    const Box box = box_of(frame, triangle);
    const Box walked = part_in(box, frame.stages.walked_area(picture));
    const double whole = (twice_the_area(v) + samples_of(box)) / 2.0;
    return {whole * (walked.area() / box.area()),
            whole * (in_picture(box, picture).area() / box.area())};
}

double sampled_work(const Frame& frame) {
    if (!frame.has_samples()) return 1.0;
    return sampling_rule(frame.settings) == Sampling::supersample ? supersampled_work
                                                                  : multisampled_work;
}

double resolve_work_of(const Frame& frame) {
    const Viewport& picture = frame.settings.viewport;
    return resolve_work * picture.width * picture.height;
}

/// The work of a drawn triangle.
double work_of(const Frame& frame, int triangle, const FragmentEstimate& fragments) {
    const Box box = box_of(frame, triangle);
    const double of_each = frame.stages.shadow == shadow_by_ray && occluders_of(frame) != nullptr &&
                                   shading_rule(frame.settings) == Shading::phong
                               ? 1.0 + shadow_ray_work
                               : 1.0;
    return triangle_work + sample_work * samples_of(box) +
           of_each * sampled_work(frame) * fragments.in_picture;
}

/// The fragments of a square that one triangle is drawn in.
double fragments_of(const WarnockSquare& square) {
    const Rectangle& pixels = square.pixels;
    if (square.surface < 0) return 0.0;
    return static_cast<double>(pixels.right - pixels.left) * (pixels.bottom - pixels.top);
}

/// The work of a square. Values are added up from the left end of its rows, even outside it.
double work_of(const Frame& frame, const WarnockSquare& square) {
    if (square.surface < 0) return square_work;
    const PolygonRows& rows = frame.squares->rows(square.surface);
    const Rectangle& pixels = square.pixels;
    const int height = pixels.bottom - pixels.top;
    const int middle = std::clamp(pixels.top + height / 2 - rows.first_row, 0, rows.size() - 1);
    const double left = rows.left[static_cast<std::size_t>(middle)].column;
    const double outside = std::max(pixels.left - left, 0.0);
    return square_work + fragments_of(square) + skipped_work * outside * height;
}

bool is_divided(const Frame& frame, double work) {
    return work > large_triangle && has_fragments(frame.settings.stage);
}

} // namespace

int rows_within(const WorkLimit& limit, double of_pixel, Viewport size, int done) {
    const double of_row = of_pixel * std::max(size.width, 1);
    const double rows = limit.of(of_row * size.height) / of_row;
    const int left = size.height - done;
    return rows < left ? std::clamp(static_cast<int>(rows), 1, left) : left;
}

void FrameWork::begin(const Frame& frame) {
    start(frame);
    advance();
}

void FrameWork::start(const Frame& frame) {
    frame_ = &frame;
    before_.clear();
    before_.reserve(static_cast<std::size_t>(count()) + 1);
    before_.push_back(0.0);
    fragments_ = {};
}

/// The triangles and what comes after them, or the squares.
int FrameWork::count() const {
    return time_units(*frame_);
}

bool FrameWork::is_done() const {
    return before_.size() == static_cast<std::size_t>(count()) + 1;
}

/// The work of a triangle, or of a square; adds its fragments.
double FrameWork::add(int number) {
    if (frame_->squares != nullptr) {
        const WarnockSquare& square = (*frame_->squares)[number];
        fragments_.all += fragments_of(square);
        fragments_.in_picture += fragments_of(square);
        return work_of(*frame_, square);
    }
    if (number == frame_->triangle_count()) return resolve_work_of(*frame_);
    if (!frame_->is_drawn(number)) return 0.0;
    const FragmentEstimate fragments = fragments_of(*frame_, number);
    fragments_.all += fragments.all;
    fragments_.in_picture += fragments.in_picture;
    return work_of(*frame_, number, fragments);
}

void FrameWork::advance(const WorkLimit& limit) {
    const double all = estimate_work * static_cast<double>(count());
    const int done = static_cast<int>(before_.size()) - 1;
    const int left = count() - done;
    const double part = std::clamp(limit.of(all) / estimate_work, 1.0, left + 1.0);
    const int end = done + std::min(static_cast<int>(part), left);
    for (int number = done; number < end; ++number)
        before_.push_back(before_.back() + add(number));
}

double FrameWork::before(const Cursor& cursor) const {
    if (frame_->squares != nullptr)
        return before_[static_cast<std::size_t>(square_at(*frame_->squares, cursor))];
    if (cursor.triangle < 0) return 0.0;
    const int unit = unit_of(*frame_, cursor.triangle);
    if (unit >= count() || cursor.pass > 0 || cursor.triangle > resolve_triangle) return total();
    const double begin = before_[static_cast<std::size_t>(unit)];
    const double work = before_[static_cast<std::size_t>(unit) + 1] - begin;
    if (is_resolve(cursor)) {
        const int height = frame_->settings.viewport.height;
        return begin + work * std::clamp(cursor.index, 0, height) / height;
    }
    if (unit == frame_->triangle_count()) return begin;
    if (cursor.phase != Phase::rows || !is_divided(*frame_, work)) return begin;
    const Box box = box_of(*frame_, cursor.triangle);
    const Box shown = in_picture(box, frame_->settings.viewport);
    if (shown.height() <= 0.0) return begin;
    const double share = (cursor.index - (shown.top - box.top)) / shown.height();
    return begin + std::clamp(share, 0.0, 1.0) * work;
}

Cursor FrameWork::at(double work) const {
    if (!(work < total())) return cursor_end;
    const auto end = std::upper_bound(before_.begin(), before_.end(), std::max(work, 0.0));
    const auto triangle = static_cast<int>(end - before_.begin()) - 1;
    if (frame_->squares != nullptr) return moment_of_square(triangle);
    const double begin = before_[static_cast<std::size_t>(triangle)], of_triangle = *end - begin;
    if (triangle == frame_->triangle_count()) {
        const double row = (work - begin) / of_triangle * frame_->settings.viewport.height;
        return moment_of_resolve(static_cast<int>(row), 0);
    }
    if (!is_divided(*frame_, of_triangle)) return {triangle, Phase::vertices, 0, 0};
    const Box box = box_of(*frame_, triangle);
    const Box shown = in_picture(box, frame_->settings.viewport);
    const double row = shown.top - box.top + (work - begin) / of_triangle * shown.height();
    return {triangle, Phase::rows, static_cast<int>(row), 0};
}

} // namespace rasterwalk
