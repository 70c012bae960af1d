#include "session/compared.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "picture/view_image.h"
#include "pipeline/timeline.h"
#include "session/results.h"

namespace rasterwalk {

namespace {

std::string size_text(Viewport size) {
    return std::to_string(size.width).append(" x ").append(std::to_string(size.height));
}

/// Why the two runs cannot be compared; empty if they can.
std::string obstacle(const Settings& a, const Settings& b) {
    if (a.viewport == b.viewport) return "";
    return std::string("Run B cannot be compared with run A: its picture has ")
        .append(size_text(b.viewport))
        .append(" pixels, that of A ")
        .append(size_text(a.viewport))
        .append(".");
}

/// The end of the scale: that of the whole frame's difference, so that it does not jump while time
/// runs, unless more is seen at the cursor.
float scale_limit(const Compared& compared, View view) {
    float largest = view == View::colour ? compared.whole.pixels.largest : 0.0f;
    for (const float value : compared.difference_values)
        largest = std::max(largest, std::abs(value));
    return difference_limit(largest);
}

void update_pictures(const Session& session, Results& results) {
    Compared& b = *results.compared;
    const Framebuffer& picture_a = *results.framebuffer;
    b.framebuffer = &b.replay.at(b.cursor);
    // Both in the colours of A, so that the same colour means the same depth.
    std::optional<DepthRange> depths = session.depth_range;
    if (!depths && results.depth) depths = results.depth->range;
    b.picture = view_image(*b.framebuffer, session.view, depths);
    b.picture_number = ++results.pictures_of_b;
    b.pixels = pixel_difference(picture_a, *b.framebuffer);
    b.difference_values = signed_difference(picture_a, *b.framebuffer, session.view);
    b.difference_limit = scale_limit(b, session.view);
    b.difference = difference_image(b.difference_values, picture_a.size, b.difference_limit);
    b.difference_number = ++results.pictures_of_b;
}

} // namespace

void update_compared(const Session& session, Results& results, bool new_frame, bool moved,
                     bool changed) {
    results.no_comparison = session.other ? obstacle(session.settings, *session.other) : "";
    if (!session.other || !results.no_comparison.empty()) {
        results.compared = std::nullopt;
        return;
    }
    const bool new_b =
        new_frame || !results.compared || !(results.compared->frame.settings == *session.other);
    if (!results.compared) results.compared.emplace();
    Compared& b = *results.compared;
    if (new_b) {
        b.frame = prepare_frame(*results.scene, *session.other);
        b.replay.begin(b.frame);
        b.messages = describe_troubles(b.frame);
        b.whole = compare_runs(results.frame, b.frame);
    }
    const Timeline timeline(b.frame);
    const Cursor cursor = timeline.at_or_after(session.cursor);
    const bool moved_b = new_b || moved || cursor != b.cursor;
    if (moved_b || changed) {
        b.cursor = cursor;
        b.done = std::nullopt;
        if (cursor != timeline.first()) b.done = timeline.previous(cursor, Granularity::moment);
        update_pictures(session, results);
        const Cursor& next = std::min(results.cursor, b.cursor);
        b.here = divergence_at(results.frame, *results.framebuffer, b.frame, *b.framebuffer, next);
    }
    if (moved_b || changed || b.inspected.triangle != results.triangle) {
        b.rows =
            results.triangle ? rows_at_cursor(b.frame, *results.triangle, cursor) : RowHistory{};
    }
    update_inspected(session, {b.frame, b.cursor, b.done, results.triangle}, new_b, moved_b,
                     b.inspected);
}

} // namespace rasterwalk
