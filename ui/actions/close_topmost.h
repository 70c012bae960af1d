#pragma once

namespace rasterwalk {

struct Ui;

/// Closes what lies on top, the first of these that is open: a menu or list, the sheet of keys, the
/// glossary, the list of moments, the check of a file, the settings, the lesson's whole text; last
/// of all it ends the lecture.
void close_topmost(Ui& ui);

} // namespace rasterwalk
