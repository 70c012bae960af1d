#include "text/markdown_parts.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "base/text_parts.h"
#include "text/markdown.h"
#include "text/markdown_notes.h"
#include "text/markdown_text.h"
#include "text/markdown_walk.h"

namespace rasterwalk {

namespace {

using PartKind = MarkdownPart::Kind;

/// How far to look for the parenthesis that closes a target, bytes.
constexpr std::size_t longest_target = 2000;

/// Finds the parts of a page during the walk. The walk gives only the places of letters, as
/// pointers into the page; the marks around them are found from there.
class PartFinder final : public MarkdownListener {
  public:
    PartFinder(std::string_view page, int deepest)
        : page_(page), deepest_(deepest),
          is_drawn_(static_cast<std::size_t>(std::count(page.begin(), page.end(), '\n')) + 1) {}

    MarkdownParts take(bool is_read);

    bool enter(MD_BLOCKTYPE type, const void* detail) override;
    bool leave(MD_BLOCKTYPE type) override;
    bool enter_span(MD_SPANTYPE type, const void* detail) override;
    bool leave_span(MD_SPANTYPE type) override;
    bool text(MD_TEXTTYPE type, std::string_view text) override;

  private:
    /// A link or picture that has begun.
    struct Open {
        std::string target;
        std::optional<std::size_t> target_at; ///< in the page
        std::optional<std::size_t> words_at;  ///< also in the page
        std::string words;
    };

    std::optional<std::size_t> place_of(std::string_view text) const;
    int line_at(std::size_t place);
    int line_ahead();
    void add(PartKind kind, std::string text, int line);
    void look_for_brackets(std::string_view text, std::size_t at);
    void look_for_target(std::size_t open);
    void tell_nesting(int line);
    void end_link(PartKind kind);
    void find_definitions();

    std::string_view page_;
    int deepest_;
    MarkdownParts found_;
    std::vector<bool> is_drawn_; ///< of each line: letters of it were reported
    std::size_t counted_ = 0;    ///< lines have been counted up to here
    int line_ = 0;               ///< of that place
    std::size_t end_ = 0;        ///< of what was reported last
    int containers_ = 0;         ///< open quotes, lists and items
    int spans_ = 0;              ///< open emphasis and links
    int brackets_ = 0;           ///< open in this block, and not links
    bool is_too_deep_ = false;   ///< the next letters show the line
    int columns_ = 0;            ///< of a table, until letters of it show the line
    int nested_line_ = -1;       ///< where nesting was reported last
    std::size_t target_bytes_ = 0;
    std::vector<Open> open_;
    std::string formula_;
    std::optional<std::size_t> formula_at_; ///< its first letter
};

std::optional<std::size_t> PartFinder::place_of(std::string_view text) const {
    const std::less_equal<const char*> precedes;
    const char* const begin = page_.data();
    const bool is_inside = text.data() != nullptr && precedes(begin, text.data()) &&
                           precedes(text.data() + text.size(), begin + page_.size());
    return is_inside ? std::optional(static_cast<std::size_t>(text.data() - begin)) : std::nullopt;
}

/// Places come nearly in order, so lines are counted on from the last one.
int PartFinder::line_at(std::size_t place) {
    const auto lines_between = [&](std::size_t from, std::size_t to) {
        const std::string_view between = page_.substr(from, to - from);
        return static_cast<int>(std::count(between.begin(), between.end(), '\n'));
    };
    line_ += place >= counted_ ? lines_between(counted_, place) : -lines_between(place, counted_);
    counted_ = place;
    return line_;
}

/// The line of something without letters: the next that is not empty.
int PartFinder::line_ahead() {
    const std::size_t from = end_ == 0 ? 0 : std::min(page_.find('\n', end_), page_.size());
    return line_at(std::min(page_.find_first_not_of(" \t\n", from), page_.size()));
}

void PartFinder::add(PartKind kind, std::string text, int line) {
    MarkdownPart& part = found_.parts.emplace_back();
    part.kind = kind;
    part.text = std::move(text);
    part.line = line;
}

bool PartFinder::enter(MD_BLOCKTYPE type, const void* detail) {
    brackets_ = spans_ = 0;
    open_.clear();
    if (type == MD_BLOCK_QUOTE || type == MD_BLOCK_UL || type == MD_BLOCK_OL ||
        type == MD_BLOCK_LI) {
        if (++containers_ > deepest_) is_too_deep_ = true;
    } else if (type == MD_BLOCK_TABLE) {
        columns_ = static_cast<int>(static_cast<const MD_BLOCK_TABLE_DETAIL*>(detail)->col_count);
    }
    return true;
}

bool PartFinder::leave(MD_BLOCKTYPE type) {
    if (type == MD_BLOCK_QUOTE || type == MD_BLOCK_UL || type == MD_BLOCK_OL ||
        type == MD_BLOCK_LI) {
        --containers_;
    } else if (type == MD_BLOCK_THEAD && columns_ > 0) {
        add(PartKind::table, {}, line_ahead());
        found_.parts.back().columns = std::exchange(columns_, 0);
    }
    return true;
}

bool PartFinder::enter_span(MD_SPANTYPE type, const void* detail) {
    if (type == MD_SPAN_LATEXMATH || type == MD_SPAN_LATEXMATH_DISPLAY) {
        formula_.clear();
        formula_at_.reset();
        return true;
    }
    if (type == MD_SPAN_CODE) return true;
    ++spans_;
    if (type != MD_SPAN_A && type != MD_SPAN_IMG) return true;
    const MD_ATTRIBUTE& target = type == MD_SPAN_A
                                     ? static_cast<const MD_SPAN_A_DETAIL*>(detail)->href
                                     : static_cast<const MD_SPAN_IMG_DETAIL*>(detail)->src;
    target_bytes_ += target.size;
    if (target_bytes_ > largest_targets) {
        found_.fault = targets_fault;
        found_.fault_line = line_at(end_);
        return false;
    }
    open_.push_back(
        {attribute_text(target), place_of({target.text, target.size}), std::nullopt, {}});
    return true;
}

bool PartFinder::leave_span(MD_SPANTYPE type) {
    switch (type) {
    case MD_SPAN_CODE:
        return true;
    case MD_SPAN_LATEXMATH:
    case MD_SPAN_LATEXMATH_DISPLAY: {
        // Between the dollar and the first letter there are only blanks.
        const std::size_t dollar = page_.rfind('$', formula_at_.value_or(end_));
        // Versions of md4c differ in the blanks that they put for line breaks.
        add(PartKind::formula, std::string(trimmed(formula_)),
            line_at(std::min(dollar, page_.size())));
        return true;
    }
    case MD_SPAN_A:
        end_link(PartKind::link);
        break;
    case MD_SPAN_IMG:
        end_link(PartKind::picture);
        break;
    default:
        break;
    }
    --spans_;
    return true;
}

void PartFinder::end_link(PartKind kind) {
    if (open_.empty()) return; // md4c 0.4.8 can report an end without its beginning
    const Open link = std::move(open_.back());
    open_.pop_back();
    if (!open_.empty()) open_.back().words += link.words;
    const bool is_address = link.words_at && *link.words_at > 0 &&
                            page_[*link.words_at - 1] == '<' && end_ < page_.size() &&
                            page_[end_] == '>';
    if (is_address) {
        const std::size_t begin = *link.words_at - 1;
        add(PartKind::address, std::string(page_.substr(begin, end_ + 1 - begin)), line_at(begin));
        return;
    }
    const std::size_t close = std::min(page_.find(']', end_), page_.size());
    add(kind, link.target, line_at(close));
    found_.parts.back().words = link.words;
    // What follows is looked for after the target, which may contain any characters.
    end_ = std::min(close + 1, page_.size());
    const bool is_behind = link.target_at && page_.substr(end_).starts_with("(") &&
                           page_.find_first_not_of(" \t\n<", end_ + 1) == *link.target_at;
    if (is_behind) end_ = std::min(*link.target_at + link.target.size(), page_.size());
}

bool PartFinder::text(MD_TEXTTYPE type, std::string_view text) {
    if (type == MD_TEXT_LATEXMATH) {
        formula_ += text;
    } else if (!open_.empty()) {
        open_.back().words += text;
    }
    const std::optional<std::size_t> at = place_of(text);
    if (!at) return true;
    const int line = line_at(*at);
    is_drawn_[static_cast<std::size_t>(line)] = true;
    end_ = *at + text.size();
    if (is_too_deep_) {
        found_.fault_line = line;
        return false;
    }
    if (columns_ > 0) {
        add(PartKind::table, {}, line);
        found_.parts.back().columns = std::exchange(columns_, 0);
    }
    if (!open_.empty() && !open_.back().words_at) open_.back().words_at = *at;
    if (type == MD_TEXT_LATEXMATH && !formula_at_) formula_at_ = *at;
    if (spans_ > deepest_) tell_nesting(line);
    if (type == MD_TEXT_NORMAL) look_for_brackets(text, *at);
    return true;
}

/// Looks through letters that are drawn as written.
void PartFinder::look_for_brackets(std::string_view text, std::size_t at) {
    for (std::size_t i = 0; (i = text.find_first_of("[]<", i)) != text.npos; ++i) {
        const std::string_view rest = text.substr(i);
        if (rest[0] == '<') {
            if (rest.starts_with("<!--")) add(PartKind::comment, {}, line_at(at + i));
        } else if (rest[0] == '[') {
            const std::string_view label = footnote_label(rest);
            if (!label.empty()) add(PartKind::footnote, std::string(label), line_at(at + i));
            if (++brackets_ > deepest_) tell_nesting(line_at(at + i));
        } else if (brackets_ > 0) {
            --brackets_;
            if (page_.substr(at + i + 1).starts_with("(")) look_for_target(at + i + 1);
        }
    }
}

/// From the parenthesis after [words] to the one that closes it.
void PartFinder::look_for_target(std::size_t open) {
    std::string_view near = page_.substr(open, longest_target);
    near = near.substr(0, near.find("\n\n"));
    int depth = 0;
    for (std::size_t i = 0; i < near.size(); ++i) {
        if (near[i] == '(') ++depth;
        if (near[i] == ')') --depth;
        if (depth > 0) continue;
        const std::string_view target = trimmed(near.substr(1, i - 1));
        if (target.find_first_of(" \t\n") != target.npos) {
            add(PartKind::split_target, std::string(target), line_at(open + i));
        }
        return;
    }
}

void PartFinder::tell_nesting(int line) {
    if (nested_line_ == line) return;
    nested_line_ = line;
    add(PartKind::nesting, {}, line);
}

/// A line that begins like a definition, and of which nothing was reported, is one.
void PartFinder::find_definitions() {
    std::string_view rest = page_;
    for (std::size_t line = 0; line < is_drawn_.size(); ++line) {
        const std::string_view whole = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(whole.size() + 1, rest.size()));
        // After the marks of quotes and lists.
        const std::size_t start = whole.find_first_not_of(" \t>-*+0123456789.)");
        const bool is_definition = !is_drawn_[line] && start != whole.npos && whole[start] == '[' &&
                                   whole.find("]:", start) != whole.npos;
        if (is_definition) add(PartKind::definition, {}, static_cast<int>(line));
    }
}

MarkdownParts PartFinder::take(bool is_read) {
    if (is_too_deep_) {
        if (is_read) found_.fault_line = line_ahead();
        found_.fault = nesting_fault(deepest_);
    } else if (!is_read && found_.fault.empty()) {
        found_.fault = "The text could not be read.";
    }
    if (found_.fault.empty()) find_definitions();
    return std::move(found_);
}

} // namespace

MarkdownParts find_markdown_parts(std::string_view text, int deepest) {
    MarkdownParts none;
    none.fault = size_fault(text);
    if (!none.fault.empty()) return none;
    const std::string page = clean_text(text);
    none.fault = walk_fault(page);
    if (!none.fault.empty()) return none;
    PartFinder finder(page, deepest);
    const bool is_read = walk_markdown(page, finder);
    return finder.take(is_read);
}

} // namespace rasterwalk
