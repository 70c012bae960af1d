#include "session/results.h"

#include <array>
#include <string_view>

#include "inspect/stats.h"
#include "picture/view_image.h"

namespace rasterwalk {

namespace {

std::string counted(int count, std::string_view one, std::string_view many) {
    return std::to_string(count).append(" ").append(count == 1 ? one : many);
}

std::optional<int> shown_triangle(const Session& session, const Results& results) {
    const int count = results.frame.triangle_count();
    if (session.selection.triangle && *session.selection.triangle < count) {
        return session.selection.triangle;
    }
    if (results.done) return results.done->triangle;
    return count > 0 ? std::optional(0) : std::nullopt;
}

/// The picked pixel, if it lies in the picture.
std::optional<glm::ivec2> picked_pixel(const Session& session, const Frame& frame) {
    const std::optional<glm::ivec2>& pixel = session.selection.pixel;
    const Viewport size = frame.settings.viewport;
    const bool is_inside =
        pixel && pixel->x >= 0 && pixel->x < size.width && pixel->y >= 0 && pixel->y < size.height;
    return is_inside ? pixel : std::nullopt;
}

void update_overlay(const Session& session, Results& results, bool moved) {
    if (!moved && results.overlay.shown == session.overlays) return;
    compose_overlays(results.frame, results.cursor, *results.framebuffer, session.overlays, !moved,
                     results.overlay);
    ++results.overlay_number;
}

void update_history(const Session& session, Results& results, bool new_frame) {
    const std::optional<glm::ivec2> pixel = picked_pixel(session, results.frame);
    const auto known = results.history ? std::optional(results.history->pixel) : std::nullopt;
    if (!new_frame && pixel == known) return;
    results.history = std::nullopt;
    if (pixel) results.history = pixel_history(results.frame, *pixel);
}

} // namespace

namespace {

/// How many pixels the stages give to a row that no edge sample has reached.
int unset_row_pixels(const Frame& frame) {
    PolygonRows rows;
    frame.stages.begin_polygon_rows(std::array<Fragment, 1>{}, edge_rules(frame.settings), rows);
    return row_span(frame.stages, rows, 0).count;
}

} // namespace

std::vector<std::string> describe_troubles(const Frame& frame) {
    std::vector<std::string> messages;
    const LeftOut left_out = count_left_out(frame);
    for (const RejectionWords& reason : rejection_list) {
        const int count = left_out.of(reason.rejection);
        if (count == 0) continue;
        messages.push_back(counted(count, "triangle", "triangles").append(" left out: ") +
                           std::string(reason.cause));
    }
    const std::int64_t unset = count_unset_rows(frame);
    if (unset > 0) {
        const int pixels = unset_row_pixels(frame);
        messages.push_back(counted(static_cast<int>(unset), "row", "rows")
                               .append(" that no edge sample reached: right − left + 1 is ")
                               .append(std::to_string(pixels))
                               .append(" there; nothing of it is in the picture"));
    }
    const Viewport size = frame.settings.viewport;
    if (frame.settings.depth_index == DepthIndex::transposed && size.width != size.height &&
        depth_rule(frame.settings) != DepthTest::off) {
        messages.push_back("[x][y] lies outside the depth buffer for every pixel with x ≥ " +
                           std::to_string(size.height) + " or y ≥ " + std::to_string(size.width) +
                           ": not written there");
    }
    const SamplesOutside outside = count_samples_outside(frame);
    if (outside.samples > 0) {
        messages.push_back(counted(static_cast<int>(outside.samples), "edge sample", "edge samples")
                               .append(" outside the row table of ")
                               .append(counted(outside.triangles, "triangle", "triangles"))
                               .append("; not written"));
    }
    return messages;
}

RowHistory rows_at_cursor(const Frame& frame, int triangle, const Cursor& cursor) {
    if (!frame.is_drawn(triangle)) return {};
    return row_history(frame, triangle, cursor);
}

bool update(const Session& session, Results& results) {
    const bool new_frame = results.scene != session.scene || !results.view ||
                           !(results.frame.settings == session.settings);
    if (new_frame) {
        results.scene = session.scene;
        results.frame = prepare_frame(*results.scene, session.settings);
        ++results.frame_number;
        results.replay.begin(results.frame);
        results.messages = describe_troubles(results.frame);
    }
    const Timeline timeline(results.frame);
    const Cursor cursor = timeline.at_or_after(session.cursor);
    const bool moved = new_frame || cursor != results.cursor;
    const bool changed =
        moved || results.view != session.view || results.depth_range != session.depth_range;
    if (changed) {
        results.cursor = cursor;
        results.done = std::nullopt;
        if (cursor != timeline.first()) {
            results.done = timeline.previous(cursor, Granularity::moment);
        }
        results.framebuffer = &results.replay.at(cursor);
        results.view = session.view;
        results.depth_range = session.depth_range;
        results.picture = view_image(*results.framebuffer, session.view, session.depth_range);
        results.depth = std::nullopt;
        if (session.view == View::depth) {
            results.depth = depth_view(*results.framebuffer, session.depth_range);
        }
        ++results.picture_number;
    }
    const std::optional<int> triangle = shown_triangle(session, results);
    if (changed || triangle != results.triangle) {
        results.triangle = triangle;
        results.rows = triangle ? rows_at_cursor(results.frame, *triangle, cursor) : RowHistory{};
    }
    update_overlay(session, results, moved);
    update_history(session, results, new_frame);
    update_inspected(session, {results.frame, results.cursor, results.done, results.triangle},
                     new_frame, moved, results.inspected);
    update_compared(session, results, new_frame, moved, changed);
    return changed;
}

} // namespace rasterwalk
