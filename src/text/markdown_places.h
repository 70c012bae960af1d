#pragma once

// The lines of a page that is being parsed.

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// Finds lines, counted from 0, for what the parser of Markdown reports. It gives only the places
/// of letters, as pointers into the page.
class MarkdownPlaces {
  public:
    /// @param page must stay where it is
    explicit MarkdownPlaces(std::string_view page);

    /// The place of letters in the page; none for what the parser added (line breaks, blanks).
    std::optional<std::size_t> find(std::string_view letters) const;
    /// Quick for places that come nearly in order.
    int line_at(std::size_t place);
    /// The line of something without letters: the next after `end` that is not empty.
    int line_ahead();
    /// Takes note of letters that are drawn. Returns their line.
    int note(std::string_view letters, std::size_t place);
    /// Lines that begin like a link's definition, [label]: target, and of which nothing is drawn.
    std::vector<int> definitions() const;

    std::size_t end = 0; ///< of what was reported last

  private:
    std::string_view page_;
    std::vector<bool> is_drawn_; ///< of each line: letters of it were reported
    std::size_t counted_ = 0;    ///< lines have been counted up to here
    int line_ = 0;               ///< of that place
};

} // namespace rasterwalk
