#include "session/undo.h"

#include "session/session.h"

namespace rasterwalk {

namespace {

/// Moves the present onto one pile and takes it from the other.
bool move_between(Session& session, std::vector<Choices>& from, std::vector<Choices>& to) {
    if (from.empty()) return false;
    UndoStack& stack = session.undo;
    to.push_back(stack.now);
    stack.now = from.back();
    from.pop_back();
    if (session.scene != stack.now.scene) {
        session.selection = {};
        session.canvas.zoom = session.canvas.outside.distance = 0.0f;
    }
    Choices& choices = session;
    choices = stack.now;
    session.runs_before = std::nullopt;
    return true;
}

} // namespace

void note_choices(Session& session) {
    UndoStack& stack = session.undo;
    const Choices& choices = session;
    if (choices == stack.now) return;
    // The very first call only takes note of how the session was opened.
    if (stack.now.scene != nullptr) {
        if (stack.past.size() == most_undo_steps) stack.past.erase(stack.past.begin());
        stack.past.push_back(std::move(stack.now));
        stack.future.clear();
    }
    stack.now = choices;
}

bool undo(Session& session) {
    note_choices(session);
    return move_between(session, session.undo.past, session.undo.future);
}

bool redo(Session& session) {
    note_choices(session);
    return move_between(session, session.undo.future, session.undo.past);
}

} // namespace rasterwalk
