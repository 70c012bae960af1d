#include <algorithm>
#include <cmath>

#include "facts/expression.h"

namespace rasterwalk {

namespace {

using Kind = SyntaxNode::Kind;
using Leaf = ExpressionMeaning::Leaf;

template <class T>
bool compare(Kind kind, const T& a, const T& b) {
    switch (kind) {
    case Kind::equal:
        return a == b;
    case Kind::unequal:
        return a != b;
    case Kind::less:
        return a < b;
    case Kind::less_equal:
        return a <= b;
    case Kind::greater:
        return a > b;
    default:
        return a >= b;
    }
}

double calculate(Kind kind, double a, double b) {
    switch (kind) {
    case Kind::add:
        return a + b;
    case Kind::subtract:
        return a - b;
    case Kind::multiply:
        return a * b;
    default:
        return a / b;
    }
}

/// Neither true nor false: no value.
using Truth = std::optional<bool>;

Truth truth_of(const Value& value) {
    if (const bool* truth = std::get_if<bool>(&value)) return *truth;
    if (const double* number = std::get_if<double>(&value)) return *number != 0.0;
    return std::nullopt;
}

Value to_value(Truth truth) {
    return truth ? Value(*truth) : Value();
}

struct Evaluator {
    const Expression& expression;
    const FactReader& fact;

    Value comparison(const SyntaxNode& here) const {
        const int a_part = here.parts[0], b_part = here.parts[1];
        const bool left_none = expression.is_leaf(a_part, Leaf::none);
        if (left_none || expression.is_leaf(b_part, Leaf::none)) {
            const bool there = is_there(value(left_none ? b_part : a_part));
            return there == (here.kind == Kind::unequal);
        }
        const Value left = value(a_part), right = value(b_part);
        if (!is_there(left) || left.index() != right.index()) return {};
        return std::visit(
            [&](const auto& a) {
                return compare(here.kind, a, std::get<std::decay_t<decltype(a)>>(right));
            },
            left);
    }

    Value both(const SyntaxNode& here) const {
        const Truth left = truth_of(value(here.parts[0]));
        const bool decides = here.kind == Kind::logical_or;
        if (left == decides) return decides;
        const Truth right = truth_of(value(here.parts[1]));
        if (right == decides) return decides;
        return left && right ? Value(!decides) : Value();
    }

    Value arithmetic(const SyntaxNode& here) const {
        const Value left = value(here.parts[0]);
        const double* const a = std::get_if<double>(&left);
        if (a == nullptr) return {};
        if (here.kind == Kind::negate) return -*a;
        if (here.parts.size() == 1) return std::abs(*a);
        const Value right = value(here.parts[1]);
        const double* const b = std::get_if<double>(&right);
        if (b == nullptr) return {};
        const double result = here.kind != Kind::call ? calculate(here.kind, *a, *b)
                              : here.text == "min"    ? std::min(*a, *b)
                                                      : std::max(*a, *b);
        return std::isfinite(result) ? Value(result) : Value();
    }

    Value leaf(int index) const {
        const ExpressionMeaning& meaning = expression.meaning(index);
        const std::string& text = expression.tree.node(index).text;
        switch (meaning.leaf) {
        case Leaf::fact:
            return fact(meaning.name);
        case Leaf::word:
            return text;
        case Leaf::moment:
            return meaning.moment;
        case Leaf::none:
            break;
        }
        return {};
    }

    Value value(int index) const {
        const SyntaxNode& here = expression.tree.node(index);
        switch (here.kind) {
        case Kind::number:
            return here.number;
        case Kind::name:
        case Kind::symbol:
            return leaf(index);
        case Kind::logical_not: {
            const Truth truth = truth_of(value(here.parts[0]));
            return to_value(truth ? Truth(!*truth) : truth);
        }
        case Kind::logical_and:
        case Kind::logical_or:
            return both(here);
        case Kind::equal:
        case Kind::unequal:
        case Kind::less:
        case Kind::less_equal:
        case Kind::greater:
        case Kind::greater_equal:
            return comparison(here);
        default:
            return arithmetic(here);
        }
    }
};

} // namespace

std::optional<double> number_of(const Expression& expression, const FactReader& fact) {
    const Value value = Evaluator{expression, fact}.value(expression.tree.root);
    const double* const number = std::get_if<double>(&value);
    return number != nullptr ? std::optional(*number) : std::nullopt;
}

bool holds(const Expression& condition, const FactReader& fact) {
    return truth_of(Evaluator{condition, fact}.value(condition.tree.root)).value_or(false);
}

} // namespace rasterwalk
