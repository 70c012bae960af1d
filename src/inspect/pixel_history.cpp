#include "inspect/pixel_history.h"

#include <algorithm>
#include <cmath>

#include "stages/orthographic.h"

namespace rasterwalk {

namespace {

PixelEntry entry_of(const FragmentEvent& event, const Projection& projection) {
    PixelEntry entry;
    entry.cursor = event.cursor;
    if (event.cursor.phase == Phase::rows) {
        entry.row = event.cursor.index;
        entry.column = event.cursor.step;
    }
    entry.zinv = event.fragment.inv_w;
    entry.z = fragment_depth(event.fragment, projection.mix);
    entry.depth = event.depth;
    entry.stored = event.stored;
    entry.margin = depth_ahead(event.depth, event.stored, projection.clip_depth);
    entry.fate = event.fate;
    entry.alpha = event.alpha;
    entry.colour_before = event.before;
    entry.colour_after = event.after;
    entry.covered = event.covered;
    entry.passed = event.passed;
    return entry;
}

/// The cost of seeing that a triangle does not reach the pixel.
constexpr double look_work = 5;

Projection projection_of(const Frame& frame) {
    return vertex_rules(frame.settings, frame.scene->space).projection;
}

/// Both ends of a row are one moment, whose cursor does not say how far from the left end it is.
void find_columns_of_row_ends(const Frame& frame, PixelHistory& history) {
    PolygonRows rows;
    for (PixelEntry& entry : history.entries) {
        if (entry.row < 0) continue; // a mark that is in no row
        compute_rows(frame, entry.cursor.triangle, rows);
        if (entry.row < rows.size()) entry.column = history.pixel.x - rows.left[entry.row].column;
    }
}

/// From the last to the first: how much of each is seen through those that came later.
/// @param seen      1; of several samples, the part of one of them
/// @param is_put_on which entries count
template <class IsPutOn>
void add_shares(const Frame& frame, float seen, IsPutOn is_put_on,
                std::vector<PixelEntry>& entries) {
    for (std::size_t i = entries.size(); i-- > 0;) {
        PixelEntry& entry = entries[i];
        if (!is_put_on(entry)) continue;
        if (!(entry.alpha < 1.0f)) {
            entry.share += seen;
            return;
        }
        entry.share += seen * frame.stages.blend(glm::vec3(1.0f), entry.alpha, glm::vec3(0.0f)).r;
        seen *= frame.stages.blend(glm::vec3(0.0f), entry.alpha, glm::vec3(1.0f)).r;
    }
}

void find_shares(const Frame& frame, std::vector<PixelEntry>& entries) {
    if (!frame.has_samples()) {
        const auto is_written = [](const PixelEntry& entry) { return entry.fate == Fate::written; };
        add_shares(frame, 1.0f, is_written, entries);
        return;
    }
    for (int sample = 0; sample < sample_count; ++sample) {
        const auto is_put_on = [sample](const PixelEntry& entry) {
            return has_sample(entry.passed, sample);
        };
        add_shares(frame, 1.0f / static_cast<float>(sample_count), is_put_on, entries);
    }
}

/// Of several samples: the entry with the largest share, the last one if there are more.
int largest_share(const std::vector<PixelEntry>& entries) {
    int largest = -1;
    float share = 0.0f;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (entries[i].share <= 0.0f || entries[i].share < share) continue;
        share = entries[i].share;
        largest = static_cast<int>(i);
    }
    return largest;
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

std::string sample_signs(SampleMask mask) {
    std::string signs;
    for (int sample = 0; sample < sample_count; ++sample)
        signs += has_sample(mask, sample) ? "●" : "○";
    return signs;
}

PixelHistory pixel_history(const EventSource& source, const glm::ivec2& pixel) {
    HistoryWork work(source, pixel);
    work.advance();
    return work.take();
}

HistoryWork::HistoryWork(EventSource source, const glm::ivec2& pixel)
    : source_(std::move(source)), frame_(source_.frame) {
    history_.pixel = pixel;
    history_.depth_tested = depth_rule(frame_->settings) != DepthTest::off;
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
    const Observer keep_all{
        .pixel_test = [this](const TestEvent& event) { history_.tests.push_back(event); },
        .fragment =
            [this, projection = projection_of(*frame_)](const FragmentEvent& event) {
                history_.entries.push_back(entry_of(event, projection));
            },
        .resolve = [this](const ResolveEvent& event) { history_.resolve = event; }};
    const Cursor from = beginning_of(drawn_);
    drawn_ += triangles;
    // Squares come after what would be the moments of triangles.
    const Cursor to = drawn_ == frame_->triangle_count() ? cursor_end : beginning_of(drawn_);
    source_.play({from, to, only_pixel(history_.pixel)}, keep_all);
}

/// Completes what is known only when everything has been drawn.
void HistoryWork::find_winner() {
    if (frame_->settings.stage == Stage::rows) find_columns_of_row_ends(*frame_, history_);
    find_shares(*frame_, history_.entries);
    for (std::size_t i = 0; i < history_.entries.size(); ++i) {
        if (history_.entries[i].fate == Fate::written) history_.winner = static_cast<int>(i);
    }
    if (frame_->has_samples()) history_.winner = largest_share(history_.entries);
    const float winning = history_.winner >= 0
                              ? history_.entries[static_cast<std::size_t>(history_.winner)].depth
                              : depth_clear_rule(frame_->settings, frame_->scene->space);
    const Projection projection = projection_of(*frame_);
    for (PixelEntry& entry : history_.entries)
        entry.margin_to_winner = depth_ahead(entry.depth, winning, projection.clip_depth);
}

} // namespace rasterwalk
