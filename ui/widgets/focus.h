#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <imgui_internal.h>

#include "ui/widgets/widget_state.h"

namespace rasterwalk {

struct Ui;

/// The panel, sheet, menu or list that contains a window of ImGui.
ImGuiID part_of(const ImGuiWindow& window);

/// Notes whether the last ImGui item can have the keyboard, and where it is.
void record_stop(WidgetPlace& place);

/// Notes the position of the last ImGui item if it is the one with the keyboard, and scrolls to it
/// if that was asked for. Returns true if it has the ring.
/// @param shown the visible part of it, screen pixels
bool show_focus(Ui& ui, std::string_view name, const ImRect& shown, bool visible);

/// Draws the ring, over the surroundings of the widget but below what lies over it. To be called
/// when everything else is drawn.
void draw_ring(Ui& ui);

/// The arrows that were pressed for the widget, which was just named. A widget that asks for them
/// keeps them from moving on to the next widget, and is not pressed by Enter.
Arrows take_arrows(Ui& ui, std::string_view name);

/// Gives the keyboard to a widget of something that opens; the previous owner gets it back.
void give_focus(Ui& ui, std::string name);

/// Was the last ImGui item pressed by a key?
bool is_pressed_by_key();

/// It takes some frames until a field has the keyboard: what is typed before is kept in order, and
/// handed over when it has.
void keep_letters(std::vector<std::uint32_t>& early);
void hand_over_letters(std::vector<std::uint32_t>& early);

} // namespace rasterwalk
