#pragma once

namespace rasterwalk {

/// At the upper and lower edge of a window that scrolls, each line of text and each widget with a
/// name is shown whole or not at all: see text_in() and register_widget(). So is what
/// clip_range_to_lines() names besides. Call it around the drawing of the content, in its window; a
/// window within it may do the same.
/// @param room the height that the window may have, screen pixels, if not its current one
void begin_line_clip(float room = 0.0f);
void end_line_clip();

/// A line of text or a widget lies between these heights, screen pixels. Does nothing if the window
/// does not end with whole lines.
void clip_range_to_lines(float top, float bottom);
/// The same for the widget drawn last, and for each line of a text drawn last.
void clip_to_lines();
void clip_text_to_lines();
/// The same for the words of a Selectable drawn last: half of the space around items belongs to it,
/// and may be cut off.
void keep_selectable_whole();
/// The same for the widget drawn last, unless what was kept last is a part of it: then it may be
/// cut between its parts, such as the lines of a text.
void keep_item_whole_unless_in_parts();

/// A box begins at the first height; at the lower edge nothing of it is shown unless it is shown
/// down to the second.
void keep_beginning(float top, float bottom);

/// The range in which the window shows its content so far: nothing in it is cut. Screen pixels.
struct ShownLines {
    float top = 0.0f, bottom = 0.0f;
};
ShownLines shown_lines();

/// The height that the window needs so far to end with whole lines while it is not scrolled: no
/// higher than its room. Screen pixels.
float whole_height();

/// The room of the current window: content fitted to its page must use this one, which does not
/// depend on the page's content. Screen pixels.
float page_room();

/// Does anything to be kept whole lie below the edge, so far?
bool is_cut_off();

} // namespace rasterwalk
