#pragma once

#include <string>

#include "ui/page/markdown.h"

namespace rasterwalk {

struct Ui;

/// Does what a lesson's link says. A fault goes to session.notice.
void follow_link(Ui& ui, const std::string& target);

/// Follows the link that was pressed on a page, and outlines what the link under the pointer points
/// at.
void answer_links(Ui& ui, const MarkdownDocument& document, const MarkdownEvents& events);

/// Outlines a widget; if its tab is closed, the tab.
/// @param is_pinned it stays outlined until the next click or key
void point_at_widget(Ui& ui, const std::string& widget, bool is_pinned);

/// The same for what the current step points at: it stays outlined until it is used or the step
/// ends, and comes back into sight if another card or window moved it away.
void point_at_widget_of_step(Ui& ui, const std::string& widget);

/// To be called once a frame, after all pages were drawn: ends the pointing, immediately if a link
/// was only hovered, otherwise with the next click or key; then what the step points at is
/// outlined.
void release_pointed(Ui& ui);

} // namespace rasterwalk
