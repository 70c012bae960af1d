#pragma once

// The parts of a page of Markdown besides its words, with their lines, for checks.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A link, a picture or the like, or what looks like one but is drawn as written.
struct MarkdownPart {
    enum class Kind : std::uint8_t {
        link,         ///< `text`: its target
        picture,      ///< `text`: its target
        formula,      ///< `text`: TeX, without the dollar signs
        footnote,     ///< `text`: the label of a reference [^label]
        address,      ///< a link without separate words; `text`: <address>
        split_target, ///< [words](with blanks), which is no link; `text`: between the parentheses
        comment,      ///< <!-- within a line
        definition,   ///< [label]: target, which is not drawn
        table,        ///< `columns`
        nesting,      ///< emphasis or brackets nested too deep
    };
    Kind kind = Kind::link;
    std::string text;
    std::string words; ///< of a link or picture, without styles
    int columns = 0;   ///< of a table
    int line = 0;      ///< of the text, from 0: where its words end, otherwise where it begins
};

/// The parts of a page.
struct MarkdownParts {
    std::vector<MarkdownPart> parts; ///< as far as the page was read; definitions at the end
    std::string fault;               ///< why the page cannot be shown, a sentence; empty: it can
    int fault_line = 0;              ///< of the text, from 0
};

/// Finds the parts of a page with the same parse as parse_markdown(), except for footnotes, whose
/// texts are elsewhere.
/// @param deepest nesting of quotes and lists, of emphasis, and of brackets that are not links
MarkdownParts find_markdown_parts(std::string_view text, int deepest);

} // namespace rasterwalk
