#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mine/check_lines.h"
#include "mine/checked_program.h"
#include "mine/program_places.h"

namespace rasterwalk {

struct Ui;

// The parts of the tab of the student's own program; see mine_panel.cpp.

/// "skeleton.cpp:142"; empty if the place is not known.
std::string place_text(const CheckedProgram& checked, const ProgramPlace& place);

/// What a place in the source is.
enum class PlaceKind : std::uint8_t { fault, definition };

/// The place's line in the source, with lines around it, or, of a function's definition, with those
/// that follow. Nothing if it cannot be read.
void draw_source(Ui& ui, const CheckedProgram& checked, const ProgramPlace& place,
                 PlaceKind kind = PlaceKind::fault);

/// leftPixels and rightPixels of the polygon in which ComputePolygonRows first differs, the
/// program's and ours, around the first row that differs.
void draw_both_row_tables(Ui& ui, const FunctionCheck& check);

/// The names of these mistakes of the laboratory, each as likely; nothing if there are none.
void name_mistakes(Ui& ui, const std::vector<std::string>& ids);

/// What the laboratory says about these mistakes, with their lessons.
void draw_remedies(Ui& ui, const std::vector<std::string>& ids);

/// Everything that is known about a line of the list.
void draw_line_card(Ui& ui, const CheckedProgram& checked, const CheckLine& line);

} // namespace rasterwalk
