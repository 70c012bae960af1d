#include "ui/widgets/whole_lines.h"

#include <algorithm>
#include <cmath>

#include <imgui_internal.h>

#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// Windows end at whole pixels.
constexpr float rounding = 1.0f;

/// Does the current window end with whole lines?
bool has_lines(const Ui& ui) {
    return !ui.whole_lines.empty() && ui.whole_lines.back().window == ImGui::GetCurrentWindow()->ID;
}

/// Those of the current window; null if it does not end with whole lines.
WholeLines* lines_of_window(Ui& ui) {
    return has_lines(ui) ? &ui.whole_lines.back() : nullptr;
}

/// May a box this high be shown in part? If it takes more than half of the window, unless it is
/// only a few lines that the window can hold.
bool fills_window(const Ui& ui, float height) {
    constexpr float few_lines = 5.0f;
    const float window = page_room(ui);
    return height > std::max(0.5f * window, std::min(window, few_lines * ImGui::GetFontSize()));
}

} // namespace

void begin_whole_lines(Ui& ui, float room) {
    const ImGuiWindow* const window = ImGui::GetCurrentWindow();
    // Everything drawn after this is clipped once it is known where it ends.
    ImDrawList* const list = window->DrawList;
    if (list->CmdBuffer.back().ElemCount > 0) list->AddDrawCmd();
    if (list->CmdBuffer.Size > 1) {
        // An empty command would be merged with the previous one.
        list->PrimReserve(6, 4);
        list->PrimRect(window->ClipRect.Min, window->ClipRect.Min, 0);
    }
    const float top = window->ClipRect.Min.y, bottom = window->ClipRect.Max.y;
    if (room <= 0.0f) room = window->Size.y;
    ui.whole_lines.push_back(
        {window->ID, list->CmdBuffer.Size - 1, top, bottom, top, bottom, top, room, top + room});
}

void keep_beginning(Ui& ui, float top, float bottom) {
    WholeLines* const lines = lines_of_window(ui);
    if (lines == nullptr) return;
    lines->lowest = std::max(lines->lowest, bottom);
    if (fills_window(ui, bottom - top)) return;
    const auto begin_of_cut = [&](float begin, float end, float edge, float otherwise) {
        const bool is_cut = begin < edge && end > edge + rounding && begin >= lines->top;
        return is_cut ? std::min(otherwise, std::floor(begin)) : otherwise;
    };
    const float scrolled = ImGui::GetScrollY();
    lines->end = begin_of_cut(top, bottom, lines->bottom, lines->end);
    lines->rest_end =
        begin_of_cut(top + scrolled, bottom + scrolled, lines->top + lines->room, lines->rest_end);
}

void keep_whole(Ui& ui, float top, float bottom) {
    keep_beginning(ui, top, bottom);
    WholeLines* const lines = lines_of_window(ui);
    if (lines == nullptr) return;
    const bool is_cut = top < lines->top - rounding && bottom > lines->top;
    if (is_cut && !fills_window(ui, bottom - top))
        lines->begin = std::max(lines->begin, std::ceil(bottom));
}

void keep_item_whole(Ui& ui) {
    keep_whole(ui, ImGui::GetItemRectMin().y, ImGui::GetItemRectMax().y);
}

void keep_text_whole(Ui& ui) {
    const float line = ImGui::GetFontSize(), bottom = ImGui::GetItemRectMax().y;
    for (float top = ImGui::GetItemRectMin().y; top + 0.5f * line < bottom; top += line)
        keep_whole(ui, top, top + line);
}

ShownLines shown_lines(const Ui& ui) {
    if (ui.whole_lines.empty()) return {};
    const WholeLines& lines = ui.whole_lines.back();
    return {lines.begin, lines.end};
}

float whole_height(const Ui& ui) {
    const WholeLines& lines = ui.whole_lines.back();
    return lines.rest_end - lines.top;
}

float page_room(const Ui& ui) {
    return has_lines(ui) ? ui.whole_lines.back().room : ImGui::GetWindowHeight();
}

bool is_cut_off(const Ui& ui) {
    if (ui.whole_lines.empty()) return false;
    const WholeLines& lines = ui.whole_lines.back();
    return lines.lowest > lines.bottom + rounding;
}

void end_whole_lines(Ui& ui) {
    const WholeLines lines = ui.whole_lines.back();
    ui.whole_lines.pop_back();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    for (int i = lines.first_command; i < list->CmdBuffer.Size; ++i) {
        ImVec4& clip = list->CmdBuffer[i].ClipRect;
        clip.y = std::min(std::max(clip.y, lines.begin), clip.w);
        clip.w = std::max(std::min(clip.w, lines.end), clip.y);
    }
    list->AddDrawCmd();
}

} // namespace rasterwalk
