#pragma once

// The parser of Markdown, md4c, with the dialect and the limits of every page. All code that reads
// Markdown listens to this walk: what is drawn and what is checked are one parse.

#include <cstddef>
#include <string>
#include <string_view>

#include <md4c.h>

namespace rasterwalk {

/// Link targets of a page, all together, bytes: reference links repeat theirs at every use.
inline constexpr std::size_t largest_targets = std::size_t{1} << 20;

/// The sentence for a page whose targets are longer.
inline constexpr const char* targets_fault =
    "The targets of the links are longer than 1 MB together.";

/// The sentence for a page whose quotes and lists stand deeper in one another than `deepest`.
std::string nesting_fault(int deepest);

/// A target as it is followed: its entities and escapes resolved.
std::string attribute_text(const MD_ATTRIBUTE& attribute);

/// Why the text is too long to be read. Empty: it is not.
std::string size_fault(std::string_view text);

/// Why the parser must not see this text: it would be busy for too long. Empty: it may.
std::string walk_fault(std::string_view text);

/// Receives what a page holds, in the order of reading. Each function returns false to end the
/// walk.
class MarkdownListener {
  public:
    virtual ~MarkdownListener() = default;

    virtual bool enter(MD_BLOCKTYPE type, const void* detail) = 0;
    virtual bool leave(MD_BLOCKTYPE type) = 0;
    virtual bool enter_span(MD_SPANTYPE type, const void* detail) = 0;
    virtual bool leave_span(MD_SPANTYPE type) = 0;
    /// @param text points into the page; what the parser puts in (line breaks, blanks) does not
    virtual bool text(MD_TEXTTYPE type, std::string_view text) = 0;
};

/// Walks Markdown from its beginning to its end: CommonMark with tables and formulas between
/// dollars, without HTML.
/// @return false if the listener ended it, or it could not be made
bool walk_markdown(std::string_view text, MarkdownListener& listener);

} // namespace rasterwalk
