#pragma once

namespace rasterwalk {

struct Ui;

/// Closes what lies on top: a menu or list that is open, or else the sheet of keys, or else the
/// glossary.
void close_topmost(Ui& ui);

} // namespace rasterwalk
