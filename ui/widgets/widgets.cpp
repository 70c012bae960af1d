#include "ui/widgets/widgets.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <optional>

#include <imgui_internal.h>

#include "base/numbers.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/line_clip.h"

namespace rasterwalk {

namespace {

const char* begin(std::string_view text) {
    return text.data();
}
const char* end(std::string_view text) {
    return text.data() + text.size();
}

struct Card {
    ImVec2 start;
    float width;
};
// Cards do not nest.
Card open_card;

/// A place for something of this size below an item, above it, or at a side, within the window;
/// none if there is no room.
/// @param aside the sides are tried first
std::optional<ImVec2> place_next_to(bool aside, const ImRect& item, ImVec2 size, float gap) {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 window = io.DisplaySize;
    const auto along = [&](float pointer, float low, float length, float room) {
        return std::max(std::min(std::max(low, pointer - 4.0f * gap), room - length), 0.0f);
    };
    const float x = along(io.MousePos.x, item.Min.x, size.x, window.x);
    const float y = along(io.MousePos.y, item.Min.y, size.y, window.y);
    const ImVec2 places[] = {{x, item.Max.y + gap},
                             {x, item.Min.y - gap - size.y},
                             {item.Max.x + gap, y},
                             {item.Min.x - gap - size.x, y}};
    const std::array<int, 4> order = aside ? std::array{2, 3, 0, 1} : std::array{0, 1, 2, 3};
    for (const int i : order) {
        const ImVec2 low = places[i];
        const bool is_inside = low.x >= 0.0f && low.y >= 0.0f && low.x + size.x <= window.x &&
                               low.y + size.y <= window.y;
        if (is_inside) return low;
    }
    return std::nullopt;
}

/// Outlines the widget that a lesson points at, and scrolls to it if necessary.
/// @param is_cut above or below, although it would fit
void outline_if_pointed_at(Ui& ui, std::string_view name, const ImRect& shown, bool visible,
                           bool is_cut) {
    LessonView& lesson = ui.lesson;
    if (lesson.pointed_at.empty() || lesson.pointed_at != name) return;
    lesson.frames_hidden = 0;
    const bool is_scrolling = ImGui::GetIO().MouseWheel != 0.0f;
    if (lesson.is_pinned && (!visible || is_cut) && !is_scrolling) scroll_here(0.5f);
    if (!visible) return;
    const float u = ui.options.text_scale;
    const ImVec4& colour = palette(ui.options.theme).changed;
    ImDrawList* const list = ImGui::GetForegroundDrawList();
    // At the border of the window it stays inside.
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const auto outline = [&](float gap, float alpha, float corner, float thickness) {
        const float inside = 0.5f * thickness;
        list->AddRect({std::max(shown.Min.x - gap, inside), std::max(shown.Min.y - gap, inside)},
                      {std::min(shown.Max.x + gap, window.x - inside),
                       std::min(shown.Max.y + gap, window.y - inside)},
                      packed(colour, alpha), corner, 0, thickness);
    };
    outline(6.0f * u, 0.35f, 8.0f * u, 3.0f * u);
    outline(3.0f * u, 1.0f, 6.0f * u, 2.0f * u);
}

} // namespace

void register_widget(Ui& ui, std::string_view name, std::string_view tooltip,
                     std::string_view text) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImRect shown(low, high);
    shown.ClipWith(ImGui::GetCurrentWindow()->ClipRect);
    const bool visible = shown.GetWidth() >= 1.0f && shown.GetHeight() >= 1.0f;
    // Half of the space around items belongs to those that can be selected: it may be cut off.
    const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
    const bool is_whole =
        shown.Min.x <= low.x + 0.5f * spacing.x && shown.Min.y <= low.y + 0.5f * spacing.y &&
        shown.Max.x >= high.x - 0.5f * spacing.x && shown.Max.y >= high.y - 0.5f * spacing.y;
    WidgetPlace place{shown.Min, shown.Max, visible, is_whole, !tooltip.empty(), std::string(text)};
    place.order = static_cast<int>(ui.widgets.size());
    record_stop(place);
    ui.widgets[std::string(name)] = place;
    keep_item_whole_unless_in_parts();
    const bool is_explained = show_focus(ui, name, shown, visible) && ui.focus.is_explained;
    // A line that is cut off by more than a pixel may be left out, see line_clip.h.
    const bool is_cut = (shown.Min.y > low.y + 1.0f || shown.Max.y < high.y - 1.0f) &&
                        high.y - low.y < ImGui::GetWindowHeight();
    outline_if_pointed_at(ui, name, shown, visible, is_cut);
    // Not over a button that is held: the tooltip would cover what the drag changes.
    const bool is_pointed_at =
        ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && !ImGui::IsMouseDown(0);
    if (!tooltip.empty() && (is_pointed_at || is_explained)) draw_tooltip(ui, tooltip);
}

void draw_tooltip(const Ui& ui, std::string_view text) {
    const float letter = ImGui::GetFontSize();
    const float widest = std::min(24.0f * letter, 0.8f * ImGui::GetIO().DisplaySize.x);
    const std::string lines = broken_into_lines(text, widest);
    const ImVec2 words = ImGui::CalcTextSize(lines.c_str(), nullptr, false, widest);
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    ImRect item(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    item.ClipWith(ImGui::GetCurrentWindow()->ClipRect);
    // In a menu or list the other entries are read too.
    const ImGuiWindow* const window = ImGui::GetCurrentWindow();
    const bool is_entry =
        (window->Flags & (ImGuiWindowFlags_Popup | ImGuiWindowFlags_ChildMenu)) != 0 &&
        (window->Flags & ImGuiWindowFlags_Modal) == 0;
    if (is_entry) {
        item.Min.x = window->Pos.x;
        item.Max.x = window->Pos.x + window->Size.x;
    }
    const std::optional<ImVec2> place =
        place_next_to(is_entry, item, {words.x + 2.0f * padding.x, words.y + 2.0f * padding.y},
                      6.0f * ui.options.text_scale);
    if (place && item.GetHeight() <= 8.0f * letter) ImGui::SetNextWindowPos(*place);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + widest);
    ImGui::TextUnformatted(lines.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void register_text(Ui& ui, std::string_view name, std::string_view text) {
    ui.widgets.at(std::string(name)).text = text;
}

bool button(Ui& ui, std::string_view name, std::string_view label, Look look,
            std::string_view tooltip, ImVec2 size) {
    const Palette& p = palette(ui.options.theme);
    const ImVec4 none(0, 0, 0, 0);
    const bool bare = look == Look::outline || look == Look::quiet || look == Look::link;
    ImGui::PushStyleColor(ImGuiCol_Button, look == Look::main     ? p.accent
                                           : look == Look::chosen ? p.chosen
                                           : bare                 ? none
                                                                  : p.button);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, look == Look::main     ? p.accent
                                                  : look == Look::chosen ? p.chosen
                                                                         : p.button_hovered);
    ImGui::PushStyleColor(ImGuiCol_Text, look == Look::main   ? p.accent_text
                                         : look == Look::link ? p.link
                                                              : p.text);
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        look == Look::link ? ImVec2(2.0f, padding.y) : padding);
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, look == Look::outline ? 1.0f : 0.0f);
    const std::string id = std::string(label) + "###" + std::string(name);
    const bool pressed = ImGui::Button(id.c_str(), size);
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor(3);
    register_widget(ui, name, tooltip);
    return pressed;
}

void put_text(std::string_view text, ImFont* font) {
    if (font != nullptr) ImGui::PushFont(font);
    ImGui::TextUnformatted(begin(text), end(text));
    clip_text_to_lines();
    if (font != nullptr) ImGui::PopFont();
}

void text_in(const ImVec4& colour, std::string_view text, ImFont* font) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    put_text(text, font);
    ImGui::PopStyleColor();
}

std::string broken_into_lines(std::string_view text, float width) {
    std::string lines;
    std::size_t line_start = 0; // in lines
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t word = std::min(text.find_first_of(" \n", at), text.size());
        const std::string_view next = text.substr(at, word - at);
        const std::size_t line_end = lines.size();
        if (line_end > line_start) lines += ' ';
        lines.append(next);
        const bool is_too_long =
            ImGui::CalcTextSize(lines.data() + line_start, lines.data() + lines.size()).x > width;
        if (line_end > line_start && is_too_long) {
            lines[line_end] = '\n';
            line_start = line_end + 1;
        }
        if (word < text.size() && text[word] == '\n') {
            lines += '\n';
            line_start = lines.size();
        }
        at = word + 1;
    }
    return lines;
}

void wrapped_text(std::string_view text, ImFont* font) {
    if (text.empty()) return;
    if (font != nullptr) ImGui::PushFont(font);
    const float wrap_at = ImGui::GetCurrentWindow()->DC.TextWrapPos;
    const float width =
        wrap_at > 0.0f ? wrap_at - ImGui::GetCursorPosX() : ImGui::GetContentRegionAvail().x;
    // A single word that is too long is still broken by ImGui.
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    put_text(broken_into_lines(text, width));
    ImGui::PopTextWrapPos();
    if (font != nullptr) ImGui::PopFont();
}

void wrapped_text_in(const ImVec4& colour, std::string_view text, ImFont* font) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    wrapped_text(text, font);
    ImGui::PopStyleColor();
}

void right_aligned(std::string_view text, const ImVec4& colour, ImFont* font) {
    if (font != nullptr) ImGui::PushFont(font);
    const float width = ImGui::CalcTextSize(begin(text), end(text)).x;
    const float room = ImGui::GetContentRegionAvail().x;
    if (room > width) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - width);
    text_in(colour, text);
    if (font != nullptr) ImGui::PopFont();
}

void draw_box_around(const Ui& ui, ImDrawList* list, ImVec2 low, ImVec2 high,
                     const ImVec4& colour) {
    const float u = ui.options.text_scale;
    list->AddRect({low.x - 2.0f * u, low.y - 1.0f * u}, {high.x + 2.0f * u, high.y + 1.0f * u},
                  packed(colour), 3.0f * u, 0, 1.5f * u);
}

void draw_current_bar(const Ui& ui, ImDrawList* list, ImVec2 low, float bottom) {
    list->AddRectFilled(low, {low.x + 3.0f * ui.options.text_scale, bottom},
                        packed(colour_of(Meaning::current, ui.options.theme)));
}

void draw_difference_mark(ImDrawList* list, ImVec2 centre, float radius, ImU32 colour) {
    list->AddQuadFilled({centre.x - radius, centre.y}, {centre.x, centre.y - radius},
                        {centre.x + radius, centre.y}, {centre.x, centre.y + radius}, colour);
}

float difference_key_indent(const Ui& ui) {
    return 16.0f * ui.options.text_scale;
}

void draw_difference_key(Ui& ui, std::string_view words) {
    const float u = ui.options.text_scale;
    const float left = ImGui::GetCursorScreenPos().x;
    ImGui::BeginGroup();
    const float indent = difference_key_indent(ui);
    ImGui::Indent(indent);
    ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.options.theme).dim);
    wrapped_text(words);
    draw_difference_mark(
        ImGui::GetWindowDrawList(),
        {left + 5.0f * u, ImGui::GetItemRectMin().y + 0.5f * ImGui::GetTextLineHeight()}, 4.5f * u,
        packed(colour_of(Meaning::fail, ui.options.theme)));
    ImGui::PopStyleColor();
    ImGui::Unindent(indent);
    ImGui::EndGroup();
}

void begin_card(Ui& ui, float width) {
    const ImVec2 padding{12.0f * ui.options.text_scale, 10.0f * ui.options.text_scale};
    open_card.start = ImGui::GetCursorScreenPos();
    open_card.width = width > 0.0f ? width : ImGui::GetContentRegionAvail().x;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->ChannelsSplit(2);
    list->ChannelsSetCurrent(1);
    ImGui::SetCursorScreenPos({open_card.start.x + padding.x, open_card.start.y + padding.y});
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + open_card.width - 2.0f * padding.x);
    ImGui::PushItemWidth(open_card.width - 2.0f * padding.x);
}

void end_card(Ui& ui) {
    const ImVec2 padding{12.0f * ui.options.text_scale, 10.0f * ui.options.text_scale};
    ImGui::PopItemWidth();
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
    const float bottom = ImGui::GetItemRectMax().y + padding.y;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->ChannelsSetCurrent(0);
    list->AddRectFilled(open_card.start, {open_card.start.x + open_card.width, bottom},
                        packed(palette(ui.options.theme).card), 5.0f * ui.options.text_scale);
    list->ChannelsMerge();
    ImGui::SetCursorScreenPos({open_card.start.x, bottom + ImGui::GetStyle().ItemSpacing.y});
    ImGui::Dummy({0, 0});
}

std::string fixed(double value, int digits) {
    if (!std::isfinite(value)) {
        return std::isnan(value) ? "not a number" : value > 0 ? "+∞" : "−∞";
    }
    const double size = std::abs(value);
    const std::string text = size >= 1e6 ? scientific(size, 2) : decimals(size, digits);
    // A negative number that rounds to zero is shown without its sign.
    const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
    return (value < 0 && !is_zero ? "−" : "") + text;
}

bool scroll_to_line(int line, float height) {
    const float lines = std::floor(ImGui::GetWindowHeight() / height);
    const float first = static_cast<float>(line) - std::floor(0.5f * lines);
    const float wished = std::max(first, 0.0f) * height;
    ImGui::SetScrollY(wished);
    return std::abs(ImGui::GetScrollY() - wished) < 1.0f;
}

std::string shortened(const std::string& text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    std::size_t length = text.size();
    while (length > 0) {
        --length;
        // Not within a character of several bytes.
        if ((static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) continue;
        const std::string cut = text.substr(0, length) + "…";
        if (ImGui::CalcTextSize(cut.c_str()).x <= width) return cut;
    }
    return "…";
}

std::string shortened_to_words(const std::string& text, float width) {
    if (text_width(text) <= width) return text;
    std::size_t end = text.size();
    while ((end = text.find_last_of(' ', end - 1)) != std::string::npos && end > 0) {
        const std::size_t word = text.find_last_not_of(" ,;:", end);
        const std::string cut = text.substr(0, word == std::string::npos ? 0 : word + 1) + " …";
        if (text_width(cut) <= width) return cut;
    }
    return shortened(text, width);
}

bool list_entry(Ui& ui, std::string_view name, std::string_view label, bool is_chosen,
                std::string_view tooltip) {
    const bool is_pressed = ImGui::Selectable(std::string(label).c_str(), is_chosen);
    register_widget(ui, name, tooltip);
    ui.widgets[std::string(name)].is_chosen = is_chosen;
    return is_pressed;
}

float text_width(std::string_view text) {
    return text.empty() ? 0.0f : ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

float text_width(const ImFont* font, std::string_view text, float size) {
    if (text.empty()) return 0.0f;
    return font
        ->CalcTextSizeA(size > 0.0f ? size : font->FontSize, FLT_MAX, 0.0f, begin(text), end(text))
        .x;
}

std::string first_fitting(const std::vector<std::string>& forms, float width) {
    for (const std::string& form : forms) {
        if (form.empty() || text_width(form) <= width) return form;
    }
    return forms.empty() ? std::string() : shortened(forms.back(), width);
}

float right_end() {
    return ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
}

float button_width(std::string_view label) {
    return ImGui::CalcTextSize(begin(label), end(label)).x +
           2.0f * ImGui::GetStyle().FramePadding.x;
}

void same_line_if_room(std::string_view label, float gap) {
    const float between = gap < 0.0f ? ImGui::GetStyle().ItemSpacing.x : gap;
    if (ImGui::GetItemRectMax().x + between + button_width(label) <= right_end())
        ImGui::SameLine(0.0f, between);
}

} // namespace rasterwalk
