#include "session/walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

} // namespace

void step_forward(Session& session, const Timeline& timeline, Granularity step) {
    scrub_to(session, timeline.next(session.cursor, step));
}

void step_back(Session& session, const Timeline& timeline, Granularity step) {
    scrub_to(session, timeline.previous(session.cursor, step));
}

void scrub_to(Session& session, const Cursor& cursor) {
    session.cursor = cursor;
    session.play.running = false;
}

void go_to(Session& session, const Cursor& cursor) {
    scrub_to(session, cursor);
    ++session.jumps;
}

void go_to_entry(Session& session, const Timeline& timeline, const PixelEntry& entry) {
    go_to(session, timeline.next(entry.cursor, Granularity::moment));
    session.selection.triangle = entry.cursor.triangle;
}

bool next_change(Session& session, const Timeline& timeline, const PixelHistory& history) {
    const Cursor here = timeline.at_or_after(session.cursor);
    for (const PixelEntry& entry : history.entries) {
        if (entry.fate != Fate::written || entry.cursor < here) continue;
        go_to_entry(session, timeline, entry);
        return true;
    }
    return false;
}

bool previous_change(Session& session, const Timeline& timeline, const PixelHistory& history) {
    const Cursor here = timeline.at_or_after(session.cursor);
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
    const bool at_end = timeline.at_or_after(session.cursor) == cursor_end;
    if (play.running && at_end) session.cursor = timeline.first();
}

void advance_play(Session& session, const Timeline& timeline, const FrameLength& length,
                  float seconds) {
    Play& play = session.play;
    if (!play.running) return;
    // The time since the previous frame does not belong to playback yet.
    if (std::exchange(play.has_just_begun, false)) return;
    const double time = seconds > 0.0f ? std::min(seconds, longest_play_step) : 0.0f;
    const Instant now = after(timeline, length, play, session.cursor, time);
    session.cursor = now.cursor;
    play.passed = now.passed;
    if (now.cursor == cursor_end) play.running = false;
}

} // namespace rasterwalk
