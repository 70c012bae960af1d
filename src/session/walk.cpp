#include "session/walk.h"

#include <algorithm>

namespace rasterwalk {

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
        // The change after which we stand is the last one, not the one before it.
        if (timeline.next(entry.cursor, Granularity::moment) == here) continue;
        go_to_entry(session, timeline, entry);
        return true;
    }
    return false;
}

void toggle_play(Session& session, const Timeline& timeline) {
    session.play.running = !session.play.running;
    session.play.owed = 0.0f;
    const bool at_end = timeline.at_or_after(session.cursor) == cursor_end;
    if (session.play.running && at_end) session.cursor = timeline.first();
}

void advance_play(Session& session, const Timeline& timeline, float seconds) {
    Play& play = session.play;
    if (!play.running) return;
    play.owed = std::min(play.owed + seconds * play.speed, 2.0f);
    if (play.owed < 1.0f) return;
    play.owed -= 1.0f;
    session.cursor = timeline.next(session.cursor, play.granularity);
    if (session.cursor == cursor_end) play.running = false;
}

} // namespace rasterwalk
