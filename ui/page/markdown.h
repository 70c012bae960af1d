#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "text/markdown.h"

namespace rasterwalk {

struct Ui;

/// A page on the screen: parsed when its text changes, laid out when text or width do.
struct MarkdownPage;

/// A text, or a page or a part of one that is already parsed.
using MarkdownContent = std::variant<std::string, MarkdownDocument>;

/// What the student does with the links of a page in this frame; indices in the document's links.
struct MarkdownEvents {
    int hovered = -1;
    int followed = -1;
};

/// Draws Markdown at ImGui's cursor, wrapped at `width` screen pixels, and moves the cursor below
/// it. Each link is entered in Ui::widgets as `prefix` and its number.
/// @param folder of the lesson, whose pictures are shown; empty: the program's own lessons
/// @param has_vectors letters of vectors in its formulas have the colours of the arrows, while
///                    these are shown; on other pages the same letters mean something else
/// @param page keeps what was computed from one frame to the next; null at first
MarkdownEvents draw_markdown(Ui& ui, std::shared_ptr<MarkdownPage>& page,
                             const MarkdownContent& content, float width, std::string_view prefix,
                             const std::string& folder = {}, bool has_vectors = false);

/// How high Markdown is when it is drawn at this width, screen pixels.
float markdown_height(Ui& ui, const MarkdownContent& content, float width);

/// The document of a page that was drawn.
const MarkdownDocument& document_of(const MarkdownPage& page);

} // namespace rasterwalk
