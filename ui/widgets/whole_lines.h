#pragma once

namespace rasterwalk {

struct Ui;

/// At the upper and lower edge of a window that scrolls, what keep_whole() names is shown whole or
/// not at all. Call it around the drawing of the content, in its window; a window within it may do
/// the same.
/// @param room the height that the window may have, screen pixels, if not its current one
void begin_whole_lines(Ui& ui, float room = 0.0f);
void end_whole_lines(Ui& ui);

/// A line of text or a widget lies between these heights, screen pixels. Does nothing if the window
/// does not end with whole lines.
void keep_whole(Ui& ui, float top, float bottom);
/// The same for the widget drawn last, and for each line of a text drawn last.
void keep_item_whole(Ui& ui);
void keep_text_whole(Ui& ui);

/// A box begins at the first height; at the lower edge nothing of it is shown unless it is shown
/// down to the second.
void keep_beginning(Ui& ui, float top, float bottom);

/// The range in which the window shows its content so far: nothing in it is cut. Screen pixels.
struct ShownLines {
    float top = 0.0f, bottom = 0.0f;
};
ShownLines shown_lines(const Ui& ui);

/// The height that the window needs so far to end with whole lines while it is not scrolled: no
/// higher than its room. Screen pixels.
float whole_height(const Ui& ui);

/// The room of the current window: content fitted to its page must use this one, which does not
/// depend on the page's content. Screen pixels.
float page_room(const Ui& ui);

/// Does anything to be kept whole lie below the edge, so far?
bool is_cut_off(const Ui& ui);

} // namespace rasterwalk
