#include "ui/hand/hand.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <utility>

#include <imgui_internal.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

const ImVec2 nowhere{-FLT_MAX, -FLT_MAX};
constexpr int largest_list = 12;

void set_modifiers(Modifiers modifiers) {
    play_modifiers(modifiers.ctrl, modifiers.shift, modifiers.alt);
}

/// What a key writes into a field; nothing if it is not a letter, digit or sign, or is held with
/// others.
std::string written_by(int key, Modifiers modifiers) {
    if (modifiers.ctrl || modifiers.alt || key < key::space || key > key::right_bracket) return {};
    const bool is_letter = key >= 'A' && key <= 'Z';
    if (is_letter && !modifiers.shift) return {static_cast<char>(key - 'A' + 'a')};
    return is_letter || !modifiers.shift ? std::string(1, static_cast<char>(key)) : std::string();
}

/// How many letters two names share at the beginning.
std::size_t common_start(std::string_view a, std::string_view b) {
    return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first -
                                    a.begin());
}

/// The whole screen coordinate nearest to the middle of a picture's column or row; none if no whole
/// one lies in it. ImGui drops the fraction of the pointer's position.
std::optional<float> screen_middle(int pixel, float origin, float scale) {
    const float middle = std::floor(origin + scale * (static_cast<float>(pixel) + 0.5f));
    for (const float candidate : {middle, middle + 1.0f}) {
        if (std::floor((candidate - origin) / scale) == static_cast<float>(pixel)) return candidate;
    }
    return std::nullopt;
}

/// A window that can be scrolled, by its number, because scrolling may make and end windows.
struct Scrollable {
    ImGuiID id;
    ImVec2 scroll;
};

std::vector<Scrollable> scrollable_windows() {
    std::vector<Scrollable> found;
    for (const ImGuiWindow* const window : GImGui->Windows) {
        if (window->WasActive && !window->Hidden &&
            (window->ScrollMax.x > 0.0f || window->ScrollMax.y > 0.0f)) {
            found.push_back({window->ID, window->Scroll});
        }
    }
    return found;
}

/// All corners of the last frame: where, in which colour, with which piece of a texture.
std::string drawn_corners() {
    std::string bytes;
    const ImDrawData* const drawn = ImGui::GetDrawData();
    for (int i = 0; drawn != nullptr && i < drawn->CmdListsCount; ++i) {
        const ImVector<ImDrawVert>& corners = drawn->CmdLists[i]->VtxBuffer;
        bytes.append(reinterpret_cast<const char*>(corners.Data),
                     static_cast<std::size_t>(corners.size_in_bytes()));
    }
    return bytes;
}

} // namespace

Hand::Hand(Ui& with, std::function<void()> build) : ui_(with), build_frame_(std::move(build)) {}

void Hand::frames(int count, float seconds) {
    for (int i = 0; i < count; ++i) {
        ImGui::GetIO().DeltaTime = seconds;
        build_frame_();
    }
}

void Hand::rest() {
    constexpr int least = frames_to_rest - 1;
    frames(least - 1);
    const std::string before = drawn_corners();
    frames(1);
    if (drawn_corners() != before) frames(frames_to_rest - least);
}

void Hand::move_to(ImVec2 place) {
    play_pointer(place);
    // ImGui finds the window under the pointer in one frame and the widget in the next.
    frames(2);
}

void Hand::press_mouse(int mouse_button, Modifiers modifiers, int times) {
    set_modifiers(modifiers);
    // The previous click, whenever it was, must not make this one a double click.
    ImGui::GetIO().MouseClickedTime[mouse_button] = -DBL_MAX;
    for (int i = 0; i < times; ++i) {
        play_mouse_button(mouse_button, true);
        frames(1);
        play_mouse_button(mouse_button, false);
        frames(1);
    }
    set_modifiers({});
    frames(frames_to_rest); // what a click opens may still be unseen when nothing moves
}

void Hand::drag_to(ImVec2 from, ImVec2 to, Modifiers modifiers, int mouse_button) {
    move_to(from);
    set_modifiers(modifiers);
    ImGui::GetIO().MouseClickedTime[mouse_button] = -DBL_MAX;
    play_mouse_button(mouse_button, true);
    frames(1);
    constexpr int steps = 4;
    for (int i = 1; i <= steps; ++i) {
        const float t = static_cast<float>(i) / steps;
        play_pointer({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
        frames(1);
    }
    play_mouse_button(mouse_button, false);
    frames(1);
    set_modifiers({});
    frames(frames_to_rest);
}

void Hand::hover(std::string_view name) {
    move_to(middle_of(name));
    rest();
}

void Hand::click(std::string_view name, Modifiers modifiers, int mouse_button) {
    move_to(middle_of(name));
    press_mouse(mouse_button, modifiers);
}

void Hand::double_click(std::string_view name) {
    move_to(middle_of(name));
    press_mouse(0, {}, 2);
}

void Hand::drag(std::string_view name, float dx, float dy, Modifiers modifiers, int mouse_button) {
    const ImVec2 from = middle_of(name);
    drag_to(from, {from.x + dx, from.y + dy}, modifiers, mouse_button);
}

void Hand::wheel(std::string_view name, float steps, Modifiers modifiers) {
    move_to(middle_of(name));
    set_modifiers(modifiers);
    play_wheel(steps);
    frames(1);
    set_modifiers({});
    rest();
}

void Hand::leave() {
    play_pointer(nowhere);
    rest();
}

void Hand::press(int key, Modifiers modifiers) {
    hold(key, 1, modifiers);
}

void Hand::hold(int key, int count, Modifiers modifiers) {
    set_modifiers(modifiers);
    play_key(key, true);
    ImGui::GetIO().AddInputCharactersUTF8(written_by(key, modifiers).c_str());
    frames(count);
    play_key(key, false);
    set_modifiers({});
    rest();
}

void Hand::type_text(std::string_view text) {
    ImGui::GetIO().AddInputCharactersUTF8(std::string(text).c_str());
    rest();
}

void Hand::enter(std::string_view name, std::string_view text) {
    click(name);
    if (!ImGui::GetIO().WantTextInput) click(name, {.ctrl = true});
    if (!ImGui::GetIO().WantTextInput) {
        throw UsageError("Nothing can be typed into '" + std::string(name) + "'.");
    }
    press('A', {.ctrl = true});
    press(key::del);
    type_text(text);
    press(key::enter);
}

ImVec2 Hand::pixel_middle(int column, int row) {
    const WidgetPlace canvas = find("canvas");
    const PicturePlace& place = ui_.canvas.place;
    const std::string pixel = "Pixel " + std::to_string(column) + "," + std::to_string(row);
    const std::optional<float> x = screen_middle(column, place.origin.x, place.scale);
    const std::optional<float> y = screen_middle(row, place.origin.y, place.scale);
    if (!x || !y) {
        throw UsageError(pixel + " cannot be pointed at because the picture is shown smaller than "
                                 "it is; zoom in.");
    }
    if (*x < canvas.top_left.x || *x >= canvas.bottom_right.x || *y < canvas.top_left.y ||
        *y >= canvas.bottom_right.y) {
        throw UsageError(pixel + " is not on the screen: zoom out or move the picture.");
    }
    return {*x, *y};
}

void Hand::hover_picture(int column, int row) {
    move_to(pixel_middle(column, row));
    rest();
}

void Hand::click_picture(int column, int row, Modifiers modifiers) {
    move_to(pixel_middle(column, row));
    press_mouse(0, modifiers);
}

void Hand::double_click_picture(int column, int row) {
    move_to(pixel_middle(column, row));
    press_mouse(0, {}, 2);
}

void Hand::drag_picture(int column, int row, int to_column, int to_row, Modifiers modifiers) {
    const ImVec2 from = pixel_middle(column, row);
    drag_to(from, pixel_middle(to_column, to_row), modifiers, 0);
}

void Hand::wheel_picture(int column, int row, float steps) {
    move_to(pixel_middle(column, row));
    play_wheel(steps);
    frames(1);
    rest();
}

bool Hand::is_visible(std::string_view name) const {
    const auto found = ui_.widgets.find(std::string(name));
    return found != ui_.widgets.end() && found->second.visible;
}

WidgetPlace Hand::find(std::string_view name) {
    if (ui_.widgets.empty()) frames(1);
    if (!is_visible(name) && !scroll_into_view(name)) throw UsageError(not_found(name));
    if (!ui_.widgets.at(std::string(name)).is_whole) scroll_until_uncut(name);
    return ui_.widgets.at(std::string(name));
}

/// Brings the rest of a widget that is partly in view into view too, if scrolling a window can.
void Hand::scroll_until_uncut(std::string_view name) {
    const auto scroll_to = [&](ImGuiID id, float y) {
        ImGuiWindow* const window = ImGui::FindWindowByID(id);
        if (window == nullptr) return;
        ImGui::SetScrollY(window, std::floor(std::clamp(y, 0.0f, window->ScrollMax.y)));
        frames(2);
    };
    const auto is_whole = [&] {
        const auto found = ui_.widgets.find(std::string(name));
        return found != ui_.widgets.end() && found->second.visible && found->second.is_whole;
    };
    for (const Scrollable& scrollable : scrollable_windows()) {
        const ImGuiWindow* const window = ImGui::FindWindowByID(scrollable.id);
        if (window == nullptr || window->ScrollMax.y <= 0.0f) continue;
        const float step = std::max(0.2f * window->InnerRect.GetHeight(), 8.0f);
        for (const int steps : {1, -1, 2, -2, 3, -3, 4, -4}) {
            scroll_to(scrollable.id, scrollable.scroll.y + static_cast<float>(steps) * step);
            if (is_whole()) return;
        }
        scroll_to(scrollable.id, scrollable.scroll.y);
    }
}

ImVec2 Hand::middle_of(std::string_view name) {
    const WidgetPlace place = find(name);
    return {0.5f * (place.top_left.x + place.bottom_right.x),
            0.5f * (place.top_left.y + place.bottom_right.y)};
}

/// Looks through every window that scrolls, because a long table draws only its visible rows: what
/// is scrolled away need not be registered at all.
bool Hand::scroll_into_view(std::string_view name) {
    for (const Scrollable& scrollable : scrollable_windows()) {
        ImVec2 target{0.0f, 0.0f};
        constexpr int most_pages = 300; // a window may grow as it is scrolled
        for (int page_number = 0; page_number < most_pages; ++page_number) {
            ImGuiWindow* const window = ImGui::FindWindowByID(scrollable.id);
            if (window == nullptr) break;
            const ImVec2 page{0.75f * std::max(window->InnerRect.GetWidth(), 24.0f),
                              0.75f * std::max(window->InnerRect.GetHeight(), 24.0f)};
            const ImVec2 end = window->ScrollMax;
            ImGui::SetScrollX(window, std::floor(std::min(target.x, end.x)));
            ImGui::SetScrollY(window, std::floor(std::min(target.y, end.y)));
            frames(2);
            if (is_visible(name)) return true;
            if (target.y < end.y) {
                target.y += page.y;
            } else if (target.x < end.x) {
                target = {target.x + page.x, 0.0f};
            } else {
                break;
            }
        }
        if (ImGuiWindow* const window = ImGui::FindWindowByID(scrollable.id)) {
            ImGui::SetScrollX(window, scrollable.scroll.x);
            ImGui::SetScrollY(window, scrollable.scroll.y);
            frames(2);
        }
    }
    return false;
}

std::vector<std::string> Hand::names() const {
    std::vector<std::string> all;
    for (const auto& [name, place] : ui_.widgets)
        all.push_back(name);
    std::sort(all.begin(), all.end());
    return all;
}

std::string Hand::not_found(std::string_view name) const {
    const std::string quoted = "'" + std::string(name) + "'";
    if (ui_.widgets.contains(std::string(name))) {
        return "The widget " + quoted + " cannot be seen and cannot be scrolled into view.";
    }
    std::vector<std::string> all = names();
    const std::vector<std::string_view> views(all.begin(), all.end());
    std::string sentence =
        "There is no widget " + quoted + " on the screen." + did_you_mean(name, views);
    std::stable_sort(all.begin(), all.end(), [&](const std::string& a, const std::string& b) {
        return common_start(a, name) > common_start(b, name);
    });
    std::string list;
    for (std::size_t i = 0; i < all.size() && i < largest_list; ++i)
        list.append(list.empty() ? "" : ", ").append(all[i]);
    if (all.size() > largest_list) list += ", ...";
    return sentence +
           (list.empty() ? " There are no widgets at all." : " There are: " + list + ".");
}

} // namespace rasterwalk
