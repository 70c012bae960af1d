#include <algorithm>
#include <cmath>

#include "facts/expression.h"

namespace rasterwalk {

namespace {

using Kind = ExpressionNode::Kind;

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
    case Kind::divide:
        return a / b;
    case Kind::smaller:
        return std::min(a, b);
    default:
        return std::max(a, b);
    }
}

/// What is neither true nor false is not there.
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

    const ExpressionNode& node(int index) const {
        return expression.nodes[static_cast<std::size_t>(index)];
    }

    Value comparison(const ExpressionNode& here) const {
        const bool left_none = node(here.left).kind == Kind::none;
        if (left_none || node(here.right).kind == Kind::none) {
            const bool there = is_there(value(left_none ? here.right : here.left));
            return there == (here.kind == Kind::unequal);
        }
        const Value left = value(here.left), right = value(here.right);
        if (!is_there(left) || left.index() != right.index()) return {};
        return std::visit(
            [&](const auto& a) {
                return compare(here.kind, a, std::get<std::decay_t<decltype(a)>>(right));
            },
            left);
    }

    Value both(const ExpressionNode& here) const {
        const Truth left = truth_of(value(here.left));
        const bool decides = here.kind == Kind::logical_or;
        if (left == decides) return decides;
        const Truth right = truth_of(value(here.right));
        if (right == decides) return decides;
        return left && right ? Value(!decides) : Value();
    }

    Value arithmetic(const ExpressionNode& here) const {
        const Value left = value(here.left);
        const double* const a = std::get_if<double>(&left);
        if (a == nullptr) return {};
        if (here.kind == Kind::negate) return -*a;
        if (here.kind == Kind::absolute) return std::abs(*a);
        const Value right = value(here.right);
        const double* const b = std::get_if<double>(&right);
        if (b == nullptr) return {};
        const double result = calculate(here.kind, *a, *b);
        return std::isfinite(result) ? Value(result) : Value();
    }

    Value value(int index) const {
        const ExpressionNode& here = node(index);
        switch (here.kind) {
        case Kind::number:
            return here.number;
        case Kind::word:
            return here.text;
        case Kind::moment:
            return here.moment;
        case Kind::none:
            return {};
        case Kind::name:
            return fact(here.text);
        case Kind::logical_not: {
            const Truth truth = truth_of(value(here.left));
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
    const Value value = Evaluator{expression, fact}.value(expression.root);
    const double* const number = std::get_if<double>(&value);
    return number != nullptr ? std::optional(*number) : std::nullopt;
}

bool holds(const Expression& condition, const FactReader& fact) {
    return truth_of(Evaluator{condition, fact}.value(condition.root)).value_or(false);
}

} // namespace rasterwalk
