#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "facts/expression.h"
#include "facts/fact_values.h"
#include "facts/facts.h"

namespace rasterwalk {

namespace {

using Kind = SyntaxNode::Kind;
using Leaf = ExpressionMeaning::Leaf;

/// All values that a number can have.
struct Reach {
    double low, high;
    bool is_whole;
};

/// Infinite ends make sums and products NaN: then nothing is known about them.
Reach known(double low, double high, bool is_whole) {
    return {std::isnan(low) ? -endless : low, std::isnan(high) ? endless : high, is_whole};
}

Reach product(const Reach& a, const Reach& b) {
    const double corners[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    if (std::any_of(std::begin(corners), std::end(corners),
                    [](double c) { return std::isnan(c); })) {
        return {-endless, endless, a.is_whole && b.is_whole};
    }
    const auto [low, high] = std::minmax_element(std::begin(corners), std::end(corners));
    return {*low, *high, a.is_whole && b.is_whole};
}

struct Ranges {
    const Expression& expression;

    const SyntaxNode& node(int index) const { return expression.tree.node(index); }

    Reach reach(int index) const {
        const SyntaxNode& here = node(index);
        if (here.kind == Kind::number) {
            return {here.number, here.number, here.number == std::floor(here.number)};
        }
        if (expression.is_leaf(index, Leaf::fact)) {
            const ValueRange range =
                find_name(expression.meaning(index).name).value_or(ValueRange{});
            return {range.low, range.high, range.is_whole};
        }
        if (here.parts.empty()) return {-endless, endless, false};
        const Reach a = reach(here.parts[0]);
        if (here.kind == Kind::negate) return {-a.high, -a.low, a.is_whole};
        if (here.kind == Kind::call && here.parts.size() == 1) {
            const double far = std::max(std::abs(a.low), std::abs(a.high));
            const double near =
                a.low <= 0.0 && a.high >= 0.0 ? 0.0 : std::min(std::abs(a.low), std::abs(a.high));
            return {near, far, a.is_whole};
        }
        if (here.parts.size() < 2) return {-endless, endless, false};
        const Reach b = reach(here.parts[1]);
        const bool both_whole = a.is_whole && b.is_whole;
        switch (here.kind) {
        case Kind::add:
            return known(a.low + b.low, a.high + b.high, both_whole);
        case Kind::subtract:
            return known(a.low - b.high, a.high - b.low, both_whole);
        case Kind::multiply:
            return product(a, b);
        case Kind::divide:
            if (b.low <= 0.0 && b.high >= 0.0) return {-endless, endless, false};
            return product({a.low, a.high, false}, {1.0 / b.high, 1.0 / b.low, false});
        case Kind::call:
            if (here.text == "min") {
                return {std::min(a.low, b.low), std::min(a.high, b.high), both_whole};
            }
            return {std::max(a.low, b.low), std::max(a.high, b.high), both_whole};
        default:
            return {-endless, endless, false};
        }
    }

    bool is_impossible(const SyntaxNode& here) const {
        const bool is_comparison = here.kind >= Kind::equal && here.kind <= Kind::greater_equal;
        if (!is_comparison) return false;
        const int left = here.parts[0], right = here.parts[1];
        if (expression.meaning(left).type != ValueType::number ||
            expression.is_leaf(left, Leaf::none) || expression.is_leaf(right, Leaf::none)) {
            return false;
        }
        const Reach a = reach(left), b = reach(right);
        const bool a_is_one = a.low == a.high, b_is_one = b.low == b.high;
        switch (here.kind) {
        case Kind::equal:
            return a.low > b.high || b.low > a.high ||
                   (a.is_whole && b_is_one && b.low != std::floor(b.low)) ||
                   (b.is_whole && a_is_one && a.low != std::floor(a.low));
        case Kind::unequal:
            return a_is_one && b_is_one && a.low == b.low;
        case Kind::less:
            return a.low >= b.high;
        case Kind::less_equal:
            return a.low > b.high;
        case Kind::greater:
            return a.high <= b.low;
        default:
            return a.high < b.low;
        }
    }

    /// How tightly a part binds: looser parts inside it need parentheses.
    static int strength(Kind kind) {
        switch (kind) {
        case Kind::negate:
            return 3;
        case Kind::multiply:
        case Kind::divide:
            return 2;
        case Kind::add:
        case Kind::subtract:
            return 1;
        case Kind::equal:
        case Kind::unequal:
        case Kind::less:
        case Kind::less_equal:
        case Kind::greater:
        case Kind::greater_equal:
            return 0;
        default:
            return 4;
        }
    }

    std::string inner(int index, int least) const {
        if (strength(node(index).kind) >= least) return text(index);
        return std::string("(").append(text(index)).append(")");
    }

    /// The part as it could have been written.
    std::string text(int index) const {
        const SyntaxNode& here = node(index);
        const int own = strength(here.kind);
        const auto two = [&](const char* sign) {
            // a - (b - c) needs its parentheses.
            const bool is_strict = here.kind == Kind::subtract || here.kind == Kind::divide;
            return inner(here.parts[0], own)
                .append(sign)
                .append(inner(here.parts[1], is_strict ? own + 1 : own));
        };
        switch (here.kind) {
        case Kind::number:
            return significant(here.number, 9);
        case Kind::negate:
            return std::string("-").append(inner(here.parts[0], own));
        case Kind::call: {
            std::string call = here.text;
            for (const int part : here.parts)
                call.append(part == here.parts[0] ? "(" : ", ").append(text(part));
            return call.append(")");
        }
        case Kind::add:
            return two(" + ");
        case Kind::subtract:
            return two(" - ");
        case Kind::multiply:
            return two(" * ");
        case Kind::divide:
            return two(" / ");
        case Kind::equal:
            return two(" == ");
        case Kind::unequal:
            return two(" != ");
        case Kind::less:
            return two(" < ");
        case Kind::less_equal:
            return two(" <= ");
        case Kind::greater:
            return two(" > ");
        case Kind::greater_equal:
            return two(" >= ");
        default:
            return here.text;
        }
    }
};

} // namespace

std::vector<std::string> impossible_parts(const Expression& condition) {
    const Ranges ranges{condition};
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < condition.tree.nodes.size(); ++i) {
        const SyntaxNode& node = condition.tree.nodes[i];
        if (!ranges.is_impossible(node)) continue;
        // The sentence is about the side that is not a plain number.
        const Reach left = ranges.reach(node.parts[0]);
        const int side = left.low == left.high ? node.parts[1] : node.parts[0];
        const Reach reach = ranges.reach(side);
        sentences.push_back("'" + ranges.text(static_cast<int>(i)) +
                            "' can never be true: " + ranges.text(side) +
                            (reach.is_whole ? " is a whole number between " : " is between ") +
                            significant(reach.low, 9) + " and " + significant(reach.high, 9) + ".");
    }
    return sentences;
}

} // namespace rasterwalk
