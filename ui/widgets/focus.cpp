#include "ui/widgets/focus.h"

#include <utility>

#include "ui/ui.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

ImGuiID part_of(const ImGuiWindow& window) {
    const ImGuiWindow* at = &window;
    const auto is_inside = [](const ImGuiWindow* w) {
        return (w->Flags & ImGuiWindowFlags_ChildWindow) != 0 &&
               (w->Flags & ImGuiWindowFlags_Popup) == 0 && w->ParentWindow != nullptr;
    };
    while (is_inside(at))
        at = at->ParentWindow;
    return at->ID;
}

void record_stop(WidgetPlace& place) {
    const ImGuiLastItemData& item = GImGui->LastItemData;
    place.part = part_of(*ImGui::GetCurrentWindow());
    // While a list is open, the last item is the list itself.
    const bool is_window = item.ID == ImGui::GetCurrentWindow()->MoveId;
    if (is_window || (item.InFlags & ImGuiItemFlags_Disabled) != 0) return;
    place.id = item.ID;
    place.is_input = (item.InFlags & ImGuiItemFlags_Inputable) != 0;
}

bool show_focus(Ui& ui, std::string_view name, const ImRect& shown, bool visible) {
    Focus& focus = ui.focus;
    const ImGuiLastItemData& item = GImGui->LastItemData;
    // After a click into a field, the keyboard continues from there.
    const bool is_typed_into = item.ID != 0 && item.ID == GImGui->ActiveId &&
                               (item.InFlags & ImGuiItemFlags_Inputable) != 0;
    if (is_typed_into) focus.name = name;
    if (focus.name != name) return false;
    focus.place = item.Rect.Min;
    focus.part = part_of(*ImGui::GetCurrentWindow());
    focus.window = ImGui::GetCurrentWindow()->ID;
    if (focus.wants_sight && item.ID != 0) {
        focus.wants_sight = false;
        // Together with a line around it: the next item of a long list is drawn only if it is in
        // view.
        ImRect wished = item.Rect;
        wished.Expand(ImGui::GetTextLineHeightWithSpacing());
        ImGui::ScrollToBringRectIntoView(ImGui::GetCurrentWindow(), wished);
    }
    if (!focus.is_shown || item.ID == 0) return false;
    if (!visible) return false;
    focus.list = ImGui::GetWindowDrawList();
    focus.low = shown.Min;
    focus.high = shown.Max;
    return true;
}

void draw_ring(Ui& ui) {
    Focus& focus = ui.focus;
    ImDrawList* const list = std::exchange(focus.list, nullptr);
    if (list == nullptr) return;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    // At the edge of the window the ring is drawn inside.
    ImRect ring(focus.low.x - 2.0f * u, focus.low.y - 2.0f * u, focus.high.x + 2.0f * u,
                focus.high.y + 2.0f * u);
    ring.ClipWith({{u, u}, {window.x - u, window.y - u}});
    list->PushClipRectFullScreen();
    // The casing on both sides makes it stand out on every ground.
    list->AddRect(ring.Min, ring.Max, packed(p.ground), 5.0f * u, 0, 5.0f * u);
    list->AddRect(ring.Min, ring.Max, packed(p.link), 5.0f * u, 0, 2.0f * u);
    list->PopClipRect();
}

Arrows take_arrows(Ui& ui, std::string_view name) {
    ui.widgets.at(std::string(name)).takes_arrows = true;
    const bool is_meant = ui.focus.is_shown && ui.focus.name == name;
    return is_meant ? ui.focus.arrows : Arrows{};
}

void give_focus(Ui& ui, std::string name) {
    Focus& focus = ui.focus;
    // It waits until the menu or list that it was chosen from closes.
    std::string& now = focus.openers.empty() ? focus.name : focus.openers.front();
    focus.before = std::exchange(now, std::move(name));
    focus.wants_sight = true;
}

bool is_pressed_by_key() {
    const ImGuiID id = GImGui->LastItemData.ID;
    return id != 0 && GImGui->NavActivateId == id;
}

void keep_letters(std::vector<std::uint32_t>& early) {
    ImVector<ImWchar>& letters = ImGui::GetIO().InputQueueCharacters;
    early.insert(early.end(), letters.begin(), letters.end());
    letters.clear();
}

void hand_over_letters(std::vector<std::uint32_t>& early) {
    ImVector<ImWchar>& letters = ImGui::GetIO().InputQueueCharacters;
    for (std::size_t i = 0; i < early.size(); ++i) {
        letters.insert(letters.begin() + i, static_cast<ImWchar>(early[i]));
    }
    early.clear();
}

} // namespace rasterwalk
