#include "ui/page/markdown_layout.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "ui/page/markdown_words.h"
#include "ui/page/page_setter.h"

namespace rasterwalk {

namespace {

using Kind = MarkdownBlock::Kind;
using Align = MarkdownBlock::Align;

} // namespace

std::size_t character_end(std::string_view text, std::size_t length) {
    length = std::max<std::size_t>(length, 1);
    while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0u) == 0x80u)
        ++length;
    return std::min(length, text.size());
}

float PageSetter::space_above(const MarkdownBlock& block) const {
    if (block.kind == Kind::heading) return block.level == 1 ? 1.5f * em_ : 1.2f * em_;
    return block.kind == Kind::rule ? 1.0f * em_ : 0.75f * em_;
}

float PageSetter::space_below(const MarkdownBlock& block) const {
    if (block.kind == Kind::heading) return block.level == 1 ? 0.6f * em_ : 0.3f * em_;
    return block.kind == Kind::rule ? 1.0f * em_ : 0.75f * em_;
}

void PageSetter::blocks(std::span<const MarkdownBlock> blocks, float x, float width) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (i > 0) {
            const float below = space_below(blocks[i - 1]);
            const bool after_heading = blocks[i - 1].kind == Kind::heading;
            y += after_heading ? below : std::max(below, space_above(blocks[i]));
        }
        block(blocks[i], x, width);
    }
}

void PageSetter::block(const MarkdownBlock& block, float x, float width) {
    switch (block.kind) {
    case Kind::heading: {
        const bool is_title = block.level == 1;
        text(block.runs, x, width,
             {.font = is_title ? PageFont::title : PageFont::bold,
              .leading = is_title ? 1.25f : 1.4f});
        break;
    }
    case Kind::list:
        list(block, x, width);
        break;
    case Kind::code:
        code(block, x, width);
        break;
    case Kind::quote:
        box(block, x, width);
        break;
    case Kind::table:
        table(block, x, width);
        break;
    case Kind::rule:
        page_.shapes.push_back({PageShape::Kind::line, {x, y}, {x + width, y + u_}});
        break;
    case Kind::math:
        math(block, x, width);
        break;
    case Kind::picture:
        picture(block, x, width);
        break;
    default:
        text(block.runs, x, width, {});
        blocks(block.children, x, width);
        break;
    }
}

void PageSetter::text(std::span<const MarkdownRun> runs, float x, float width,
                      const TextLook& look) {
    const WordList list = cut_words(runs, look, fonts_, u_, 0.7f * width);
    if (list.words.empty()) return;
    Pen pen{0.0f, page_.pieces.size(), false};
    for (const Word& word : list.words) {
        const bool fits = pen.x + word.space + word.width <= width;
        if (word.begins_line || (pen.has_words && !fits)) end_line(pen, width, look);
        if (pen.has_words) pen.x += word.space;
        for (std::size_t i = 0; i < word.part_count; ++i) {
            const WordPart& part = list.parts[word.first_part + i];
            if (word.width <= width) {
                put(part, pen, x, look);
            } else {
                put_broken(part, pen, x, width, look);
            }
        }
        pen.has_words = true;
    }
    end_line(pen, width, look);
}

void PageSetter::put(const WordPart& part, Pen& pen, float x, const TextLook& look) {
    const ImFont* const base = font_of(fonts_, look.font);
    const ImFont* const font = font_of(fonts_, part.font);
    const float end = x + pen.x + part.width - part.padding_right;
    if (page_.pieces.size() > pen.line_start) {
        // Words of one run on one line are one piece, with the blank between them.
        PagePiece& last = page_.pieces.back();
        const char* const begin = part.text.data();
        const char* const last_end = last.text.data() + last.text.size();
        const char* const run_begin = part.run->text.data();
        if (part.padding_left == 0.0f && last.text.data() >= run_begin && last_end <= begin &&
            last_end + 1 >= begin) {
            last.text = {last.text.data(),
                         static_cast<std::size_t>(begin - last.text.data()) + part.text.size()};
            last.width = end - last.at.x;
            pen.x += part.width;
            return;
        }
    }
    const float raise = part.run->raised > 0   ? 0.38f * em_
                        : part.run->raised < 0 ? -0.2f * em_
                                               : 0.0f;
    const float top = y + std::round(0.5f * (line_height(look) - base->FontSize)) + base->Ascent -
                      font->Ascent - std::round(raise);
    const bool is_link = part.run->link >= 0;
    page_.pieces.push_back({.at = {x + pen.x + part.padding_left, top},
                            .width = part.width - part.padding_left - part.padding_right,
                            .text = part.text,
                            .font = part.font,
                            .tint = is_link ? PageTint::link : look.tint,
                            .is_code = part.run->code,
                            .link = part.run->link,
                            .vector = part.run->vector});
    pen.x += part.width;
}

/// A word that is longer than the line: as many letters on each line as fit, but at least one.
void PageSetter::put_broken(const WordPart& part, Pen& pen, float x, float width,
                            const TextLook& look) {
    const ImFont* const font = font_of(fonts_, part.font);
    std::string_view rest = part.text;
    while (!rest.empty()) {
        const char* stop = nullptr;
        const float room = std::max(width - pen.x, 0.0f);
        font->CalcTextSizeA(font->FontSize, room, 0.0f, rest.data(), rest.data() + rest.size(),
                            &stop);
        auto length = static_cast<std::size_t>(stop - rest.data());
        if (length == 0 && pen.x > 0.0f) {
            end_line(pen, width, look);
            continue;
        }
        length = character_end(rest, length);
        WordPart piece = part;
        piece.text = rest.substr(0, length);
        piece.padding_left = piece.padding_right = 0.0f;
        piece.width = width_of(font, piece.text);
        put(piece, pen, x, look);
        rest.remove_prefix(length);
    }
}

void PageSetter::end_line(Pen& pen, float width, const TextLook& look) {
    if (look.align != Align::left) {
        const float slack = std::max(width - pen.x, 0.0f);
        const float shift = std::floor(look.align == Align::right ? slack : 0.5f * slack);
        for (std::size_t i = pen.line_start; i < page_.pieces.size(); ++i)
            page_.pieces[i].at.x += shift;
    }
    page_.lines.push_back({y, y + line_height(look)});
    y += line_height(look);
    pen = {0.0f, page_.pieces.size(), false};
}

ImFont* font_of(const Fonts& fonts, PageFont font) {
    switch (font) {
    case PageFont::text:
        return fonts.text;
    case PageFont::bold:
        return fonts.bold;
    case PageFont::italic:
        return fonts.italic;
    case PageFont::mono:
        return fonts.mono;
    case PageFont::title:
        return fonts.title;
    case PageFont::small:
        return fonts.small;
    }
    return fonts.text;
}

PageLayout lay_out(const MarkdownDocument& document, const Fonts& fonts, float unit, float width,
                   const PictureSizes& picture_size) {
    PageLayout page;
    PageSetter setter(fonts, unit, page, picture_size);
    setter.blocks(document.blocks, 0.0f, std::max(width, 1.0f));
    page.height = setter.y;
    return page;
}

} // namespace rasterwalk
