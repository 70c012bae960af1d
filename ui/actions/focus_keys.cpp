#include "ui/actions/focus_keys.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <imgui_internal.h>

#include "ui/actions/actions.h"
#include "ui/actions/focus_stops.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

void show_at(Ui& ui, const std::string& name) {
    ui.focus.name = name;
    ui.focus.is_shown = ui.focus.wants_sight = true;
}

using Stops = std::vector<const Stop*>;

/// Where the way begins: in a list, the chosen entry; elsewhere the lesson, if there is one.
const Stop& first_of(const Stops& stops) {
    const auto chosen =
        std::find_if(stops.begin(), stops.end(), [](const Stop* s) { return s->second.is_chosen; });
    if (chosen != stops.end()) return **chosen;
    const auto found = std::find_if(stops.begin(), stops.end(),
                                    [](const Stop* s) { return s->first.starts_with("lesson."); });
    return found == stops.end() ? *stops.front() : **found;
}

/// What takes over from a widget that has gone: the nearest one in its part, or the one that had
/// the keyboard before the part was opened.
const Stop& fallback_stop(const Ui& ui, const Stops& stops) {
    const Focus& focus = ui.focus;
    if (focus.name.empty()) return first_of(stops);
    const Stop* nearest = nullptr;
    const Stop* before = nullptr;
    float least = std::numeric_limits<float>::max();
    for (const Stop* const stop : stops) {
        if (stop->first == focus.before) before = stop;
        const WidgetPlace& place = stop->second;
        const float dx = place.top_left.x - focus.place.x, dy = place.top_left.y - focus.place.y;
        const float distance = dx * dx + dy * dy;
        if (place.part != focus.part || !place.visible || distance >= least) continue;
        least = distance;
        nearest = stop;
    }
    if (nearest == nullptr) nearest = before;
    return nearest != nullptr ? *nearest : first_of(stops);
}

/// A menu or list that opens takes the keyboard, and gives it back. Returns true if it has just
/// done so: what was last drawn then still lacks the widget that has it again.
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

/// After a click the pointer takes over, and Tab goes on from where it was.
void follow_pointer(Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!io.MouseClicked[0] && !io.MouseClicked[1]) return;
    ui.focus.is_shown = false;
    float least = std::numeric_limits<float>::max();
    for (const Stop* const stop : stops_in_reach(ui)) {
        const WidgetPlace& place = stop->second;
        const ImRect area(place.top_left, place.bottom_right);
        if (!area.Contains(io.MousePos) || area.GetArea() >= least) continue;
        if (sheet_over(ui, place.part, {io.MousePos, io.MousePos}) != nullptr) continue;
        least = area.GetArea();
        ui.focus.name = stop->first;
    }
}

/// A widget that can no longer be seen gives up the keyboard.
void leave_hidden_stop(Ui& ui) {
    if (!ui.focus.is_shown) return;
    const Stop* const now = stop_with_keyboard(ui);
    if (now == nullptr) {
        const Stops stops = stops_in_reach(ui);
        if (stops.empty()) return;
        show_at(ui, fallback_stop(ui, stops).first);
    } else if (const ImGuiWindow* const sheet = sheet_over(ui, now->second)) {
        const Stops stops = stops_in_reach(ui);
        const auto first = std::find_if(stops.begin(), stops.end(), [&](const Stop* stop) {
            return stop->second.part == sheet->ID;
        });
        if (first != stops.end()) give_focus(ui, (*first)->first);
    }
}

/// Moves to the next of these widgets, or the previous one; from the last to the first.
void move_on(Ui& ui, const Stops& stops, int distance) {
    if (stops.empty()) return;
    const auto here = std::find(stops.begin(), stops.end(), stop_with_keyboard(ui));
    const int count = static_cast<int>(stops.size());
    const int from = here == stops.end() ? -1 : static_cast<int>(here - stops.begin());
    show_at(ui, stops[static_cast<std::size_t>((from + distance + count) % count)]->first);
}

/// Moves to the first widget of the next part, or of the previous one.
void move_to_part(Ui& ui, const Stops& stops, int distance) {
    if (stops.empty()) return;
    Stops firsts;
    for (const Stop* const stop : stops) {
        const bool is_known = std::any_of(firsts.begin(), firsts.end(), [&](const Stop* first) {
            return first->second.part == stop->second.part;
        });
        if (!is_known) firsts.push_back(stop);
    }
    const Stop* const now = stop_with_keyboard(ui);
    const auto here = std::find_if(firsts.begin(), firsts.end(), [&](const Stop* first) {
        return now != nullptr && first->second.part == now->second.part;
    });
    const int count = static_cast<int>(firsts.size());
    const int from =
        here == firsts.end() ? (distance > 0 ? -1 : 0) : static_cast<int>(here - firsts.begin());
    show_at(ui, firsts[static_cast<std::size_t>((from + distance + count) % count)]->first);
}

/// An arrow never leads to a widget that takes arrows: holding it a little too long would change
/// that.
void move_by_arrows(Ui& ui, const Arrows& arrows) {
    const Stop* const now = stop_with_keyboard(ui);
    Stops stops = stops_of_tab(ui);
    std::erase_if(stops, [&](const Stop* s) { return s != now && s->second.takes_arrows; });
    move_on(ui, stops, arrows.right - arrows.up > 0 ? 1 : -1);
}

Arrows pressed_arrows() {
    Arrows arrows;
    const auto pressed = [](int code) { return is_key_pressed(code, true) ? 1 : 0; };
    arrows.right = pressed(key::right) - pressed(key::left);
    arrows.up = pressed(key::up) - pressed(key::down);
    return arrows;
}

bool can_be_pressed(const WidgetPlace& place) {
    return place.is_input || !place.takes_arrows;
}

void press(const WidgetPlace& place) {
    GImGui->NavNextActivateId = place.id;
    GImGui->NavNextActivateFlags =
        place.is_input ? ImGuiActivateFlags_PreferInput : ImGuiActivateFlags_None;
}

/// The first key only shows where the keyboard is.
void show_where_it_is(Ui& ui) {
    const Stop* const now = stop_with_keyboard(ui);
    if (now != nullptr && sheet_over(ui, now->second) == nullptr) return show_at(ui, now->first);
    const Stops stops = stops_in_reach(ui);
    if (!stops.empty())
        show_at(ui, (now == nullptr ? fallback_stop(ui, stops) : first_of(stops)).first);
}

/// Is it part of a prediction that waits for its answer: a field, a choice, or the button that
/// gives a pixel?
bool is_answer(std::string_view name) {
    return name.starts_with("lesson.prediction.") &&
           (name.ends_with(".number") || name.ends_with(".answer") ||
            name.find(".choice.") != std::string_view::npos);
}

/// Is it in the strip, the button of a card with a question or a task, such as lesson.card.2?
bool is_card_of_question(std::string_view name) {
    return name.starts_with("lesson.card.") && name != "lesson.card.text";
}

/// The first answer on the page; if the strip has it on another card, that card's button.
const Stop* first_answer(const Ui& ui, const Stops& stops) {
    const auto first = [&](const auto& is_meant) {
        const auto found = std::find_if(stops.begin(), stops.end(), is_meant);
        return found == stops.end() ? nullptr : *found;
    };
    const bool is_strip = ui.lesson.is_strip;
    const Stop* const answer = first(
        [&](const Stop* s) { return is_answer(s->first) && (s->second.visible || !is_strip); });
    if (answer != nullptr || !is_strip) return answer;
    return first([](const Stop* s) { return is_card_of_question(s->first); });
}

/// Tab leads to an answer that is new on the page first, once. Returns false if there is none.
bool move_to_new_answer(Ui& ui) {
    const Stop* const stop = first_answer(ui, stops_of_tab(ui));
    if (stop == nullptr) return false;
    std::string answer = fmt::format("{} {} {}", ui.session.lesson, ui.session.step, stop->first);
    if (ui.focus.answer == answer) return false;
    ui.focus.answer = std::move(answer);
    if (stop == stop_with_keyboard(ui) && ui.focus.is_shown) return false;
    show_at(ui, stop->first);
    return true;
}

/// Tab and F6. Returns true if one was pressed.
bool take_moving_keys(Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    const int distance = io.KeyShift ? -1 : 1;
    const bool is_tab = is_key_pressed(key::tab, true);
    const bool is_part = is_key_pressed(key::f1 + 5, false);
    if (!is_tab && !is_part) return false;
    const bool was_typing = io.WantTextInput;
    if (was_typing) ImGui::ClearActiveID();
    if (is_part) {
        move_to_part(ui, stops_in_reach(ui), distance);
    } else if (distance > 0 && !was_typing && move_to_new_answer(ui)) {
        return true;
    } else if (ui.focus.is_shown || was_typing) {
        move_on(ui, stops_of_tab(ui), distance);
    } else {
        show_where_it_is(ui);
    }
    return true;
}

/// Typing opens the field that has the frame, and goes into it. Returns true while it opens.
bool take_letters(Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    std::vector<std::uint32_t>& early = ui.focus.early_letters;
    const Stop* const stop = ui.focus.is_shown ? stop_with_keyboard(ui) : nullptr;
    if (stop == nullptr || !stop->second.is_input) {
        early.clear();
        return false;
    }
    if (io.WantTextInput) {
        if (stop->second.id != GImGui->ActiveId) early.clear();
        hand_over_letters(early);
        return false;
    }
    const ImVector<ImWchar>& letters = io.InputQueueCharacters;
    // Space presses, as everywhere.
    const bool is_typed = !letters.empty() && letters.front() != key::space;
    if (early.empty() && !is_typed) return false;
    keep_letters(early);
    ui.focus.wants_sight = true;
    press(stop->second);
    return true;
}

void take_widget_keys(Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    Focus& focus = ui.focus;
    if (io.WantTextInput || io.KeyShift) return;
    const Arrows arrows = pressed_arrows();
    const bool is_arrow = arrows.right != 0 || arrows.up != 0;
    const Stop* const stop = stop_with_keyboard(ui);
    if (!focus.is_shown || stop == nullptr) {
        // Everywhere else they move the camera.
        const bool leads = ui.start.is_open || !focus.openers.empty();
        if (is_arrow && leads) show_where_it_is(ui);
        return;
    }
    if (is_arrow && stop->second.takes_arrows) {
        focus.arrows = arrows;
    } else if (is_arrow) {
        move_by_arrows(ui, arrows);
    }
    const bool is_press = is_key_pressed(key::enter, false) ||
                          is_key_pressed(key::keypad_enter, false) ||
                          is_key_pressed(key::space, false);
    if (is_press && can_be_pressed(stop->second)) press(stop->second);
}

/// The window that scrolls there: that of the widget that has the keyboard, or else the largest.
ImGuiWindow* scrolled_in(ImGuiID part, const Focus& focus) {
    const auto scrolls = [](const ImGuiWindow* w) {
        const bool is_fixed = (w->Flags & ImGuiWindowFlags_NoScrollWithMouse) != 0;
        return w->WasActive && w->ScrollMax.y > 0.0f && !is_fixed;
    };
    ImGuiWindow* largest = nullptr;
    float most = 0.0f;
    for (ImGuiWindow* const window : GImGui->Windows) {
        if (!scrolls(window) || part_of(*window) != part) continue;
        if (window->ID == focus.window) return window;
        const float area = window->InnerRect.GetArea();
        if (area <= most) continue;
        most = area;
        largest = window;
    }
    return largest;
}

/// The part with the lesson, or with the page shown in its place; 0 if there is none.
ImGuiID part_of_lesson(const Ui& ui) {
    const auto found = std::find_if(ui.widgets.begin(), ui.widgets.end(), [](const Stop& stop) {
        return stop.first.starts_with("lesson.");
    });
    return found == ui.widgets.end() ? 0 : found->second.part;
}

void take_scrolling_keys(const Ui& ui) {
    const int up = pressed_arrows().up;
    if (up == 0) return;
    const Focus& focus = ui.focus;
    ImGuiWindow* window = scrolled_in(focus.part, focus);
    if (window == nullptr && !focus.is_shown) window = scrolled_in(part_of_lesson(ui), focus);
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
    follow_pointer(ui);
    leave_hidden_stop(ui);
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl && !io.WantTextInput) take_scrolling_keys(ui);
    if (io.KeyCtrl || io.KeyAlt) return;
    if (!take_moving_keys(ui) && !take_letters(ui)) take_widget_keys(ui);
}

bool is_moving_by_arrows(const Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!ui.focus.is_shown || io.KeyCtrl || io.KeyAlt || io.KeyShift) return false;
    const Stop* const stop = stop_with_keyboard(ui);
    if (stop == nullptr || !stop->second.takes_arrows) return false;
    return is_key_down(key::right) || is_key_down(key::left) || is_key_down(key::up) ||
           is_key_down(key::down);
}

bool belongs_to_focus(const Ui& ui, const Chord& chord) {
    if (!ui.focus.is_shown || chord.ctrl || chord.alt) return false;
    const auto found = ui.widgets.find(ui.focus.name);
    if (found == ui.widgets.end() || found->second.id == 0) return false;
    if (found->second.is_input && key::writes(chord.key)) return true;
    if (chord.key == key::space) return can_be_pressed(found->second);
    const bool zooms = chord.key == key::equal || chord.key == key::minus;
    return zooms && ui.focus.name == "canvas";
}

} // namespace rasterwalk
