#pragma once

// Markdown, the format of lessons, notes and descriptions, as a tree of blocks. What is drawn and
// what is checked are one parse.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// A run of text in one style. A "\n" in it is a line break that the author asked for.
struct MarkdownRun {
    std::string text; ///< UTF-8 without control characters
    bool emphasis = false;
    bool strong = false;
    bool code = false;
    int link = -1;          ///< index in MarkdownDocument::links; -1: none
    std::int8_t raised = 0; ///< of a formula: 1 superscript, -1 subscript
    char vector = 0; ///< of a formula: the letter of a vector, see is_vector_letter(); 0: none

    friend bool operator==(const MarkdownRun&, const MarkdownRun&) = default;
};

bool has_same_style(const MarkdownRun& a, const MarkdownRun& b);

/// The last run if it is in this style, otherwise a new one in it.
MarkdownRun& run_like(std::vector<MarkdownRun>& runs, const MarkdownRun& style);

/// A part of the page. Text is in `runs` (paragraph, heading, cell, code), everything else in
/// `children`.
struct MarkdownBlock {
    enum class Kind : std::uint8_t {
        paragraph,
        heading,
        list, ///< children: items
        item,
        code,  ///< one run, one line per "\n"
        quote, ///< shown as a box
        table, ///< children: rows
        row,   ///< children: cells
        cell,
        rule,    ///< a line across the page
        math,    ///< a formula on its own line: one run of TeX
        picture, ///< `target` names the file; runs: its alternative text
    };
    enum class Align : std::uint8_t { left, centre, right };

    Kind kind = Kind::paragraph;
    int level = 0;             ///< heading: 1..6
    bool is_numbered = false;  ///< list
    int start = 1;             ///< numbered list: the first number
    bool is_tight = true;      ///< list: no space between its items
    bool is_header = false;    ///< cell
    Align align = Align::left; ///< cell
    std::string label;         ///< quote that begins with a paragraph all in strong: that paragraph
    std::string target;        ///< picture: its place, as written
    std::vector<MarkdownRun> runs;
    std::vector<MarkdownBlock> children;

    friend bool operator==(const MarkdownBlock&, const MarkdownBlock&) = default;
};

/// What a check looks at: a link, a picture or the like, or what looks like one but is drawn as
/// written.
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

    friend bool operator==(const MarkdownPart&, const MarkdownPart&) = default;
};

/// A page of Markdown, ready to be laid out and to be checked.
struct MarkdownDocument {
    std::vector<MarkdownBlock> blocks;
    std::vector<std::string> links;  ///< targets, in the order of the page; `note:1` is a footnote
    std::vector<std::string> notes;  ///< the footnotes, plain text; they are also at the end
    std::vector<MarkdownPart> parts; ///< as far as the page was read; definitions at the end
    std::string fault;  ///< why the page cannot be shown, a sentence; it then has no blocks
    int fault_line = 0; ///< of the text, from 0

    friend bool operator==(const MarkdownDocument&, const MarkdownDocument&) = default;
};

/// Reads Markdown (CommonMark with tables, footnotes and formulas between dollars, without HTML).
/// Never fails: odd bytes become U+FFFD, and a text beyond the limits below gives a document with a
/// fault.
MarkdownDocument parse_markdown(std::string_view text);

/// The same parse of a text whose footnotes are left as they are written, so that each line keeps
/// its number, for checks.
/// @param deepest nesting of quotes and lists, of emphasis, and of brackets that are not links
MarkdownDocument parse_as_written(std::string_view text, int deepest);

/// The largest text that is read, bytes, and the deepest nesting of lists and quotes.
inline constexpr std::size_t largest_markdown = std::size_t{1} << 20;
inline constexpr int deepest_markdown = 32;

} // namespace rasterwalk
