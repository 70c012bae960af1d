#include "text/math.h"

#include <algorithm>

#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/ui/driver.h"
#include "text/math.h"
#include "text/math_runs.h"
#include "ui/page/math_layout.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

using NodeKind = MathNode::Kind;

/// As a person would write it without TeX: "frac(a, b)", "a^{2}_{i}".
std::string written(const MathNode& node) {
    const auto child = [&](std::size_t i) { return written(node.children[i]); };
    switch (node.kind) {
    case NodeKind::symbol:
        return node.text;
    case NodeKind::fraction:
        return "frac(" + child(0) + "|" + child(1) + ")";
    case NodeKind::script:
        return child(0) + "^{" + child(1) + "}_{" + child(2) + "}";
    case NodeKind::root:
        return "root(" + child(0) + ")";
    case NodeKind::accent:
        return "accent(" + child(0) + ")";
    case NodeKind::row:
        break;
    }
    std::string text;
    for (std::size_t i = 0; i < node.children.size(); ++i)
        text += child(i);
    return text;
}

std::string written(std::string_view tex) {
    return written(parse_math(tex));
}

std::vector<std::string> formula_faults(std::string_view tex) {
    std::vector<std::string> faults;
    parse_math(tex, &faults);
    return faults;
}

std::string line_of(std::string_view tex) {
    std::string text;
    for (const MarkdownRun& run : math_runs(parse_math(tex))) {
        if (run.raised > 0) text += "^";
        if (run.raised < 0) text += "_";
        text += run.text;
    }
    return text;
}

int depth_of(const MathNode& node) {
    int deepest = 0;
    for (const MathNode& child : node.children)
        deepest = std::max(deepest, depth_of(child));
    return 1 + deepest;
}

/// A formula that has been set, with its text.
struct Set {
    std::deque<std::string> made;
    MathBox box;

    Set(std::string_view tex, const Fonts& fonts)
        : box(set_math(parse_math(tex), fonts, 1.0f, made)) {}

    const PagePiece& piece(std::string_view text) const {
        const auto found = std::find_if(box.pieces.begin(), box.pieces.end(),
                                        [&](const PagePiece& piece) { return piece.text == text; });
        INFO(text);
        REQUIRE(found != box.pieces.end());
        return *found;
    }
};

std::string times(int count, const std::string& text) {
    std::string result;
    for (int i = 0; i < count; ++i)
        result += text;
    return result;
}

} // namespace

TEST_CASE("Formulas are read: letters, numbers, signs, groups and commands") {
    CHECK(written("a + 12.5 b") == "a+12.5b");
    CHECK(written("\\frac{a}{b c}") == "frac(a|bc)");
    CHECK(written("\\frac12") == "frac(12|)"); // a number is one symbol
    CHECK(written("x^2") == "x^{2}_{}");
    CHECK(written("x_i^2") == "x^{2}_{i}");
    CHECK(written("x^{a+b}_{min}") == "x^{a+b}_{min}");
    CHECK(written("\\sqrt{r^2}") == "root(r^{2}_{})");
    CHECK(written("\\hat{n} \\cdot \\vec r") == "accent(n)·accent(r)");
    CHECK(written("\\text{one step} = \\mathrm{n}") == "one step=n");
    CHECK(written("\\left( \\frac{1}{z} \\right.") == "(frac(1|z)");
    CHECK(written("\\le \\ge \\ne \\approx \\to \\infty \\pi \\rho") == "≤≥≠≈→∞πρ");
    CHECK(written("-a - b") == "−a−b");
    CHECK(written("πr²") == "πr²");
}

TEST_CASE("Letters are slanted, words and numbers are not, and signs have blanks between two") {
    const MathNode formula = parse_math("-a = \\text{b} - 5");
    REQUIRE(formula.children.size() == 6);
    CHECK(formula.children[0].style == MathNode::Style::upright); // belongs to the a
    CHECK(formula.children[1].style == MathNode::Style::slanted);
    CHECK(formula.children[2].style == MathNode::Style::relation);
    CHECK(formula.children[3].style == MathNode::Style::upright);
    CHECK(formula.children[4].style == MathNode::Style::relation);
    CHECK(parse_math("(-a)").children[1].style == MathNode::Style::upright);
    CHECK(parse_math("a = -b").children[2].style == MathNode::Style::upright);
}

TEST_CASE("What cannot be read is shown as written, and nothing gets lost") {
    CHECK(written("\\foo + 1") == "\\foo+1");
    CHECK(written("a } b") == "ab");
    CHECK(written("{a") == "a");
    CHECK(written("\\frac{a}") == "frac(a|)");
    CHECK(written("x^") == "x^{}_{}");
    CHECK(written("^2") == "^2"); // a sign like any other
    CHECK(written("\\") == "\\");
    CHECK(written("").empty());
    CHECK(written("   ").empty());
}

TEST_CASE("A formula nested too deep is cut off, and a long one does not run away") {
    for (const char* piece :
         {"{", "\\sqrt{", "\\frac{", "x^{", "\\hat", "\\sqrt", "\\left", "x_", "}"}) {
        INFO(piece);
        const MathNode formula = parse_math(times(3'000, piece));
        CHECK(depth_of(formula) <= 3 * deepest_math + 3);
        CHECK(math_runs(formula).size() < 10'000);
    }
}

TEST_CASE("Every command that rasterwalk check knows is drawn, and no other") {
    const char* known[] = {
        "cdot",  "times", "le",    "leq",   "ge",    "geq",   "ne",      "approx", "to",
        "pm",    "infty", "ldots", "dots",  "sum",   "max",   "min",     "cos",    "sin",
        "tan",   "alpha", "beta",  "gamma", "delta", "Delta", "epsilon", "theta",  "lambda",
        "mu",    "pi",    "rho",   "sigma", "phi",   "omega", "lfloor",  "rfloor", "lvert",
        "rvert", "quad",  ",",     ";",     "{",     "}",     "_",       "$"};
    for (const char* name : known) {
        const std::string tex = std::string("a \\") + name + " b";
        INFO(tex);
        CHECK(formula_faults(tex).empty());
        CHECK(written(tex).find('\\') == std::string::npos);
    }
    for (const char* name : {"frac{a}", "sqrt", "hat", "vec", "bar", "text", "mathrm", "texttt"}) {
        const std::string tex = std::string("\\") + name + "{b}";
        INFO(tex);
        CHECK(formula_faults(tex).empty());
        CHECK(written(tex).find('\\') == std::string::npos);
    }
    for (const char* name : {"foo", "begin", "int", "dot", "cdott", "Pi", "!", " "}) {
        const std::string tex = std::string("a \\") + name + " b";
        INFO(tex);
        CHECK(formula_faults(tex).size() == 1);
        CHECK(written(tex).find('\\') != std::string::npos);
    }
    CHECK(formula_faults("").empty());
    CHECK(deepest_formula < deepest_math);
}

TEST_CASE("In a line of text a fraction has a slash, and brackets where they are needed") {
    CHECK(line_of("\\frac{1}{z}") == "1/z");
    CHECK(line_of("\\frac{a + b}{2}") == "(a + b)/2");
    CHECK(line_of("\\frac{1}{4 \\pi r^2}") == "1/(4πr^2)");
    CHECK(line_of("x_i^2") == "x_i^2");
    CHECK(line_of("\\sqrt{a b}") == "√(ab)");
    CHECK(line_of("\\hat{n}") == "n\xCC\x82");
    CHECK(line_of("\\frac{\\frac{a}{b}}{c}").find("a/b") != std::string::npos);
}

TEST_CASE("A fraction has its halves above and below a line that is as wide as the wider one") {
    const Driver driver;
    const Fonts& fonts = driver.ui.fonts;
    const Set set("\\frac{a}{bbbb}", fonts);
    const PagePiece& top = set.piece("a");
    const auto stroke =
        std::find_if(set.box.shapes.begin(), set.box.shapes.end(),
                     [](const PageShape& s) { return s.kind == PageShape::Kind::stroke; });
    REQUIRE(stroke != set.box.shapes.end());
    CHECK(top.at.y + 0.8f * fonts.text->FontSize <= stroke->low.y + 2.0f);
    float low = 1e9f, high = -1e9f;
    for (const PagePiece& piece : set.box.pieces) {
        if (piece.text != "b") continue;
        CHECK(piece.at.y + 2.0f >= stroke->high.y);
        low = std::min(low, piece.at.x);
        high = std::max(high, piece.at.x + piece.width);
    }
    CHECK(stroke->low.x <= low);
    CHECK(stroke->high.x >= high);
    CHECK(0.5f * (low + high) == Approx(top.at.x + 0.5f * top.width).margin(1.0));
    CHECK(set.box.ascent > fonts.text->Ascent);
    CHECK(set.box.descent > fonts.text->FontSize - fonts.text->Ascent);
}

TEST_CASE("Scripts are smaller, one above and one below, in one place") {
    const Driver driver;
    const Set set("x^2_i", driver.ui.fonts);
    const PagePiece &base = set.piece("x"), &above = set.piece("2"), &below = set.piece("i");
    CHECK(above.font == PageFont::small);
    CHECK(below.font == PageFont::small);
    CHECK(above.at.x == Approx(below.at.x));
    CHECK(above.at.x >= base.at.x + base.width - 0.01f);
    CHECK(above.at.y < below.at.y);
}

TEST_CASE("The line of a root covers all that is under it") {
    const Driver driver;
    const Set set("\\sqrt{a + b}", driver.ui.fonts);
    REQUIRE(set.box.shapes.size() == 1);
    CHECK(set.box.shapes[0].low.x <= set.piece("a").at.x);
    CHECK(set.box.shapes[0].high.x >= set.piece("b").at.x + set.piece("b").width);
    CHECK(set.box.shapes[0].low.y <= set.piece("a").at.y + 4.0f);
}

TEST_CASE("Whatever is set stays within the box that is returned") {
    const Driver driver;
    test::Random random(5);
    const char* pieces[] = {"a",        "12",     "{",       "}",        "^",           "_",
                            "\\frac",   "\\sqrt", "\\hat",   "\\vec",    "\\text{b c}", "\\left(",
                            "\\right)", " + ",    "\\cdot ", "\\infty ", "\\foo ",      "-",
                            ",",        "\\",     "π",       "\xff"};
    for (int round = 0; round < 400; ++round) {
        std::string tex;
        for (int i = random.integer(0, 25); i > 0; --i)
            tex += pieces[random.integer(0, static_cast<int>(std::size(pieces)) - 1)];
        INFO(tex);
        const Set set(tex, driver.ui.fonts);
        for (const PagePiece& piece : set.box.pieces) {
            REQUIRE(piece.at.x >= -8.0f); // an accent may extend over the left edge
            REQUIRE(piece.at.x + piece.width <= set.box.width + 8.0f);
            REQUIRE(piece.at.y >= -set.box.ascent - 0.01f);
            REQUIRE(piece.at.y <= set.box.descent + 0.01f);
        }
    }
}

TEST_CASE("Letters of vectors are marked in line and displayed, but not in scripts") {
    const auto marked = [](std::string_view tex) {
        std::string letters;
        for (const MarkdownRun& run : math_runs(parse_math(tex))) {
            if (run.vector != 0) letters += run.text + " ";
        }
        return letters;
    };
    CHECK(marked("\\hat{n} \\cdot l") == "n\xCC\x82 l ");
    CHECK(marked("u_x v_y - u_y v_x") == "u v u v ");
    CHECK(marked("p_n + x^t + \\text{n} + \\sin b") == "b ");
    CHECK(marked("nl") == "n l ");
    Driver driver;
    const Set set("\\frac{\\hat{n} \\cdot p}{x_b} + u", driver.ui.fonts);
    std::string letters;
    for (const PagePiece& piece : set.box.pieces) {
        if (piece.vector != 0) letters += piece.vector;
    }
    CHECK(letters == "nu");
}

} // namespace rasterwalk
