#include "facts/expression.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/quoted.h"
#include "facts/facts.h"

namespace rasterwalk {

namespace {

using Node = ExpressionNode;
using Kind = ExpressionNode::Kind;

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::string_view type_word(const Node& node) {
    switch (node.type) {
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

/// Reads from left to right, each kind of sign by a function of its own. A word stays a word until
/// it is seen what it is compared with.
class Parser {
  public:
    explicit Parser(std::string_view text) : rest_(text) { result_.text = std::string(text); }

    Expression parse(bool is_condition) {
        if (rest_.size() > longest_expression) {
            throw UsageError("an expression has at most " + std::to_string(longest_expression) +
                             " letters.");
        }
        result_.root = read_or();
        skip_blanks();
        if (!rest_.empty())
            throw UsageError("it is not clear what " + in_quotes(rest_) + " means.");
        require_value(result_.root);
        const Node& root = node(result_.root);
        const bool fits =
            root.type == ValueType::number || (is_condition && root.type == ValueType::truth);
        if (!fits) {
            throw UsageError(in_quotes(result_.text) +
                             (is_condition ? " is no condition, but " : " is no number, but ") +
                             std::string(type_word(root)) + ".");
        }
        return std::move(result_);
    }

  private:
    const Node& node(int index) const { return result_.nodes[static_cast<std::size_t>(index)]; }
    Node& node(int index) { return result_.nodes[static_cast<std::size_t>(index)]; }

    int add(Node made) {
        result_.nodes.push_back(std::move(made));
        return static_cast<int>(result_.nodes.size()) - 1;
    }
    int add(Kind kind, ValueType type, int left, int right = -1) {
        Node made;
        made.kind = kind;
        made.type = type;
        made.left = left;
        made.right = right;
        return add(std::move(made));
    }

    void skip_blanks() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
    }
    bool take(std::string_view sign) {
        skip_blanks();
        if (!rest_.starts_with(sign)) return false;
        rest_.remove_prefix(sign.size());
        return true;
    }
    bool take_word(std::string_view word) {
        skip_blanks();
        if (!rest_.starts_with(word)) return false;
        const std::string_view after = rest_.substr(word.size());
        if (!after.empty() && (is_letter(after[0]) || is_digit(after[0]) || after[0] == '.')) {
            return false;
        }
        rest_ = after;
        return true;
    }

    /// A word that nobody compared with anything is a name that does not exist.
    void require_value(int index) const {
        const Node& part = node(index);
        if (part.kind == Kind::none) throw UsageError("'none' can only be compared with a name.");
        if (part.kind != Kind::word) return;
        const std::vector<std::string> names = all_names();
        const std::vector<std::string_view> views(names.begin(), names.end());
        throw UsageError("there is no name " + in_quotes(part.text) + "." +
                         did_you_mean(part.text, views));
    }
    void require_number(int index) const {
        require_value(index);
        if (node(index).type == ValueType::number) return;
        throw UsageError(
            "a number is needed where " + std::string(type_word(node(index))) + " stands" +
            (node(index).text.empty() ? "." : ": " + in_quotes(node(index).text) + "."));
    }
    void require_truth(int index) const {
        require_value(index);
        const ValueType type = node(index).type;
        if (type == ValueType::truth || type == ValueType::number) return;
        throw UsageError(in_quotes(node(index).text) + " is no condition by itself.");
    }

    int read_or() {
        int left = read_and();
        while (take_word("or")) {
            require_truth(left);
            const int right = read_and();
            require_truth(right);
            left = add(Kind::logical_or, ValueType::truth, left, right);
        }
        return left;
    }

    int read_and() {
        int left = read_not();
        while (take_word("and")) {
            require_truth(left);
            const int right = read_not();
            require_truth(right);
            left = add(Kind::logical_and, ValueType::truth, left, right);
        }
        return left;
    }

    int read_not() {
        if (!take_word("not")) return read_comparison();
        const Deeper deeper(*this);
        const int part = read_not();
        require_truth(part);
        return add(Kind::logical_not, ValueType::truth, part);
    }

    std::optional<Kind> take_comparison() {
        constexpr std::array<std::pair<std::string_view, Kind>, 6> signs{{
            {"==", Kind::equal},
            {"!=", Kind::unequal},
            {"<=", Kind::less_equal},
            {">=", Kind::greater_equal},
            {"<", Kind::less},
            {">", Kind::greater},
        }};
        for (const auto& [sign, kind] : signs) {
            if (take(sign)) return kind;
        }
        if (take("=")) throw UsageError("'=' sets; to compare write '=='.");
        return std::nullopt;
    }

    int read_comparison() {
        const int left = read_sum();
        const std::optional<Kind> kind = take_comparison();
        if (!kind) return left;
        const int right = read_sum();
        if (take_comparison()) {
            throw UsageError("write 'a < b and b < c' in place of 'a < b < c'.");
        }
        match(left, right, *kind);
        return add(*kind, ValueType::truth, left, right);
    }

    /// Sees to it that two sides can be compared: a word stands for what the other side's name can
    /// be.
    void match(int left, int right, Kind kind) {
        take_as_word(left, right);
        take_as_word(right, left);
        const bool is_equality = kind == Kind::equal || kind == Kind::unequal;
        for (const auto& [one, other] : {std::pair(left, right), std::pair(right, left)}) {
            if (node(one).kind != Kind::none) continue;
            if (is_equality && node(other).kind == Kind::name) return;
            throw UsageError("'none' can only be compared with a name, by '==' or '!='.");
        }
        const bool both_words =
            node(left).type == ValueType::word && node(right).type == ValueType::word;
        const bool is_word_known =
            both_words && (node(left).kind == Kind::name || node(right).kind == Kind::name);
        if (!is_word_known) {
            require_value(left);
            require_value(right);
        }
        if (node(left).type != node(right).type || node(left).type == ValueType::truth) {
            throw UsageError(std::string(type_word(node(left))) + " cannot be compared with " +
                             std::string(type_word(node(right))) + ".");
        }
        if (both_words && !is_equality) throw UsageError("words are compared by '==' or '!='.");
    }

    /// If `index` is a name that takes words, `other` is one of them.
    void take_as_word(int index, int other) {
        if (node(index).kind != Kind::name || node(index).type != ValueType::word) return;
        Node& word = node(other);
        const bool may_be_word = word.kind == Kind::word || word.kind == Kind::name ||
                                 (word.kind == Kind::moment && word.text == "end");
        if (!may_be_word) return;
        node(index).text = meant_name(node(index).text, word.text);
        const ValueRange range = find_name(node(index).text).value_or(ValueRange{});
        const auto found = std::find(range.words.begin(), range.words.end(), word.text);
        if (found != range.words.end()) {
            word.kind = Kind::word;
            word.type = ValueType::word;
        } else if (word.kind == Kind::word) {
            std::string known;
            for (const std::string_view one : range.words)
                known.append(known.empty() ? "" : ", ").append(one);
            throw UsageError(node(index).text + " is never " + in_quotes(word.text) +
                             "; it is one of " + known + "." +
                             did_you_mean(word.text, range.words));
        }
    }

    int read_sum() {
        int left = read_product();
        while (true) {
            const bool is_plus = take("+");
            if (!is_plus && !take("-")) return left;
            require_number(left);
            const int right = read_product();
            require_number(right);
            left = add(is_plus ? Kind::add : Kind::subtract, ValueType::number, left, right);
        }
    }

    int read_product() {
        int left = read_sign();
        while (true) {
            const bool is_times = take("*");
            if (!is_times && !take("/")) return left;
            require_number(left);
            const int right = read_sign();
            require_number(right);
            left = add(is_times ? Kind::multiply : Kind::divide, ValueType::number, left, right);
        }
    }

    int read_sign() {
        if (!take("-")) return read_leaf();
        const Deeper deeper(*this);
        const int part = read_sign();
        require_number(part);
        return add(Kind::negate, ValueType::number, part);
    }

    int read_leaf() {
        if (take("(")) {
            const Deeper deeper(*this);
            const int inner = read_or();
            close();
            return inner;
        }
        skip_blanks();
        if (rest_.empty())
            throw UsageError("the expression " + in_quotes(result_.text) + " ends too early.");
        if (is_digit(rest_[0]) || rest_[0] == '.') return read_number();
        if (is_letter(rest_[0])) return read_name();
        throw UsageError("it is not clear what " + in_quotes(rest_) + " means.");
    }

    void close() {
        if (!take(")")) throw UsageError("a ')' is missing in " + in_quotes(result_.text) + ".");
    }

    int read_number() {
        double value = 0.0;
        const char* const last = rest_.data() + rest_.size();
        const auto [end, fault] = std::from_chars(rest_.data(), last, value);
        if (fault != std::errc{} || !std::isfinite(value)) {
            throw UsageError(in_quotes(rest_) + " is not a number.");
        }
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        Node made;
        made.kind = Kind::number;
        made.number = value;
        return add(std::move(made));
    }

    /// A moment goes on over its slashes: `t12/r37/c5`.
    std::size_t moment_length() const {
        const auto piece_end = [&](std::size_t begin) {
            std::size_t end = begin + 1;
            while (end < rest_.size() && is_digit(rest_[end]))
                ++end;
            return end;
        };
        const auto is_piece = [&](std::size_t begin) {
            return begin + 1 < rest_.size() && is_letter(rest_[begin]) &&
                   is_digit(rest_[begin + 1]);
        };
        if (rest_[0] != 't' || !is_piece(0)) return 0;
        std::size_t length = piece_end(0);
        while (length < rest_.size() && rest_[length] == '/' && is_piece(length + 1))
            length = piece_end(length + 1);
        const bool goes_on =
            length < rest_.size() && (is_letter(rest_[length]) || rest_[length] == '.');
        return goes_on ? 0 : length;
    }

    int read_moment(std::size_t length) {
        Node made;
        made.kind = Kind::moment;
        made.type = ValueType::moment;
        made.text = std::string(rest_.substr(0, length));
        const std::optional<Cursor> moment = parse_cursor(made.text);
        if (!moment) throw UsageError(in_quotes(made.text) + " is not a moment.");
        made.moment = *moment;
        rest_.remove_prefix(length);
        return add(std::move(made));
    }

    int read_name() {
        if (const std::size_t length = moment_length(); length > 0) return read_moment(length);
        std::size_t length = 0;
        while (length < rest_.size() &&
               (is_letter(rest_[length]) || is_digit(rest_[length]) || rest_[length] == '.')) {
            ++length;
        }
        const std::string_view word = rest_.substr(0, length);
        if (word == "end") return read_moment(length);
        rest_.remove_prefix(length);
        if (take("(")) return read_call(word);
        Node made;
        made.text = std::string(word);
        if (word == "none") return add(std::move(made));
        if (const std::optional<ValueRange> range = find_name(word)) {
            made.kind = Kind::name;
            made.type = range->type;
        } else {
            made.kind = Kind::word;
            made.type = ValueType::word;
        }
        return add(std::move(made));
    }

    int read_call(std::string_view function) {
        const bool is_min = function == "min", is_max = function == "max";
        if (!is_min && !is_max && function != "abs") {
            throw UsageError("there is no function " + in_quotes(function) +
                             "; there are abs, min and max.");
        }
        const Deeper deeper(*this);
        const int left = read_sum();
        require_number(left);
        if (!is_min && !is_max) {
            close();
            return add(Kind::absolute, ValueType::number, left);
        }
        if (!take(",")) throw UsageError(std::string(function) + " takes two numbers: (a, b).");
        const int right = read_sum();
        require_number(right);
        close();
        return add(is_min ? Kind::smaller : Kind::larger, ValueType::number, left, right);
    }

    /// Counts how deep the reading is.
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

    Expression result_;
    std::string_view rest_;
    int depth_ = 0;
};

} // namespace

Expression parse_expression(std::string_view text) {
    return Parser(text).parse(false);
}

Expression parse_condition(std::string_view text) {
    return Parser(text).parse(true);
}

bool Expression::is_constant() const {
    return std::none_of(nodes.begin(), nodes.end(),
                        [](const Node& node) { return node.kind == Kind::name; });
}

} // namespace rasterwalk
