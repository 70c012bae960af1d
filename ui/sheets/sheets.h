#pragma once

#include <imgui.h>

// The sheets and bars laid over the whole window.

namespace rasterwalk {

struct Ui;

/// The sheet of keys (F1).
void draw_key_sheet(Ui& ui, ImVec2 window);

/// The sheet on which a file is opened or the view is saved, if it is open. Nothing else can be
/// clicked while it is.
void draw_file_sheet(Ui& ui, ImVec2 window);

/// The progress of a large file read in the background, and the button that stops it; nothing while
/// none is read. What lies below can still be used.
void draw_reading_bar(Ui& ui, ImVec2 window);

/// What the triangle shown does, moment by moment, as text.
void draw_event_sheet(Ui& ui, ImVec2 window);

/// The most moments that it lists; if there are more, those around the cursor.
inline constexpr int most_events = 100'000;

/// The test before and after the lessons: its items one after the other, and what came of them.
void draw_test_sheet(Ui& ui, ImVec2 window);

/// The words of the lab (F2).
void draw_glossary_sheet(Ui& ui, ImVec2 window);

/// The map of the course: its lessons, a column for each track, and lines from each lesson to those
/// that build on it.
void draw_map_sheet(Ui& ui, ImVec2 window);

} // namespace rasterwalk
