#pragma once

#include <string>

namespace rasterwalk {

struct LanguageChoice;
struct Ui;

/// Reads the language that the options ask for, if it is not the current one: the texts of the
/// window, and the lessons. If it cannot be read, session.notice says why, and the window is in
/// English; the options still ask for it, as another folder of lessons may have it.
void renew_language(Ui& ui);

/// Asks for a language, also for one that could not be read before.
void choose_language(Ui& ui, const std::string& code);

/// The language that follows the current one among those that the lessons are in.
const LanguageChoice& next_language(const Ui& ui);

} // namespace rasterwalk
