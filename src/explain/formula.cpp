#include "explain/formula.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/error.h"
#include "base/numbers.h"
#include "base/sine.h"
#include "base/syntax.h"
#include "stages/put_pixel.h"
#include "stages/texture_level.h"

namespace rasterwalk {

namespace {

using SyntaxKind = SyntaxNode::Kind;

constexpr std::string_view true_minus = "−";

constexpr std::array<SignSpelling, 8> formula_signs{{{"+", Sign::plus},
                                                     {true_minus, Sign::minus},
                                                     {"·", Sign::times},
                                                     {"/", Sign::over},
                                                     {"²", Sign::square},
                                                     {"(", Sign::open},
                                                     {")", Sign::close},
                                                     {",", Sign::comma}}};

/// May a symbol end before this text?
bool ends_symbol(std::string_view text) {
    const auto begins = [&](const SignSpelling& sign) { return text.starts_with(sign.text); };
    if (text.empty() || std::any_of(formula_signs.begin(), formula_signs.end(), begins)) {
        return true;
    }
    const auto first = static_cast<unsigned char>(text.front());
    return std::isalnum(first) == 0 && first != '_' && first != '.' && first < 0x80;
}

/// The length of the longest symbol that the text begins with; 0: none.
std::size_t symbol_length(std::string_view text, const std::vector<FormulaInput>& inputs) {
    std::size_t length = 0;
    for (const FormulaInput& input : inputs) {
        const std::string& symbol = input.symbol;
        if (text.starts_with(symbol) && ends_symbol(text.substr(symbol.size()))) {
            length = std::max(length, symbol.size());
        }
    }
    return length;
}

/// The formula must outlive it.
ExpressionLanguage language_of(const Formula& formula) {
    return {formula_signs, false,
            [&formula](std::string_view rest) { return symbol_length(rest, formula.inputs); }};
}

/// The input of a symbol found by symbol_length().
int input_of(const Formula& formula, std::string_view symbol) {
    const auto found =
        std::find_if(formula.inputs.begin(), formula.inputs.end(),
                     [symbol](const FormulaInput& input) { return input.symbol == symbol; });
    return static_cast<int>(found - formula.inputs.begin());
}

[[noreturn]] void reject(const Formula& formula, const std::string& reason) {
    throw std::invalid_argument("formula " + formula.id + ": " + reason + " in '" +
                                formula.expression + "'");
}

SyntaxTree tree_of(const Formula& formula) {
    try {
        return parse_syntax(formula.expression, language_of(formula));
    } catch (const UsageError& fault) {
        reject(formula, fault.what());
    }
}

/// Works an expression out.
class Evaluator {
  public:
    explicit Evaluator(const Formula& formula) : formula_(formula), tree_(tree_of(formula)) {}

    const SyntaxTree& tree() const { return tree_; }

    Number value(int index) const {
        const SyntaxNode& here = tree_.node(index);
        std::vector<Number> parts;
        for (const int part : here.parts)
            parts.push_back(value(part));
        switch (here.kind) {
        case SyntaxKind::number:
            return {static_cast<float>(here.number), here.number == std::floor(here.number)};
        case SyntaxKind::symbol:
            return formula_.inputs[static_cast<std::size_t>(input_of(formula_, here.text))].number;
        case SyntaxKind::call:
            return apply(here.text, parts);
        case SyntaxKind::negate:
            return {-parts[0].value, parts[0].is_whole};
        case SyntaxKind::square:
            return {parts[0].value * parts[0].value, parts[0].is_whole};
        default:
            break;
        }
        if (parts.size() < 2) reject(formula_, "no symbol is '" + here.text + "'");
        return of_two(here.kind, parts[0], parts[1]);
    }

  private:
    static Number of_two(SyntaxKind kind, const Number& a, const Number& b) {
        const bool both_whole = a.is_whole && b.is_whole;
        switch (kind) {
        case SyntaxKind::add:
            return {a.value + b.value, both_whole};
        case SyntaxKind::subtract:
            return {a.value - b.value, both_whole};
        case SyntaxKind::multiply:
            return {a.value * b.value, both_whole};
        default:
            return {a.value / b.value, false};
        }
    }

    Number apply(std::string_view name, const std::vector<Number>& arguments) const {
        const auto wants = [&](std::string_view function, std::size_t count) {
            return name == function && arguments.size() == count;
        };
        const Number a = arguments[0];
        const Number b = arguments.size() > 1 ? arguments[1] : Number{};
        const Number c = arguments.size() > 2 ? arguments[2] : Number{};
        if (wants("int", 1)) return {std::trunc(a.value), true};
        if (wants("floor", 1)) return {std::floor(a.value), true};
        // In double, where the half can be added to every float without loss.
        if (wants("round", 1)) {
            return {static_cast<float>(std::floor(static_cast<double>(a.value) + 0.5)), true};
        }
        if (wants("abs", 1)) return {std::abs(a.value), a.is_whole};
        if (wants("sqrt", 1)) return {std::sqrt(a.value), false};
        if (wants("log2", 1)) return {log2_of(a.value), false};
        if (wants("cos", 1)) return {cosine(a.value), false};
        if (wants("sin", 1)) return {sine(a.value), false};
        if (wants("pow", 2)) return {std::pow(a.value, b.value), false};
        if (wants("srgb", 1)) return {encode_srgb(a.value), false};
        if (wants("min", 2)) return {std::min(a.value, b.value), a.is_whole && b.is_whole};
        if (wants("max", 2)) return {std::max(a.value, b.value), a.is_whole && b.is_whole};
        if (wants("clamp", 3)) return {std::min(std::max(a.value, b.value), c.value), false};
        if (wants("wrap", 2)) {
            const float rest = std::fmod(a.value, b.value);
            if (std::isnan(rest)) return {0.0f, true};
            // + 0: the remainder of a number below 0 may be −0.
            return {rest < 0.0f ? rest + b.value : rest + 0.0f, a.is_whole && b.is_whole};
        }
        if (wants("accumulate", 3)) {
            float value = a.value;
            for (int i = 0; i < static_cast<int>(c.value); ++i)
                value += b.value;
            return {value, false};
        }
        reject(formula_, "no function " + std::string(name) + " of " +
                             std::to_string(arguments.size()) + " numbers");
    }

    const Formula& formula_;
    SyntaxTree tree_;
};

/// A term of the outermost sum.
struct Summand {
    std::string_view sign; ///< in front; empty for the first
    int node = -1;
};

/// From left to right. A sum in parentheses is one term.
std::vector<Summand> terms_of(const SyntaxTree& tree) {
    std::vector<Summand> terms;
    int index = tree.root;
    while (true) {
        const SyntaxNode& here = tree.node(index);
        const bool is_sum = !here.is_in_parentheses &&
                            (here.kind == SyntaxKind::add || here.kind == SyntaxKind::subtract);
        if (!is_sum) break;
        terms.push_back({here.kind == SyntaxKind::add ? "+" : true_minus, here.parts[1]});
        index = here.parts[0];
    }
    terms.push_back({{}, index});
    std::reverse(terms.begin(), terms.end());
    return terms;
}

bool shows_minus(const std::string& text) {
    return text.starts_with(true_minus);
}

} // namespace

std::string function_help(std::string_view expression) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> helps{{
        {"int(", "int(x): x without its fraction, so it moves toward 0."},
        {"clamp(", "clamp(x, low, high): x, or the bound that x is beyond."},
        {"wrap(", "wrap(x, n): the remainder of x divided by n, never below 0."},
        {"accumulate(", "accumulate(start, step, n): starts with start and adds step n times, one "
                        "by one. Each sum is rounded to a float, as in a walk along a line."},
        {"pow(", "pow(x, e): x to the power of e."},
        {"log2(", "log2(x): the power to which 2 is raised to give x; log2(8) is 3."},
        {"srgb(",
         "srgb(x): 12.92 · x up to x = 0.0031308, and 1.055 · pow(x, 1/2.4) − 0.055 above it."},
        {"max(0,", "max(0, x): x, or 0 if x is below 0."},
    }};
    std::string text;
    for (const auto& [function, help] : helps) {
        if (expression.find(function) == expression.npos) continue;
        text.append(text.empty() ? "" : "\n").append(help);
    }
    return text;
}

std::string shown(const Number& number) {
    const float value = number.value;
    if (std::isnan(value)) return "not a number";
    if (std::isinf(value)) return value > 0 ? "+∞" : "−∞";
    const double size = std::abs(static_cast<double>(value));
    const bool is_integral = size < 1e6 && static_cast<double>(std::trunc(value)) == value;
    const int digits = size >= 1.0 ? 3 : size >= 0.1 ? 4 : size >= 0.01 ? 5 : 6;
    std::string text = number.is_whole || is_integral ? decimals(size, 0)
                       : size >= 1e6 || size < 1e-3   ? scientific(size, 2)
                                                      : decimals(size, digits);
    // Typed numbers are shown as typed: 0.15, not 0.1500.
    const std::string brief = shortest(std::abs(value));
    if (brief.size() < text.size()) text = brief;
    std::string result = value < 0 ? std::string(true_minus) + text : text;
    const std::size_t hyphen = result.find('-');
    if (hyphen != std::string::npos) result.replace(hyphen, 1, true_minus);
    return result;
}

float evaluate(const Formula& formula) {
    const Evaluator evaluator(formula);
    return evaluator.value(evaluator.tree().root).value;
}

std::vector<FormulaPiece> pieces_with_numbers(const Formula& formula) {
    using TokenKind = SyntaxToken::Kind;
    std::vector<FormulaPiece> pieces;
    const std::vector<SyntaxToken> tokens = split_tokens(formula.expression, language_of(formula));
    const SyntaxToken* before = nullptr; // the last that is not blank
    const auto is_sign = [](const SyntaxToken& token, Sign sign) {
        return token.kind == TokenKind::sign && token.sign == sign;
    };
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const SyntaxToken& token = tokens[i];
        FormulaPiece piece{std::string(token.text)};
        if (token.kind == TokenKind::symbol) {
            piece.input = input_of(formula, token.text);
            piece.text = shown(formula.inputs[static_cast<std::size_t>(piece.input)].number);
            const bool squared = i + 1 < tokens.size() && is_sign(tokens[i + 1], Sign::square);
            const bool after_sign = before != nullptr && !is_sign(*before, Sign::open) &&
                                    !is_sign(*before, Sign::comma);
            const bool is_power = piece.text.find('e') != std::string::npos;
            const bool needs = squared ? is_power || shows_minus(piece.text)
                                       : after_sign && shows_minus(piece.text);
            if (needs) piece.text = "(" + piece.text + ")";
        }
        pieces.push_back(std::move(piece));
        if (token.kind != TokenKind::blank) before = &token;
    }
    return pieces;
}

std::string with_numbers(const Formula& formula) {
    std::string text;
    for (const FormulaPiece& piece : pieces_with_numbers(formula))
        text += piece.text;
    return text;
}

std::string with_terms(const Formula& formula) {
    const Evaluator evaluator(formula);
    const SyntaxTree& tree = evaluator.tree();
    const std::vector<Summand> terms = terms_of(tree);
    const auto is_call = [&](const Summand& term) {
        const SyntaxNode& node = tree.node(term.node);
        return node.kind == SyntaxKind::call && !node.is_in_parentheses;
    };
    evaluator.value(tree.root); // all of it must make sense
    if (terms.size() == 1 && !is_call(terms.front())) return {};
    std::string text;
    for (const Summand& term : terms) {
        if (!term.sign.empty()) text.append(" ").append(term.sign).append(" ");
        if (is_call(term)) {
            const SyntaxNode& call = tree.node(term.node);
            std::string arguments;
            for (const int part : call.parts)
                arguments.append(arguments.empty() ? "" : ", ")
                    .append(shown(evaluator.value(part)));
            text.append(call.text).append("(").append(arguments).append(")");
        } else {
            std::string written = shown(evaluator.value(term.node));
            if (shows_minus(written) && !term.sign.empty()) written = "(" + written + ")";
            text += written;
        }
    }
    return text == with_numbers(formula) ? std::string() : text;
}

std::string_view first_part(std::string_view id) {
    return id.substr(0, id.find('.'));
}

bool is_possible_id(std::string_view id, std::span<const std::string_view> whole,
                    std::span<const std::string_view> first_parts) {
    const auto has = [](std::span<const std::string_view> list, std::string_view one) {
        return std::find(list.begin(), list.end(), one) != list.end();
    };
    const std::string_view first = first_part(id);
    return has(whole, id) || (has(first_parts, first) && id.size() > first.size() + 1);
}

const Formula* find_formula(const std::vector<Formula>& formulas, std::string_view id) {
    const auto found = std::find_if(formulas.begin(), formulas.end(),
                                    [id](const Formula& formula) { return formula.id == id; });
    return found == formulas.end() ? nullptr : &*found;
}

} // namespace rasterwalk
