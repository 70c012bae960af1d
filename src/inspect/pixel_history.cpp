#include "inspect/pixel_history.h"

#include <algorithm>
#include <cmath>

#include "pipeline/draw.h"
#include "stages/orthographic.h"

namespace rasterwalk {

namespace {

class Collector : public Observer {
  public:
    Collector(PixelHistory& into, const Projection& projection)
        : entries(into.entries), tests_(into.tests), projection_(projection) {}

    bool wants_pixel_tests() const override { return true; }
    void pixel_test(const TestEvent& event) override { tests_.push_back(event); }

    void fragment(const FragmentEvent& event) override {
        PixelEntry entry;
        entry.cursor = event.cursor;
        if (event.cursor.phase == Phase::rows) {
            entry.row = event.cursor.index;
            entry.column = event.cursor.step;
        }
        entry.zinv = event.fragment.inv_w;
        entry.z = fragment_depth(event.fragment, projection_.mix);
        entry.depth = event.depth;
        entry.stored = event.stored;
        entry.margin = depth_ahead(event.depth, event.stored, projection_.clip_depth);
        entry.fate = event.fate;
        entry.alpha = event.alpha;
        entry.colour_before = event.before;
        entry.colour_after = event.after;
        entries.push_back(entry);
    }

  private:
    std::vector<PixelEntry>& entries;
    std::vector<TestEvent>& tests_;
    Projection projection_;
};

/// The cost of seeing that a triangle does not reach the pixel.
constexpr double look_work = 5;

Projection projection_of(const Frame& frame) {
    return vertex_rules(frame.settings, frame.scene->space).projection;
}

/// Both ends of a row are one moment, whose cursor does not say how far from the left end it is.
void find_columns_of_row_ends(const Frame& frame, PixelHistory& history) {
    PolygonRows rows;
    for (PixelEntry& entry : history.entries) {
        compute_rows(frame, entry.cursor.triangle, rows);
        entry.column = history.pixel.x - rows.left[entry.row].column;
    }
}

/// From the last to the first: how much of each is seen through those that came later.
void find_shares(const Frame& frame, std::vector<PixelEntry>& entries) {
    float seen = 1.0f;
    for (std::size_t i = entries.size(); i-- > 0;) {
        PixelEntry& entry = entries[i];
        if (entry.fate != Fate::written) continue;
        if (!(entry.alpha < 1.0f)) {
            entry.share = seen;
            return;
        }
        entry.share = seen * frame.stages.blend(glm::vec3(1.0f), entry.alpha, glm::vec3(0.0f)).r;
        seen *= frame.stages.blend(glm::vec3(0.0f), entry.alpha, glm::vec3(1.0f)).r;
    }
}

/// Triangles this much farther away than the nearest, in pixels, explain nothing.
constexpr double hardly_farther = 8.0;

void keep_the_near(std::vector<NearTriangle>& nearest) {
    const auto distance = [](const NearTriangle& near) {
        return std::hypot(static_cast<double>(near.columns_away),
                          static_cast<double>(near.rows_away));
    };
    std::erase_if(
        nearest, [&, limit = nearest.empty() ? 0.0 : distance(nearest[0])](
                     const NearTriangle& near) { return distance(near) > limit + hardly_farther; });
}

} // namespace

PixelHistory pixel_history(const Frame& frame, const glm::ivec2& pixel) {
    HistoryWork work(frame, pixel);
    work.advance();
    return work.take();
}

HistoryWork::HistoryWork(const Frame& frame, const glm::ivec2& pixel) : frame_(&frame) {
    history_.pixel = pixel;
    history_.depth_tested = depth_rule(frame.settings) != DepthTest::off;
    clear(one_pixel_, frame, {1, 1}, pixel);
}

void HistoryWork::advance(const WorkLimit& limit) {
    if (is_done_) return;
    const int count = frame_->triangle_count();
    // A triangle may be looked at twice: for the pixel, and in the search for the nearest.
    double part = std::max(limit.of(2.0 * look_work * count), look_work);
    const auto triangles_of = [&](int left) {
        return static_cast<int>(std::min(part / look_work, static_cast<double>(left)));
    };
    if (drawn_ < count) {
        const int triangles = triangles_of(count - drawn_);
        draw_part(triangles);
        part -= look_work * triangles;
        if (drawn_ < count) return;
    }
    if (!nearest_) {
        find_winner();
        is_done_ = !history_.entries.empty();
        if (is_done_) return;
        nearest_.emplace(*frame_, history_.pixel);
    }
    nearest_->look(triangles_of(count));
    if (!nearest_->is_done()) return;
    history_.nearest = nearest_->found();
    keep_the_near(history_.nearest);
    nearest_ = std::nullopt;
    is_done_ = true;
}

void HistoryWork::draw_part(int triangles) {
    Collector collector(history_, projection_of(*frame_));
    const Cursor from{drawn_, Phase::vertices, 0, 0};
    drawn_ += triangles;
    draw(*frame_, {from, behind_triangle(drawn_ - 1), {}}, one_pixel_, &collector);
}

/// Completes what is known only when everything has been drawn.
void HistoryWork::find_winner() {
    if (frame_->settings.stage == Stage::rows) find_columns_of_row_ends(*frame_, history_);
    for (std::size_t i = 0; i < history_.entries.size(); ++i) {
        if (history_.entries[i].fate == Fate::written) history_.winner = static_cast<int>(i);
    }
    const float winning = history_.winner >= 0
                              ? history_.entries[static_cast<std::size_t>(history_.winner)].depth
                              : one_pixel_.depth.front();
    const Projection projection = projection_of(*frame_);
    for (PixelEntry& entry : history_.entries)
        entry.margin_to_winner = depth_ahead(entry.depth, winning, projection.clip_depth);
    find_shares(*frame_, history_.entries);
}

} // namespace rasterwalk
