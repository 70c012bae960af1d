#pragma once

#include <string>
#include <vector>

namespace rasterwalk {

struct Ui;
struct Bug;
struct Candidate;
struct Diagnosis;
struct LabAnswer;
struct LabPictures;

// The parts of the bug laboratory; see lab_panel.cpp.

/// What there is to say about a mistake, as Markdown: how to find it in a program, the cure, and
/// the lesson that explains it.
std::string remedy_of(Ui& ui, const Bug& bug);

/// Keeps the line just drawn in sight: that of the mistake whose card is shown.
/// @param below what must be visible below the line, screen pixels
void keep_in_sight(Ui& ui, const Bug& chosen, float below);

/// The height of title and buttons of a card that opens below a line, screen pixels.
float height_of_card_head();

/// The quiz: which mistake is it?
void draw_lab_quiz(Ui& ui);

/// The text below a small picture.
struct PictureCaption {
    std::string title;
    std::string words; ///< may be empty
};

/// The student's picture, and the one it is compared with, with its caption: side by side, or one
/// below the other if there is little room.
/// @param owner before the names of the widgets: "lab"
void draw_lab_pictures(Ui& ui, LabPictures& pictures, const std::string& owner,
                       const PictureCaption& beside);

/// The beginning of the card of a diagnosis.
struct LabHeadline {
    std::vector<std::string> names; ///< of the likely mistakes, or a sentence: each a line
    std::string rest;               ///< how much of the fault these explain; may be empty
};
LabHeadline headline_of(const LabAnswer& answer);

/// How much differs, and where; empty: nothing.
std::string difference_words(const LabAnswer& answer);

/// The rules and numbers by which the program works, or by which the nearest correct picture is
/// drawn, if they differ from the chosen reference; empty: they do not.
std::string rules_words(const Diagnosis& diagnosis);

/// What each likely mistake is, and how to fix it, as Markdown; may be empty.
std::string remedy_words(Ui& ui, const Diagnosis& diagnosis);

/// The mistakes of a candidate, and the assumptions that go with it.
std::string candidate_words(const Candidate& candidate);

/// The mistake from the laboratory that a candidate names first; null: it names none.
const Bug* bug_of(Ui& ui, const Candidate& candidate);

/// The card that says what may be wrong with a result.
void draw_lab_answer(Ui& ui);

/// A result from the student's own program, and what may be wrong with it.
void draw_lab_result(Ui& ui);

} // namespace rasterwalk
