#include "explain/formula.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace rasterwalk {

namespace {

constexpr std::string_view plus = "+", minus = "−", times = "·", over = "/", square = "²";

enum class TokenKind : std::uint8_t { blank, number, symbol, function, sign };

struct Token {
    TokenKind kind;
    std::string_view text;
    int input = -1; ///< of a symbol
};

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool starts_with_sign(std::string_view text, std::string_view& sign) {
    static constexpr std::array<std::string_view, 8> signs{plus,   minus, times, over,
                                                           square, "(",   ")",   ","};
    for (const std::string_view candidate : signs) {
        if (text.starts_with(candidate)) {
            sign = candidate;
            return true;
        }
    }
    return false;
}

/// May a symbol end before this text?
bool ends_word(std::string_view text) {
    std::string_view sign;
    if (text.empty() || text.front() == ' ' || starts_with_sign(text, sign)) return true;
    return !is_letter(text.front()) && !is_digit(text.front()) && text.front() != '.' &&
           static_cast<unsigned char>(text.front()) < 0x80;
}

/// The input whose symbol the text begins with; of several the longest; -1: none.
int input_at(std::string_view text, const std::vector<FormulaInput>& inputs) {
    int found = -1;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const std::string& symbol = inputs[i].symbol;
        if (!text.starts_with(symbol) || !ends_word(text.substr(symbol.size()))) continue;
        if (found < 0 || symbol.size() > inputs[static_cast<std::size_t>(found)].symbol.size()) {
            found = static_cast<int>(i);
        }
    }
    return found;
}

[[noreturn]] void reject(const Formula& formula, const std::string& reason) {
    throw std::invalid_argument("formula " + formula.id + ": " + reason + " in '" +
                                formula.expression + "'");
}

std::vector<Token> tokens_of(const Formula& formula) {
    std::vector<Token> tokens;
    std::string_view rest = formula.expression;
    const auto take = [&](TokenKind kind, std::size_t length, int input = -1) {
        tokens.push_back({kind, rest.substr(0, length), input});
        rest.remove_prefix(length);
    };
    while (!rest.empty()) {
        std::string_view sign;
        std::size_t length = 1;
        if (rest.front() == ' ') {
            take(TokenKind::blank, length);
        } else if (const int input = input_at(rest, formula.inputs); input >= 0) {
            take(TokenKind::symbol, formula.inputs[static_cast<std::size_t>(input)].symbol.size(),
                 input);
        } else if (starts_with_sign(rest, sign)) {
            take(TokenKind::sign, sign.size());
        } else if (is_digit(rest.front())) {
            while (length < rest.size() && is_digit(rest[length]))
                ++length;
            take(TokenKind::number, length);
        } else if (is_letter(rest.front())) {
            while (length < rest.size() && (is_letter(rest[length]) || is_digit(rest[length])))
                ++length;
            take(TokenKind::function, length);
        } else {
            reject(formula,
                   "no sign or symbol begins with '" + std::string(rest.substr(0, 4)) + "'");
        }
    }
    return tokens;
}

/// A term of the outermost sum, for the line in which only the terms are worked out.
struct Term {
    std::string_view sign; ///< before it; empty before the first
    float value = 0.0f;
    bool is_whole = false;
    std::string_view function;     ///< if the term is nothing but the call of a function
    std::vector<Number> arguments; ///< of that function
};

/// Reads an expression from left to right and works it out on the way.
class Evaluator {
  public:
    explicit Evaluator(const Formula& of) : formula(of) {
        for (const Token& token : tokens_of(of)) {
            if (token.kind != TokenKind::blank) tokens.push_back(token);
        }
    }

    Number all(std::vector<Term>* terms = nullptr) {
        const Number result = sum(terms);
        if (at < tokens.size()) reject(formula, "too much");
        return result;
    }

  private:
    bool next_is(std::string_view sign) const {
        return at < tokens.size() && tokens[at].kind == TokenKind::sign && tokens[at].text == sign;
    }
    bool accept(std::string_view sign) {
        if (!next_is(sign)) return false;
        ++at;
        return true;
    }
    void expect(std::string_view sign) {
        if (!accept(sign)) reject(formula, "no '" + std::string(sign) + "'");
    }

    Number sum(std::vector<Term>* terms = nullptr) {
        Term term;
        Number total = product(term);
        if (terms != nullptr) terms->push_back(term);
        while (next_is(plus) || next_is(minus)) {
            const std::string_view sign = tokens[at++].text;
            Term further;
            const Number number = product(further);
            further.sign = sign;
            if (terms != nullptr) terms->push_back(further);
            const float value =
                sign == plus ? total.value + number.value : total.value - number.value;
            total = {value, total.is_whole && number.is_whole};
        }
        return total;
    }

    Number product(Term& term) {
        Number total = power(term);
        while (next_is(times) || next_is(over)) {
            const bool multiplies = tokens[at++].text == times;
            Term ignored;
            const Number number = power(ignored);
            term.function = {};
            total = {multiplies ? total.value * number.value : total.value / number.value,
                     multiplies && total.is_whole && number.is_whole};
        }
        term.value = total.value;
        term.is_whole = total.is_whole;
        return total;
    }

    Number power(Term& term) {
        Number number = factor(term);
        while (accept(square)) {
            term.function = {};
            number.value = number.value * number.value;
        }
        return number;
    }

    Number factor(Term& term) {
        if (accept(minus)) {
            Term ignored;
            const Number number = power(ignored);
            return {-number.value, number.is_whole};
        }
        if (accept("(")) {
            const Number number = sum();
            expect(")");
            return number;
        }
        if (at == tokens.size()) reject(formula, "a number is missing");
        const Token token = tokens[at++];
        switch (token.kind) {
        case TokenKind::number:
            return {std::stof(std::string(token.text)), true};
        case TokenKind::symbol:
            return formula.inputs[static_cast<std::size_t>(token.input)].number;
        case TokenKind::function:
            return call(token.text, term);
        case TokenKind::blank:
        case TokenKind::sign:
            break;
        }
        reject(formula, "a number is missing before '" + std::string(token.text) + "'");
    }

    Number call(std::string_view name, Term& term) {
        std::vector<Number> arguments;
        expect("(");
        do {
            arguments.push_back(sum());
        } while (accept(","));
        expect(")");
        term.function = name;
        term.arguments = arguments;
        return apply(name, arguments);
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
        if (wants("cos", 1)) return {std::cos(a.value), false};
        if (wants("sin", 1)) return {std::sin(a.value), false};
        if (wants("min", 2)) return {std::min(a.value, b.value), a.is_whole && b.is_whole};
        if (wants("max", 2)) return {std::max(a.value, b.value), a.is_whole && b.is_whole};
        if (wants("clamp", 3)) return {std::min(std::max(a.value, b.value), c.value), false};
        if (wants("wrap", 2)) {
            const float rest = std::fmod(a.value, b.value);
            if (std::isnan(rest)) return {0.0f, true};
            return {rest < 0.0f ? rest + b.value : rest, a.is_whole && b.is_whole};
        }
        if (wants("accumulate", 3)) {
            float value = a.value;
            for (int i = 0; i < static_cast<int>(c.value); ++i)
                value += b.value;
            return {value, false};
        }
        reject(formula, "no function " + std::string(name) + " of " +
                            std::to_string(arguments.size()) + " numbers");
    }

    const Formula& formula;
    std::vector<Token> tokens;
    std::size_t at = 0;
};

bool shows_minus(const std::string& text) {
    return text.starts_with(minus);
}

} // namespace

Source from_words(std::string words) {
    Source source;
    source.name = std::move(words);
    return source;
}

Source from_setting(std::string name) {
    Source source;
    source.kind = SourceKind::setting;
    source.name = std::move(name);
    return source;
}

Source from_vertex(int triangle, int vertex, std::string value_id) {
    Source source;
    source.kind = SourceKind::vertex;
    source.name = std::move(value_id);
    source.triangle = triangle;
    source.vertex = vertex;
    return source;
}

Source from_row_end(int triangle, int row, bool is_right) {
    Source source;
    source.kind = SourceKind::row_end;
    source.triangle = triangle;
    source.row = row;
    source.is_right = is_right;
    return source;
}

Source from_moment(const Cursor& moment) {
    Source source;
    source.kind = SourceKind::moment;
    source.moment = moment;
    return source;
}

Source from_formula(std::string id) {
    Source source;
    source.kind = SourceKind::formula;
    source.name = std::move(id);
    return source;
}

std::string source_text(const Source& source) {
    switch (source.kind) {
    case SourceKind::given:
        return source.name;
    case SourceKind::setting:
        return "setting " + source.name;
    case SourceKind::vertex:
        return "vertex " + std::to_string(source.vertex + 1) + " of triangle " +
               std::to_string(source.triangle + 1);
    case SourceKind::row_end:
        return std::string(source.is_right ? "right" : "left") + " end of row " +
               std::to_string(source.row);
    case SourceKind::moment:
        return "the moment " + to_text(source.moment);
    case SourceKind::formula:
        return "a formula of its own";
    }
    return {};
}

std::string shown(const Number& number) {
    const float value = number.value;
    if (std::isnan(value)) return "not a number";
    if (std::isinf(value)) return value > 0 ? "+∞" : "−∞";
    const double size = std::abs(static_cast<double>(value));
    const bool is_integral = size < 1e6 && static_cast<double>(std::trunc(value)) == value;
    char text[48];
    if (number.is_whole || is_integral) {
        std::snprintf(text, sizeof text, "%.0f", size);
    } else if (size >= 1e6 || size < 1e-3) {
        std::snprintf(text, sizeof text, "%.2e", size);
    } else {
        const int digits = size >= 1.0 ? 3 : size >= 0.1 ? 4 : size >= 0.01 ? 5 : 6;
        std::snprintf(text, sizeof text, "%.*f", digits, size);
    }
    // Numbers that someone has typed are shown as typed: 0.15, not 0.1500.
    char brief[48];
    const auto end = std::to_chars(brief, brief + sizeof brief, std::abs(value)).ptr;
    const std::string_view shortest(brief, static_cast<std::size_t>(end - brief));
    const bool is_brief = shortest.size() < std::string_view(text).size();
    std::string result = value < 0 ? std::string(minus) : std::string();
    result += is_brief ? shortest : std::string_view(text);
    const std::size_t hyphen = result.find('-');
    if (hyphen != std::string::npos) result.replace(hyphen, 1, minus);
    return result;
}

float evaluate(const Formula& formula) {
    return Evaluator(formula).all().value;
}

std::vector<FormulaPiece> pieces_with_numbers(const Formula& formula) {
    std::vector<FormulaPiece> pieces;
    const std::vector<Token> tokens = tokens_of(formula);
    std::string_view before;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        std::string text(token.text);
        if (token.kind == TokenKind::symbol) {
            const std::size_t input = static_cast<std::size_t>(token.input);
            text = shown(formula.inputs[input].number);
            const bool squared = i + 1 < tokens.size() && tokens[i + 1].text == square;
            const bool after_sign = !before.empty() && before != "(" && before != ",";
            const bool is_power = text.find('e') != std::string::npos;
            const bool needs =
                squared ? is_power || shows_minus(text) : after_sign && shows_minus(text);
            if (needs) text = "(" + text + ")";
        }
        pieces.push_back({std::move(text), token.input});
        if (token.kind != TokenKind::blank) before = token.text;
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
    std::vector<Term> terms;
    Evaluator(formula).all(&terms);
    if (terms.size() == 1 && terms.front().function.empty()) return {};
    std::string text;
    for (const Term& term : terms) {
        if (!term.sign.empty()) text.append(" ").append(term.sign).append(" ");
        std::string written;
        if (term.function.empty()) {
            written = shown({term.value, term.is_whole});
            if (shows_minus(written) && !term.sign.empty()) written = "(" + written + ")";
        } else {
            for (const Number& argument : term.arguments)
                written.append(written.empty() ? "" : ", ").append(shown(argument));
            written = std::string(term.function).append("(").append(written).append(")");
        }
        text += written;
    }
    return text == with_numbers(formula) ? std::string() : text;
}

const Formula* find_formula(const std::vector<Formula>& formulas, std::string_view id) {
    const auto found = std::find_if(formulas.begin(), formulas.end(),
                                    [id](const Formula& formula) { return formula.id == id; });
    return found == formulas.end() ? nullptr : &*found;
}

} // namespace rasterwalk
