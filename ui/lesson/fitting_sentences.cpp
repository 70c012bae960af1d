#include "ui/lesson/fitting_sentences.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "text/sentences.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"
#include "ui/widgets/layout.h"

namespace rasterwalk {

namespace {

float height_of_lines(Ui& ui, float width, int lines) {
    const float one = markdown_height(ui, "x", width), two = markdown_height(ui, "x\\\ny", width);
    return one + static_cast<float>(lines - 1) * (two - one) + 0.5f;
}

/// The head of the table at the end of a piece, and some of its rows.
MarkdownDocument some_rows(const MarkdownDocument& piece, std::size_t first, std::size_t count) {
    MarkdownDocument part = piece;
    part.blocks = {piece.blocks.back()};
    std::vector<MarkdownBlock>& rows = part.blocks.front().children;
    const auto begin = rows.begin() + 1 + static_cast<std::ptrdiff_t>(first);
    rows.erase(std::min(begin + static_cast<std::ptrdiff_t>(count), rows.end()), rows.end());
    rows.erase(rows.begin() + 1, begin);
    return part;
}

/// The words before the table at the end of a piece, and the table in as few parts as have room.
void add_table(Ui& ui, const MarkdownDocument& piece, float width, float most,
               std::vector<MarkdownDocument>& parts) {
    if (piece.blocks.size() > 1) {
        parts.push_back(piece);
        parts.back().blocks.pop_back();
    }
    const std::size_t rows = piece.blocks.back().children.size() - 1;
    const auto fits = [&](std::size_t first, std::size_t count) {
        return markdown_height(ui, some_rows(piece, first, count), width) <= most;
    };
    std::vector<std::size_t> counts; // as many rows as have room, part by part
    for (std::size_t r = 0; r < rows; r += counts.back()) {
        counts.push_back(1);
        while (r + counts.back() < rows && fits(r, counts.back() + 1))
            ++counts.back();
    }
    // Three and two rows are better than four and one.
    const std::size_t even = (rows + counts.size() - 1) / counts.size();
    bool is_even = true;
    for (std::size_t r = 0; r < rows; r += even)
        is_even = is_even && fits(r, even);
    std::size_t first = 0;
    for (std::size_t i = 0; first < rows; ++i) {
        const std::size_t count = is_even ? even : counts[i];
        parts.push_back(some_rows(piece, first, count));
        first += count;
    }
}

} // namespace

int lines_of_strip(const Ui& ui) {
    // In a squat window the table below needs the room.
    const bool has_room = !is_squat(ImGui::GetIO().DisplaySize, ui.options);
    return ui.lesson.strip.is_at_side && has_room ? 4 : 2;
}

std::vector<MarkdownDocument> fitting_parts(Ui& ui, const MarkdownDocument& page, float width,
                                            int lines, float most) {
    const float room = height_of_lines(ui, width, lines);
    std::vector<MarkdownDocument> parts;
    for (ReadingPiece& piece : reading_pieces(page)) {
        if (!piece.is_first) {
            MarkdownDocument longer = continued(parts.back(), piece.page);
            if (markdown_height(ui, longer, width) <= room) {
                parts.back() = std::move(longer);
                continue;
            }
        }
        const MarkdownBlock& last = piece.page.blocks.back();
        const bool is_long_table = last.kind == MarkdownBlock::Kind::table &&
                                   last.children.size() > 2 &&
                                   markdown_height(ui, piece.page, width) > most;
        const bool is_with_picture =
            last.kind == MarkdownBlock::Kind::picture && piece.page.blocks.size() > 1;
        if (is_with_picture) {
            MarkdownDocument words = piece.page, picture = piece.page;
            words.blocks.pop_back();
            picture.blocks = {last};
            parts.push_back(std::move(words));
            parts.push_back(std::move(picture));
        } else if (is_long_table) {
            add_table(ui, piece.page, width, most, parts);
        } else {
            parts.push_back(std::move(piece.page));
        }
    }
    return parts;
}

namespace {

MarkdownDocument work_out(Ui& ui, const std::string& text, float width, int lines) {
    MarkdownDocument page = parse_markdown(text), dots = parse_markdown("…");
    const bool is_one_block = page.blocks.size() == 1;
    std::erase_if(page.blocks, [](const MarkdownBlock& block) {
        return block.kind != MarkdownBlock::Kind::paragraph;
    });
    page.blocks.resize(std::min(page.blocks.size(), std::size_t{1}));
    page.notes.clear();
    const std::vector<MarkdownDocument> parts = fitting_parts(ui, page, width, lines, 0.0f);
    if (parts.empty()) return dots;
    return is_one_block && parts.size() == 1 ? parts.front() : continued(parts.front(), dots);
}

} // namespace

MarkdownDocument fitting_sentences(Ui& ui, const std::string& text, float width, int lines) {
    LessonStrip::Fitting& kept = ui.lesson.strip.fitting;
    const float text_size = ui.fonts.text->FontSize;
    const bool is_known = kept.of == text && kept.width == width && kept.text_size == text_size &&
                          kept.lines == lines;
    if (!is_known) kept = {text, work_out(ui, text, width, lines), width, text_size, lines};
    return kept.sentences;
}

} // namespace rasterwalk
