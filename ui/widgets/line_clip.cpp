#include "ui/widgets/line_clip.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <imgui_internal.h>

namespace rasterwalk {

namespace {

/// Windows end at whole pixels.
constexpr float rounding = 1.0f;

/// The edges of a window that scrolls, while its content is drawn. Screen pixels.
struct LineClip {
    ImGuiID window = 0;
    int first_command = 0; ///< of the window's draw list, the one that the content begins with
    float top = 0.0f, bottom = 0.0f; ///< the window's edges
    float begin = 0.0f, end = 0.0f; ///< beyond these nothing is shown, because an edge would cut it
    float lowest = 0.0f;            ///< end of everything to be kept whole
    float room = 0.0f;              ///< the height that the window may have
    float rest_end = 0.0f; ///< the value of `end` in such a window while it is not scrolled
    float kept_top = 0.0f, kept_bottom = 0.0f; ///< of what was kept whole last
};

/// Of the windows being drawn; the last is the innermost.
std::vector<LineClip> open_windows;

/// Does the current window end with whole lines?
bool has_lines() {
    return !open_windows.empty() && open_windows.back().window == ImGui::GetCurrentWindow()->ID;
}

/// Those of the current window; null if it does not end with whole lines.
LineClip* lines_of_window() {
    return has_lines() ? &open_windows.back() : nullptr;
}

/// May a box this high be shown in part? If it takes more than half of the window, unless it is
/// only a few lines that the window can hold.
bool fills_window(float height) {
    constexpr float few_lines = 5.0f;
    const float window = page_room();
    return height > std::max(0.5f * window, std::min(window, few_lines * ImGui::GetFontSize()));
}

} // namespace

void begin_line_clip(float room) {
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
    open_windows.push_back(
        {window->ID, list->CmdBuffer.Size - 1, top, bottom, top, bottom, top, room, top + room});
}

void keep_beginning(float top, float bottom) {
    LineClip* const lines = lines_of_window();
    if (lines == nullptr) return;
    lines->lowest = std::max(lines->lowest, bottom);
    if (fills_window(bottom - top)) return;
    const auto begin_of_cut = [&](float begin, float end, float edge, float otherwise) {
        const bool is_cut = begin < edge && end > edge + rounding && begin >= lines->top;
        return is_cut ? std::min(otherwise, std::floor(begin)) : otherwise;
    };
    const float scrolled = ImGui::GetScrollY();
    lines->end = begin_of_cut(top, bottom, lines->bottom, lines->end);
    lines->rest_end =
        begin_of_cut(top + scrolled, bottom + scrolled, lines->top + lines->room, lines->rest_end);
}

void clip_range_to_lines(float top, float bottom) {
    keep_beginning(top, bottom);
    LineClip* const lines = lines_of_window();
    if (lines == nullptr) return;
    const bool is_cut = top < lines->top - rounding && bottom > lines->top;
    if (is_cut && !fills_window(bottom - top))
        lines->begin = std::max(lines->begin, std::ceil(bottom));
    lines->kept_top = top;
    lines->kept_bottom = bottom;
}

void clip_to_lines() {
    clip_range_to_lines(ImGui::GetItemRectMin().y, ImGui::GetItemRectMax().y);
}

void keep_selectable_whole() {
    const float spacing = ImGui::GetStyle().ItemSpacing.y, above = std::floor(0.5f * spacing);
    clip_range_to_lines(ImGui::GetItemRectMin().y + above,
                        ImGui::GetItemRectMax().y - spacing + above);
}

void keep_item_whole_unless_in_parts() {
    const LineClip* const lines = lines_of_window();
    if (lines == nullptr) return;
    const bool has_parts = lines->kept_top >= ImGui::GetItemRectMin().y &&
                           lines->kept_bottom <= ImGui::GetItemRectMax().y;
    if (!has_parts) clip_to_lines();
}

void clip_text_to_lines() {
    if (!has_lines()) return;
    const float line = ImGui::GetFontSize(), bottom = ImGui::GetItemRectMax().y;
    for (float top = ImGui::GetItemRectMin().y; top + 0.5f * line < bottom; top += line)
        clip_range_to_lines(top, top + line);
}

ShownLines shown_lines() {
    if (open_windows.empty()) return {};
    const LineClip& lines = open_windows.back();
    return {lines.begin, lines.end};
}

float whole_height() {
    const LineClip& lines = open_windows.back();
    return lines.rest_end - lines.top;
}

float page_room() {
    return has_lines() ? open_windows.back().room : ImGui::GetWindowHeight();
}

bool is_cut_off() {
    if (open_windows.empty()) return false;
    const LineClip& lines = open_windows.back();
    return lines.lowest > lines.bottom + rounding;
}

void end_line_clip() {
    const LineClip lines = open_windows.back();
    open_windows.pop_back();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    for (int i = lines.first_command; i < list->CmdBuffer.Size; ++i) {
        ImVec4& clip = list->CmdBuffer[i].ClipRect;
        clip.y = std::min(std::max(clip.y, lines.begin), clip.w);
        clip.w = std::max(std::min(clip.w, lines.end), clip.y);
    }
    list->AddDrawCmd();
}

} // namespace rasterwalk
