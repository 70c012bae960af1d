#include "ui/page/math_layout.h"

#include <algorithm>
#include <cmath>

#include "ui/page/markdown_words.h"

namespace rasterwalk {

namespace {

class MathSetter {
  public:
    MathSetter(const Fonts& fonts, float unit, std::deque<std::string>& made)
        : fonts_(fonts), u_(unit), em_(fonts.text->FontSize), made_(made) {}

    /// @param small at the size of scripts
    MathBox set(const MathNode& node, bool small);

  private:
    MathBox text(std::string_view text, PageFont font, float padding);
    MathBox symbol(const MathNode& node, bool small);
    MathBox row(const MathNode& node, bool small);
    MathBox fraction(const MathNode& node, bool small);
    MathBox script(const MathNode& node, bool small);
    MathBox root(const MathNode& node, bool small);
    MathBox accent(const MathNode& node, bool small);
    /// Puts `part` into the box, its baseline's left end at (x, y); y grows downward.
    static void put(MathBox& box, MathBox&& part, float x, float y);
    void line(MathBox& box, float x, float y, float width) const {
        const float thickness = std::max(std::round(u_), 1.0f);
        box.shapes.push_back(
            {PageShape::Kind::stroke, {x, y}, {x + width, y + thickness}, PageTint::text});
    }

    const Fonts& fonts_;
    float u_, em_;
    std::deque<std::string>& made_;
};

void MathSetter::put(MathBox& box, MathBox&& part, float x, float y) {
    for (PagePiece& piece : part.pieces) {
        piece.at = {piece.at.x + x, piece.at.y + y};
        box.pieces.push_back(piece);
    }
    for (PageShape& shape : part.shapes) {
        shape.low = {shape.low.x + x, shape.low.y + y};
        shape.high = {shape.high.x + x, shape.high.y + y};
        box.shapes.push_back(shape);
    }
    box.width = std::max(box.width, x + part.width);
    box.ascent = std::max(box.ascent, part.ascent - y);
    box.descent = std::max(box.descent, part.descent + y);
}

MathBox MathSetter::text(std::string_view text, PageFont font, float padding) {
    MathBox box;
    if (text.empty()) return box;
    const ImFont* const face = font_of(fonts_, font);
    made_.emplace_back(text);
    const float width = width_of(face, made_.back());
    box.width = width + 2.0f * padding;
    box.ascent = face->Ascent;
    box.descent = face->FontSize - face->Ascent;
    box.pieces.push_back(
        {.at = {padding, -face->Ascent}, .width = width, .text = made_.back(), .font = font});
    return box;
}

MathBox MathSetter::symbol(const MathNode& node, bool small) {
    const bool has_blanks = node.style == MathNode::Style::relation && !small;
    const PageFont full =
        node.style == MathNode::Style::slanted ? PageFont::italic : PageFont::text;
    MathBox box = text(node.text, small ? PageFont::small : full, has_blanks ? 0.28f * em_ : 0.0f);
    // In a script a letter is only a name.
    if (!small && !box.pieces.empty()) box.pieces.back().vector = vector_letter(node);
    return box;
}

MathBox MathSetter::row(const MathNode& node, bool small) {
    MathBox box;
    float x = 0.0f;
    for (const MathNode& child : node.children) {
        MathBox part = set(child, small);
        const float width = part.width;
        put(box, std::move(part), x, 0.0f);
        x += width;
    }
    return box;
}

MathBox MathSetter::fraction(const MathNode& node, bool small) {
    MathBox top = set(node.children[0], small), bottom = set(node.children[1], small);
    const float margin = 3.0f * u_;
    const float width = std::max(top.width, bottom.width) + 2.0f * margin;
    const float axis = -0.3f * em_; // the line is at the height of a minus sign
    const float top_x = 0.5f * (width - top.width), bottom_x = 0.5f * (width - bottom.width);
    const float top_y = axis - top.descent - 1.0f * u_;
    const float bottom_y = axis + bottom.ascent + 2.0f * u_;
    MathBox box;
    put(box, std::move(top), top_x, top_y);
    put(box, std::move(bottom), bottom_x, bottom_y);
    line(box, 0.0f, std::round(axis), width);
    // A little space, so that two fractions side by side do not share a line.
    box.width = width + 2.0f * u_;
    return box;
}

MathBox MathSetter::script(const MathNode& node, bool small) {
    MathBox box;
    put(box, set(node.children[0], small), 0.0f, 0.0f);
    const float x = box.width;
    put(box, set(node.children[1], true), x, -std::round(0.4f * em_));
    put(box, set(node.children[2], true), x, std::round(0.22f * em_));
    return box;
}

MathBox MathSetter::root(const MathNode& node, bool small) {
    MathBox box = text("√", small ? PageFont::small : PageFont::text, 0.0f);
    MathBox body = set(node.children[0], small);
    const float x = box.width, width = body.width, top = -body.ascent;
    put(box, std::move(body), x, 0.0f);
    line(box, x, std::round(top), width + 1.0f * u_);
    return box;
}

MathBox MathSetter::accent(const MathNode& node, bool small) {
    MathBox body = set(node.children[0], small);
    if (node.text == "ˆ" && !body.pieces.empty()) {
        // The fonts have the hat as a mark over the letter before it.
        PagePiece& last = body.pieces.back();
        made_.emplace_back(last.text);
        made_.back() += "\xCC\x82";
        last.text = made_.back();
        return body;
    }
    MathBox mark = text(node.text, PageFont::small, 0.0f);
    const float x = 0.5f * (body.width - mark.width);
    const float width = body.width;
    const float y = -0.5f * em_;
    put(body, std::move(mark), x, y);
    body.width = width;
    return body;
}

MathBox MathSetter::set(const MathNode& node, bool small) {
    switch (node.kind) {
    case MathNode::Kind::symbol:
        return symbol(node, small);
    case MathNode::Kind::fraction:
        return fraction(node, small);
    case MathNode::Kind::script:
        return script(node, small);
    case MathNode::Kind::root:
        return root(node, small);
    case MathNode::Kind::accent:
        return accent(node, small);
    case MathNode::Kind::row:
        break;
    }
    return row(node, small);
}

} // namespace

MathBox set_math(const MathNode& formula, const Fonts& fonts, float unit,
                 std::deque<std::string>& made) {
    return MathSetter(fonts, unit, made).set(formula, false);
}

} // namespace rasterwalk
