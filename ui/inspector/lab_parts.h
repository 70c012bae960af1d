#pragma once

#include <string>

namespace rasterwalk {

struct Ui;

// The parts of the bug laboratory; see lab_panel.cpp.

/// Text of the data as Markdown that says the same.
std::string plain_markdown(const std::string& text);

/// The quiz: which mistake is it?
void draw_lab_quiz(Ui& ui);

/// A result of the student's own, and what may be wrong with it.
void draw_lab_result(Ui& ui);

} // namespace rasterwalk
