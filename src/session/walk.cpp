#include "session/walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engines/program_drawing.h"
#include "pipeline/shadow_pass.h"

namespace rasterwalk {

namespace {

/// Where playback is after running for this many seconds.
Instant after(const Timeline& timeline, const FrameLength& length, const Play& play,
              const Cursor& cursor, double seconds) {
    const Speed speed = speed_in(play.speed, length.of(play.granularity));
    switch (speed.unit) {
    case SpeedUnit::steps: {
        const double steps = play.passed + seconds * speed.value;
        const double whole = std::floor(steps);
        return {advance(timeline, cursor, static_cast<std::int64_t>(whole), play.granularity),
                steps - whole};
    }
    case SpeedUnit::frame:
        return run_on(timeline, {cursor, play.passed}, seconds / speed.value * length.triangles,
                      play.granularity);
    case SpeedUnit::unlimited:
        break;
    }
    return {cursor_end, 0.0};
}

/// The session's cursor as a moment of the frame that is shown.
Cursor moment_in(const Timeline& timeline, const Session& session) {
    return timeline.at_or_after(in_frame(session.cursor, timeline.frame().pass));
}

int first_pass(const Session& session) {
    return first_pass(session.a.settings, session.scene->space);
}

/// Sets the cursor. Pixels and rows are those of one picture, so another pass has none of them; nor
/// has it the triangles of a drawn list.
void move_to(Session& session, const Cursor& cursor) {
    if (std::min(cursor.pass, 0) != std::min(session.cursor.pass, 0)) {
        session.selection.pixel = std::nullopt;
        session.selection.row = std::nullopt;
        if (!follows_scene_order(session.a.settings)) session.selection.triangle = std::nullopt;
    }
    session.cursor = cursor;
}

/// Where the student's program that is run B first puts another pixel, if that is after this
/// moment, and if run A still has the settings that the program was compared with.
std::optional<Cursor> parting_ahead(const Session& session, const Timeline& timeline,
                                    const Cursor& here) {
    if (!session.b || session.b->program == nullptr || timeline.frame().pass < 0 ||
        session.scene != session.b->program->scene || !(session.a.settings == session.b->settings))
        return std::nullopt;
    const std::optional<Cursor> moment = moment_of_parting(*session.b->program);
    if (!moment) return std::nullopt;
    const Cursor there = timeline.at_or_after(*moment);
    return there > here ? std::optional(there) : std::nullopt;
}

} // namespace

void step_forward(Session& session, const Timeline& timeline, Granularity step) {
    const int pass = timeline.frame().pass;
    const Cursor here = moment_in(timeline, session);
    const bool is_over = here == cursor_end && pass < 0;
    scrub_to(session,
             is_over ? in_pass(cursor_begin, pass + 1) : in_pass(timeline.next(here, step), pass));
}

void step_back(Session& session, const Timeline& timeline, Granularity step) {
    const int pass = timeline.frame().pass;
    const Cursor here = moment_in(timeline, session);
    const bool is_first = here == timeline.first() && pass > first_pass(session);
    scrub_to(session, is_first ? in_pass(cursor_end, pass - 1)
                               : in_pass(timeline.previous(here, step), pass));
}

void scrub_to(Session& session, const Cursor& cursor) {
    move_to(session, cursor);
    session.play.running = false;
}

void go_to(Session& session, const Cursor& cursor) {
    scrub_to(session, cursor);
    ++session.jumps;
}

void go_to(Session& session, const Timeline& timeline, const Cursor& cursor) {
    go_to(session, in_pass(cursor, timeline.frame().pass));
}

void go_to_texel(Session& session, int face, const glm::ivec2& texel) {
    const int pass = pass_of_face(face);
    const Frame frame = prepare_pass(*session.scene, session.a.settings, pass);
    const PixelHistory history = pixel_history(frame, texel);
    const Timeline timeline(frame);
    if (history.winner >= 0) {
        go_to_entry(session, timeline, history.entries[static_cast<std::size_t>(history.winner)]);
    } else {
        go_to(session, timeline, cursor_end);
        session.selection.triangle = std::nullopt;
    }
    session.selection.pixel = texel;
    session.selection.row = std::nullopt;
    if (session.canvas.zoom > 0.0f) session.canvas.centre = glm::vec2(texel) + 0.5f;
}

void go_to_beginning(Session& session, const Timeline& timeline) {
    const bool is_there = moment_in(timeline, session) == timeline.first();
    go_to(session, in_pass(cursor_begin, is_there ? first_pass(session) : timeline.frame().pass));
}

void go_to_end(Session& session, const Timeline& timeline) {
    const bool is_there = moment_in(timeline, session) == cursor_end;
    go_to(session, in_pass(cursor_end, is_there ? 0 : timeline.frame().pass));
}

void go_to_entry(Session& session, const Timeline& timeline, const PixelEntry& entry) {
    go_to(session, timeline, timeline.next(entry.cursor, Granularity::moment));
    session.selection.triangle = entry.cursor.triangle;
}

bool next_change(Session& session, const Timeline& timeline, const PixelHistory& history) {
    const Cursor here = moment_in(timeline, session);
    for (const PixelEntry& entry : history.entries) {
        if (entry.fate != Fate::written || entry.cursor < here) continue;
        go_to_entry(session, timeline, entry);
        return true;
    }
    return false;
}

bool previous_change(Session& session, const Timeline& timeline, const PixelHistory& history) {
    const Cursor here = moment_in(timeline, session);
    for (std::size_t i = history.entries.size(); i-- > 0;) {
        const PixelEntry& entry = history.entries[i];
        if (entry.fate != Fate::written || entry.cursor >= here) continue;
        // If we are just after a change, that is the last one, not the one before it.
        if (timeline.next(entry.cursor, Granularity::moment) == here) continue;
        go_to_entry(session, timeline, entry);
        return true;
    }
    return false;
}

void toggle_play(Session& session, const Timeline& timeline) {
    Play& play = session.play;
    play.running = !play.running;
    play.has_just_begun = play.running;
    play.passed = 0.0;
    const bool at_end = timeline.frame().pass == 0 && moment_in(timeline, session) == cursor_end;
    if (play.running && at_end) session.cursor = timeline.first();
}

void advance_play(Session& session, const Timeline& timeline, const FrameLength& length,
                  float seconds) {
    Play& play = session.play;
    if (!play.running) return;
    // The time since the previous frame does not belong to playback yet.
    if (std::exchange(play.has_just_begun, false)) return;
    const double time = seconds > 0.0f ? std::min(seconds, longest_play_step) : 0.0f;
    const int pass = timeline.frame().pass;
    const Cursor here = moment_in(timeline, session);
    if (here == cursor_end && pass < 0) {
        move_to(session, in_pass(cursor_begin, pass + 1));
        play.passed = 0.0;
        return;
    }
    const Instant now = after(timeline, length, play, here, time);
    const std::optional<Cursor> parting = parting_ahead(session, timeline, here);
    if (parting && now.cursor >= *parting) {
        move_to(session, *parting);
        play.running = false;
        play.passed = 0.0;
        show_info(session, parting_text(*session.b->program->parting));
        return;
    }
    move_to(session, in_pass(now.cursor, pass));
    play.passed = now.passed;
    if (now.cursor == cursor_end && pass == 0) play.running = false;
}

} // namespace rasterwalk
