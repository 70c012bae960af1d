#pragma once

#include "ui/hosts/host_state.h"

namespace rasterwalk {

struct Ui;

/// Makes the ImGui context, fonts and style. ui.session must be open, ui.options set.
void open_ui(Ui& ui, TextureHost& textures);

/// Ends the ImGui context. The host must have ended its renderer already.
void close_ui(Ui& ui);

/// One frame of the interface, from ImGui::NewFrame to ImGui::Render; ImGui::GetDrawData() then
/// shows it. Never throws: faults are reported in session.notice. The host must first set
/// io.DisplaySize, io.DeltaTime and the input. A change that a widget makes is drawn in the same
/// call: the frame is then built a second time.
void build_ui(Ui& ui);

/// Writes what is kept between two runs of the program, perhaps for the last time.
void keep_everything(Ui& ui);

/// True while the next frame will differ without any input: time is playing. Blinking pictures are
/// still in between, see seconds_to_blink().
bool is_animating(const Ui& ui);

} // namespace rasterwalk
