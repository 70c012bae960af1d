#include "ui/actions/focus_keys.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <imgui_internal.h>

#include "ui/actions/actions.h"
#include "ui/actions/keys.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"

namespace rasterwalk {

namespace {

/// A widget that can have the keyboard.
struct Stop {
    std::string name;
    WidgetPlace place;
};

/// What can be reached now, in the order in which it is drawn: only the menu or list on top, if one
/// is open.
std::vector<Stop> stops_in_reach(const Ui& ui) {
    const ImVector<ImGuiPopupData>& popups = GImGui->OpenPopupStack;
    std::vector<Stop> stops;
    if (!popups.empty() && popups.back().Window == nullptr) return stops; // it is not drawn yet
    const ImGuiID part = popups.empty() ? 0 : popups.back().Window->ID;
    for (const auto& [name, place] : ui.widgets) {
        if (place.id == 0 || (part != 0 && place.part != part)) continue;
        stops.push_back({name, place});
    }
    std::sort(stops.begin(), stops.end(),
              [](const Stop& a, const Stop& b) { return a.place.order < b.place.order; });
    return stops;
}

const Stop* find_stop(const std::vector<Stop>& stops, const std::string& name) {
    const auto found =
        std::find_if(stops.begin(), stops.end(), [&](const Stop& s) { return s.name == name; });
    return found == stops.end() ? nullptr : &*found;
}

void show_at(Ui& ui, const std::string& name) {
    ui.focus.name = name;
    ui.focus.is_shown = ui.focus.wants_sight = true;
}

/// Where the way begins: in a list with the entry that holds, and else with the lesson, if there is
/// one.
const Stop& first_of(const std::vector<Stop>& stops) {
    const auto chosen =
        std::find_if(stops.begin(), stops.end(), [](const Stop& s) { return s.place.is_chosen; });
    if (chosen != stops.end()) return *chosen;
    const auto found = std::find_if(stops.begin(), stops.end(),
                                    [](const Stop& s) { return s.name.starts_with("lesson."); });
    return found == stops.end() ? stops.front() : *found;
}

/// What takes over from a widget that has gone: the nearest one of its part, or what had the
/// keyboard before the part was opened.
const Stop& heir(const Ui& ui, const std::vector<Stop>& stops) {
    const Focus& focus = ui.focus;
    const Stop* nearest = nullptr;
    float least = std::numeric_limits<float>::max();
    for (const Stop& stop : stops) {
        const ImVec2 at = stop.place.top_left;
        const float dx = at.x - focus.place.x, dy = at.y - focus.place.y;
        const float distance = dx * dx + dy * dy;
        if (stop.place.part != focus.part || !stop.place.visible || distance >= least) continue;
        least = distance;
        nearest = &stop;
    }
    if (nearest == nullptr) nearest = find_stop(stops, focus.before);
    return nearest != nullptr ? *nearest : first_of(stops);
}

/// A menu or list that opens takes the keyboard, and gives it back. Returns true if it just did:
/// what was drawn last is then still without the one that has it again.
bool follow_popups(Ui& ui) {
    Focus& focus = ui.focus;
    const auto open = static_cast<std::size_t>(GImGui->OpenPopupStack.Size);
    while (focus.openers.size() < open) {
        focus.openers.push_back(focus.name);
        focus.name.clear();
    }
    if (focus.openers.size() == open) return false;
    focus.name = focus.openers[open];
    focus.openers.resize(open);
    return true;
}

/// A click goes on by pointer, and Tab goes on from where it was.
void follow_pointer(Ui& ui, const std::vector<Stop>& stops) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!io.MouseClicked[0] && !io.MouseClicked[1]) return;
    ui.focus.is_shown = false;
    float least = std::numeric_limits<float>::max();
    for (const Stop& stop : stops) {
        const ImRect area(stop.place.top_left, stop.place.bottom_right);
        if (!area.Contains(io.MousePos) || area.GetArea() >= least) continue;
        least = area.GetArea();
        ui.focus.name = stop.name;
    }
}

int number_of(const std::vector<Stop>& stops, const std::string& name) {
    const Stop* const stop = find_stop(stops, name);
    return stop == nullptr ? -1 : static_cast<int>(stop - stops.data());
}

/// To the next widget, or the one before; from the last to the first.
void move_on(Ui& ui, const std::vector<Stop>& stops, int distance) {
    const int count = static_cast<int>(stops.size());
    const int from = number_of(stops, ui.focus.name);
    show_at(ui, stops[static_cast<std::size_t>((from + distance + count) % count)].name);
}

/// To the first widget of the next part, or of the one before.
void move_to_part(Ui& ui, const std::vector<Stop>& stops, int distance) {
    std::vector<const Stop*> firsts;
    for (const Stop& stop : stops) {
        const bool is_known = std::any_of(firsts.begin(), firsts.end(), [&](const Stop* first) {
            return first->place.part == stop.place.part;
        });
        if (!is_known) firsts.push_back(&stop);
    }
    const Stop* const now = find_stop(stops, ui.focus.name);
    const auto here = std::find_if(firsts.begin(), firsts.end(), [&](const Stop* first) {
        return now != nullptr && first->place.part == now->place.part;
    });
    const int count = static_cast<int>(firsts.size());
    const int from =
        here == firsts.end() ? (distance > 0 ? -1 : 0) : static_cast<int>(here - firsts.begin());
    show_at(ui, firsts[static_cast<std::size_t>((from + distance + count) % count)]->name);
}

Arrows pressed_arrows() {
    Arrows arrows;
    const auto pressed = [](int code) { return ImGui::IsKeyPressed(code, true) ? 1 : 0; };
    arrows.right = pressed(key::right) - pressed(key::left);
    arrows.up = pressed(key::up) - pressed(key::down);
    return arrows;
}

bool can_be_pressed(const WidgetPlace& place) {
    return place.is_input || !place.takes_arrows;
}

void press(const WidgetPlace& place) {
    ImGui::ActivateItem(place.id);
    GImGui->NavNextActivateFlags =
        place.is_input ? ImGuiActivateFlags_PreferInput : ImGuiActivateFlags_None;
}

/// Tab and F6. Returns true if one was pressed.
bool take_moving_keys(Ui& ui, const std::vector<Stop>& stops) {
    const ImGuiIO& io = ImGui::GetIO();
    const int distance = io.KeyShift ? -1 : 1;
    const bool is_tab = ImGui::IsKeyPressed(key::tab, true);
    const bool is_part = ImGui::IsKeyPressed(key::f1 + 5, false);
    if (!is_tab && !is_part) return false;
    const bool was_typing = io.WantTextInput;
    if (was_typing) ImGui::ClearActiveID();
    if (is_part) {
        move_to_part(ui, stops, distance);
    } else if (ui.focus.is_shown || was_typing) {
        move_on(ui, stops, distance);
    } else {
        // The first time it only shows where the keyboard is.
        show_at(ui, find_stop(stops, ui.focus.name) ? ui.focus.name : first_of(stops).name);
    }
    return true;
}

void take_widget_keys(Ui& ui, const std::vector<Stop>& stops) {
    const ImGuiIO& io = ImGui::GetIO();
    Focus& focus = ui.focus;
    if (io.WantTextInput || io.KeyShift) return;
    const Arrows arrows = pressed_arrows();
    const bool is_arrow = arrows.right != 0 || arrows.up != 0;
    const Stop* const stop = find_stop(stops, focus.name);
    if (!focus.is_shown || stop == nullptr) {
        // Elsewhere they move the camera.
        const bool leads = ui.start.is_open || !focus.openers.empty();
        if (is_arrow && leads) show_at(ui, stop != nullptr ? stop->name : first_of(stops).name);
        return;
    }
    if (is_arrow && stop->place.takes_arrows) {
        focus.arrows = arrows;
    } else if (is_arrow) {
        move_on(ui, stops, arrows.right - arrows.up > 0 ? 1 : -1);
    }
    const bool is_press = ImGui::IsKeyPressed(key::enter, false) ||
                          ImGui::IsKeyPressed(key::keypad_enter, false) ||
                          ImGui::IsKeyPressed(key::space, false);
    if (is_press && can_be_pressed(stop->place)) press(stop->place);
}

/// What scrolls with the widget: its own window, or else the largest one of its part.
ImGuiWindow* scrolled_with(const Focus& focus) {
    const auto scrolls = [](const ImGuiWindow* w) { return w->WasActive && w->ScrollMax.y > 0.0f; };
    ImGuiWindow* largest = nullptr;
    float most = 0.0f;
    for (ImGuiWindow* const window : GImGui->Windows) {
        if (!scrolls(window) || part_of(*window) != focus.part) continue;
        if (window->ID == focus.window) return window;
        const float area = window->InnerRect.GetArea();
        if (area <= most) continue;
        most = area;
        largest = window;
    }
    return largest;
}

void take_scrolling_keys(const Ui& ui) {
    const int up = pressed_arrows().up;
    ImGuiWindow* const window = up == 0 ? nullptr : scrolled_with(ui.focus);
    if (window == nullptr) return;
    const float step = 3.0f * ImGui::GetTextLineHeightWithSpacing();
    const float y = window->Scroll.y - step * static_cast<float>(up);
    ImGui::SetScrollY(window, std::clamp(y, 0.0f, window->ScrollMax.y));
}

} // namespace

void take_focus_keys(Ui& ui) {
    Focus& focus = ui.focus;
    focus.arrows = {};
    if (follow_popups(ui)) return;
    const std::vector<Stop> stops = stops_in_reach(ui);
    if (stops.empty()) return;
    follow_pointer(ui, stops);
    if (focus.is_shown && find_stop(stops, focus.name) == nullptr) {
        show_at(ui, focus.name.empty() ? first_of(stops).name : heir(ui, stops).name);
    }
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl && !io.WantTextInput) take_scrolling_keys(ui);
    if (io.KeyCtrl || io.KeyAlt) return;
    if (!take_moving_keys(ui, stops)) take_widget_keys(ui, stops);
}

bool belongs_to_focus(const Ui& ui, const Chord& chord) {
    if (!ui.focus.is_shown || chord.ctrl || chord.alt) return false;
    const auto found = ui.widgets.find(ui.focus.name);
    if (found == ui.widgets.end() || found->second.id == 0) return false;
    if (chord.key == key::space) return can_be_pressed(found->second);
    const bool zooms = chord.key == key::equal || chord.key == key::minus;
    return zooms && ui.focus.name == "canvas";
}

} // namespace rasterwalk
