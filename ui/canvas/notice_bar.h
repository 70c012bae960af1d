#pragma once

// A line above the picture that says something about it, with buttons for what can be done.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

struct Ui;

struct NoticeButton {
    std::string_view name; ///< of the widget
    std::string label, help;
};

/// Draws the line, with the buttons at its right end. Where there is too little room for all of
/// them, the last ones are left out.
/// @param name of the widget that has the sentence
/// @param forms of the sentence, at least one, the longest first: the first that fits is shown
/// @param help for the sentence
/// @param is_true_now false: it is about the previous picture, and dim
/// @return the name of the button that was clicked; empty: none was
std::string_view draw_notice_bar(Ui& ui, const char* name, const std::vector<std::string>& forms,
                                 const std::string& help, bool is_true_now,
                                 std::span<const NoticeButton> buttons);

} // namespace rasterwalk
