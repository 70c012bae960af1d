#include "ui/lesson/fitting_sentences.h"

#include <algorithm>
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

std::string work_out(Ui& ui, const std::string& text, float width, int lines) {
    const std::vector<std::string> sentences = leading_sentences(text);
    if (sentences.empty()) return {};
    const float room = height_of_lines(ui, width, lines);
    std::string fitting = sentences.front();
    for (std::size_t i = 1; i < sentences.size(); ++i) {
        const std::string longer = fitting + " " + sentences[i];
        if (markdown_height(ui, longer, width) > room) break;
        fitting = longer;
    }
    return fitting;
}

/// Head and some of the rows.
std::string some_rows(const CutTable& table, std::size_t first, std::size_t count) {
    std::string text = table.head;
    for (std::size_t r = first; r < std::min(first + count, table.rows.size()); ++r)
        text.append("\n").append(table.rows[r]);
    return text;
}

/// The words before a table, and the table in as few parts as have room.
void add_table(Ui& ui, const CutTable& table, float width, float most,
               std::vector<std::string>& parts) {
    if (!table.before.empty()) parts.push_back(table.before);
    const auto fits = [&](std::size_t first, std::size_t count) {
        return markdown_height(ui, some_rows(table, first, count), width) <= most;
    };
    std::vector<std::size_t> counts; // as many rows as have room, part by part
    for (std::size_t r = 0; r < table.rows.size(); r += counts.back()) {
        counts.push_back(1);
        while (r + counts.back() < table.rows.size() && fits(r, counts.back() + 1))
            ++counts.back();
    }
    // Three and two rows are better than four and one.
    const std::size_t even = (table.rows.size() + counts.size() - 1) / counts.size();
    bool is_even = true;
    for (std::size_t r = 0; r < table.rows.size(); r += even)
        is_even = is_even && fits(r, even);
    std::size_t first = 0;
    for (std::size_t i = 0; first < table.rows.size(); ++i) {
        const std::size_t count = is_even ? even : counts[i];
        parts.push_back(some_rows(table, first, count));
        first += count;
    }
    if (!table.after.empty()) parts.push_back(table.after);
}

} // namespace

int lines_of_strip(const Ui& ui) {
    // In a squat window the table below needs the room.
    const bool has_room = !is_squat(ImGui::GetIO().DisplaySize, ui.options);
    return ui.lesson.strip.is_at_side && has_room ? 4 : 2;
}

std::string fitting_sentences(Ui& ui, const std::string& text, float width, int lines) {
    LessonStrip::Fitting& kept = ui.lesson.strip.fitting;
    const float text_size = ui.fonts.text->FontSize;
    const bool is_known = kept.of == text && kept.width == width && kept.text_size == text_size &&
                          kept.lines == lines;
    if (!is_known) kept = {text, work_out(ui, text, width, lines), width, text_size, lines};
    return kept.sentences;
}

std::vector<std::string> fitting_parts(Ui& ui, const std::string& text, float width, int lines,
                                       float most) {
    const float room = height_of_lines(ui, width, lines);
    std::vector<std::string> parts;
    for (const ReadingPiece& piece : reading_pieces(text)) {
        if (!piece.is_first) {
            const std::string longer = parts.back() + std::string(piece.glue) + piece.text;
            if (markdown_height(ui, longer, width) <= room) {
                parts.back() = longer;
                continue;
            }
        }
        if (const CutTable table = cut_table(piece.text);
            table.rows.size() > 1 && markdown_height(ui, piece.text, width) > most) {
            add_table(ui, table, width, most, parts);
        } else {
            parts.push_back(piece.text);
        }
    }
    return parts;
}

} // namespace rasterwalk
