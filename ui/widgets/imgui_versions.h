#pragma once

// Where Dear ImGui 1.86 and later versions differ: the only file that asks which version it is.

#include <imgui.h>

namespace rasterwalk {

/// Is the key down, or was it pressed in this frame? Keys as in ui/widgets/keys.h.
/// @param repeats also true again and again while it is held
bool is_key_down(int key);
bool is_key_pressed(int key, bool repeats);

/// Is any key down, Shift and its like too?
bool is_any_key_down();
/// Was any key pressed in this frame? Shift and the like, which modify another key, do not count.
bool is_any_key_pressed();

/// To be called once, when the context is made.
void open_keys();
/// Keeps Tab from ImGui, which would only find fields: see ui/actions/focus_keys.h. To be called
/// before each frame.
void keep_tab();

/// Does input wait for a later frame, so that things that belong apart do not arrive together?
bool is_input_waiting();

/// Input that is played, not a person's: all of it takes effect in the next frame.
void play_key(int key, bool is_down);
void play_modifiers(bool ctrl, bool shift, bool alt);
void play_pointer(ImVec2 place);
void play_mouse_button(int mouse_button, bool is_down);
/// @param steps up is positive
/// @param sideways to the left is positive
void play_wheel(float steps, float sideways = 0.0f);

/// Removes the lists that draw nothing: WebGL takes an empty range of memory to mean all of it.
void drop_empty_lists(ImDrawData& data);

/// An invisible button that other widgets may overlap. Returns true if it was pressed.
bool overlapped_button(const char* id, ImVec2 size, ImGuiButtonFlags flags = 0);

/// The line of a table, chosen or not, that other widgets may overlap. Returns true if it was
/// pressed.
bool selectable_row(const char* id, bool is_chosen);

/// ImGui::BeginTable() with a line above each row, including the first where nothing scrolls;
/// ImGui::EndTable() ends it.
bool begin_lined_table(const char* id, int columns, ImGuiTableFlags flags = 0, ImVec2 size = {});

/// The clipper's items from `first` to before `end` are processed even though they are not seen.
void keep_items(ImGuiListClipper& clipper, int first, int end);

/// Scrolls the last item to this share of the window's height, by whole pixels, rounded down.
void scroll_here(float share);

/// ImGui::BeginChild() with the padding of a window; ImGui::EndChild() ends it.
bool begin_padded_child(const char* id, ImVec2 size);

} // namespace rasterwalk
