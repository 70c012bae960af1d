#include "facts/expression.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/quoted.h"
#include "facts/facts.h"

namespace rasterwalk {

namespace {

using SyntaxKind = SyntaxNode::Kind;
using Leaf = ExpressionMeaning::Leaf;

constexpr std::array<SignSpelling, 14> condition_signs{{
    {"==", Sign::equal},
    {"!=", Sign::unequal},
    {"<=", Sign::less_equal},
    {">=", Sign::greater_equal},
    {"<", Sign::less},
    {">", Sign::greater},
    {"=", Sign::assign},
    {"+", Sign::plus},
    {"-", Sign::minus},
    {"*", Sign::times},
    {"/", Sign::over},
    {"(", Sign::open},
    {")", Sign::close},
    {",", Sign::comma},
}};

bool is_small_letter(char c) {
    return c >= 'a' && c <= 'z';
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// May a name continue with this?
bool is_in_name(char c) {
    return is_small_letter(c) || is_digit(c) || (c >= 'A' && c <= 'Z') || c == '_' || c == '.';
}

/// Is it a slash and the letter of a phase that is a single piece, as "/k"?
bool is_unnumbered_phase(std::string_view text) {
    if (text.size() != 2 || text[0] != '/') return false;
    return std::any_of(phase_list.begin(), phase_list.end(), [&](const PhaseInfo& info) {
        return !info.is_numbered && info.letter == text[1];
    });
}

/// The length of the pass in front of a moment, "p3:"; 0 if there is none.
std::size_t pass_length(std::string_view text) {
    if (text.empty() || text[0] != 'p') return 0;
    const std::size_t end = text.find_first_not_of("0123456789", 1);
    return end != text.npos && end > 1 && text[end] == ':' ? end + 1 : 0;
}

/// The length of the moment at the front of the text: `end`, or with its slashes `t12/r37/c5`,
/// `t12/k`, and its pass before it; 0 if there is none.
std::size_t moment_length(std::string_view text) {
    if (const std::size_t pass = pass_length(text); pass > 0 && pass < text.size()) {
        const std::size_t length = moment_length(text.substr(pass));
        return length > 0 ? pass + length : 0;
    }
    constexpr std::string_view end = "end";
    const auto ends_at = [&](std::size_t place) {
        return place == text.size() || !is_in_name(text[place]);
    };
    if (text.starts_with(end) && ends_at(end.size())) return end.size();
    const auto is_piece = [&](std::size_t begin) {
        return begin + 1 < text.size() && is_in_name(text[begin]) && !is_digit(text[begin]) &&
               text[begin] != '.' && is_digit(text[begin + 1]);
    };
    const auto piece_end = [&](std::size_t begin) {
        return std::min(text.find_first_not_of("0123456789", begin + 1), text.size());
    };
    if (text[0] != 't' || !is_piece(0)) return 0;
    std::size_t length = piece_end(0);
    while (length < text.size() && text[length] == '/' && is_piece(length + 1))
        length = piece_end(length + 1);
    if (is_unnumbered_phase(text.substr(length, 2)) && ends_at(length + 2)) length += 2;
    return ends_at(length) ? length : 0;
}

std::string type_word(ValueType type) {
    switch (type) {
    case ValueType::number:
        return "a number";
    case ValueType::word:
        return "a word";
    case ValueType::moment:
        return "a moment";
    case ValueType::truth:
        return "true or false";
    }
    return {};
}

/// Finds out what the parts of a tree mean, from left to right, the inner ones
/// first. A word stays a word until it is clear what it is compared with.
class Resolver {
  public:
    explicit Resolver(Expression& expression) : expression_(expression), tree_(expression.tree) {
        expression.meanings.resize(tree_.nodes.size());
    }

    void resolve(bool is_condition) {
        resolve(tree_.root);
        require_value(tree_.root);
        const ValueType type = of(tree_.root).type;
        if (type == ValueType::number || (is_condition && type == ValueType::truth)) return;
        throw UsageError(in_quotes(tree_.text) +
                         (is_condition ? " is not a condition but " : " is not a number but ") +
                         type_word(type) + ".");
    }

  private:
    const SyntaxNode& node(int index) const { return tree_.node(index); }
    ExpressionMeaning& of(int index) const {
        return expression_.meanings[static_cast<std::size_t>(index)];
    }
    bool is_leaf(int index, Leaf leaf) const { return expression_.is_leaf(index, leaf); }

    void resolve(int index) {
        const SyntaxNode& here = node(index);
        switch (here.kind) {
        case SyntaxKind::number:
            return;
        case SyntaxKind::name:
            resolve_name(index);
            return;
        case SyntaxKind::symbol:
            resolve_moment(index);
            return;
        case SyntaxKind::call:
            resolve_call(index);
            return;
        case SyntaxKind::logical_not:
        case SyntaxKind::logical_and:
        case SyntaxKind::logical_or:
            for (const int part : here.parts) {
                resolve(part);
                require_truth(part);
            }
            of(index).type = ValueType::truth;
            return;
        case SyntaxKind::equal:
        case SyntaxKind::unequal:
        case SyntaxKind::less:
        case SyntaxKind::less_equal:
        case SyntaxKind::greater:
        case SyntaxKind::greater_equal:
            for (const int part : here.parts)
                resolve(part);
            match(here.parts[0], here.parts[1], here.kind);
            of(index).type = ValueType::truth;
            return;
        default:
            resolve_numbers(here.parts);
        }
    }

    void resolve_numbers(const std::vector<int>& parts) {
        for (const int part : parts) {
            resolve(part);
            require_number(part);
        }
    }

    void resolve_name(int index) {
        ExpressionMeaning& meaning = of(index);
        if (node(index).text == "none") {
            meaning.leaf = Leaf::none;
        } else if (const std::optional<ValueRange> range = find_name(node(index).text)) {
            meaning.type = range->type;
            meaning.name = node(index).text;
        } else {
            meaning.leaf = Leaf::word;
            meaning.type = ValueType::word;
        }
    }

    void resolve_moment(int index) {
        const std::optional<Cursor> moment = parse_cursor(node(index).text);
        if (!moment) throw UsageError(in_quotes(node(index).text) + " is not a moment.");
        of(index) = {Leaf::moment, ValueType::moment, *moment, {}};
    }

    void resolve_call(int index) {
        const SyntaxNode& call = node(index);
        const bool takes_two = call.text == "min" || call.text == "max";
        if (!takes_two && call.text != "abs") {
            throw UsageError("there is no function " + in_quotes(call.text) +
                             "; the functions are abs, min and max.");
        }
        resolve_numbers(call.parts);
        const std::size_t wanted = takes_two ? 2 : 1;
        if (call.parts.size() < wanted) {
            throw UsageError(call.text + " takes two numbers: (a, b).");
        }
        if (call.parts.size() > wanted) {
            throw UsageError("a ')' is missing from " + in_quotes(tree_.text) + ".");
        }
    }

    /// A word that is not compared with anything is a name that does not exist.
    void require_value(int index) const {
        if (is_leaf(index, Leaf::none)) {
            throw UsageError("'none' can only be compared with a name.");
        }
        if (!is_leaf(index, Leaf::word)) return;
        const std::vector<std::string> names = all_names();
        const std::vector<std::string_view> views(names.begin(), names.end());
        throw UsageError("there is no name " + in_quotes(node(index).text) + "." +
                         did_you_mean(node(index).text, views));
    }
    void require_number(int index) const {
        require_value(index);
        if (of(index).type == ValueType::number) return;
        const std::string& text = node(index).text;
        throw UsageError("a number is needed instead of " + type_word(of(index).type) +
                         (text.empty() ? "." : ": " + in_quotes(text) + "."));
    }
    void require_truth(int index) const {
        require_value(index);
        const ValueType type = of(index).type;
        if (type == ValueType::truth || type == ValueType::number) return;
        throw UsageError(in_quotes(node(index).text) + " is not a condition by itself.");
    }

    /// Makes sure that two sides can be compared: a word must be a value of the
    /// other side's name.
    void match(int left, int right, SyntaxKind kind) {
        take_as_word(left, right);
        take_as_word(right, left);
        const bool is_equality = kind == SyntaxKind::equal || kind == SyntaxKind::unequal;
        for (const auto& [one, other] : {std::pair(left, right), std::pair(right, left)}) {
            if (!is_leaf(one, Leaf::none)) continue;
            if (is_equality && is_leaf(other, Leaf::fact)) return;
            throw UsageError("'none' can only be compared with a name, using '==' or '!='.");
        }
        const bool both_words =
            of(left).type == ValueType::word && of(right).type == ValueType::word;
        const bool is_word_known =
            both_words && (is_leaf(left, Leaf::fact) || is_leaf(right, Leaf::fact));
        if (!is_word_known) {
            require_value(left);
            require_value(right);
        }
        if (of(left).type != of(right).type || of(left).type == ValueType::truth) {
            throw UsageError(type_word(of(left).type) + " cannot be compared with " +
                             type_word(of(right).type) + ".");
        }
        if (both_words && !is_equality) throw UsageError("words are compared using '==' or '!='.");
    }

    /// If `index` is a name that takes words, `other` becomes one of them.
    void take_as_word(int index, int other) {
        if (!is_leaf(index, Leaf::fact) || of(index).type != ValueType::word) return;
        const std::string& word = node(other).text;
        const bool may_be_word = is_leaf(other, Leaf::word) || is_leaf(other, Leaf::fact) ||
                                 (is_leaf(other, Leaf::moment) && word == "end");
        if (!may_be_word) return;
        of(index).name = meant_name(node(index).text, word);
        const ValueRange range = find_name(of(index).name).value_or(ValueRange{});
        const auto found = std::find(range.words.begin(), range.words.end(), word);
        if (found != range.words.end()) {
            of(other) = {Leaf::word, ValueType::word, {}, {}};
        } else if (is_leaf(other, Leaf::word)) {
            std::string known;
            for (const std::string_view one : range.words)
                known.append(known.empty() ? "" : ", ").append(one);
            throw UsageError(node(index).text + " is never " + in_quotes(word) + "; it is one of " +
                             known + "." + did_you_mean(word, range.words));
        }
    }

    Expression& expression_;
    const SyntaxTree& tree_;
};

Expression read_expression(std::string_view text, bool is_condition) {
    const ExpressionLanguage language{condition_signs, true, moment_length};
    Expression expression;
    expression.tree = parse_syntax(text, language);
    Resolver(expression).resolve(is_condition);
    return expression;
}

} // namespace

Expression parse_expression(std::string_view text) {
    return read_expression(text, false);
}

Expression parse_condition(std::string_view text) {
    return read_expression(text, true);
}

bool Expression::is_leaf(int index, Leaf leaf) const {
    const SyntaxKind kind = tree.node(index).kind;
    return (kind == SyntaxKind::name || kind == SyntaxKind::symbol) && meaning(index).leaf == leaf;
}

bool Expression::is_constant() const {
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        if (is_leaf(static_cast<int>(i), Leaf::fact)) return false;
    }
    return true;
}

} // namespace rasterwalk
