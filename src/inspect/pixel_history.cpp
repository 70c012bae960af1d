#include "inspect/pixel_history.h"

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
        entry.colour_before = event.before;
        entry.colour_after = event.after;
        entries.push_back(entry);
    }

  private:
    std::vector<PixelEntry>& entries;
    std::vector<TestEvent>& tests_;
    Projection projection_;
};

/// Both ends of a row are one moment, whose cursor does not tell how far from the left end it is.
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
    for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
        if (entry->fate != Fate::written) continue;
        const float alpha = frame.blends ? alpha_of(*frame.scene, entry->cursor.triangle) : 1.0f;
        if (!(alpha < 1.0f)) {
            entry->share = seen;
            return;
        }
        entry->share = seen * frame.stages.blend(glm::vec3(1.0f), alpha, glm::vec3(0.0f)).r;
        seen *= frame.stages.blend(glm::vec3(0.0f), alpha, glm::vec3(1.0f)).r;
    }
}

/// Triangles that stay this much farther away than the nearest, in pixels, explain nothing.
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
    PixelHistory history;
    history.pixel = pixel;
    history.depth_tested = depth_rule(frame.settings) != DepthTest::off;
    Framebuffer one_pixel;
    clear(one_pixel, frame, {1, 1}, pixel);
    const Projection projection = vertex_rules(frame.settings, frame.scene->space).projection;
    Collector collector(history, projection);
    draw(frame, {}, one_pixel, &collector);
    if (frame.settings.stage == Stage::rows) find_columns_of_row_ends(frame, history);
    for (std::size_t i = 0; i < history.entries.size(); ++i) {
        if (history.entries[i].fate == Fate::written) history.winner = static_cast<int>(i);
    }
    for (PixelEntry& entry : history.entries) {
        // Who wins is known only now.
        const float winning = history.winner >= 0
                                  ? history.entries[static_cast<std::size_t>(history.winner)].depth
                                  : one_pixel.depth.front();
        entry.margin_to_winner = depth_ahead(entry.depth, winning, projection.clip_depth);
    }
    find_shares(frame, history.entries);
    if (history.entries.empty()) {
        history.nearest = nearest_triangles(frame, pixel);
        keep_the_near(history.nearest);
    }
    return history;
}

} // namespace rasterwalk
