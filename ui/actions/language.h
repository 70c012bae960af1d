#pragma once

namespace rasterwalk {

struct LanguageChoice;
struct Ui;

/// Reads the language that the options ask for, if it is not the current one: the texts of the
/// window, and the lessons. If it cannot be read, session.notice says why, and English stays.
void renew_language(Ui& ui);

/// The language that follows the current one among those that the lessons are in.
const LanguageChoice& next_language(const Ui& ui);

} // namespace rasterwalk
