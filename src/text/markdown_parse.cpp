#include "text/markdown.h"

#include <algorithm>
#include <utility>

#include "base/text_parts.h"
#include "text/markdown_builder.h"
#include "text/markdown_notes.h"
#include "text/markdown_text.h"

namespace rasterwalk {

namespace {

using BlockKind = MarkdownBlock::Kind;
using PartKind = MarkdownPart::Kind;

/// The parser looks through all lines of a paragraph for each bracket in it; this many take about a
/// tenth of a second.
constexpr std::size_t most_bracket_looks = 200'000'000;

/// Would the parser look through lines for brackets more often than allowed?
bool is_bracket_swamp(std::string_view text) {
    std::size_t lines = 0, brackets = 0, looks = 0;
    while (!text.empty()) {
        const std::string_view line = take_part(text, '\n');
        if (line.find_first_not_of(" \t") == std::string_view::npos) {
            looks += lines * brackets;
            lines = brackets = 0;
        } else {
            ++lines;
            brackets += static_cast<std::size_t>(std::count(line.begin(), line.end(), '['));
        }
    }
    return looks + lines * brackets > most_bracket_looks;
}

bool is_container(MD_BLOCKTYPE type) {
    return type == MD_BLOCK_QUOTE || type == MD_BLOCK_UL || type == MD_BLOCK_OL ||
           type == MD_BLOCK_LI;
}

} // namespace

bool has_same_style(const MarkdownRun& a, const MarkdownRun& b) {
    return a.emphasis == b.emphasis && a.strong == b.strong && a.code == b.code &&
           a.link == b.link && a.raised == b.raised && a.vector == b.vector;
}

MarkdownRun& run_like(std::vector<MarkdownRun>& runs, const MarkdownRun& style) {
    if (runs.empty() || !has_same_style(runs.back(), style))
        runs.push_back(
            {{}, style.emphasis, style.strong, style.code, style.link, style.raised, style.vector});
    return runs.back();
}

MarkdownBlock& MarkdownBuilder::push(BlockKind kind) {
    Open& parent = open_.back();
    parent.has_loose_text = false;
    MarkdownBlock& block = parent.block->children.emplace_back();
    block.kind = kind;
    open_.push_back({&block, false});
    return block;
}

/// Items of a tight list hold their text without a paragraph around it.
MarkdownBlock& MarkdownBuilder::text_block() {
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
MarkdownRun& MarkdownBuilder::run() {
    return run_like(text_block().runs, {{}, emphasis_ > 0, strong_ > 0, code_ > 0, link_, 0});
}

bool MarkdownBuilder::enter(MD_BLOCKTYPE type, const void* detail) {
    if (is_too_deep_) return true;
    brackets_ = 0;
    open_links_.clear();
    if (is_container(type)) ++containers_;
    if (containers_ > deepest_ || open_.size() > static_cast<std::size_t>(deepest_markdown)) {
        is_too_deep_ = true;
        return true;
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
        columns_ = static_cast<int>(static_cast<const MD_BLOCK_TABLE_DETAIL*>(detail)->col_count);
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

void MarkdownBuilder::leave(MD_BLOCKTYPE type) {
    if (is_too_deep_) return;
    if (is_container(type)) --containers_;
    if (type == MD_BLOCK_THEAD && columns_ > 0) add_table(places_.line_ahead());
    if (type == MD_BLOCK_DOC || type == MD_BLOCK_THEAD || type == MD_BLOCK_TBODY) return;
    MarkdownBlock& block = *open_.back().block;
    open_.pop_back();
    if (block.kind == BlockKind::code && !block.runs.empty()) {
        std::string& text = block.runs.back().text;
        if (text.ends_with('\n')) text.pop_back();
    }
    if (type == MD_BLOCK_P) leave_paragraph(block);
    if (block.kind != BlockKind::quote || block.children.size() < 2) return;
    const MarkdownBlock& first = block.children.front();
    if (first.kind == BlockKind::paragraph && first.runs.size() == 1 && first.runs[0].strong) {
        block.label = first.runs[0].text;
        block.children.erase(block.children.begin());
    }
}

/// A picture or a formula that is all of its paragraph becomes a block of its own.
void MarkdownBuilder::leave_paragraph(MarkdownBlock& block) {
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

bool MarkdownBuilder::enter_span(MD_SPANTYPE type, const void* detail) {
    if (is_too_deep_) return true;
    switch (type) {
    case MD_SPAN_STRONG:
        ++strong_;
        return true;
    case MD_SPAN_CODE:
        ++code_;
        return true;
    case MD_SPAN_A:
        return begin_link(false, static_cast<const MD_SPAN_A_DETAIL*>(detail)->href);
    case MD_SPAN_IMG:
        ++emphasis_; // within a text, a picture's alternative text
        return begin_link(true, static_cast<const MD_SPAN_IMG_DETAIL*>(detail)->src);
    case MD_SPAN_LATEXMATH:
    case MD_SPAN_LATEXMATH_DISPLAY:
        formula_.clear();
        formula_at_.reset();
        return true;
    default:
        ++emphasis_;
        return true;
    }
}

void MarkdownBuilder::leave_span(MD_SPANTYPE type) {
    if (is_too_deep_) return;
    switch (type) {
    case MD_SPAN_STRONG:
        --strong_;
        break;
    case MD_SPAN_CODE:
        --code_;
        break;
    case MD_SPAN_A:
        link_ = -1;
        end_link(PartKind::link);
        break;
    case MD_SPAN_IMG:
        --emphasis_;
        if (lead_.kind == BlockKind::picture && lead_.runs == 0)
            lead_.runs = text_block().runs.size();
        end_link(PartKind::picture);
        break;
    case MD_SPAN_LATEXMATH:
    case MD_SPAN_LATEXMATH_DISPLAY:
        end_formula(type == MD_SPAN_LATEXMATH_DISPLAY);
        break;
    default:
        --emphasis_;
        break;
    }
}

bool MarkdownBuilder::text(MD_TEXTTYPE type, std::string_view text) {
    const std::optional<std::size_t> at = places_.find(text);
    if (is_too_deep_) {
        if (at) document_.fault_line = places_.line_at(*at);
        return !at;
    }
    if (type == MD_TEXT_LATEXMATH) {
        formula_ += text;
    } else {
        append_text(type, text);
        if (!open_links_.empty()) open_links_.back().words += text;
    }
    if (at) look_at(type, text, *at);
    return true;
}

void MarkdownBuilder::append_text(MD_TEXTTYPE type, std::string_view text) {
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
}

MarkdownDocument MarkdownBuilder::build() {
    MD_PARSER parser{};
    parser.flags = MD_FLAG_TABLES | MD_FLAG_NOHTML | MD_FLAG_LATEXMATHSPANS;
    // md4c ignores positive answers.
    constexpr int goes_on = 0, ends = -1;
    parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* data) {
        return static_cast<MarkdownBuilder*>(data)->enter(type, detail) ? goes_on : ends;
    };
    parser.leave_block = [](MD_BLOCKTYPE type, void*, void* data) {
        static_cast<MarkdownBuilder*>(data)->leave(type);
        return goes_on;
    };
    parser.enter_span = [](MD_SPANTYPE type, void* detail, void* data) {
        return static_cast<MarkdownBuilder*>(data)->enter_span(type, detail) ? goes_on : ends;
    };
    parser.leave_span = [](MD_SPANTYPE type, void*, void* data) {
        static_cast<MarkdownBuilder*>(data)->leave_span(type);
        return goes_on;
    };
    parser.text = [](MD_TEXTTYPE type, const MD_CHAR* part, MD_SIZE size, void* data) {
        return static_cast<MarkdownBuilder*>(data)->text(type, {part, size}) ? goes_on : ends;
    };
    const bool is_read =
        md_parse(page_.data(), static_cast<MD_SIZE>(page_.size()), &parser, this) == 0;
    if (is_too_deep_) {
        if (is_read) document_.fault_line = places_.line_ahead();
        document_.fault = "The text is nested deeper than " + std::to_string(deepest_) + " levels.";
    } else if (!is_read && document_.fault.empty()) {
        document_.fault = "The text could not be read.";
    }
    if (document_.fault.empty()) {
        document_.blocks = std::move(root_.children);
        for (const int line : places_.definitions())
            add(PartKind::definition, {}, line);
    } else {
        document_.links.clear();
    }
    return std::move(document_);
}

namespace {

/// @param with_notes takes the footnotes out of the text
MarkdownDocument parse(std::string_view text, int deepest, bool with_notes) {
    MarkdownDocument document;
    if (text.size() > largest_markdown) {
        document.fault = "The text is longer than 1 MB.";
        return document;
    }
    std::string page = clean_text(text);
    std::vector<std::string> notes;
    if (with_notes) notes = take_footnotes(page);
    if (is_bracket_swamp(page)) {
        document.fault = "A paragraph has too many lines and brackets.";
    } else {
        document = MarkdownBuilder(page, deepest).build();
    }
    document.notes = std::move(notes);
    return document;
}

} // namespace

MarkdownDocument parse_markdown(std::string_view text) {
    return parse(text, deepest_markdown, true);
}

MarkdownDocument parse_as_written(std::string_view text, int deepest) {
    return parse(text, deepest, false);
}

} // namespace rasterwalk
