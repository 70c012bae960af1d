#include "ui/hosts/web/input.h"

#include <array>
#include <cfloat>
#include <set>
#include <utility>

#include <imgui.h>

#include "ui/widgets/imgui_versions.h"

namespace rasterwalk {

namespace {

constexpr int button_count = 3;

/// What is held now, according to the events played.
struct Modifiers {
    std::set<int> keys;
    std::array<bool, button_count> buttons{};
};
Modifiers modifiers;

/// Notes what an event presses or releases. Returns false if that changes nothing.
bool take(const PageEvent& event, Modifiers& now) {
    if (event.kind == PageEvent::Kind::button) {
        return std::exchange(now.buttons[static_cast<std::size_t>(event.code)], event.is_down) !=
               event.is_down;
    }
    if (event.kind != PageEvent::Kind::key || event.code == 0) return false;
    return event.is_down ? now.keys.insert(event.code).second : now.keys.erase(event.code) > 0;
}

/// What was played in this frame.
struct Played {
    std::set<int> keys;
    bool button = false;
    float up = 0.0f, left = 0.0f; ///< steps of the wheel
};

bool waits(const PageEvent& event, const Played& played) {
    switch (event.kind) {
    case PageEvent::Kind::pointer:
    case PageEvent::Kind::button:
        return played.button;
    case PageEvent::Kind::key:
        // What is held with a key changes only after the frame of that key.
        return event.code == 0 ? !played.keys.empty() || played.button
                               : played.keys.count(event.code) > 0;
    default:
        return false;
    }
}

void play(const PageEvent& event, Played& played) {
    switch (event.kind) {
    case PageEvent::Kind::pointer:
        play_pointer({event.x, event.y});
        break;
    case PageEvent::Kind::button:
        play_mouse_button(event.code, event.is_down);
        take(event, modifiers);
        played.button = true;
        break;
    case PageEvent::Kind::wheel:
        played.left += event.x;
        played.up += event.y;
        break;
    case PageEvent::Kind::key:
        play_modifiers(event.has_ctrl, event.has_shift, event.has_alt);
        if (event.code == 0) break; // a modifier alone
        play_key(event.code, event.is_down);
        // A key that repeats is one press.
        if (take(event, modifiers)) played.keys.insert(event.code);
        break;
    case PageEvent::Kind::letters:
        ImGui::GetIO().AddInputCharactersUTF8(event.letters.c_str());
        break;
    }
}

} // namespace

void play_events(PageEvents& events) {
    Played played;
    while (!events.empty() && !waits(events.front(), played)) {
        play(events.front(), played);
        events.pop_front();
    }
    if (played.up != 0.0f || played.left != 0.0f) play_wheel(played.up, played.left);
}

void release_everything(PageEvents& events) {
    Modifiers left = modifiers; // once all waiting events are played
    for (const PageEvent& event : events)
        take(event, left);
    for (const int key : left.keys)
        events.push_back({.kind = PageEvent::Kind::key, .code = key});
    events.push_back({.kind = PageEvent::Kind::key});
    for (int button = 0; button < button_count; ++button) {
        if (left.buttons[static_cast<std::size_t>(button)])
            events.push_back({.kind = PageEvent::Kind::button, .code = button});
    }
}

} // namespace rasterwalk
