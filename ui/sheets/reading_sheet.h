#pragma once

// How a reading sheet is opened, closed and searched: the same for all of them.

#include <imgui.h>

#include "ui/sheets/sheets_state.h"

namespace rasterwalk {

struct Ui;

/// A sheet as it is laid over the window.
struct SheetLook {
    Sheet sheet;
    const char* window; ///< name for ImGui; the widgets' names begin with `widgets`
    const char* widgets;
    const char* title;
    const char* close_help;
    ImVec2 size{0.0f, 0.0f}; ///< design pixels, at most; 0: as large as its content
    bool is_aside = false;   ///< at the right, so that the picture next to it can be seen
};

/// Begins the window of an open sheet, with its title and the button that closes it. What follows
/// on the same line is behind that button. To be ended by end_sheet().
/// @param window size of the program's window, screen pixels
void begin_sheet(Ui& ui, const SheetLook& look, ImVec2 window);
void end_sheet();

/// The field that filters the sheet. Escape closes the sheet while it has the keyboard.
void draw_sheet_search(Ui& ui, const SheetLook& look, const char* hint, const char* help);

} // namespace rasterwalk
