#pragma once

#include <string>
#include <vector>

#include "tests/ui/driver.h"

namespace rasterwalk {

/// What the window shows, and how it comes about.
struct Situation {
    std::string scene; ///< file in the folder of scenes
    /// Steps apart by blanks, each a link of a lesson ("tab:rows", "set:stage=fill") or one of
    /// these: "click:WIDGET", "key:Ctrl+O", "lesson:ID/STEP", "layers" for all
    /// of them, "two_runs", "shown_by:NAME" of a way to show them, "start" for the start page.
    std::string steps;
    /// Widgets apart by blanks that are seen whole in every window, once what scrolls is scrolled.
    std::string reached = {};
    /// Those that are seen whole before anything is scrolled.
    std::string in_sight = {};
};

/// Everything that the workplace can show: each tab with all that changes what it has, two runs,
/// stages and layers.
const std::vector<Situation>& workplace_situations();

/// What comes and goes, so that no lesson points at all of its widgets: sheets, menus, lists, the
/// start page, steps of lessons, lectures, a quiz.
const std::vector<Situation>& passing_situations();

/// Takes the steps that lead to a situation in a window just opened on its scene.
void bring_about(Driver& driver, const Situation& situation);

/// The words of a list, which are apart by blanks.
std::vector<std::string> words_of_list(const std::string& list);

} // namespace rasterwalk
