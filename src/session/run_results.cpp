#include "session/run_results.h"

#include <utility>
#include <vector>

#include "pipeline/draw.h"
#include "pipeline/timeline.h"

namespace rasterwalk {

namespace {

/// The triangle that a picked pixel belongs to at the cursor.
std::optional<int> owner_of_pixel(const Session& session, const RunResults& results) {
    const std::optional<glm::ivec2>& pixel = session.selection.pixel;
    const Framebuffer& picture = *results.framebuffer;
    if (!pixel || !results.is_drawn() || !picture.contains(pixel->x, pixel->y)) return std::nullopt;
    const int owner = picture.owner[picture.at(pixel->x, pixel->y)];
    return owner >= 0 ? std::optional(owner) : std::nullopt;
}

std::optional<int> shown_triangle(const Session& session, const RunResults& results) {
    const int count = results.frame.triangle_count();
    if (session.selection.triangle && *session.selection.triangle < count) {
        return session.selection.triangle;
    }
    // While walking through time, the one at work comes first.
    if (results.cursor == cursor_end) {
        if (const std::optional<int> owner = owner_of_pixel(session, results)) return owner;
    }
    if (results.done) {
        if (const std::optional<int> at_work = triangle_at(results.frame, *results.done))
            return at_work;
    }
    return count > 0 ? std::optional(0) : std::nullopt;
}

/// The triangle that run A shows, in this run.
std::optional<int> triangle_of_shared(const SharedView& shared, const RunResults& results) {
    if (!shared.triangle) return std::nullopt;
    return triangle_in(results.frame, *shared.frame, *shared.triangle);
}

/// The moment at which this run has drawn what the other has at its cursor. If they cut the scene
/// into different triangles, only the beginning of a triangle of the scene is a common moment; if
/// only one of them divides the picture into squares, none is but the beginning and the end.
Cursor moment_of_shared(const SharedView& shared, const Cursor& wanted, const RunResults& results) {
    const Frame &a = *shared.frame, &b = results.frame;
    if ((a.squares == nullptr) != (b.squares == nullptr))
        return wanted <= Timeline(a).first() ? cursor_begin : cursor_end;
    // A square that was stood at under another rule is in neither.
    if (a.squares != nullptr || is_square(wanted)) return wanted;
    const bool is_alike = have_same_triangles(results.frame, *shared.frame);
    if (is_alike || wanted.triangle >= shared.frame->triangle_count()) return wanted;
    return {triangle_in(results.frame, *shared.frame, wanted.triangle), Phase::vertices, 0, 0};
}

bool have_same_size(const std::optional<Run>& a, const Run& b) {
    return a && a->settings.viewport == b.settings.viewport;
}

void begin_next(const std::shared_ptr<const Scene>& scene, const Run& run, int pass,
                RunResults& results) {
    PendingFrame& next = results.next;
    next.run = std::nullopt;
    next.is_done = false;
    next.frame.tessellated = results.frame.tessellated;
    next.frame.divided = results.frame.divided;
    if (occluders_of(results.frame) != nullptr) results.occluders = results.frame.occluders;
    next.frame.occluders = results.occluders;
    next.preparation = begin_frame(*scene, run.settings, nullptr, next.frame);
    next.frame.pass = pass;
    next.scene = scene;
}

/// Prepares the vertices and polygons, then counts how much work they are to draw.
void advance_next(const WorkLimit& limit, PendingFrame& next) {
    if (next.preparation) {
        next.preparation->advance(limit);
        if (!next.preparation->is_done()) return;
        next.preparation = std::nullopt;
        next.work.start(next.frame);
    }
    // When that is done, something is drawn in the same update, too.
    next.work.advance({limit.slice, limit.slice});
    next.is_done = next.work.is_done();
}

/// Shows the frame that is ready; false: there is none.
bool take_next(RunResults& results) {
    PendingFrame& next = results.next;
    if (!next.run || !next.is_done) return false;
    // Noted as shown only when it is, so that after an exception it is prepared again.
    results.run = std::nullopt;
    results.planes.begin(); // it must not refer to a frame that has moved
    std::swap(results.frame, next.frame);
    results.scene = next.scene;
    results.replay.begin(results.frame, next.work);
    if (next.run->program != nullptr)
        results.program_planes.begin(next.run->program, results.frame);
    std::swap(results.run, next.run);
    return true;
}

/// Moves to the session's cursor; false if it was already there.
bool update_cursor(const Cursor& wanted, bool new_frame, RunResults& results) {
    const Timeline timeline(results.frame);
    const Cursor cursor = timeline.at_or_after(wanted);
    if (!new_frame && cursor == results.cursor) return false;
    results.cursor = cursor;
    results.done = std::nullopt;
    if (cursor != timeline.first()) results.done = timeline.previous(cursor, Granularity::moment);
    return true;
}

/// Finds what is wrong in the whole frame. Row tables that have not been drawn are counted, unless
/// that is too much work or they are still being drawn; then only what has been drawn is counted.
void update_warnings(const WorkLimit& limit, RunResults& results) {
    if (results.is_of_program()) { // they would be ours
        results.warnings.clear();
        results.has_all_warnings = true;
        return;
    }
    DrawTally tally = results.replay.tally();
    const FrameWork& work = results.replay.work();
    const Cursor& to = results.replay.tallied();
    results.has_all_warnings =
        results.is_drawn() && work.total() - work.before(to) <= limit.at_once;
    const bool has_tables = results.frame.squares != nullptr && to > moment_of_square(0);
    if (results.has_all_warnings && to < cursor_end && !has_tables) {
        const bool has_begun = to > Cursor{to.triangle, Phase::vertices, 0, 0};
        tally += tally_rows(results.frame, has_begun ? to.triangle + 1 : to.triangle);
    }
    results.warnings = describe_warnings(results.frame, tally, results.engine);
    const Settings& settings = results.frame.settings;
    // Once it refuses altogether, that is said already.
    if (!results.planes.fault.empty() && engine_refuses(*results.frame.scene, settings).empty()) {
        results.warnings.push_back(steps_draw_instead(settings.engine, results.planes.fault));
    }
}

/// Where the rows of a triangle begin and end; empty if it is not drawn.
PolygonRows whole_rows(const Frame& frame, int triangle) {
    PolygonRows rows;
    if (frame.is_drawn(triangle)) compute_rows(frame, triangle, rows, nullptr, VaryingSet());
    return rows;
}

/// Does the picture show the same of the framebuffer as before, pixel by pixel?
bool is_same_view(View view, const std::optional<DepthInterval>& depths,
                  const RunResults& results) {
    const Framebuffer& framebuffer = *results.framebuffer;
    return is_by_pixel(view) && results.view == view && results.depth_range == depths &&
           results.rules == framebuffer.rules && results.picture.width == framebuffer.size.width &&
           results.picture.height == framebuffer.size.height;
}

/// Paints what has changed in the picture; if that is a lot, the first rows.
void paint_changes(View view, const WorkLimit& limit, RunResults& results) {
    const Rectangle& all = results.unpainted;
    const Viewport size{all.right - all.left, all.bottom - all.top};
    Rectangle part = all;
    if (!is_empty(all)) part.bottom = all.top + rows_within(limit, view_pixel_work, size, 0);
    update_view_image(*results.framebuffer, view, part, results.picture);
    results.picture_before = results.picture_number;
    results.picture_changed = part;
    results.unpainted.top = part.bottom;
    if (is_empty(results.unpainted)) results.unpainted = {};
}

/// Shows the pixels that the program has put by the moment; that is little work.
void put_by_program(RunResults& results) {
    ProgramPlanes& planes = results.program_planes;
    const bool is_same = results.framebuffer == &planes.planes();
    planes.go_to(puts_at(*results.run->program, results.cursor));
    const Viewport size = planes.planes().size;
    results.framebuffer = &planes.planes();
    results.unpainted = around(
        results.unpainted, is_same ? planes.changed() : Rectangle{0, 0, size.width, size.height});
}

/// Draws as far as the limit allows, with the engine for the moment. Until the planes of an engine
/// without moments can be shown, those of the steps are, with nothing drawn.
void draw_some(const WorkLimit& limit, RunResults& results) {
    if (results.is_of_program()) {
        put_by_program(results);
        return;
    }
    Replay& replay = results.replay;
    const Framebuffer* const before = results.framebuffer;
    const bool has_moments = results.engine == Engine::steps;
    if (!has_moments) {
        advance_engine_planes(results.drawn_scene(), results.frame, limit, results.planes);
        if (!results.planes.fault.empty()) results.has_all_warnings = false;
    }
    if (!has_moments && results.planes.have_all_rows(results.frame)) {
        results.framebuffer = &results.planes.planes;
    } else {
        results.framebuffer = &replay.toward(has_moments ? results.cursor : replay.drawn(), limit);
    }
    const bool is_same = has_moments && results.framebuffer == before;
    const Viewport size = results.framebuffer->size;
    const Rectangle whole{0, 0, size.width, size.height};
    results.unpainted = around(results.unpainted, is_same ? replay.changed() : whole);
}

/// Paints the whole picture again, or only the part that has changed.
void update_picture(View view, const std::optional<DepthInterval>& depths, const WorkLimit& limit,
                    RunResults& results) {
    const bool is_same = is_same_view(view, depths, results);
    results.view = std::nullopt; // after an exception, paint all next time
    if (is_same) {
        paint_changes(view, limit, results);
    } else {
        results.picture_before = 0;
        make_view_image(*results.framebuffer, view, depths, results.picture);
        results.unpainted = {};
    }
    results.view = view;
    results.depth_range = depths;
    results.rules = results.framebuffer->rules;
}

} // namespace

bool is_shown(const std::shared_ptr<const Scene>& scene, const Run& run,
              const RunResults& results) {
    return results.scene == scene && results.run == run;
}

bool prepare_run(const std::shared_ptr<const Scene>& scene, const Run& run, int pass, bool is_aside,
                 const WorkLimit& limit, RunResults& results) {
    PendingFrame& next = results.next;
    if (is_shown(scene, run, results)) {
        next.run = std::nullopt;
        return true;
    }
    // What is next to the frame relies on its scene and size: if they change, nothing waits.
    const bool is_alike = results.scene == scene && have_same_size(results.run, run);
    const bool may_wait = is_aside || is_alike;
    const bool may_go_on = may_wait && next.scene == scene && have_same_size(next.run, run);
    const bool is_begun = may_go_on && (next.run == run || !results.preview.is_shown);
    if (!is_begun) begin_next(scene, run, pass, results);
    // Noted as begun only if it could go on.
    const Run target = is_begun ? *next.run : run;
    next.run = std::nullopt;
    if (!next.is_done) advance_next(may_wait ? limit : WorkLimit{}, next);
    next.run = target;
    return next.is_done;
}

RowHistory rows_at_cursor(const Frame& frame, int triangle, const Cursor& cursor) {
    if (!frame.is_drawn(triangle)) return {};
    return row_history(frame, triangle, cursor);
}

RunChanges update_run(const Session& session, const Run& run, bool takes_frame,
                      const SharedView* shared, const WorkLimit& limit, std::uint64_t& numbers,
                      RunResults& results) {
    RunChanges changes;
    changes.frame = takes_frame && take_next(results);
    results.is_frame_late = !is_shown(session.scene, run, results);
    if (changes.frame) results.frame_number = ++numbers;
    const Cursor here = in_frame(session.cursor, results.frame.pass);
    const Cursor wanted = shared != nullptr ? moment_of_shared(*shared, here, results) : here;
    changes.moment = update_cursor(wanted, changes.frame, results);
    const bool has_failed = !results.planes.fault.empty();
    results.engine =
        has_failed ? Engine::steps
                   : drawing_engine(*results.frame.scene, results.frame.settings, results.cursor);
    results.is_deferred = results.engine == Engine::steps && !results.is_of_program() &&
                          results.replay.is_deferred(results.cursor, limit);
    const bool draws_on = changes.moment || results.is_drawing();
    const std::optional<DepthInterval> depths =
        shared != nullptr ? shared->depths : session.depth_range;
    const std::optional<View> view_before = results.view;
    if (draws_on) {
        results.view = std::nullopt; // after an exception, paint all next time
        draw_some(limit, results);
        results.view = view_before;
        if (changes.frame || !results.has_all_warnings) update_warnings(limit, results);
    }
    const bool is_other_view = results.view != session.view || results.depth_range != depths;
    changes.picture = draws_on || is_other_view || !is_empty(results.unpainted);
    if (changes.picture) {
        update_picture(session.view, depths, limit, results);
        results.picture_number = ++numbers;
    }
    const std::optional<int> triangle =
        shared != nullptr ? triangle_of_shared(*shared, results) : shown_triangle(session, results);
    if (changes.frame || triangle != results.triangle)
        results.whole_rows = triangle ? whole_rows(results.frame, *triangle) : PolygonRows{};
    if (changes.moment || triangle != results.triangle) {
        results.triangle = triangle;
        results.rows =
            triangle ? rows_at_cursor(results.frame, *triangle, results.cursor) : RowHistory{};
    }
    // Only those of run A are drawn.
    const bool has_vectors = shared == nullptr && session.overlays.has(Overlay::vectors);
    update_inspected(session, {results.frame, results.cursor, results.done, results.triangle},
                     changes.frame, changes.moment, has_vectors, results.inspected);
    return changes;
}

} // namespace rasterwalk
