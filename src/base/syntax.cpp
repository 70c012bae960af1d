#include "base/syntax.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/quoted.h"

namespace rasterwalk {

namespace {

using TokenKind = SyntaxToken::Kind;
using SyntaxKind = SyntaxNode::Kind;

constexpr std::string_view blank_letters = " \t\r\n";

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// The number at the front of the text, and its length; 0 if there is none or it is not finite.
std::pair<double, std::size_t> number_at(std::string_view text) {
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{} || !std::isfinite(value)) return {0.0, 0};
    return {value, static_cast<std::size_t>(end - text.data())};
}

SyntaxToken token_at(std::string_view rest, const ExpressionLanguage& language) {
    const auto made = [&](TokenKind kind, std::size_t length) {
        return SyntaxToken{kind, rest.substr(0, length)};
    };
    if (const std::size_t length = rest.find_first_not_of(blank_letters); length != 0) {
        return made(TokenKind::blank, length);
    }
    if (language.symbol) {
        if (const std::size_t length = language.symbol(rest); length > 0) {
            return made(TokenKind::symbol, length);
        }
    }
    for (const SignSpelling& spelling : language.signs) {
        if (!rest.starts_with(spelling.text)) continue;
        return {TokenKind::sign, rest.substr(0, spelling.text.size()), spelling.sign};
    }
    if (is_digit(rest[0]) || rest[0] == '.') {
        // If it begins like a number but is none, everything from there to the end makes no sense.
        const std::size_t length = number_at(rest).second;
        return made(TokenKind::number, length > 0 ? length : rest.size());
    }
    if (!is_letter(rest[0])) return made(TokenKind::unknown, 1);
    std::size_t length = 1;
    while (length < rest.size() &&
           (is_letter(rest[length]) || is_digit(rest[length]) || rest[length] == '.')) {
        ++length;
    }
    return made(TokenKind::name, length);
}

/// Reads tokens from left to right, with one function for each kind of sign.
class Parser {
  public:
    Parser(std::string_view text, const ExpressionLanguage& language)
        : text_(text), language_(language) {
        tree_.text = std::string(text);
    }

    SyntaxTree parse() {
        if (text_.size() > longest_expression) {
            throw UsageError("an expression may have at most " +
                             std::to_string(longest_expression) + " bytes.");
        }
        for (const SyntaxToken& token : split_tokens(text_, language_)) {
            if (token.kind != TokenKind::blank) tokens_.push_back(token);
        }
        tree_.root = read_or();
        if (next_ < tokens_.size()) reject_rest();
        return std::move(tree_);
    }

  private:
    /// Counts the depth of the reading.
    struct Deeper {
        explicit Deeper(Parser& owner) : parser(owner) {
            if (++parser.depth_ > deepest_expression) {
                throw UsageError("the expression is nested deeper than " +
                                 std::to_string(deepest_expression) + " levels.");
            }
        }
        Deeper(const Deeper&) = delete;
        Deeper& operator=(const Deeper&) = delete;
        ~Deeper() { --parser.depth_; }
        Parser& parser;
    };

    /// From the next token to the end.
    std::string_view rest() const {
        return text_.substr(static_cast<std::size_t>(tokens_[next_].text.data() - text_.data()));
    }
    [[noreturn]] void reject_rest() const {
        throw UsageError("it is not clear what " + in_quotes(rest()) + " means.");
    }

    bool next_is(TokenKind kind) const {
        return next_ < tokens_.size() && tokens_[next_].kind == kind;
    }
    bool take(Sign sign) {
        if (!next_is(TokenKind::sign) || tokens_[next_].sign != sign) return false;
        ++next_;
        return true;
    }
    bool take_word(std::string_view word) {
        if (!language_.has_logic || !next_is(TokenKind::name) || tokens_[next_].text != word) {
            return false;
        }
        ++next_;
        return true;
    }

    int add(SyntaxKind kind, std::vector<int> parts) {
        SyntaxNode made;
        made.kind = kind;
        made.parts = std::move(parts);
        return add(std::move(made));
    }
    int add(SyntaxNode made) {
        tree_.nodes.push_back(std::move(made));
        return static_cast<int>(tree_.nodes.size()) - 1;
    }

    int read_or() {
        int left = read_and();
        while (take_word("or"))
            left = add(SyntaxKind::logical_or, {left, read_and()});
        return left;
    }

    int read_and() {
        int left = read_not();
        while (take_word("and"))
            left = add(SyntaxKind::logical_and, {left, read_not()});
        return left;
    }

    int read_not() {
        if (!take_word("not")) return read_comparison();
        const Deeper deeper(*this);
        return add(SyntaxKind::logical_not, {read_not()});
    }

    std::optional<SyntaxKind> take_comparison() {
        constexpr std::array<std::pair<Sign, SyntaxKind>, 6> signs{{
            {Sign::equal, SyntaxKind::equal},
            {Sign::unequal, SyntaxKind::unequal},
            {Sign::less_equal, SyntaxKind::less_equal},
            {Sign::greater_equal, SyntaxKind::greater_equal},
            {Sign::less, SyntaxKind::less},
            {Sign::greater, SyntaxKind::greater},
        }};
        for (const auto& [sign, kind] : signs) {
            if (take(sign)) return kind;
        }
        if (take(Sign::assign)) throw UsageError("'=' sets a value; to compare, write '=='.");
        return std::nullopt;
    }

    int read_comparison() {
        const int left = read_sum();
        const std::optional<SyntaxKind> kind = take_comparison();
        if (!kind) return left;
        const int right = read_sum();
        if (take_comparison()) {
            throw UsageError("write 'a < b and b < c' instead of 'a < b < c'.");
        }
        return add(*kind, {left, right});
    }

    int read_sum() {
        int left = read_product();
        while (true) {
            const bool is_plus = take(Sign::plus);
            if (!is_plus && !take(Sign::minus)) return left;
            const int right = read_product();
            left = add(is_plus ? SyntaxKind::add : SyntaxKind::subtract, {left, right});
        }
    }

    int read_product() {
        int left = read_minus();
        while (true) {
            const bool is_times = take(Sign::times);
            if (!is_times && !take(Sign::over)) return left;
            const int right = read_minus();
            left = add(is_times ? SyntaxKind::multiply : SyntaxKind::divide, {left, right});
        }
    }

    int read_minus() {
        if (!take(Sign::minus)) return read_square();
        const Deeper deeper(*this);
        return add(SyntaxKind::negate, {read_minus()});
    }

    int read_square() {
        int part = read_leaf();
        while (take(Sign::square))
            part = add(SyntaxKind::square, {part});
        return part;
    }

    int read_leaf() {
        if (take(Sign::open)) {
            const Deeper deeper(*this);
            const int inner = read_or();
            close();
            tree_.nodes[static_cast<std::size_t>(inner)].is_in_parentheses = true;
            return inner;
        }
        if (next_ == tokens_.size()) {
            throw UsageError("the expression " + in_quotes(tree_.text) + " ends too early.");
        }
        const SyntaxToken& token = tokens_[next_];
        SyntaxNode leaf;
        leaf.text = std::string(token.text);
        switch (token.kind) {
        case TokenKind::number: {
            const auto [value, length] = number_at(token.text);
            if (length == 0) throw UsageError(in_quotes(rest()) + " is not a number.");
            leaf.number = value;
            break;
        }
        case TokenKind::name:
            leaf.kind = SyntaxKind::name;
            break;
        case TokenKind::symbol:
            leaf.kind = SyntaxKind::symbol;
            break;
        default:
            reject_rest();
        }
        ++next_;
        if (leaf.kind == SyntaxKind::name && take(Sign::open)) return read_call(std::move(leaf));
        return add(std::move(leaf));
    }

    int read_call(SyntaxNode call) {
        const Deeper deeper(*this);
        call.kind = SyntaxKind::call;
        do {
            call.parts.push_back(read_sum());
        } while (take(Sign::comma));
        close();
        return add(std::move(call));
    }

    void close() {
        if (!take(Sign::close))
            throw UsageError("a ')' is missing from " + in_quotes(tree_.text) + ".");
    }

    std::string_view text_;
    const ExpressionLanguage& language_;
    std::vector<SyntaxToken> tokens_; ///< without the blank_letters
    std::size_t next_ = 0;
    SyntaxTree tree_;
    int depth_ = 0;
};

} // namespace

std::vector<SyntaxToken> split_tokens(std::string_view text, const ExpressionLanguage& language) {
    std::vector<SyntaxToken> tokens;
    while (!text.empty()) {
        tokens.push_back(token_at(text, language));
        text.remove_prefix(tokens.back().text.size());
    }
    return tokens;
}

SyntaxTree parse_syntax(std::string_view text, const ExpressionLanguage& language) {
    return Parser(text, language).parse();
}

} // namespace rasterwalk
