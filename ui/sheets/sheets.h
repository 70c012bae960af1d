#pragma once

#include <imgui.h>

// What is laid over the whole window.

namespace rasterwalk {

struct Ui;

/// The sheet of keys (F1).
void draw_key_sheet(Ui& ui, ImVec2 window);

/// The sheet on which a file is opened or the view is saved, if it is up. Nothing else can be
/// clicked meanwhile.
void draw_file_sheet(Ui& ui, ImVec2 window);

/// How far a large file is that is read beside the window, and the button that stops it; nothing
/// while none is read. What lies below can be used meanwhile.
void draw_reading_bar(Ui& ui, ImVec2 window);

/// What the triangle shown does, moment by moment, as text.
void draw_event_sheet(Ui& ui, ImVec2 window);

/// As many moments it lists at once; of more, those around the cursor.
inline constexpr int most_events = 100'000;

/// The words of the lab (F2).
void draw_glossary_sheet(Ui& ui, ImVec2 window);

} // namespace rasterwalk
