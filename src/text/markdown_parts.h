#pragma once

// What stands in a page of Markdown beside its words, with the lines: for those who check it.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A link, a picture and their like, and what looks like one and is drawn as it is written.
struct MarkdownPart {
    enum class Kind : std::uint8_t {
        link,         ///< `text`: its target
        picture,      ///< `text`: its target
        formula,      ///< `text`: TeX, without the dollar signs
        footnote,     ///< `text`: the label of a reference [^label]
        address,      ///< a link without words of its own; `text`: <address>
        split_target, ///< [words](with blanks), which is no link; `text`: between the parentheses
        comment,      ///< <!-- within a line
        definition,   ///< [label]: target, of which nothing is drawn
        table,        ///< `columns`
        nesting,      ///< emphasis or brackets too deep in one another
    };
    Kind kind = Kind::link;
    std::string text;
    std::string words; ///< of a link or picture, without their styles
    int columns = 0;   ///< of a table
    int line = 0;      ///< of the text, from 0: where its words end, otherwise where it begins
};

/// The parts of a page.
struct MarkdownParts {
    std::vector<MarkdownPart> parts; ///< as far as the page was read; definitions at the end
    std::string fault;               ///< a sentence why the page cannot be shown; empty: it can
    int fault_line = 0;              ///< of the text, from 0
};

/// Finds the parts of a page by the parse by which parse_markdown() draws it, but for footnotes,
/// whose texts stand elsewhere.
/// @param deepest nesting of quotes and lists, of emphasis, and of brackets that are no links
MarkdownParts find_markdown_parts(std::string_view text, int deepest);

} // namespace rasterwalk
