#include "ui/lesson/fitting_sentences.h"

#include <memory>
#include <vector>

#include "text/sentences.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

float height_of(Ui& ui, const std::string& text, float width) {
    std::shared_ptr<MarkdownPage> page;
    return markdown_height(ui, page, text, width);
}

float height_of_lines(Ui& ui, float width, int lines) {
    const float one = height_of(ui, "x", width), two = height_of(ui, "x\\\ny", width);
    return one + static_cast<float>(lines - 1) * (two - one) + 0.5f;
}

std::string work_out(Ui& ui, const std::string& text, float width, int lines) {
    const std::vector<std::string> sentences = leading_sentences(text);
    if (sentences.empty()) return {};
    const float room = height_of_lines(ui, width, lines);
    std::string fitting = sentences.front();
    for (std::size_t i = 1; i < sentences.size(); ++i) {
        const std::string longer = fitting + " " + sentences[i];
        if (height_of(ui, longer, width) > room) break;
        fitting = longer;
    }
    return fitting;
}

} // namespace

std::string fitting_sentences(Ui& ui, const std::string& text, float width, int lines) {
    LessonStrip::Fitting& kept = ui.lesson.strip.fitting;
    const float text_size = ui.fonts.text->FontSize;
    const bool is_known = kept.of == text && kept.width == width && kept.text_size == text_size &&
                          kept.lines == lines;
    if (!is_known) kept = {text, work_out(ui, text, width, lines), width, text_size, lines};
    return kept.sentences;
}

std::vector<std::string> fitting_parts(Ui& ui, const std::string& text, float width, int lines) {
    const float room = height_of_lines(ui, width, lines);
    std::vector<std::string> parts;
    for (const ReadingPiece& piece : reading_pieces(text)) {
        if (!piece.is_first) {
            const std::string longer = parts.back() + std::string(piece.glue) + piece.text;
            if (height_of(ui, longer, width) <= room) {
                parts.back() = longer;
                continue;
            }
        }
        parts.push_back(piece.text);
    }
    return parts;
}

} // namespace rasterwalk
