#include "text/markdown.h"

#include <algorithm>

#include "text/markdown_notes.h"
#include "text/markdown_text.h"
#include "text/markdown_walk.h"
#include "text/math.h"
#include "text/math_runs.h"

namespace rasterwalk {

namespace {

using BlockKind = MarkdownBlock::Kind;

/// Builds the page from what the walk reports.
class Builder final : public MarkdownListener {
  public:
    explicit Builder(MarkdownDocument& document) : document_(document) {
        open_.push_back({&root_, false});
    }

    bool enter(MD_BLOCKTYPE type, const void* detail) override;
    bool leave(MD_BLOCKTYPE type) override;
    bool enter_span(MD_SPANTYPE type, const void* detail) override;
    bool leave_span(MD_SPANTYPE type) override;
    bool text(MD_TEXTTYPE type, std::string_view text) override;

    /// The blocks of the page.
    std::vector<MarkdownBlock> take() { return std::move(root_.children); }

  private:
    struct Open {
        MarkdownBlock* block;
        bool has_loose_text; ///< its last child is a paragraph for text directly in it
    };

    MarkdownBlock& push(BlockKind kind);
    MarkdownBlock& text_block();
    MarkdownRun& run();
    void leave_paragraph(MarkdownBlock& block);

    MarkdownDocument& document_;
    MarkdownBlock root_;
    // Pointers stay valid: only the children of the innermost block grow.
    std::vector<Open> open_;
    int emphasis_ = 0, strong_ = 0, code_ = 0;
    int link_ = -1;
    std::size_t target_bytes_ = 0;
    std::string formula_; ///< TeX of the formula being read
    /// The picture or formula that the paragraph begins with; if it is all, it becomes a block.
    struct Lead {
        BlockKind kind = BlockKind::paragraph;
        std::string source;
        std::size_t runs = 0; ///< of the paragraph, when it ended
    } lead_;
};

MarkdownBlock& Builder::push(BlockKind kind) {
    Open& parent = open_.back();
    parent.has_loose_text = false;
    MarkdownBlock& block = parent.block->children.emplace_back();
    block.kind = kind;
    open_.push_back({&block, false});
    return block;
}

/// Items of a tight list hold their text without a paragraph around it.
MarkdownBlock& Builder::text_block() {
    Open& open = open_.back();
    switch (open.block->kind) {
    case BlockKind::list:
    case BlockKind::item:
    case BlockKind::quote:
    case BlockKind::table:
    case BlockKind::row:
        if (!open.has_loose_text) {
            open.block->children.emplace_back();
            open.has_loose_text = true;
        }
        return open.block->children.back();
    default:
        return *open.block;
    }
}

/// The run that text in the present style belongs to.
MarkdownRun& Builder::run() {
    std::vector<MarkdownRun>& runs = text_block().runs;
    const bool emphasis = emphasis_ > 0, strong = strong_ > 0, code = code_ > 0;
    if (!runs.empty()) {
        MarkdownRun& last = runs.back();
        if (last.emphasis == emphasis && last.strong == strong && last.code == code &&
            last.link == link_ && last.raised == 0) {
            return last;
        }
    }
    return runs.emplace_back(MarkdownRun{{}, emphasis, strong, code, link_, 0});
}

bool Builder::enter(MD_BLOCKTYPE type, const void* detail) {
    if (open_.size() > static_cast<std::size_t>(deepest_markdown)) {
        document_.fault = nesting_fault(deepest_markdown);
        return false;
    }
    switch (type) {
    case MD_BLOCK_QUOTE:
        push(BlockKind::quote);
        break;
    case MD_BLOCK_UL: {
        MarkdownBlock& list = push(BlockKind::list);
        list.is_tight = static_cast<const MD_BLOCK_UL_DETAIL*>(detail)->is_tight != 0;
        break;
    }
    case MD_BLOCK_OL: {
        const auto& ordered = *static_cast<const MD_BLOCK_OL_DETAIL*>(detail);
        MarkdownBlock& list = push(BlockKind::list);
        list.is_numbered = true;
        list.is_tight = ordered.is_tight != 0;
        list.start = static_cast<int>(std::min(ordered.start, 999'999'999u));
        break;
    }
    case MD_BLOCK_LI:
        push(BlockKind::item);
        break;
    case MD_BLOCK_HR:
        push(BlockKind::rule);
        break;
    case MD_BLOCK_H:
        push(BlockKind::heading).level =
            static_cast<int>(static_cast<const MD_BLOCK_H_DETAIL*>(detail)->level);
        break;
    case MD_BLOCK_CODE:
        push(BlockKind::code);
        break;
    case MD_BLOCK_P:
    case MD_BLOCK_HTML:
        push(BlockKind::paragraph);
        break;
    case MD_BLOCK_TABLE:
        push(BlockKind::table);
        break;
    case MD_BLOCK_TR:
        push(BlockKind::row);
        break;
    case MD_BLOCK_TH:
    case MD_BLOCK_TD: {
        MarkdownBlock& cell = push(BlockKind::cell);
        const MD_ALIGN align = static_cast<const MD_BLOCK_TD_DETAIL*>(detail)->align;
        cell.is_header = type == MD_BLOCK_TH;
        cell.align = align == MD_ALIGN_CENTER  ? MarkdownBlock::Align::centre
                     : align == MD_ALIGN_RIGHT ? MarkdownBlock::Align::right
                                               : MarkdownBlock::Align::left;
        break;
    }
    case MD_BLOCK_DOC:
    case MD_BLOCK_THEAD:
    case MD_BLOCK_TBODY:
        break;
    }
    return true;
}

bool Builder::leave(MD_BLOCKTYPE type) {
    if (type == MD_BLOCK_DOC || type == MD_BLOCK_THEAD || type == MD_BLOCK_TBODY) return true;
    MarkdownBlock& block = *open_.back().block;
    open_.pop_back();
    if (block.kind == BlockKind::code && !block.runs.empty()) {
        std::string& text = block.runs.back().text;
        if (text.ends_with('\n')) text.pop_back();
    }
    if (type == MD_BLOCK_P) leave_paragraph(block);
    if (block.kind != BlockKind::quote || block.children.size() < 2) return true;
    const MarkdownBlock& first = block.children.front();
    if (first.kind == BlockKind::paragraph && first.runs.size() == 1 && first.runs[0].strong) {
        block.label = first.runs[0].text;
        block.children.erase(block.children.begin());
    }
    return true;
}

bool Builder::enter_span(MD_SPANTYPE type, const void* detail) {
    switch (type) {
    case MD_SPAN_STRONG:
        ++strong_;
        break;
    case MD_SPAN_CODE:
        ++code_;
        break;
    case MD_SPAN_A: {
        const MD_ATTRIBUTE& href = static_cast<const MD_SPAN_A_DETAIL*>(detail)->href;
        target_bytes_ += href.size;
        if (target_bytes_ > largest_targets) {
            document_.fault = targets_fault;
            return false;
        }
        link_ = static_cast<int>(document_.links.size());
        document_.links.push_back(attribute_text(href));
        break;
    }
    case MD_SPAN_LATEXMATH:
    case MD_SPAN_LATEXMATH_DISPLAY:
        formula_.clear();
        break;
    case MD_SPAN_IMG:
        if (text_block().runs.empty()) {
            lead_ = {BlockKind::picture,
                     attribute_text(static_cast<const MD_SPAN_IMG_DETAIL*>(detail)->src), 0};
        }
        ++emphasis_; // within a text, a picture's alternative text
        break;
    default:
        ++emphasis_;
        break;
    }
    return true;
}

/// A picture or a formula that is all of its paragraph becomes a block of its own.
void Builder::leave_paragraph(MarkdownBlock& block) {
    const bool is_alone = lead_.kind != BlockKind::paragraph && block.runs.size() == lead_.runs;
    if (is_alone && lead_.kind == BlockKind::picture) {
        block.kind = BlockKind::picture;
        block.target = lead_.source;
    } else if (is_alone) {
        block.kind = BlockKind::math;
        block.runs = {MarkdownRun{lead_.source}};
    }
    lead_ = {};
}

bool Builder::leave_span(MD_SPANTYPE type) {
    switch (type) {
    case MD_SPAN_STRONG:
        --strong_;
        break;
    case MD_SPAN_CODE:
        --code_;
        break;
    case MD_SPAN_A:
        link_ = -1;
        break;
    case MD_SPAN_LATEXMATH:
    case MD_SPAN_LATEXMATH_DISPLAY: {
        std::vector<MarkdownRun>& runs = text_block().runs;
        const bool is_lead = runs.empty() && type == MD_SPAN_LATEXMATH_DISPLAY;
        for (MarkdownRun& part : math_runs(parse_math(formula_))) {
            part.link = link_;
            runs.push_back(std::move(part));
        }
        if (is_lead) lead_ = {BlockKind::math, formula_, runs.size()};
        break;
    }
    case MD_SPAN_IMG:
        --emphasis_;
        if (lead_.kind == BlockKind::picture && lead_.runs == 0)
            lead_.runs = text_block().runs.size();
        break;
    default:
        --emphasis_;
        break;
    }
    return true;
}

bool Builder::text(MD_TEXTTYPE type, std::string_view text) {
    if (type == MD_TEXT_LATEXMATH) {
        formula_ += text;
        return true;
    }
    std::string& out = run().text;
    const bool in_code_block = text_block().kind == BlockKind::code;
    switch (type) {
    case MD_TEXT_NULLCHAR:
        out += replacement_character;
        break;
    case MD_TEXT_BR:
        out += '\n';
        break;
    case MD_TEXT_SOFTBR:
        out += ' ';
        break;
    case MD_TEXT_ENTITY:
        append_entity(out, text);
        break;
    default:
        for (const char c : text) {
            if (c == '\t') {
                out += in_code_block ? "    " : " ";
            } else if (c == '\n' && !in_code_block) {
                out += ' ';
            } else {
                out += c;
            }
        }
    }
    return true;
}

} // namespace

MarkdownDocument parse_markdown(std::string_view text) {
    MarkdownDocument document;
    document.fault = size_fault(text);
    if (!document.fault.empty()) return document;
    std::string source = clean_text(text);
    document.notes = take_footnotes(source);
    document.fault = walk_fault(source);
    if (!document.fault.empty()) return document;
    Builder builder(document);
    const bool is_read = walk_markdown(source, builder);
    if (!is_read && document.fault.empty()) document.fault = "The text could not be read.";
    if (document.fault.empty()) {
        document.blocks = builder.take();
    } else {
        document.links.clear();
    }
    return document;
}

} // namespace rasterwalk
