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

std::string work_out(Ui& ui, const std::string& text, float width, int lines) {
    const std::vector<std::string> sentences = leading_sentences(text);
    if (sentences.empty()) return {};
    const float one = height_of(ui, "x", width), two = height_of(ui, "x\\\ny", width);
    const float room = one + static_cast<float>(lines - 1) * (two - one) + 0.5f;
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

} // namespace rasterwalk
