#include "text/math_runs.h"

namespace rasterwalk {

namespace {

class Writer {
  public:
    void write(const MathNode& node, int raised) {
        switch (node.kind) {
        case MathNode::Kind::symbol:
            symbol(node, raised);
            break;
        case MathNode::Kind::fraction:
            bracketed(node.children[0], raised);
            put("/", false, raised);
            bracketed(node.children[1], raised);
            break;
        case MathNode::Kind::script:
            write(node.children[0], raised);
            write(node.children[2], raised == 0 ? -1 : raised);
            write(node.children[1], raised == 0 ? 1 : raised);
            break;
        case MathNode::Kind::root:
            put("√", false, raised);
            bracketed(node.children[0], raised);
            break;
        case MathNode::Kind::accent:
            write(node.children[0], raised);
            // In the fonts the hat is a mark over the preceding letter.
            if (node.text == "ˆ" && !runs.empty())
                put("\xCC\x82", true, raised, runs.back().vector);
            break;
        case MathNode::Kind::row:
            for (const MathNode& child : node.children)
                write(child, raised);
            break;
        }
    }

    std::vector<MarkdownRun> runs;

  private:
    void symbol(const MathNode& node, int raised) {
        const bool has_blanks = node.style == MathNode::Style::relation && raised == 0;
        if (has_blanks) put(" ", false, raised);
        put(node.text, node.style == MathNode::Style::slanted, raised,
            raised == 0 ? vector_letter(node) : char{0});
        if (has_blanks) put(" ", false, raised);
    }

    /// In brackets if it is more than one symbol.
    void bracketed(const MathNode& node, int raised) {
        const bool is_one = node.kind != MathNode::Kind::row || node.children.size() < 2;
        const bool is_fraction = node.kind == MathNode::Kind::fraction;
        if (is_one && !is_fraction) return write(node, raised);
        put("(", false, raised);
        write(node, raised);
        put(")", false, raised);
    }

    void put(std::string_view text, bool is_slanted, int raised, char vector = 0) {
        if (text.empty()) return;
        const auto raise = static_cast<std::int8_t>(raised);
        run_like(runs, {{}, is_slanted, false, false, -1, raise, vector}).text += text;
    }
};

} // namespace

std::vector<MarkdownRun> math_runs(const MathNode& formula) {
    Writer writer;
    writer.write(formula, 0);
    return std::move(writer.runs);
}

} // namespace rasterwalk
