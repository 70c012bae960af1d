#pragma once

// How a page of Markdown is built. markdown_parse.cpp makes its tree, markdown_parts.cpp finds its
// parts.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <md4c.h>

#include "text/markdown.h"
#include "text/markdown_places.h"

namespace rasterwalk {

/// Builds a page from what the parser reports. It reports only the places of letters; the marks
/// around them are found from there.
class MarkdownBuilder {
  public:
    MarkdownBuilder(std::string_view page, int deepest)
        : page_(page), deepest_(deepest), places_(page) {
        open_.push_back({&root_, false});
    }

    /// Reads the page from its beginning to its end.
    MarkdownDocument build();

  private:
    /// A block that has begun.
    struct Open {
        MarkdownBlock* block;
        bool has_loose_text; ///< its last child is a paragraph for text directly in it
    };
    /// A link or picture that has begun.
    struct OpenLink {
        std::string target;
        std::optional<std::size_t> target_at; ///< in the page
        std::optional<std::size_t> words_at;  ///< also in the page
        std::string words;
    };

    // What the parser reports, in reading order. False ends the walk.
    bool enter(MD_BLOCKTYPE type, const void* detail);
    void leave(MD_BLOCKTYPE type);
    bool enter_span(MD_SPANTYPE type, const void* detail);
    void leave_span(MD_SPANTYPE type);
    bool text(MD_TEXTTYPE type, std::string_view text);

    MarkdownBlock& push(MarkdownBlock::Kind kind);
    MarkdownBlock& text_block();
    MarkdownRun& run();
    void append_text(MD_TEXTTYPE type, std::string_view text);
    void leave_paragraph(MarkdownBlock& block);
    bool begin_link(bool is_picture, const MD_ATTRIBUTE& target);
    void end_link(MarkdownPart::Kind kind);
    void end_formula(bool is_displayed);

    MarkdownPart& add(MarkdownPart::Kind kind, std::string text, int line);
    void add_table(int line);
    void add_nesting(int line);
    void look_at(MD_TEXTTYPE type, std::string_view text, std::size_t at);
    void look_for_brackets(std::string_view text, std::size_t at);
    void look_for_target(std::size_t open);

    std::string_view page_;
    int deepest_; ///< nesting of quotes and lists, of emphasis, and of brackets
    MarkdownPlaces places_;
    MarkdownDocument document_;
    MarkdownBlock root_;
    // Pointers stay valid: only the children of the innermost block grow.
    std::vector<Open> open_;
    int containers_ = 0;       ///< open quotes, lists and items
    bool is_too_deep_ = false; ///< the next letters show the line
    int emphasis_ = 0, strong_ = 0, code_ = 0;
    int brackets_ = 0;     ///< open in this block, and not links
    int columns_ = 0;      ///< of a table, until letters of it show the line
    int nested_line_ = -1; ///< where nesting was reported last
    int link_ = -1;
    std::vector<OpenLink> open_links_;
    std::size_t target_bytes_ = 0;
    std::string formula_;                   ///< TeX of the formula being read
    std::optional<std::size_t> formula_at_; ///< its first letter
    /// The picture or formula that the paragraph begins with; if it is all, it becomes a block.
    struct Lead {
        MarkdownBlock::Kind kind = MarkdownBlock::Kind::paragraph;
        std::string source;
        std::size_t runs = 0; ///< of the paragraph, when it ended
    } lead_;
};

} // namespace rasterwalk
