#pragma once

#include <string>

namespace rasterwalk {

struct Ui;
struct Bug;

// The parts of the bug laboratory; see lab_panel.cpp.

/// What there is to say of a mistake, as Markdown: how to find it in a program, the cure, and the
/// lesson that explains it.
std::string remedy_of(Ui& ui, const Bug& bug);

/// The line just drawn, of the mistake whose card is on show, stays in sight.
/// @param below what is to be seen below the line, screen pixels
void keep_in_sight(Ui& ui, const Bug& chosen, float below);

/// Of a card that opens below a line: its title and buttons, screen pixels.
float height_of_card_head();

/// The quiz: which mistake is it?
void draw_lab_quiz(Ui& ui);

/// What is said below a small picture.
struct PictureCaption {
    std::string title;
    std::string words; ///< may be empty
};

/// The picture that was diagnosed, and that of the program's own with its caption: beside each
/// other, or one below the other where there is little room.
void draw_lab_pictures(Ui& ui, const PictureCaption& beside);

/// A result of the student's own, and what may be wrong with it.
void draw_lab_result(Ui& ui);

} // namespace rasterwalk
