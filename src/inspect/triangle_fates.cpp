#include "inspect/triangle_fates.h"

#include <algorithm>

#include "pipeline/draw.h"
#include "settings/settings.h"

namespace rasterwalk {

namespace {

/// The cost of a row of a triangle in addition to its fragments: its edges are walked.
constexpr double work_of_row = 6.0;

/// The cost of testing whether a triangle reaches the part.
constexpr double work_of_triangle = 0.5;

/// The work of the triangles from `first` up to and including `last` in a part of the picture; if
/// it is more than `most`, some number above `most`.
double work_between(const Frame& frame, int first, int last, const Rectangle& part, double most) {
    const EdgeRules rules = edge_rules(frame.settings);
    double work = 0.0;
    for (int t = first; t <= last && work <= most; ++t) {
        work += work_of_triangle;
        if (!frame.is_drawn(t)) continue;
        const Rectangle box =
            frame.stages.polygon_box(frame.triangle_vertices(t), rules, frame.stages);
        const double width = std::min(box.right, part.right) - std::max(box.left, part.left);
        const double height = std::min(box.bottom, part.bottom) - std::max(box.top, part.top);
        if (width <= 0.0 || height <= 0.0) continue;
        // The edges are walked along their whole length.
        work += width * height +
                work_of_row * (static_cast<double>(box.bottom) - static_cast<double>(box.top) +
                               static_cast<double>(box.right) - static_cast<double>(box.left));
    }
    return work;
}

/// The part of it that lies in the picture.
Rectangle in_picture(const Rectangle& part, const Viewport& size) {
    return {std::clamp(part.left, 0, size.width), std::clamp(part.top, 0, size.height),
            std::clamp(part.right, 0, size.width), std::clamp(part.bottom, 0, size.height)};
}

} // namespace

const std::vector<FragmentFate>& FateFinder::find(const Frame& frame, std::uint64_t frame_number,
                                                  int triangle, const Rectangle& part) {
    const Rectangle inside = in_picture(part, frame.settings.viewport);
    const Place place{frame_number, inside};
    if (place_ == place && triangle_ == triangle) return fates_;
    fates_.clear();
    place_ = place;
    triangle_ = triangle;
    const bool has_fates =
        has_fragments(frame.settings.stage) && depth_rule(frame.settings) != DepthTest::off &&
        inside.left < inside.right && inside.top < inside.bottom && triangle >= 0 &&
        triangle < frame.triangle_count() && frame.is_drawn(triangle);
    if (!has_fates) return fates_;
    const bool goes_on = planes_place_ == place && drawn_ <= triangle;
    const int first = goes_on ? drawn_ : 0;
    if (work_between(frame, first, triangle, inside, most_work) > most_work) return fates_;
    planes_place_ = std::nullopt; // until the planes are complete
    if (!goes_on) {
        clear(planes_, frame, {inside.right - inside.left, inside.bottom - inside.top},
              {inside.left, inside.top});
    }
    draw(frame, {beginning_of(first), beginning_of(triangle), {}}, planes_);
    const Observer keep_fates{.fragment = [this](const FragmentEvent& event) {
        fates_.push_back({{event.fragment.column, event.fragment.row}, event.cursor, event.fate});
    }};
    draw(frame, {beginning_of(triangle), beginning_of(triangle + 1), {}}, planes_, &keep_fates);
    planes_place_ = place;
    drawn_ = triangle + 1;
    return fates_;
}

} // namespace rasterwalk
