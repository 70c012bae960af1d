#include <algorithm>
#include <cmath>
#include <span>

#include "text/math_runs.h"
#include "ui/page/markdown_words.h"
#include "ui/page/math_layout.h"
#include "ui/page/page_setter.h"

namespace rasterwalk {

namespace {

/// Words that head a box and give it its colour.
PageTint label_tint(std::string_view label) {
    const auto says = [&](std::string_view word) { return label.find(word) != label.npos; };
    if (says("Try") || says("Task")) return PageTint::task;
    if (says("mistake")) return PageTint::mistake;
    return PageTint::link;
}

std::string capitals(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return result;
}

} // namespace

void PageSetter::list(const MarkdownBlock& list, float x, float width) {
    std::string last_number;
    if (list.is_numbered) {
        last_number = std::to_string(list.start + static_cast<long>(list.children.size()) - 1);
    }
    const float number = list.is_numbered ? width_of(fonts_.text, last_number + ".") : 0.0f;
    const float wished = list.is_numbered ? number + 0.5f * em_ : 1.15f * em_;
    // Deeply nested lists are indented in ever smaller steps, and never leave the column.
    const float indent = std::round(std::min(wished, 0.25f * width));
    for (std::size_t i = 0; i < list.children.size(); ++i) {
        if (i > 0) y += list.is_tight ? 0.35f * em_ : 0.75f * em_;
        const float line = std::round(1.4f * em_);
        if (list.is_numbered) {
            page_.made.push_back(std::to_string(list.start + static_cast<long>(i)) + ".");
            const std::string& own = page_.made.back();
            const float own_width = width_of(fonts_.text, own);
            page_.pieces.push_back({.at = {x + std::max(number - own_width, 0.0f),
                                           y + std::round(0.5f * (line - em_))},
                                    .width = own_width,
                                    .text = own,
                                    .tint = PageTint::dim});
        } else {
            const float r = 2.3f * u_;
            const ImVec2 c{x + 0.4f * indent, y + 0.5f * line + 0.03f * em_};
            page_.shapes.push_back(
                {PageShape::Kind::bullet, {c.x - r, c.y - r}, {c.x + r, c.y + r}});
        }
        const float before = y;
        blocks(list.children[i].children, x + indent, width - indent);
        if (y > before) continue;
        page_.lines.push_back({y, y + line}); // an empty item still has its mark
        y += line;
    }
}

/// How much of a line of code goes into `room`: all of it, or up to a blank, but at least a letter.
std::size_t PageSetter::code_line_length(std::string_view line, float room) const {
    // Nothing to measure, and perhaps no data, which ImGui would still read.
    if (line.empty()) return 0;
    const char* stop = nullptr;
    fonts_.mono->CalcTextSizeA(fonts_.mono->FontSize, std::max(room, 0.0f), 0.0f, line.data(),
                               line.data() + line.size(), &stop);
    auto length = static_cast<std::size_t>(stop - line.data());
    if (length >= line.size()) return line.size();
    const std::string_view fitting = line.substr(0, length);
    const std::size_t blank = fitting.find_last_of(' ');
    const std::size_t first_letter = fitting.find_first_not_of(' ');
    if (blank != line.npos && first_letter != line.npos && blank > first_letter) length = blank + 1;
    return character_end(line, length);
}

void PageSetter::code(const MarkdownBlock& code, float x, float width) {
    const ImVec2 padding{std::min(10.0f * u_, 0.1f * width), 7.0f * u_};
    const std::size_t shape = page_.shapes.size();
    page_.shapes.push_back({PageShape::Kind::card, {x, y}, {x + width, y}});
    const float line_height = std::round(1.4f * fonts_.mono->FontSize);
    const float letter = fonts_.mono->GetCharAdvance('0');
    const float room = width - 2.0f * padding.x;
    y += padding.y;
    std::string_view rest = code.runs.empty() ? std::string_view() : code.runs[0].text;
    for (bool more = true; more;) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        more = end < rest.size();
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(more ? end + 1 : end);
        float indent = 0.0f;
        do {
            const std::size_t length = code_line_length(line, room - indent);
            page_.pieces.push_back(
                {.at = {x + padding.x + indent,
                        y + std::round(0.5f * (line_height - fonts_.mono->FontSize))},
                 .width = width_of(fonts_.mono, line.substr(0, length)),
                 .text = line.substr(0, length),
                 .font = PageFont::mono});
            page_.lines.push_back({y, y + line_height});
            y += line_height;
            line.remove_prefix(length);
            indent = std::min(2.0f * letter, 0.25f * room);
        } while (!line.empty());
    }
    y += padding.y;
    page_.shapes[shape].high.y = y;
}

void PageSetter::box(const MarkdownBlock& quote, float x, float width) {
    const float bar = 3.0f * u_;
    const float padding = std::min(12.0f * u_, 0.1f * width);
    const PageTint tint = label_tint(quote.label);
    const std::size_t shape = page_.shapes.size();
    page_.shapes.push_back({PageShape::Kind::card, {x, y}, {x + width, y}});
    page_.shapes.push_back({PageShape::Kind::bar, {x, y}, {x + bar, y}, tint});
    const float left = std::min(std::round(bar + padding), width);
    y += 9.0f * u_;
    if (!quote.label.empty()) {
        page_.made.push_back(capitals(quote.label));
        // A separate run, because the document's is not in capitals.
        const MarkdownRun run{page_.made.back(), false, false, false, -1};
        TextLook look{.font = PageFont::small, .tint = tint};
        const std::size_t first = page_.pieces.size();
        text({&run, 1}, x + left, width - left - padding, look);
        for (std::size_t i = first; i < page_.pieces.size(); ++i) {
            PagePiece& piece = page_.pieces[i];
            const auto offset = static_cast<std::size_t>(piece.text.data() - run.text.data());
            piece.text = std::string_view(page_.made.back()).substr(offset, piece.text.size());
        }
        y += 2.0f * u_;
    }
    blocks(quote.children, x + left, width - left - padding);
    y += 9.0f * u_;
    page_.shapes[shape].high.y = page_.shapes[shape + 1].high.y = y;
}

/// Columns as wide as their longest line if there is room; otherwise as their longest word and a
/// share of what is left.
std::vector<float> PageSetter::column_widths(const MarkdownBlock& table, float width) const {
    std::vector<float> least, wished;
    for (const MarkdownBlock& row : table.children) {
        least.resize(std::max(least.size(), row.children.size()));
        wished.resize(least.size());
        for (std::size_t c = 0; c < row.children.size(); ++c) {
            const TextLook look{.font =
                                    row.children[c].is_header ? PageFont::bold : PageFont::text};
            const WordList list = words_of(row.children[c], look, width);
            least[c] = std::max(least[c], list.widest_word);
            wished[c] = std::max(wished[c], list.whole_width);
        }
    }
    float least_sum = 0.0f, wished_sum = 0.0f;
    for (std::size_t c = 0; c < least.size(); ++c) {
        least_sum += least[c];
        wished_sum += wished[c];
    }
    std::vector<float> widths(least.size());
    for (std::size_t c = 0; c < least.size(); ++c) {
        if (wished_sum <= width) {
            widths[c] = wished[c];
        } else if (least_sum < width) {
            const float share = (wished[c] - least[c]) / (wished_sum - least_sum);
            widths[c] = std::floor(least[c] + share * (width - least_sum));
        } else {
            widths[c] = std::floor(width * least[c] / least_sum);
        }
    }
    return widths;
}

void PageSetter::table(const MarkdownBlock& table, float x, float width) {
    std::size_t columns = 1;
    for (const MarkdownBlock& row : table.children)
        columns = std::max(columns, row.children.size());
    const float gap = std::min(16.0f * u_, 0.5f * width / static_cast<float>(columns));
    const std::vector<float> widths =
        column_widths(table, width - gap * static_cast<float>(columns - 1));
    for (std::size_t r = 0; r < table.children.size(); ++r) {
        const MarkdownBlock& row = table.children[r];
        y += 4.0f * u_;
        const float top = y;
        float bottom = top, left = x;
        for (std::size_t c = 0; c < row.children.size(); ++c) {
            const MarkdownBlock& cell = row.children[c];
            y = top;
            text(cell.runs, left, widths[c],
                 {.font = cell.is_header ? PageFont::bold : PageFont::text, .align = cell.align});
            bottom = std::max(bottom, y);
            left += widths[c] + gap;
        }
        page_.lines.push_back({top, bottom});
        y = bottom + 4.0f * u_;
        if (r + 1 < table.children.size()) {
            page_.shapes.push_back({PageShape::Kind::line, {x, y}, {x + width, y + u_}});
        }
    }
}

/// In the middle of the column; a wider formula is set as text.
void PageSetter::math(const MarkdownBlock& formula, float x, float width) {
    if (formula.runs.empty()) return;
    const MathNode tree = parse_math(formula.runs[0].text);
    MathBox box = set_math(tree, fonts_, u_, page_.made);
    const std::size_t first = page_.pieces.size();
    if (box.width > width) {
        page_.runs.push_back(math_runs(tree));
        text(page_.runs.back(), x, width, {});
        return;
    }
    const float left = x + std::floor(0.5f * (width - box.width));
    const float baseline = y + std::ceil(box.ascent);
    page_.pieces.insert(page_.pieces.end(), box.pieces.begin(), box.pieces.end());
    for (std::size_t i = first; i < page_.pieces.size(); ++i) {
        ImVec2& at = page_.pieces[i].at;
        at = {at.x + left, at.y + baseline};
    }
    for (PageShape& shape : box.shapes) {
        shape.low = {shape.low.x + left, shape.low.y + baseline};
        shape.high = {shape.high.x + left, shape.high.y + baseline};
        page_.shapes.push_back(shape);
    }
    const float bottom = baseline + std::ceil(box.descent);
    page_.lines.push_back({y, bottom});
    y = bottom;
}

/// As wide as the column at most; a picture that cannot be shown is replaced by its words.
void PageSetter::picture(const MarkdownBlock& picture, float x, float width) {
    const ImVec2 size = picture_size_ ? picture_size_(picture.target) : ImVec2(0, 0);
    if (size.x < 1.0f || size.y < 1.0f) {
        text(picture.runs, x, width, {.tint = PageTint::dim});
        return;
    }
    const float shown = std::max(std::floor(std::min(width, size.x * u_)), 1.0f);
    const float left = x + std::floor(0.5f * (width - shown));
    const float height = std::ceil(shown * size.y / size.x);
    page_.pictures.push_back({{left, y}, {left + shown, y + height}, picture.target});
    y += height;
}

} // namespace rasterwalk
