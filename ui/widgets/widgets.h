#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "ui/widgets/style.h"

namespace rasterwalk {

struct Ui;

/// Enters the last ImGui item in Ui::widgets under this name, and shows `tooltip` while the pointer
/// rests on it (empty: none). In a window that ends with whole lines it stays whole.
/// @param text the number or words that it shows, so that they can be looked up by name
void register_widget(Ui& ui, std::string_view name, std::string_view tooltip = {},
                     std::string_view text = {});

/// A tooltip next to the last ImGui item, where it does not cover what it explains; over something
/// large, next to the pointer.
void draw_tooltip(const Ui& ui, std::string_view text);

/// Notes the number that the widget with this name shows, so that it can be looked up by name. The
/// widget must have been named in this frame.
void register_text(Ui& ui, std::string_view name, std::string_view text);

/// The signs of pass and fail, shown with their colours.
inline constexpr const char* passed_sign = "✓";
inline constexpr const char* failed_sign = "✗";

/// How a button looks.
enum class Look : std::uint8_t {
    plain,   ///< filled
    main,    ///< filled with the accent: the one main action of its place
    chosen,  ///< filled quietly: the one chosen of several, or a switch that is on
    outline, ///< a border only
    quiet,   ///< text only
    link,    ///< text in the colour of links, without space around it
};

/// A button under a name. Returns true when it is pressed.
/// @param size 0 in a direction: as large as the label needs
bool button(Ui& ui, std::string_view name, std::string_view label, Look look,
            std::string_view tooltip, ImVec2 size = {0, 0});

/// Text, and text in a colour. In a window that ends with whole lines each line stays whole.
/// @param font null: the current one
void put_text(std::string_view text, ImFont* font = nullptr);
void text_in(const ImVec4& colour, std::string_view text, ImFont* font = nullptr);

/// The text with line breaks between words so that no line is wider than this, screen pixels. ImGui
/// would also break numbers at their point.
std::string broken_into_lines(std::string_view text, float width);

/// Text that wraps between words, at the end of the column or of the card.
void wrapped_text(std::string_view text, ImFont* font = nullptr);
void wrapped_text_in(const ImVec4& colour, std::string_view text, ImFont* font = nullptr);

/// Text at the right edge of the current table cell or of the width given.
void right_aligned(std::string_view text, const ImVec4& colour, ImFont* font = nullptr);

/// A frame around a number: in Palette::changed, what the current moment has just changed.
void draw_box_around(const Ui& ui, ImDrawList* list, ImVec2 low, ImVec2 high, const ImVec4& colour);

/// The bar at the left of the current moment's row.
/// @param low its upper left corner
void draw_current_bar(const Ui& ui, ImDrawList* list, ImVec2 low, float bottom);

/// The mark of moments at which two runs differ, as on the time line.
void draw_difference_mark(ImDrawList* list, ImVec2 centre, float radius, ImU32 colour);

/// The mark, and what it means.
void draw_difference_key(Ui& ui, std::string_view words);
/// Where its words begin, screen pixels.
float difference_key_indent(const Ui& ui);

/// A box on the background that grows with its content: between begin_card and end_card.
void begin_card(Ui& ui, float width = 0.0f);
void end_card(Ui& ui);

/// A number with a fixed count of digits after the point, with a true minus sign, so that columns
/// do not jump: "-0.821", " 1.000". Numbers too large for it come out as 1.2e+06.
std::string fixed(double value, int digits);

/// Brings a line of the scrolling window, counted from its first, to the middle, with a whole line
/// at the top. Returns true if it is there.
/// @param height of each line, screen pixels
bool scroll_to_line(int line, float height);

/// As much of the text as fits into the width in the current font, with an ellipsis if that is not
/// all.
std::string shortened(const std::string& text, float width);

/// The same, cut between two words: a letter or two of a word say nothing.
std::string shortened_to_words(const std::string& text, float width);

/// An entry of an open list; opening the list by key starts at the chosen one. Returns true when it
/// is pressed.
bool list_entry(Ui& ui, std::string_view name, std::string_view label, bool is_chosen,
                std::string_view tooltip);

/// How wide one line of text is in the current font, in pixels of the window.
float text_width(std::string_view text);

/// The same in a given font.
/// @param size of its letters; 0: the font's own
float text_width(const ImFont* font, std::string_view text, float size = 0.0f);

/// The first of these texts that fits into the width in the current font, or else as much of the
/// last one as fits. If saying nothing is acceptable, the last one is empty: that always fits.
std::string first_fitting(const std::vector<std::string>& forms, float width);

/// Where the room for the next item ends at the right, in a window or in a cell of a table. Screen
/// pixels.
float right_end();

/// The width that a label takes as a button.
float button_width(std::string_view label);

/// Continues the line after the last item if a button with this label fits there.
/// @param gap between them, screen pixels; less than 0: the usual one
void same_line_if_room(std::string_view label, float gap = -1.0f);

} // namespace rasterwalk
