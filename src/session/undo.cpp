#include "session/undo.h"

#include <algorithm>

#include "engines/program_drawing.h"
#include "session/session.h"

namespace rasterwalk {

namespace {

/// Moves the present onto one pile and takes a new one from the other.
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

void count_kept(const Choices& choices, KeptBytes& bytes) {
    if (choices.b) bytes.add(choices.b->program.get());
    bytes.add(choices.scene.get());
    if (choices.replaced) bytes.add(choices.replaced->before_scene.get());
}

/// Forgets the oldest steps if there are too many or what they keep takes too much memory.
void forget_oldest(UndoStack& stack) {
    KeptBytes bytes;
    count_kept(stack.now, bytes);
    const std::size_t open = bytes.total();
    const auto newest = stack.past.rbegin();
    const auto is_too_much = [&](const Choices& step) {
        count_kept(step, bytes);
        return &step != &*newest && bytes.total() - open > stack.most_bytes;
    };
    const auto first = std::find_if(newest, stack.past.rend(), is_too_much);
    const auto kept = std::min<std::ptrdiff_t>(first - newest, most_undo_steps);
    stack.past.erase(stack.past.begin(), stack.past.end() - kept);
}

template <typename Element>
std::size_t bytes_of(const std::vector<Element>& list) {
    return list.capacity() * sizeof(Element);
}

} // namespace

void record_undo_step(Session& session) {
    UndoStack& stack = session.undo;
    const Choices& choices = session;
    if (choices == stack.now) return;
    // The very first call only records how the session was opened.
    if (stack.now.scene != nullptr) {
        stack.past.push_back(std::move(stack.now));
        stack.future.clear();
    }
    stack.now = choices;
    forget_oldest(stack);
}

bool undo(Session& session) {
    record_undo_step(session);
    return move_between(session, session.undo.past, session.undo.future);
}

bool redo(Session& session) {
    record_undo_step(session);
    return move_between(session, session.undo.future, session.undo.past);
}

void KeptBytes::add(const ProgramDrawing* drawing) {
    if (drawing == nullptr || !counted_.insert(drawing).second) return;
    total_ += drawing->bytes();
    add(drawing->scene.get());
}

void KeptBytes::add(const Scene* scene) {
    if (scene == nullptr || !counted_.insert(scene).second) return;
    total_ += sizeof(Scene) + bytes_of(scene->mesh.vertices()) + bytes_of(scene->mesh.triangles()) +
              bytes_of(scene->parts) + bytes_of(scene->polygons) + bytes_of(scene->examples);
    for (const SharedTexture& texture : scene->textures) {
        if (!counted_.insert(&*texture).second) continue;
        for (const TextureLevel& level : (*texture).levels)
            total_ += bytes_of(level.texels) + bytes_of(level.alphas);
    }
}

} // namespace rasterwalk
