#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

namespace rasterwalk {

struct CodeLook;
struct Ui;

// The parts of the tab of the lab's code; see code_panel.cpp.

/// The lines of the file that is being carried out, with what each has computed.
/// @param height of the box, screen pixels
void draw_code_lines(Ui& ui, float height);

/// The number that a line of a file has where it is shown; 0: it is not shown.
int number_in_file(const CodeLook& look, int file, int line);

/// "interpolate.cpp:12": the file and the line that comes next; of the file as it is shown.
std::string code_place_text(const Ui& ui);

/// The same for the group's button, or what the tab is for.
std::string code_subject(const Ui& ui);

} // namespace rasterwalk
