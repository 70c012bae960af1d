#include "ui/widgets/imgui_versions.h"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>

#include <imgui_internal.h>

#include "ui/widgets/keys.h"
#include "ui/widgets/line_clip.h"

namespace rasterwalk {

namespace {

/// The keys that ImGui has names for in every version.
constexpr std::pair<int, ImGuiKey> named_keys[] = {
    {key::left, ImGuiKey_LeftArrow},      {key::right, ImGuiKey_RightArrow},
    {key::up, ImGuiKey_UpArrow},          {key::down, ImGuiKey_DownArrow},
    {key::page_up, ImGuiKey_PageUp},      {key::page_down, ImGuiKey_PageDown},
    {key::home, ImGuiKey_Home},           {key::end, ImGuiKey_End},
    {key::insert, ImGuiKey_Insert},       {key::del, ImGuiKey_Delete},
    {key::backspace, ImGuiKey_Backspace}, {key::space, ImGuiKey_Space},
    {key::enter, ImGuiKey_Enter},         {key::escape, ImGuiKey_Escape},
};

} // namespace

#if IMGUI_VERSION_NUM < 18700

bool is_key_down(int key) {
    return ImGui::IsKeyDown(key);
}

bool is_key_pressed(int key, bool repeats) {
    return ImGui::IsKeyPressed(key, repeats);
}

bool is_any_key_down() {
    const ImGuiIO& io = ImGui::GetIO();
    return std::any_of(std::begin(io.KeysDown), std::end(io.KeysDown), std::identity{});
}

bool is_any_key_pressed() {
    const auto keys = std::span(ImGui::GetIO().KeysDownDuration).first<key::first_modifier>();
    return std::any_of(keys.begin(), keys.end(), [](float seconds) { return seconds == 0.0f; });
}

void open_keys() {
    ImGuiIO& io = ImGui::GetIO();
    for (const auto& [key, name] : named_keys)
        io.KeyMap[name] = key;
    io.KeyMap[ImGuiKey_KeyPadEnter] = key::keypad_enter;
    constexpr std::pair<int, ImGuiKey> letters[] = {{'A', ImGuiKey_A}, {'C', ImGuiKey_C},
                                                    {'V', ImGuiKey_V}, {'X', ImGuiKey_X},
                                                    {'Y', ImGuiKey_Y}, {'Z', ImGuiKey_Z}};
    for (const auto& [key, name] : letters)
        io.KeyMap[name] = key;
}

void keep_tab() {
    ImGui::GetIO().KeyMap[ImGuiKey_Tab] = -1;
}

bool is_input_waiting() {
    return false;
}

void play_key(int key, bool is_down) {
    ImGuiIO& io = ImGui::GetIO();
    IM_ASSERT(key >= 0 && key < IM_ARRAYSIZE(io.KeysDown));
    io.KeysDown[key] = is_down;
}

void play_modifiers(bool ctrl, bool shift, bool alt) {
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = ctrl;
    io.KeyShift = shift;
    io.KeyAlt = alt;
}

void play_pointer(ImVec2 place) {
    ImGui::GetIO().MousePos = place;
}

void play_mouse_button(int mouse_button, bool is_down) {
    ImGui::GetIO().MouseDown[mouse_button] = is_down;
}

void play_wheel(float steps, float sideways) {
    ImGui::GetIO().MouseWheel = steps;
    ImGui::GetIO().MouseWheelH = sideways;
}

void drop_empty_lists(ImDrawData& data) {
    ImDrawList** const end =
        std::remove_if(data.CmdLists, data.CmdLists + data.CmdListsCount,
                       [](const ImDrawList* list) { return list->IdxBuffer.empty(); });
    data.CmdListsCount = static_cast<int>(end - data.CmdLists);
}

bool overlapped_button(const char* id, ImVec2 size, ImGuiButtonFlags flags) {
    const bool is_pressed = ImGui::InvisibleButton(id, size, flags);
    ImGui::SetItemAllowOverlap();
    return is_pressed;
}

bool selectable_row(const char* id, bool is_chosen) {
    const bool is_pressed = ImGui::Selectable(
        id, is_chosen, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap);
    keep_selectable_whole();
    return is_pressed;
}

bool begin_lined_table(const char* id, int columns, ImGuiTableFlags flags, ImVec2 size) {
    return ImGui::BeginTable(id, columns, flags | ImGuiTableFlags_BordersInnerH, size);
}

void keep_items(ImGuiListClipper& clipper, int first, int end) {
    clipper.ForceDisplayRangeByIndices(first, end);
}

void scroll_here(float share) {
    ImGui::SetScrollHereY(share);
}

bool begin_padded_child(const char* id, ImVec2 size) {
    return ImGui::BeginChild(id, size, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
}

#else

namespace {

ImGuiKey imgui_key(int key) {
    const auto nth = [key](ImGuiKey first, int from) {
        return static_cast<ImGuiKey>(first + (key - from));
    };
    if (key >= 'A' && key <= 'Z') return nth(ImGuiKey_A, 'A');
    if (key >= '0' && key <= '9') return nth(ImGuiKey_0, '0');
    if (key >= key::f1 && key <= key::f12) return nth(ImGuiKey_F1, key::f1);
    if (key >= key::keypad_0 && key < key::keypad_0 + 10)
        return nth(ImGuiKey_Keypad0, key::keypad_0);
    constexpr std::pair<int, ImGuiKey> signs[] = {
        {key::tab, ImGuiKey_Tab},
        {key::comma, ImGuiKey_Comma},
        {key::minus, ImGuiKey_Minus},
        {key::period, ImGuiKey_Period},
        {key::equal, ImGuiKey_Equal},
        {key::left_bracket, ImGuiKey_LeftBracket},
        {key::right_bracket, ImGuiKey_RightBracket},
        {'\'', ImGuiKey_Apostrophe},
        {'/', ImGuiKey_Slash},
        {';', ImGuiKey_Semicolon},
        {'\\', ImGuiKey_Backslash},
        {key::keypad_add, ImGuiKey_KeypadAdd},
        {key::keypad_subtract, ImGuiKey_KeypadSubtract},
        {key::keypad_enter, ImGuiKey_KeypadEnter},
    };
    for (const std::span<const std::pair<int, ImGuiKey>> known :
         {std::span(named_keys), std::span(signs)}) {
        for (const auto& [code, name] : known) {
            if (code == key) return name;
        }
    }
    return ImGuiKey_None;
}

/// Does this hold for any key of the keyboard?
template <typename Predicate>
bool any_key(const Predicate& holds) {
    for (int key = ImGuiKey_NamedKey_BEGIN; key < ImGuiKey_GamepadStart; ++key) {
        if (holds(static_cast<ImGuiKey>(key))) return true;
    }
    return false;
}

/// The hand plays one thing at a time, each in its own frame.
ImGuiIO& played_io() {
    ImGuiIO& io = ImGui::GetIO();
    io.ConfigInputTrickleEventQueue = false;
    return io;
}

} // namespace

bool is_key_down(int key) {
    return ImGui::IsKeyDown(imgui_key(key));
}

bool is_key_pressed(int key, bool repeats) {
    return ImGui::IsKeyPressed(imgui_key(key), repeats);
}

bool is_any_key_down() {
    return any_key([](ImGuiKey key) { return ImGui::IsKeyDown(key); });
}

bool is_any_key_pressed() {
    return any_key([](ImGuiKey key) {
        const bool is_modifier = key >= ImGuiKey_LeftCtrl && key <= ImGuiKey_RightSuper;
        return !is_modifier && ImGui::IsKeyPressed(key, false);
    });
}

void open_keys() {}

void keep_tab() {
    // A request for a key without an owner, like ImGui's own for Tab, no longer gets it.
    ImGui::SetKeyOwner(ImGuiKey_Tab, ImHashStr("rasterwalk"));
}

bool is_input_waiting() {
    return !ImGui::GetCurrentContext()->InputEventsQueue.empty();
}

void play_key(int key, bool is_down) {
    IM_ASSERT(imgui_key(key) != ImGuiKey_None);
    played_io().AddKeyEvent(imgui_key(key), is_down);
}

void play_modifiers(bool ctrl, bool shift, bool alt) {
    ImGuiIO& io = played_io();
    io.AddKeyEvent(ImGuiMod_Ctrl, ctrl);
    io.AddKeyEvent(ImGuiMod_Shift, shift);
    io.AddKeyEvent(ImGuiMod_Alt, alt);
}

void play_pointer(ImVec2 place) {
    played_io().AddMousePosEvent(place.x, place.y);
}

void play_mouse_button(int mouse_button, bool is_down) {
    played_io().AddMouseButtonEvent(mouse_button, is_down);
}

void play_wheel(float steps, float sideways) {
    played_io().AddMouseWheelEvent(sideways, steps);
}

void drop_empty_lists(ImDrawData& data) {
    ImDrawList** const end =
        std::remove_if(data.CmdLists.begin(), data.CmdLists.end(),
                       [](const ImDrawList* list) { return list->IdxBuffer.empty(); });
    data.CmdLists.resize(static_cast<int>(end - data.CmdLists.begin()));
    data.CmdListsCount = data.CmdLists.Size;
}

bool overlapped_button(const char* id, ImVec2 size, ImGuiButtonFlags flags) {
    ImGui::SetNextItemAllowOverlap();
    return ImGui::InvisibleButton(id, size, flags);
}

bool selectable_row(const char* id, bool is_chosen) {
    const bool is_pressed = ImGui::Selectable(
        id, is_chosen, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowOverlap);
    keep_selectable_whole();
    return is_pressed;
}

bool begin_lined_table(const char* id, int columns, ImGuiTableFlags flags, ImVec2 size) {
    if (!ImGui::BeginTable(id, columns, flags | ImGuiTableFlags_BordersInnerH, size)) return false;
    ImGuiTable& table = *ImGui::GetCurrentTable();
    // Only rows after the first get a line above them: count the first as one of these.
    if (table.InnerWindow == table.OuterWindow) table.CurrentRow = 0;
    return true;
}

void keep_items(ImGuiListClipper& clipper, int first, int end) {
    clipper.IncludeItemsByIndex(first, end);
}

void scroll_here(float share) {
    ImGui::SetScrollHereY(share);
    // ImGui rounds it to the nearest pixel.
    ImGui::GetCurrentWindow()->ScrollTarget.y -= 0.5f;
}

bool begin_padded_child(const char* id, ImVec2 size) {
    return ImGui::BeginChild(id, size, ImGuiChildFlags_AlwaysUseWindowPadding);
}

#endif

} // namespace rasterwalk
