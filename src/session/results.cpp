#include "session/results.h"

#include <memory>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "session/difference_parts.h"
#include "session/preview_parts.h"
#include "session/shown_pass.h"

namespace rasterwalk {

namespace {

/// The picked pixel, if it is in the picture.
std::optional<glm::ivec2> picked_pixel(const Session& session, const Frame& frame) {
    const std::optional<glm::ivec2>& pixel = session.selection.pixel;
    const Viewport size = frame.settings.viewport;
    const bool is_inside =
        pixel && pixel->x >= 0 && pixel->x < size.width && pixel->y >= 0 && pixel->y < size.height;
    return is_inside ? pixel : std::nullopt;
}

/// Draws another part of the triangle that is shown alone.
void update_lone(const WorkLimit& limit, Results& results) {
    const RunResults& run = results.a;
    LoneTriangle& lone = results.overlay.lone;
    if (results.overlay.shown.has(Overlay::alone) && run.triangle) {
        const bool has_changed = lone.draw(run.frame, run.replay.work(), run.frame_number,
                                           *run.triangle, run.cursor, limit);
        results.overlay_number += has_changed ? 1 : 0;
    } else if (lone.triangle()) {
        lone = {};
        ++results.overlay_number;
    }
}

/// Counts another part of the costs, if they are shown; returns whether that was the last one. A
/// part is not worth making the picture of the overlays again.
bool update_costs(OverlaySet wanted, const WorkLimit& limit, Results& results) {
    const RunResults& run = results.a;
    if (!wanted.has(Overlay::cost)) results.overlay.cost = {};
    if (!wanted.has(Overlay::cost) || !run.is_drawn()) return false;
    CostDrawing& cost = results.overlay.cost;
    const bool has_changed =
        cost.count(run.frame, run.replay.work(), run.frame_number, run.cursor, limit);
    return has_changed && cost.is_counted();
}

/// The edge whose field is shown: the chosen one, the one at work, or the first.
int edge_of_field(const Session& session, const RunResults& run) {
    if (session.canvas.field_edge) return *session.canvas.field_edge;
    const bool is_at_work =
        run.done && run.done->phase == Phase::edges && run.done->triangle == run.triangle;
    return is_at_work ? run.done->index : 0;
}

GeometrySource wanted_geometry(const Session& session, OverlaySet wanted, const RunResults& run) {
    GeometrySource source;
    if (!run.is_drawn() || !run.triangle || !run.frame.is_drawn(*run.triangle)) return source;
    source.frame = run.frame_number;
    source.triangle = run.triangle;
    if (wanted.has(Overlay::edge_field)) source.edge = edge_of_field(session, run);
    if (wanted.has(Overlay::weights)) source.pixel = picked_pixel(session, run.frame);
    return source;
}

/// Finds the geometry of the triangle shown that overlays draw; returns whether the field, which
/// tints the picture, has changed.
bool update_geometry(const Session& session, OverlaySet wanted, Results& results) {
    const GeometrySource source = wanted_geometry(session, wanted, results.a);
    if (source == results.geometry_of) return false;
    results.geometry_of = source;
    const Frame& frame = results.a.frame;
    results.overlay.weights = std::nullopt;
    if (source.pixel)
        results.overlay.weights = weight_parts(frame, *source.triangle, *source.pixel);
    std::optional<EdgeField> field;
    if (source.edge) field = edge_field(frame, *source.triangle, *source.edge);
    if (field == results.overlay.field) return false;
    results.overlay.field = field;
    return true;
}

void update_overlay(const Session& session, const WorkLimit& limit, bool moved, Results& results) {
    OverlaySet wanted = session.overlays;
    if (session.b) wanted.set(Overlay::alone, false); // whole pictures are compared
    const bool has_field_changed = update_geometry(session, wanted, results);
    const bool is_missing = !(results.overlay.shown == wanted) || results.overlay_is_old;
    const bool are_counted = update_costs(wanted, limit, results);
    if (moved || is_missing || are_counted || has_field_changed) {
        // The overlay marks the picture at the cursor, so it is empty until that is drawn.
        results.overlay_is_old = true; // if memory runs out, it is made again next time
        if (!results.a.is_drawn()) {
            CostDrawing counted = std::move(results.overlay.cost); // goes on from where it is
            results.overlay = {};
            results.overlay.cost = std::move(counted);
        } else {
            compose_overlays(results.a.frame, results.a.cursor, *results.a.framebuffer, wanted,
                             !moved, results.overlay);
            results.overlay_is_old = false;
        }
        ++results.overlay_number;
    }
    update_lone(limit, results);
}

/// What is below the overlays, if it is not the picture of A: a triangle alone, in the same
/// colours, and either in grey if the overlay has colours.
void update_ground(const Session& session, Results& results) {
    const GroundSource source{results.a.picture_number, results.overlay_number};
    if (results.ground_of == source) return;
    results.ground_of = source;
    const LoneTriangle& lone = results.overlay.lone;
    const bool is_grey = !results.overlay.image.rgba.empty();
    results.ground = {};
    if (lone.triangle()) {
        const auto depths =
            results.depth ? std::optional(values_of(results.depth->range)) : std::nullopt;
        results.ground = view_image(lone.picture(), session.view, depths,
                                    results.overdraw ? results.overdraw->most : 0);
    }
    if (is_grey)
        results.ground = ground_of_overlays(lone.triangle() ? results.ground : results.a.picture);
    if (lone.triangle() || is_grey) results.ground_number = ++results.numbers;
}

/// The pixel whose history is known, or being computed.
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
    // First the picture, then what fell on one of its pixels.
    if (!results.history_work || !(results.a.is_drawn() || results.a.is_deferred)) return;
    // And not both in one update, if the picture was a lot of work.
    const bool was_much = results.a.replay.work().total() > limit.at_once;
    if (changes.picture && was_much) return;
    results.history_work->advance({limit.slice, limit.slice});
    if (!results.history_work->is_done()) return;
    results.history = results.history_work->take();
    results.history_work = std::nullopt;
}

/// Finds what the program that is run B puts on the picked pixel.
void update_program_writes(const Session& session, Results& results) {
    const std::optional<glm::ivec2> pixel = picked_pixel(session, results.a.frame);
    ProgramWrites& writes = results.program_writes;
    if (!pixel || !results.b || !results.b->is_of_program()) {
        writes = {};
    } else if (writes.program != results.b->run->program || writes.pixel != *pixel) {
        writes.program = results.b->run->program;
        writes.pixel = *pixel;
        writes.puts = writes_on(*writes.program, *pixel);
    }
}

std::string size_text(Viewport size) {
    return fmt::format("{} x {}", size.width, size.height);
}

/// Why what a student's program has drawn does not correspond to run A; empty if it does. Other
/// settings may differ: they are what is compared.
std::string program_obstacle(const Session& session, const ProgramDrawing& program) {
    if (session.scene != program.scene)
        return "Your program has drawn the lab's room, and another scene is open. Undo, or end the "
               "comparison.";
    if (!(session.a.settings.camera == program.settings.camera))
        return "Your program has drawn the room from another place than run A. Undo, or end the "
               "comparison.";
    return "";
}

/// Why the two runs cannot be compared; empty if they can.
std::string obstacle(const Session& session) {
    if (session.b->program != nullptr) {
        std::string why = program_obstacle(session, *session.b->program);
        if (!why.empty()) return why;
    }
    if (shown_pass(session, session.a) != shown_pass(session, *session.b))
        return "Run B cannot be compared with run A because it has no shadow map.";
    const Settings a = shown_run(session, session.a).settings;
    const Settings b = shown_run(session, *session.b).settings;
    if (a.viewport == b.viewport) return "";
    return fmt::format("Run B cannot be compared with run A because its picture has {} pixels and "
                       "A's has {}.",
                       size_text(b.viewport), size_text(a.viewport));
}

/// Continues preparing the frames that are asked for. Both runs show theirs at the same time, so
/// that they are seen from the same place.
bool prepare_runs(const Session& session, const WorkLimit& limit, Results& results) {
    const auto prepare = [&](const Run& run, RunResults& of) {
        return prepare_run(session.scene, shown_run(session, run), shown_pass(session, run), false,
                           limit, of);
    };
    const bool is_ready = prepare(session.a, results.a);
    if (!session.b || !results.b) return is_ready;
    return prepare(*session.b, *results.b) && is_ready;
}

/// How much work it is to compare the whole frames.
double comparison_work(const Results& results) {
    return compare_work_factor *
           (results.a.replay.work().total() + results.b->replay.work().total());
}

void update_second_run(const Session& session, const RunChanges& a, bool are_ready,
                       const WorkLimit& limit, Results& results) {
    results.no_comparison = session.b ? obstacle(session) : std::string();
    if (!session.b || !results.no_comparison.empty()) {
        results.b = nullptr;
        results.next_b = nullptr;
        results.comparison = {};
        return;
    }
    if (!results.b) {
        if (!results.next_b) results.next_b = std::make_unique<RunResults>();
        are_ready = prepare_run(session.scene, shown_run(session, *session.b),
                                shown_pass(session, *session.b), true, limit, *results.next_b);
        if (!are_ready) return;
        results.b = std::move(results.next_b);
    }
    // Both in the colours of A, so that the same colour means the same depth.
    SharedView shared{&results.a.frame, results.a.triangle, session.depth_range};
    if (!shared.depths && results.depth) shared.depths = values_of(results.depth->range);
    const RunChanges b = update_run(session, shown_run(session, *session.b), are_ready, &shared,
                                    limit, results.numbers, *results.b);
    ComparisonResults& comparison = results.comparison;
    if (a.frame || b.frame)
        comparison.work.begin(results.a.frame, results.b->frame, cursor_end,
                              results.b->run->program);
    const bool was_done = comparison.work.is_done();
    const bool are_drawn = results.a.is_drawn() && results.b->is_drawn();
    // And not in an update with much other work.
    const bool was_much = (a.picture || b.picture) && comparison_work(results) > limit.at_once;
    if (are_drawn && !was_much) comparison.work.advance(limit);
    // The scale of the difference follows the whole frames.
    const bool new_scale = !was_done && comparison.work.is_done();
    update_difference(session.view, new_scale, limit, results);
}

/// Hints are wanted only for a whole picture that is not being compared.
void update_hints(const Session& session, const RunChanges& changes, const WorkLimit& limit,
                  Results& results) {
    PictureHints& hints = results.hints;
    const bool is_model = results.a.scene && results.a.scene->model_report;
    const bool are_wanted = is_model && session.cursor == cursor_end && !session.b;
    const std::shared_ptr<const Scene> scene = are_wanted ? results.a.scene : nullptr;
    const bool is_other_scene = hints.scene != scene;
    if (is_other_scene) hints.found.clear();
    if (is_other_scene || changes.frame || changes.moment) {
        hints.work = std::nullopt;
        hints.scene = scene;
        hints.are_due = are_wanted;
    }
    if (!are_wanted) return;
    // They are looked for after everything else, in separate updates.
    const bool is_whole =
        results.a.is_drawn() && results.a.is_complete() && !results.a.is_frame_late;
    if (!hints.are_due || !is_whole || changes.picture || results.history_work) return;
    try {
        if (!hints.work) hints.work.emplace(results.a.frame, *results.a.framebuffer);
        hints.work->advance({limit.slice, limit.slice, limit.most});
        if (!hints.work->is_done()) return;
        hints.found = hints.work->hints();
    } catch (const std::bad_alloc&) {
        hints.found.clear(); // the picture does not need them
    }
    hints.are_due = false;
    hints.work = std::nullopt;
}

bool is_counting(const HiddenTable& table) {
    return table.work && !table.work->is_done();
}

/// Counts the ways to remove hidden surfaces, after everything else.
void update_hidden(const Session& session, const RunChanges& changes, const WorkLimit& limit,
                   Results& results) {
    HiddenTable& table = results.hidden;
    if (tab_below(session) != hidden_tab) {
        table.ways.clear();
        table.work = std::nullopt;
        table.scene = nullptr;
        return;
    }
    try {
        const Settings settings = counted_settings(results.a.frame.settings);
        if (table.scene != results.a.scene || !(table.settings == settings)) {
            if (table.scene != results.a.scene) table.ways.clear();
            if (!table.work) table.work.emplace();
            table.scene = results.a.scene;
            table.settings = settings;
            table.work->begin(*table.scene, settings);
        }
        const bool is_whole = results.a.is_drawn() && !results.a.is_frame_late;
        if (!is_counting(table) || !is_whole || changes.picture) return;
        table.work->advance({limit.slice, limit.slice});
        if (table.work->is_done()) table.ways = table.work->ways();
    } catch (const std::bad_alloc&) {
        table.ways.clear(); // the picture does not need them
        table.work = std::nullopt;
    }
}

/// The limit for each of two runs.
WorkLimit half_slices(WorkLimit limit) {
    limit.slice /= 2.0;
    return limit;
}

bool update_within(const Session& session, const WorkLimit& limit, Results& results) {
    const auto shown_preview = [&] {
        return results.a.preview.is_shown ? results.a.preview.number : 0;
    };
    const std::uint64_t preview_before = shown_preview();
    results.hand.watch(session);
    if (follow_hand(session, limit, results)) return shown_preview() != preview_before;
    const bool are_ready = prepare_runs(session, limit, results);
    const RunChanges changes = update_run(session, shown_run(session, session.a), are_ready,
                                          nullptr, limit, results.numbers, results.a);
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
    update_overlay(session, limit, changes.moment, results);
    update_ground(session, results);
    update_history(session, changes, limit, results);
    update_second_run(session, changes, are_ready, limit, results);
    update_program_writes(session, results);
    update_hints(session, changes, limit, results);
    update_hidden(session, changes, limit, results);
    update_previews(session, results);
    return changes.picture || shown_preview() != preview_before;
}

} // namespace

bool update(const Session& session, Results& results, const WorkLimit& limit) {
    return update_within(session, session.b ? half_slices(limit) : limit, results);
}

bool finish(const Session& session, Results& results) {
    bool has_changed = update(session, results, {});
    // Work begun earlier is finished first.
    while (is_working(results))
        has_changed = update(session, results, {}) || has_changed;
    return has_changed;
}

bool is_working(const Results& results) {
    if (results.a.is_frame_late || !results.a.is_complete()) return true;
    if (results.history_work || results.next_b) return true;
    if (results.hints.are_due && results.a.is_drawn()) return true;
    if (is_counting(results.hidden) && results.a.is_drawn()) return true;
    if (results.overlay.lone.is_drawing() || results.overlay.cost.is_counting()) return true;
    if (!results.b) return false;
    if (results.b->is_frame_late || !results.b->is_complete()) return true;
    if (!results.comparison.progress.is_done) return true;
    const bool are_drawn = results.a.is_drawn() && results.b->is_drawn();
    return are_drawn && !results.comparison.work.is_done();
}

} // namespace rasterwalk
