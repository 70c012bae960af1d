#include "session/results.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "session/difference_parts.h"

namespace rasterwalk {

namespace {

/// The picked pixel, if it lies in the picture.
std::optional<glm::ivec2> picked_pixel(const Session& session, const Frame& frame) {
    const std::optional<glm::ivec2>& pixel = session.selection.pixel;
    const Viewport size = frame.settings.viewport;
    const bool is_inside =
        pixel && pixel->x >= 0 && pixel->x < size.width && pixel->y >= 0 && pixel->y < size.height;
    return is_inside ? pixel : std::nullopt;
}

void update_overlay(const Session& session, Results& results, bool moved) {
    const bool is_missing = !(results.overlay.shown == session.overlays) || results.overlay_is_old;
    if (!moved && !is_missing) return;
    // It marks what is on the picture at the cursor: until that is drawn there is nothing to mark.
    results.overlay_is_old = !results.a.is_drawn();
    if (results.overlay_is_old) {
        results.overlay = {};
        ++results.overlay_number;
        return;
    }
    compose_overlays(results.a.frame, results.a.cursor, *results.a.framebuffer, session.overlays,
                     !moved, results.overlay);
    ++results.overlay_number;
}

void update_ground(Results& results) {
    if (results.overlay.image.rgba.empty()) {
        results.ground = {};
        results.ground_of = 0;
        return;
    }
    if (results.ground_of == results.a.picture_number) return;
    results.ground = ground_of_overlays(results.a.picture);
    results.ground_of = results.a.picture_number;
    results.ground_number = ++results.numbers;
}

/// The pixel whose history is known, or on its way.
std::optional<glm::ivec2> pixel_of_history(const Results& results) {
    if (results.history) return results.history->pixel;
    if (results.history_work) return results.history_work->pixel();
    return std::nullopt;
}

void update_history(const Session& session, const RunChanges& changes, const WorkLimit& limit,
                    Results& results) {
    const std::optional<glm::ivec2> pixel = picked_pixel(session, results.a.frame);
    if (changes.frame || pixel != pixel_of_history(results)) {
        results.history = std::nullopt;
        results.history_work = std::nullopt;
        if (pixel) results.history_work.emplace(results.a.frame, *pixel);
    }
    // First the picture, then what fell on one pixel of it.
    if (!results.history_work || !(results.a.is_drawn() || results.a.is_held)) return;
    // Nor both in one update, if the picture was much work.
    const bool was_much = results.a.replay.work().total() > limit.at_once;
    if (changes.picture && was_much) return;
    results.history_work->advance({limit.slice, limit.slice});
    if (!results.history_work->is_done()) return;
    results.history = results.history_work->take();
    results.history_work = std::nullopt;
}

std::string size_text(Viewport size) {
    return fmt::format("{} x {}", size.width, size.height);
}

/// Why the two runs cannot be compared; empty if they can.
std::string obstacle(const Settings& a, const Settings& b) {
    if (a.viewport == b.viewport) return "";
    return fmt::format("Run B cannot be compared with run A: its picture has {} pixels, that of A "
                       "{}.",
                       size_text(b.viewport), size_text(a.viewport));
}

/// Goes on preparing the frames that are asked for. Both runs show theirs at once, so that they are
/// seen from the same place.
bool prepare_runs(const Session& session, const WorkLimit& limit, Results& results) {
    const bool is_ready = prepare_run(session.scene, session.a, limit, results.a);
    if (!session.b || !results.b) return is_ready;
    return prepare_run(session.scene, *session.b, limit, *results.b) && is_ready;
}

/// How much work it is to compare the whole frames.
double comparison_work(const Results& results) {
    return compare_work_factor *
           (results.a.replay.work().total() + results.b->replay.work().total());
}

void update_second_run(const Session& session, const RunChanges& a, bool are_ready,
                       const WorkLimit& limit, Results& results) {
    results.no_comparison =
        session.b ? obstacle(session.a.settings, session.b->settings) : std::string();
    if (!session.b || !results.no_comparison.empty()) {
        results.b = std::nullopt;
        results.comparison = {};
        return;
    }
    if (!results.b) {
        results.b.emplace();
        are_ready = prepare_run(session.scene, *session.b, limit, *results.b);
    }
    // Both in the colours of A, so that the same colour means the same depth.
    SharedView shared{&results.a.frame, results.a.triangle, session.depth_range};
    if (!shared.depths && results.depth) shared.depths = values_of(results.depth->range);
    const RunChanges b =
        update_run(session, *session.b, are_ready, &shared, limit, results.numbers, *results.b);
    ComparisonResults& comparison = results.comparison;
    if (a.frame || b.frame) comparison.work.begin(results.a.frame, results.b->frame);
    const bool was_done = comparison.work.is_done();
    const bool are_drawn = results.a.is_drawn() && results.b->is_drawn();
    // Nor in an update with much other work.
    const bool was_much = (a.picture || b.picture) && comparison_work(results) > limit.at_once;
    if (are_drawn && !was_much) comparison.work.advance(limit);
    // The scale of the difference follows the whole frames.
    const bool new_scale = !was_done && comparison.work.is_done();
    update_difference(session.view, new_scale, limit, results);
}

/// For each of two runs.
WorkLimit half_slices(WorkLimit limit) {
    limit.slice /= 2.0;
    return limit;
}

bool update_within(const Session& session, const WorkLimit& limit, Results& results) {
    const bool are_ready = prepare_runs(session, limit, results);
    const RunChanges changes =
        update_run(session, session.a, are_ready, nullptr, limit, results.numbers, results.a);
    if (changes.picture) {
        results.depth = std::nullopt;
        results.overdraw = std::nullopt;
        if (session.view == View::overdraw)
            results.overdraw = overdraw_counts(*results.a.framebuffer);
        if (session.view == View::depth) {
            results.depth = depth_view(*results.a.framebuffer, session.depth_range);
        }
    }
    if (changes.frame) results.length = frame_length(Timeline(results.a.frame));
    update_overlay(session, results, changes.moment);
    update_ground(results);
    update_history(session, changes, limit, results);
    update_second_run(session, changes, are_ready, limit, results);
    return changes.picture;
}

} // namespace

bool update(const Session& session, Results& results, const WorkLimit& limit) {
    return update_within(session, session.b ? half_slices(limit) : limit, results);
}

bool finish(const Session& session, Results& results) {
    bool has_changed = update(session, results, {});
    // What was begun before is ended first.
    while (is_working(results))
        has_changed = update(session, results, {}) || has_changed;
    return has_changed;
}

bool is_working(const Results& results) {
    if (results.a.is_frame_late || !results.a.is_complete()) return true;
    if (results.history_work) return true;
    if (!results.b) return false;
    if (results.b->is_frame_late || !results.b->is_complete()) return true;
    if (!results.comparison.progress.is_done) return true;
    const bool are_drawn = results.a.is_drawn() && results.b->is_drawn();
    return are_drawn && !results.comparison.work.is_done();
}

} // namespace rasterwalk
