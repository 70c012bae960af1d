#include "ui/actions/focus_stops.h"

#include <algorithm>

#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// The menu or list on top.
struct OpenList {
    bool is_open = false;
    const ImGuiWindow* window = nullptr; ///< null before it is drawn
};

OpenList open_list() {
    const ImVector<ImGuiPopupData>& popups = GImGui->OpenPopupStack;
    if (popups.empty()) return {};
    return {true, popups.back().Window};
}

bool is_stop_of(const OpenList& list, const WidgetPlace& place) {
    if (place.id == 0) return false;
    return !list.is_open || (list.window != nullptr && list.window->ID == place.part);
}

/// The window of an open sheet; null for any other part.
const ImGuiWindow* sheet_of(const Ui& ui, ImGuiID part) {
    for (std::size_t i = 0; i < sheet_count; ++i) {
        if (ui.sheets.open[i] && ui.sheets.parts[i] == part) return ImGui::FindWindowByID(part);
    }
    return nullptr;
}

} // namespace

const ImGuiWindow* sheet_over(const Ui& ui, ImGuiID part, const ImRect& place) {
    if (open_list().is_open) return nullptr; // it lies over all sheets
    const ImGuiWindow* const own = sheet_of(ui, part);
    for (std::size_t i = 0; i < sheet_count; ++i) {
        const ImGuiID id = ui.sheets.parts[i];
        const ImGuiWindow* const sheet = ui.sheets.open[i] ? ImGui::FindWindowByID(id) : nullptr;
        if (sheet == nullptr || sheet == own || !sheet->WasActive) continue;
        const bool is_above = own == nullptr || sheet->FocusOrder > own->FocusOrder;
        if (is_above && sheet->Rect().Contains(place)) return sheet;
    }
    return nullptr;
}

const ImGuiWindow* sheet_over(const Ui& ui, const WidgetPlace& widget) {
    ImRect place(widget.top_left, widget.bottom_right);
    const ImGuiWindow* const part = ImGui::FindWindowByID(widget.part);
    if (!widget.visible && part != nullptr) place.Min.y = place.Max.y = part->Rect().GetCenter().y;
    return sheet_over(ui, widget.part, place);
}

const Stop* stop_with_keyboard(const Ui& ui) {
    const auto found = ui.widgets.find(ui.focus.name);
    if (found == ui.widgets.end() || !is_stop_of(open_list(), found->second)) return nullptr;
    return &*found;
}

std::vector<const Stop*> stops_in_reach(const Ui& ui) {
    const OpenList list = open_list();
    std::vector<const Stop*> stops;
    for (const Stop& stop : ui.widgets) {
        const WidgetPlace& place = stop.second;
        if (is_stop_of(list, place) && sheet_over(ui, place) == nullptr) stops.push_back(&stop);
    }
    std::sort(stops.begin(), stops.end(),
              [](const Stop* a, const Stop* b) { return a->second.order < b->second.order; });
    return stops;
}

std::vector<const Stop*> stops_of_tab(const Ui& ui) {
    std::vector<const Stop*> stops = stops_in_reach(ui);
    const Stop* const now = stop_with_keyboard(ui);
    const ImGuiWindow* const sheet = now == nullptr ? nullptr : sheet_of(ui, now->second.part);
    std::erase_if(stops, [&](const Stop* s) { return sheet_of(ui, s->second.part) != sheet; });
    return stops;
}

} // namespace rasterwalk
