#include <algorithm>
#include <bit>
#include <charconv>
#include <limits>

#include <fmt/format.h>

#include "code/code_builder.h"

namespace rasterwalk {

namespace {

using Kind = CodeExpression::Kind;
using TypeKind = CodeType::Kind;
using Where = BuiltValue::Where;

/// The instruction of an operator for each kind of number.
struct NumberOps {
    std::string_view sign;
    CodeOp of_int, of_real, of_double;
};

constexpr NumberOps arithmetic_ops[]{
    {"+", CodeOp::add_i, CodeOp::add_f, CodeOp::add_d},
    {"-", CodeOp::sub_i, CodeOp::sub_f, CodeOp::sub_d},
    {"*", CodeOp::mul_i, CodeOp::mul_f, CodeOp::mul_d},
    {"/", CodeOp::div_i, CodeOp::div_f, CodeOp::div_d},
};

CodeOp op_for(const NumberOps& ops, CodeTypeId number) {
    if (number == code_type::double_real) return ops.of_double;
    return number == code_type::real ? ops.of_real : ops.of_int;
}

/// The type in which C++ computes with two numbers.
CodeTypeId common_number(CodeTypeId a, CodeTypeId b) {
    if (a == code_type::double_real || b == code_type::double_real) return code_type::double_real;
    if (a == code_type::real || b == code_type::real) return code_type::real;
    return code_type::integer;
}

} // namespace

BuiltValue CodeBuilder::build(const CodeExpression& expression) {
    switch (expression.kind) {
    case Kind::integer: {
        const BuiltValue made = temporary(code_type::integer);
        emit(CodeOp::set, 1, made.at, *constant_of(expression));
        return made;
    }
    case Kind::boolean: {
        const BuiltValue made = temporary(code_type::boolean);
        emit(CodeOp::set, 1, made.at, expression.text == "true" ? 1 : 0);
        return made;
    }
    case Kind::real: {
        const BuiltValue made = temporary(code_type::double_real);
        double value = 0.0;
        if (std::from_chars(expression.text.data(), expression.text.data() + expression.text.size(),
                            value)
                .ec != std::errc())
            fail(expression.line, fmt::format("The number {} is too large", expression.text));
        const auto words = std::bit_cast<std::array<int, 2>>(value);
        emit(CodeOp::set, 1, made.at, words[0]);
        emit(CodeOp::set, 1, made.at + 1, words[1]);
        return made;
    }
    case Kind::single_real: {
        const BuiltValue made = temporary(code_type::real);
        float value = 0.0f;
        if (std::from_chars(expression.text.data(), expression.text.data() + expression.text.size(),
                            value)
                .ec != std::errc())
            fail(expression.line, fmt::format("The number {} is too large", expression.text));
        emit(CodeOp::set, 1, made.at, std::bit_cast<int>(value));
        return made;
    }
    case Kind::text:
        fail(expression.line, "Strings are not understood here");
    case Kind::name:
        return build_name(expression);
    case Kind::unary:
        return build_unary(expression);
    case Kind::binary:
        return build_binary(expression);
    case Kind::assign:
        return build_assignment(expression);
    case Kind::conditional:
        return build_conditional(expression);
    case Kind::call:
        return build_call(expression);
    case Kind::index:
        return build_index(expression);
    case Kind::member:
        return build_member(expression);
    case Kind::method:
        return build_method(expression);
    case Kind::before:
    case Kind::after:
        return build_step(expression);
    case Kind::list:
        break;
    }
    fail(expression.line, "What these braces are to make is not known");
}

BuiltValue CodeBuilder::build_name(const CodeExpression& expression) {
    const NamedVariable* const variable = find_variable(expression.text);
    if (variable != nullptr) return variable->value;
    static constexpr std::pair<std::string_view, int> limits[]{
        {"INT_MAX", std::numeric_limits<int>::max()}, {"INT_MIN", std::numeric_limits<int>::min()}};
    for (const auto& [name, value] : limits) {
        if (name != expression.text) continue;
        const BuiltValue made = temporary(code_type::integer);
        emit(CodeOp::set, 1, made.at, value);
        return made;
    }
    std::vector<std::string_view> names;
    for (const BuiltScope& scope : scopes_)
        for (const auto& [name, known] : scope.variables)
            names.push_back(name);
    fail(expression.line, fmt::format("`{}` is not declared here{}", expression.text,
                                      or_meant(expression.text, names)));
}

BuiltValue CodeBuilder::build_unary(const CodeExpression& expression) {
    BuiltValue value = build(*expression.parts[0]);
    if (expression.text == "!") {
        const int slot = in_slots(converted(value, code_type::boolean, expression.line));
        const BuiltValue made = temporary(code_type::boolean);
        emit(CodeOp::invert, 1, made.at, slot);
        return made;
    }
    if (value.type == code_type::boolean)
        value = converted(value, code_type::integer, expression.line);
    const CodeType& type = program_.types[value.type];
    const bool can =
        program_.types.is_number(value.type) || is_vector(type) || type.kind == TypeKind::matrix;
    if (!can)
        fail(expression.line, fmt::format("{} has no sign", at_beginning(with_article(type.name))));
    const int slot = in_slots(value);
    if (expression.text == "+") return {value.type, Where::slots, slot, 0, false, false};
    const BuiltValue made = temporary(value.type);
    const bool is_double = value.type == code_type::double_real;
    const bool is_int = value.type == code_type::integer || type.kind == TypeKind::int_vector;
    emit(is_double ? CodeOp::neg_d
         : is_int  ? CodeOp::neg_i
                   : CodeOp::neg_f,
         is_double ? 1 : program_.types[value.type].words, made.at, slot);
    return made;
}

BuiltValue CodeBuilder::arithmetic(const std::string& sign, const BuiltValue& left,
                                   const BuiltValue& right, int line) {
    const CodeTypes& types = program_.types;
    const bool are_numbers = types.is_number(left.type) && types.is_number(right.type);
    if (sign == "%") {
        if (!are_numbers || common_number(left.type, right.type) != code_type::integer)
            fail(line, "% is for whole numbers");
        const int a = in_slots(left), b = in_slots(right);
        const BuiltValue made = temporary(code_type::integer);
        emit(CodeOp::rem_i, 1, made.at, a, b);
        return made;
    }
    const NumberOps& ops = *std::find_if(std::begin(arithmetic_ops), std::end(arithmetic_ops),
                                         [&](const NumberOps& one) { return one.sign == sign; });
    if (are_numbers) {
        const CodeTypeId type = common_number(left.type, right.type);
        const int a = in_slots(converted(left, type, line));
        const int b = in_slots(converted(right, type, line));
        const BuiltValue made = temporary(type);
        emit(op_for(ops, type), 1, made.at, a, b);
        return made;
    }
    const bool has_matrix =
        types[left.type].kind == TypeKind::matrix || types[right.type].kind == TypeKind::matrix;
    const bool is_product_of_matrix =
        has_matrix && sign == "*" && !types.is_number(left.type) && !types.is_number(right.type);
    if (is_product_of_matrix) return build_host_call("*", {left, right}, line);
    // Component by component; a number goes with each of them.
    const CodeTypeId whole = types.is_number(left.type) ? right.type : left.type;
    const CodeType& type = types[whole];
    const bool is_of_reals =
        type.kind == TypeKind::real_vector || (type.kind == TypeKind::matrix && sign != "/");
    const CodeTypeId number = is_of_reals ? code_type::real : code_type::integer;
    const auto fits = [&](const BuiltValue& part) {
        return part.type == whole || part.type == number;
    };
    if ((!is_vector(type) && type.kind != TypeKind::matrix) || !fits(left) || !fits(right))
        fail(line,
             fmt::format("There is no {} {} {}{}", name_of(left.type), sign, name_of(right.type),
                         is_of_reals && (left.type == code_type::double_real ||
                                         right.type == code_type::double_real)
                             ? ": a number like 2.0f is a float"
                             : ""));
    const auto lanes = [&](const BuiltValue& part) {
        const int slot = in_slots(part);
        if (part.type == whole) return slot;
        const int words = program_.types[whole].words;
        const int spread = reserve(words);
        emit(CodeOp::spread, words, spread, slot);
        return spread;
    };
    const int a = lanes(left), b = lanes(right);
    const BuiltValue made = temporary(whole);
    emit(op_for(ops, number), program_.types[whole].words, made.at, a, b);
    return made;
}

BuiltValue CodeBuilder::build_binary(const CodeExpression& expression) {
    const std::string& sign = expression.text;
    if (sign == "&&" || sign == "||") return build_logic(expression);
    if (sign == "<" || sign == ">" || sign == "<=" || sign == ">=" || sign == "==" || sign == "!=")
        return build_comparison(expression);
    const BuiltValue left = build(*expression.parts[0]);
    const BuiltValue right = build(*expression.parts[1]);
    return arithmetic(sign, left, right, expression.line);
}

BuiltValue CodeBuilder::build_logic(const CodeExpression& expression) {
    const BuiltValue made = temporary(code_type::boolean);
    const auto part = [&](std::size_t index) {
        const CodeExpression& one = *expression.parts[index];
        store(made, converted(build(one), code_type::boolean, one.line));
    };
    part(0);
    const std::size_t jump =
        emit(expression.text == "&&" ? CodeOp::jump_if_not : CodeOp::jump_if, 1, made.at);
    part(1);
    land(jump);
    return made;
}

BuiltValue CodeBuilder::build_comparison(const CodeExpression& expression) {
    BuiltValue left = build(*expression.parts[0]);
    BuiltValue right = build(*expression.parts[1]);
    const CodeTypes& types = program_.types;
    if (!types.is_number(left.type) || !types.is_number(right.type))
        fail(expression.line, fmt::format("{} and {} cannot be compared with {}",
                                          at_beginning(with_article(name_of(left.type))),
                                          with_article(name_of(right.type)), expression.text));
    const CodeTypeId type = common_number(left.type, right.type);
    int a = in_slots(converted(left, type, expression.line));
    int b = in_slots(converted(right, type, expression.line));
    const std::string& sign = expression.text;
    if (sign == ">" || sign == ">=") std::swap(a, b);
    static constexpr NumberOps less{"<", CodeOp::less_i, CodeOp::less_f, CodeOp::less_d};
    static constexpr NumberOps less_equal{"<=", CodeOp::less_equal_i, CodeOp::less_equal_f,
                                          CodeOp::less_equal_d};
    static constexpr NumberOps equal{"==", CodeOp::equal_i, CodeOp::equal_f, CodeOp::equal_d};
    const NumberOps& ops = sign == "<" || sign == ">"     ? less
                           : sign == "<=" || sign == ">=" ? less_equal
                                                          : equal;
    const BuiltValue made = temporary(code_type::boolean);
    emit(op_for(ops, type), 1, made.at, a, b);
    if (sign == "!=") emit(CodeOp::invert, 1, made.at, made.at);
    return made;
}

BuiltValue CodeBuilder::build_assignment(const CodeExpression& expression) {
    const CodeExpression& right = *expression.parts[1];
    const BuiltValue target = build(*expression.parts[0]);
    if (!target.can_change)
        fail(expression.line, target.has_name ? "This is const, so nothing can be assigned to it"
                                              : "Nothing can be assigned to this");
    BuiltValue value;
    if (expression.text == "=") {
        value = value_of(right, target.type);
    } else {
        value = arithmetic(expression.text.substr(0, 1), target, build(right), expression.line);
        value = converted(value, target.type, expression.line);
    }
    store(target, value);
    return target;
}

/// ++ and --.
BuiltValue CodeBuilder::build_step(const CodeExpression& expression) {
    const BuiltValue target = build(*expression.parts[0]);
    if (!target.can_change || !program_.types.is_number(target.type))
        fail(expression.line, fmt::format("{} is for numbers that can change", expression.text));
    BuiltValue before = target;
    if (expression.kind == Kind::after) {
        const int slot = in_slots(target);
        before = temporary(target.type);
        emit(CodeOp::copy, program_.types[target.type].words, before.at, slot);
    }
    const BuiltValue one = temporary(code_type::integer);
    emit(CodeOp::set, 1, one.at, 1);
    const BuiltValue value = arithmetic(expression.text.substr(0, 1), target, one, expression.line);
    store(target, converted(value, target.type, expression.line));
    return expression.kind == Kind::after ? before : target;
}

BuiltValue CodeBuilder::build_conditional(const CodeExpression& expression) {
    const BuiltValue condition =
        converted(build(*expression.parts[0]), code_type::boolean, expression.line);
    const std::size_t to_second = emit(CodeOp::jump_if_not, 1, in_slots(condition));
    const BuiltValue first = build(*expression.parts[1]);
    if (program_.types.has_list(first.type))
        fail(expression.line, "Vectors cannot be chosen with ?:");
    const BuiltValue made = temporary(first.type);
    store(made, first);
    const std::size_t to_end = emit(CodeOp::jump);
    land(to_second);
    const BuiltValue second = build(*expression.parts[2]);
    if (second.type != first.type)
        fail(expression.line, fmt::format("Both values of ?: must have one type, not {} and {}",
                                          name_of(first.type), name_of(second.type)));
    store(made, second);
    land(to_end);
    return made;
}

BuiltValue CodeBuilder::build_index(const CodeExpression& expression) {
    const BuiltValue whole = build(*expression.parts[0]);
    const CodeType type = program_.types[whole.type];
    const bool is_list = type.kind == TypeKind::list;
    if (!is_list && type.kind != TypeKind::array && !is_vector(type) &&
        type.kind != TypeKind::matrix)
        fail(expression.line,
             fmt::format("{} has no elements", at_beginning(with_article(type.name))));
    const CodeExpression& written = *expression.parts[1];
    const int words = program_.types[type.element].words;
    const std::optional<int> constant = constant_of(written);
    if (constant && !is_list) {
        if (*constant < 0 || *constant >= type.count)
            fail(expression.line, fmt::format("[{}] is not in a {}: its elements are [0] to [{}]",
                                              *constant, type.name, type.count - 1));
        BuiltValue element = whole;
        element.type = type.element;
        (whole.where == Where::place ? element.offset : element.at) += *constant * words;
        return element;
    }
    const BuiltValue index = build(written);
    if (!program_.types.is_number(index.type) ||
        common_number(index.type, code_type::integer) != code_type::integer)
        fail(expression.line,
             fmt::format("An index is a whole number, not {}", with_article(name_of(index.type))));
    const int index_slot = in_slots(index);
    const int from = is_list ? in_slots(whole) : place_of(whole);
    const int place = reserve(2);
    emit(is_list ? CodeOp::list_element : CodeOp::element, words, place, from, index_slot,
         type.count);
    return {type.element, Where::place, place, 0, whole.has_name, whole.can_change};
}

BuiltValue CodeBuilder::build_member(const CodeExpression& expression) {
    const BuiltValue whole = build(*expression.parts[0]);
    const CodeField* const field = program_.types.field(whole.type, expression.text);
    if (field == nullptr) {
        std::vector<std::string_view> names;
        for (const CodeField& one : program_.types[whole.type].fields)
            names.push_back(one.name);
        fail(expression.line,
             fmt::format("{} has no member `{}`{}", at_beginning(with_article(name_of(whole.type))),
                         expression.text, or_meant(expression.text, names)));
    }
    BuiltValue member = whole;
    member.type = field->type;
    (whole.where == Where::place ? member.offset : member.at) += field->offset;
    return member;
}

} // namespace rasterwalk
