#pragma once

namespace rasterwalk {

struct Ui;

/// At the upper and lower edge of a window that scrolls, what keep_whole() names is shown whole or
/// not at all. Around the drawing of what scrolls, in its window; a window in it may do the same.
/// @param room the height that the window may have, screen pixels, if that is not the one it has
void begin_whole_lines(Ui& ui, float room = 0.0f);
void end_whole_lines(Ui& ui);

/// A line of text or a widget lies between these heights, screen pixels. Does nothing where the
/// window does not end with whole lines.
void keep_whole(Ui& ui, float top, float bottom);
/// The same for the widget drawn last, and for each line of a text drawn last.
void keep_item_whole(Ui& ui);
void keep_text_whole(Ui& ui);

/// Of a box that begins at the first height, nothing is shown at the lower edge where it is not
/// shown as far as to the second.
void keep_beginning(Ui& ui, float top, float bottom);

/// From where to where the window shows what is in it, so far: nothing of it is cut. Screen pixels.
struct ShownLines {
    float top = 0.0f, bottom = 0.0f;
};
ShownLines shown_lines(const Ui& ui);

/// How high the window has to be to end with whole lines while it is not scrolled, so far: no
/// higher than its room. Screen pixels.
float whole_height(const Ui& ui);

/// The room of the window that is drawn into: what is fitted to its page is to ask for this one,
/// which does not follow from what stands in the page. Screen pixels.
float page_room(const Ui& ui);

/// Lies anything that was to be kept whole below the edge, so far?
bool is_cut_off(const Ui& ui);

} // namespace rasterwalk
