#include "ui/page/markdown_words.h"

#include <algorithm>
#include <cfloat>

namespace rasterwalk {

namespace {

PageFont run_font(const MarkdownRun& run, const TextLook& look) {
    if (run.raised != 0) return PageFont::small;
    if (run.code) return PageFont::mono;
    if (look.font != PageFont::text) return look.font;
    if (run.strong) return PageFont::bold;
    return run.emphasis ? PageFont::italic : PageFont::text;
}

/// Puts words together from pieces of runs; a word may continue in the next run.
class Cutter {
  public:
    void add(std::string_view text, const MarkdownRun& run, PageFont font, float width, float left,
             float right) {
        if (!open_) {
            list.words.push_back({list.parts.size(), 0, 0.0f, space_, begins_line_});
            open_ = true;
        }
        Word& word = list.words.back();
        list.parts.push_back({text, font, width + left + right, left, right, &run});
        ++word.part_count;
        word.width += width + left + right;
    }
    void space(float width) {
        close();
        space_ = width;
    }
    void new_line() {
        close();
        list.whole_width = std::max(list.whole_width, line_width_);
        line_width_ = 0.0f;
        begins_line_ = true;
    }
    WordList finish() {
        new_line();
        return std::move(list);
    }

  private:
    void close() {
        if (!open_) return;
        const Word& word = list.words.back();
        list.widest_word = std::max(list.widest_word, word.width);
        line_width_ += (line_width_ > 0.0f ? word.space : 0.0f) + word.width;
        open_ = false;
        begins_line_ = false;
        space_ = 0.0f;
    }

    WordList list;
    bool open_ = false;
    bool begins_line_ = false;
    float space_ = 0.0f;
    float line_width_ = 0.0f;
};

} // namespace

float width_of(const ImFont* font, std::string_view text) {
    if (text.empty()) return 0.0f; // may have no data, which ImGui would take for a text
    return font
        ->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.data(), text.data() + text.size())
        .x;
}

WordList cut_words(std::span<const MarkdownRun> runs, const TextLook& look, const Fonts& fonts,
                   float unit, float keep_code) {
    Cutter cutter;
    for (const MarkdownRun& run : runs) {
        const PageFont name = run_font(run, look);
        const ImFont* const font = font_of(fonts, name);
        const float padding = run.code ? 3.0f * unit : 0.0f;
        const std::string_view text = run.text;
        if (run.code && width_of(font, text) < keep_code) {
            cutter.add(text, run, name, width_of(font, text), padding, padding);
            continue;
        }
        const float space = font->GetCharAdvance(' ');
        std::size_t begin = 0;
        while (begin < text.size()) {
            if (text[begin] == ' ') {
                cutter.space(space);
                ++begin;
            } else if (text[begin] == '\n') {
                cutter.new_line();
                ++begin;
            } else {
                const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
                const std::string_view word = text.substr(begin, end - begin);
                cutter.add(word, run, name, width_of(font, word), begin == 0 ? padding : 0.0f,
                           end == text.size() ? padding : 0.0f);
                begin = end;
            }
        }
    }
    return cutter.finish();
}

} // namespace rasterwalk
