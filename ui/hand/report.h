#pragma once

#include <string>

namespace rasterwalk {

struct Ui;

/// What is on the screen, for a program that watches from outside (a test with a real mouse). One
/// thing per line, with spaces between the words:
///
///     window 1600 1000                      size, screen pixels
///     setting stage depth                   every setting by name, with its value
///     cursor end
///     notice Copied: rasterwalk             if something is said in the line at the bottom
///     picture 331.0 96.0 1.5                where pixel 0,0 lies, screen pixels per picture pixel
///     widget stage.points 12 40 92 70       left, top, right, bottom of its visible part
///
/// Widgets are in the order of their names; those that cannot be seen are left out.
std::string screen_report(const Ui& ui);

} // namespace rasterwalk
