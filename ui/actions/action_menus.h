#pragma once

// The actions menu by menu, each list in the order of its menu. action_table() puts them together.

#include <vector>

#include "ui/actions/actions.h"

namespace rasterwalk {

/// What is opened, saved and undone: File, Edit.
std::vector<Action> file_actions();
std::vector<Action> edit_actions();

/// What is seen, and how far it is drawn: View, Stage.
std::vector<Action> view_actions();
std::vector<Action> stage_actions();

/// Where in time, and compared with which other run: Compare, Walk.
std::vector<Action> compare_actions();
std::vector<Action> walk_actions();

/// Lesson, Help.
std::vector<Action> lesson_actions();
std::vector<Action> help_actions();

} // namespace rasterwalk
