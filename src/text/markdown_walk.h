#pragma once

// The parser of Markdown, md4c, with the dialect and the limits of every page. All code that reads
// Markdown listens to this walk: what is drawn and what is checked are one parse.

#include <cstddef>
#include <string>
#include <string_view>

#include <md4c.h>

namespace rasterwalk {

/// Total length of a page's link targets, bytes: reference links repeat theirs at every use.
inline constexpr std::size_t largest_targets = std::size_t{1} << 20;

/// The sentence for a page whose targets are longer.
inline constexpr const char* targets_fault =
    "The targets of the links are longer than 1 MB together.";

/// The sentence for a page whose quotes and lists are nested deeper than `deepest`.
std::string nesting_fault(int deepest);

/// A target ready to follow, with its entities and escapes resolved.
std::string attribute_text(const MD_ATTRIBUTE& attribute);

/// Why the text is too long to read; empty: it is not.
std::string size_fault(std::string_view text);

/// Why the parser must not see this text, because it would take too long; empty: it may.
std::string walk_fault(std::string_view text);

/// Receives what a page holds, in reading order. Each function returns false to end the walk.
class MarkdownListener {
  public:
    virtual ~MarkdownListener() = default;

    virtual bool enter(MD_BLOCKTYPE type, const void* detail) = 0;
    virtual bool leave(MD_BLOCKTYPE type) = 0;
    virtual bool enter_span(MD_SPANTYPE type, const void* detail) = 0;
    virtual bool leave_span(MD_SPANTYPE type) = 0;
    /// @param text points into the page, unless the parser adds it (line breaks, blanks)
    virtual bool text(MD_TEXTTYPE type, std::string_view text) = 0;
};

/// Walks Markdown from its beginning to its end: CommonMark with tables and formulas between
/// dollars, without HTML.
/// @return false if the listener ended it, or if it failed
bool walk_markdown(std::string_view text, MarkdownListener& listener);

} // namespace rasterwalk
