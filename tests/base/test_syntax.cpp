#include "base/syntax.h"

#include <array>

#include "base/error.h"
#include "tests/support/catch.h"

namespace rasterwalk {

namespace {

constexpr std::array<SignSpelling, 9> tried_signs{{{"<=", Sign::less_equal},
                                                   {"<", Sign::less},
                                                   {"+", Sign::plus},
                                                   {"-", Sign::minus},
                                                   {"·", Sign::times},
                                                   {"²", Sign::square},
                                                   {"(", Sign::open},
                                                   {")", Sign::close},
                                                   {",", Sign::comma}}};

/// A language with logic, in which `1/z` is a symbol.
ExpressionLanguage tried_language() {
    return {tried_signs, true,
            [](std::string_view rest) -> std::size_t { return rest.starts_with("1/z") ? 3 : 0; }};
}

/// The tree with every pair of operands in brackets.
std::string bracketed(const SyntaxTree& tree, int index) {
    const SyntaxNode& node = tree.node(index);
    std::string text = "[" + std::to_string(static_cast<int>(node.kind)) + node.text;
    if (node.kind == SyntaxNode::Kind::number) text = "[" + node.text;
    for (const int part : node.parts)
        text += " " + bracketed(tree, part);
    return text + "]";
}

bool same_tree(std::string_view one, std::string_view other) {
    const SyntaxTree a = parse_syntax(one, tried_language());
    const SyntaxTree b = parse_syntax(other, tried_language());
    return bracketed(a, a.root) == bracketed(b, b.root);
}

std::string refusal(const std::string& text) {
    try {
        parse_syntax(text, tried_language());
    } catch (const UsageError& fault) {
        return fault.what();
    }
    return {};
}

std::string many(std::string_view text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i)
        result += text;
    return result;
}

} // namespace

TEST_CASE("Tokens add up to the whole expression, including blanks and unknown characters") {
    const std::string text = "not  1/z²<= a.b2·(1.5e3 § -)";
    std::string joined;
    std::string kinds;
    for (const SyntaxToken& token : split_tokens(text, tried_language())) {
        joined += token.text;
        kinds += "_1nysu"[static_cast<std::size_t>(token.kind)];
    }
    CHECK(joined == text);
    CHECK(kinds == "n_yss_nss1_uu_ss");
}

TEST_CASE("Signs bind as in arithmetic, and logic binds less tightly") {
    CHECK(same_tree("1 + 2 · 3", "1 + (2 · 3)"));
    CHECK(same_tree("8 - 4 - 2", "(8 - 4) - 2"));
    CHECK(same_tree("-3²", "-(3²)"));
    CHECK(same_tree("2 · -3² · 4", "(2 · (-(3²))) · 4"));
    CHECK(same_tree("not a < b + 1 and c or d", "((not (a < (b + 1))) and c) or d"));
    CHECK(same_tree("f(a + 1, -b)²", "(f((a + 1), (-b)))²"));
    CHECK_FALSE(same_tree("8 - (4 - 2)", "8 - 4 - 2"));
    CHECK_FALSE(same_tree("(-3)²", "-3²"));
}

TEST_CASE("The tree has its numbers, its symbols and what was in parentheses") {
    const SyntaxTree tree = parse_syntax("(a + 1/z) · 0.5", tried_language());
    const SyntaxNode& root = tree.node(tree.root);
    REQUIRE(root.kind == SyntaxNode::Kind::multiply);
    CHECK_FALSE(root.is_in_parentheses);
    const SyntaxNode& sum = tree.node(root.parts[0]);
    CHECK(sum.is_in_parentheses);
    CHECK(tree.node(sum.parts[0]).kind == SyntaxNode::Kind::name);
    CHECK(tree.node(sum.parts[1]).kind == SyntaxNode::Kind::symbol);
    CHECK(tree.node(sum.parts[1]).text == "1/z");
    CHECK(tree.node(root.parts[1]).number == 0.5);
}

TEST_CASE("A text that is not an expression is answered with a sentence") {
    CHECK(refusal("") == "the expression '' ends too early.");
    CHECK(refusal("a +") == "the expression 'a +' ends too early.");
    CHECK(refusal("a )") == "it is not clear what ')' means.");
    CHECK(refusal("a § b") == "it is not clear what '§ b' means.");
    CHECK(refusal("(a") == "a ')' is missing from '(a'.");
    CHECK(refusal("f()") == "it is not clear what ')' means.");
    CHECK(refusal("1e999 + 2") == "'1e999 + 2' is not a number.");
    CHECK(refusal("a < b < c") == "write 'a < b and b < c' instead of 'a < b < c'.");
}

TEST_CASE("The length and the depth of an expression are limited") {
    CHECK(refusal(many("1", 1001)) == "an expression may have at most 1000 bytes.");
    const std::string too_deep = "the expression is nested deeper than 32 levels.";
    for (const char* opening : {"(", "-", "not ", "f("}) {
        INFO(opening);
        CHECK(refusal(many(opening, 200)) == too_deep);
        CHECK(refusal(many(opening, 33) + "1") == too_deep);
    }
    CHECK(refusal(many("(", 32) + "1" + many(")", 32)).empty());
    CHECK(refusal("1" + many("²", 400)).empty());
}

} // namespace rasterwalk
