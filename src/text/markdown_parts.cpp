#include "text/markdown_builder.h"

#include <algorithm>
#include <utility>

#include "base/text_parts.h"
#include "text/markdown_notes.h"
#include "text/markdown_text.h"
#include "text/math.h"
#include "text/math_runs.h"

namespace rasterwalk {

namespace {

using PartKind = MarkdownPart::Kind;

/// Total length of a page's link targets, bytes: reference links repeat theirs at every use.
constexpr std::size_t largest_targets = std::size_t{1} << 20;

/// How far to look for the parenthesis that closes a target, bytes.
constexpr std::size_t longest_target = 2000;

/// A target ready to follow, with its entities and escapes resolved.
std::string attribute_text(const MD_ATTRIBUTE& attribute) {
    std::string text;
    for (int i = 0; attribute.size > 0 && attribute.substr_offsets[i] < attribute.size; ++i) {
        const MD_OFFSET begin = attribute.substr_offsets[i];
        const std::string_view part(attribute.text + begin,
                                    attribute.substr_offsets[i + 1] - begin);
        if (attribute.substr_types[i] == MD_TEXT_ENTITY) {
            append_entity(text, part);
        } else if (attribute.substr_types[i] == MD_TEXT_NULLCHAR) {
            text += replacement_character;
        } else {
            text += part;
        }
    }
    return text;
}

} // namespace

bool MarkdownBuilder::begin_link(bool is_picture, const MD_ATTRIBUTE& target) {
    target_bytes_ += target.size;
    if (target_bytes_ > largest_targets) {
        document_.fault = "The targets of the links are longer than 1 MB together.";
        document_.fault_line = places_.line_at(places_.end);
        return false;
    }
    open_links_.push_back(
        {attribute_text(target), places_.find({target.text, target.size}), std::nullopt, {}});
    const std::string& text = open_links_.back().target;
    if (!is_picture) {
        link_ = static_cast<int>(document_.links.size());
        document_.links.push_back(text);
    } else if (text_block().runs.empty()) {
        lead_ = {MarkdownBlock::Kind::picture, text, 0};
    }
    return true;
}

void MarkdownBuilder::end_link(PartKind kind) {
    if (open_links_.empty()) return; // md4c 0.4.8 can report an end without its beginning
    OpenLink link = std::move(open_links_.back());
    open_links_.pop_back();
    if (!open_links_.empty()) open_links_.back().words += link.words;
    std::size_t& end = places_.end;
    const bool is_address = link.words_at && *link.words_at > 0 &&
                            page_[*link.words_at - 1] == '<' && end < page_.size() &&
                            page_[end] == '>';
    if (is_address) {
        const std::size_t begin = *link.words_at - 1;
        add(PartKind::address, std::string(page_.substr(begin, end + 1 - begin)),
            places_.line_at(begin));
        return;
    }
    const std::size_t close = std::min(page_.find(']', end), page_.size());
    add(kind, link.target, places_.line_at(close)).words = std::move(link.words);
    // What follows is looked for after the target, which may contain any characters.
    end = std::min(close + 1, page_.size());
    const bool is_behind = link.target_at && page_.substr(end).starts_with("(") &&
                           page_.find_first_not_of(" \t\n<", end + 1) == *link.target_at;
    if (is_behind) end = std::min(*link.target_at + link.target.size(), page_.size());
}

void MarkdownBuilder::end_formula(bool is_displayed) {
    std::vector<MarkdownRun>& runs = text_block().runs;
    const bool is_lead = runs.empty() && is_displayed;
    for (MarkdownRun& part : math_runs(parse_math(formula_))) {
        part.link = link_;
        runs.push_back(std::move(part));
    }
    if (is_lead) lead_ = {MarkdownBlock::Kind::math, formula_, runs.size()};
    // Between the dollar and the first letter there are only blanks.
    const std::size_t dollar = page_.rfind('$', formula_at_.value_or(places_.end));
    // Versions of md4c differ in the blanks that they put for line breaks.
    add(PartKind::formula, std::string(trimmed(formula_)),
        places_.line_at(std::min(dollar, page_.size())));
}

MarkdownPart& MarkdownBuilder::add(PartKind kind, std::string text, int line) {
    return document_.parts.emplace_back(MarkdownPart{kind, std::move(text), {}, 0, line});
}

void MarkdownBuilder::add_table(int line) {
    add(PartKind::table, {}, line).columns = std::exchange(columns_, 0);
}

void MarkdownBuilder::add_nesting(int line) {
    if (std::exchange(nested_line_, line) != line) add(PartKind::nesting, {}, line);
}

/// Takes note of letters in the page.
void MarkdownBuilder::look_at(MD_TEXTTYPE type, std::string_view text, std::size_t at) {
    const int line = places_.note(text, at);
    if (columns_ > 0) add_table(line);
    if (!open_links_.empty() && !open_links_.back().words_at) open_links_.back().words_at = at;
    if (type == MD_TEXT_LATEXMATH && !formula_at_) formula_at_ = at;
    if (emphasis_ + strong_ + (link_ >= 0 ? 1 : 0) > deepest_) add_nesting(line);
    if (type == MD_TEXT_NORMAL) look_for_brackets(text, at);
}

/// Looks through letters that are drawn as written.
void MarkdownBuilder::look_for_brackets(std::string_view text, std::size_t at) {
    for (std::size_t i = 0; (i = text.find_first_of("[]<", i)) != text.npos; ++i) {
        const std::string_view rest = text.substr(i);
        if (rest[0] == '<') {
            if (rest.starts_with("<!--")) add(PartKind::comment, {}, places_.line_at(at + i));
        } else if (rest[0] == '[') {
            const std::string_view label = footnote_label(rest);
            if (!label.empty())
                add(PartKind::footnote, std::string(label), places_.line_at(at + i));
            if (++brackets_ > deepest_) add_nesting(places_.line_at(at + i));
        } else if (brackets_ > 0) {
            --brackets_;
            if (page_.substr(at + i + 1).starts_with("(")) look_for_target(at + i + 1);
        }
    }
}

/// From the parenthesis after [words] to the one that closes it.
void MarkdownBuilder::look_for_target(std::size_t open) {
    std::string_view near = page_.substr(open, longest_target);
    near = near.substr(0, near.find("\n\n"));
    int depth = 0;
    for (std::size_t i = 0; i < near.size(); ++i) {
        if (near[i] == '(') ++depth;
        if (near[i] == ')') --depth;
        if (depth > 0) continue;
        const std::string_view target = trimmed(near.substr(1, i - 1));
        if (target.find_first_of(" \t\n") != target.npos) {
            add(PartKind::split_target, std::string(target), places_.line_at(open + i));
        }
        return;
    }
}

} // namespace rasterwalk
