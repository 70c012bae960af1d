#pragma once

namespace rasterwalk {

struct Ui;

/// Closes what lies on top, the first that is open of: a menu or list, the sheet of keys, the
/// glossary, the list of moments, the check of a file, the settings, the lesson's whole text; at
/// last ends the lecture.
void close_topmost(Ui& ui);

} // namespace rasterwalk
