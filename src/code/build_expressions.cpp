#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "code/code_builder.h"
#include "code/code_host.h"

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

bool is_vector(const CodeType& type) {
    return type.kind == TypeKind::int_vector || type.kind == TypeKind::real_vector;
}

/// The type in which C++ computes with two numbers.
CodeTypeId common_number(CodeTypeId a, CodeTypeId b) {
    if (a == code_type::double_real || b == code_type::double_real) return code_type::double_real;
    if (a == code_type::real || b == code_type::real) return code_type::real;
    return code_type::integer;
}

/// The end of a sentence about a name that is not known.
std::string or_meant(const std::string& name, const std::vector<std::string_view>& names) {
    const std::string meant = did_you_mean(name, names);
    return meant.empty() ? meant : "." + meant;
}

/// How far a conversion is from none; -1: there is none.
int distance_between(const CodeTypes& types, CodeTypeId from, CodeTypeId to) {
    if (from == to) return 0;
    if (!types.is_number(from) || !types.is_number(to)) return -1;
    // Nearly as C++ chooses among its functions: sqrt(2) is one of doubles.
    if (to == code_type::double_real) return 1;
    return to == code_type::real && from != code_type::double_real ? 2 : 3;
}

} // namespace

void CodeBuilder::fail(int line, const std::string& sentence) const {
    throw InputError(syntax_.file, line, sentence + (sentence.ends_with('?') ? "" : "."));
}

std::size_t CodeBuilder::emit(CodeOp op, int n, int a, int b, int c, int d) {
    program_.instructions.push_back({op, n, a, b, c, d});
    return here() - 1;
}

/// A jump goes to what is built next.
void CodeBuilder::land(std::size_t jump) {
    program_.instructions[jump].b = static_cast<int>(here());
}

void CodeBuilder::land(const std::vector<std::size_t>& jumps) {
    for (const std::size_t jump : jumps)
        land(jump);
}

int CodeBuilder::reserve(int words) {
    const int slot = next_slot_;
    next_slot_ += words;
    if (next_slot_ > largest_frame)
        throw InputError(syntax_.file, current().line,
                         "The variables of " + current().name + " need too much room.");
    current().words = std::max(current().words, next_slot_);
    return slot;
}

BuiltValue CodeBuilder::temporary(CodeTypeId type) {
    return {type, Where::slots, reserve(program_.types[type].words), 0, false, false};
}

int CodeBuilder::in_slots(const BuiltValue& value) {
    if (value.where == Where::slots) return value.at;
    const int words = program_.types[value.type].words;
    const int slot = reserve(words);
    if (value.where == Where::global) {
        emit(CodeOp::load_global, words, slot, value.at);
    } else {
        emit(CodeOp::load, words, slot, value.at, value.offset);
    }
    return slot;
}

int CodeBuilder::place_of(const BuiltValue& value) {
    const bool is_there = value.where == Where::place && value.offset == 0;
    if (is_there) return value.at;
    const int slot = reserve(2);
    if (value.where == Where::slots) emit(CodeOp::place_of_slot, 2, slot, value.at);
    if (value.where == Where::global) emit(CodeOp::place_of_global, 2, slot, value.at);
    if (value.where == Where::place) emit(CodeOp::move_place, 2, slot, value.at, value.offset);
    return slot;
}

bool CodeBuilder::can_convert(CodeTypeId from, CodeTypeId to) const {
    return distance_between(program_.types, from, to) >= 0;
}

BuiltValue CodeBuilder::converted(const BuiltValue& value, CodeTypeId type, int line) {
    if (value.type == type) return value;
    if (!can_convert(value.type, type))
        fail(line, fmt::format("{} is not {}", at_beginning(with_article(name_of(value.type))),
                               with_article(name_of(type))));
    const int from = in_slots(value);
    const BuiltValue made = temporary(type);
    const bool from_whole = value.type == code_type::integer || value.type == code_type::boolean;
    const auto change = [&](CodeOp op) { emit(op, 1, made.at, from); };
    if (type == code_type::boolean) {
        // True is what is not 0.
        const BuiltValue zero = temporary(value.type);
        fill_zero(zero.at, program_.types[value.type].words);
        const CodeOp equal = value.type == code_type::double_real ? CodeOp::equal_d
                             : value.type == code_type::real      ? CodeOp::equal_f
                                                                  : CodeOp::equal_i;
        emit(equal, 1, made.at, from, zero.at);
        emit(CodeOp::invert, 1, made.at, made.at);
    } else if (type == code_type::integer) {
        change(from_whole                      ? CodeOp::copy
               : value.type == code_type::real ? CodeOp::real_to_int
                                               : CodeOp::double_to_int);
    } else if (type == code_type::real) {
        change(from_whole ? CodeOp::int_to_real : CodeOp::double_to_real);
    } else {
        change(from_whole ? CodeOp::int_to_double : CodeOp::real_to_double);
    }
    return made;
}

/// Both have the same type.
void CodeBuilder::store(const BuiltValue& target, const BuiltValue& value) {
    const CodeType& type = program_.types[target.type];
    if (type.kind == TypeKind::list) {
        const int place = place_of(target);
        emit(CodeOp::list_copy, program_.types[type.element].words, place, in_slots(value));
        return;
    }
    const int slot = in_slots(value);
    if (target.where == Where::slots) {
        if (target.at != slot) emit(CodeOp::copy, type.words, target.at, slot);
    } else if (target.where == Where::global) {
        emit(CodeOp::store_global, type.words, target.at, slot);
    } else {
        emit(CodeOp::store, type.words, target.at, slot, target.offset);
    }
}

void CodeBuilder::fill_zero(int slot, int words) {
    for (int i = 0; i < words; ++i)
        emit(CodeOp::set, 1, slot + i, 0);
}

const NamedVariable* CodeBuilder::find_variable(const std::string& name) const {
    // A name is looked for from inside to outside.
    for (std::size_t i = scopes_.size(); i-- > 0;) {
        const auto found = scopes_[i].variables.find(name);
        if (found != scopes_[i].variables.end()) return &found->second;
    }
    return nullptr;
}

/// The value of an expression in whole numbers that is known before the program runs.
std::optional<int> CodeBuilder::constant_of(const CodeExpression& expression) const {
    if (expression.kind == Kind::integer) {
        int value = 0;
        const char* const end = expression.text.data() + expression.text.size();
        const auto [stop, fault] = std::from_chars(expression.text.data(), end, value);
        if (fault != std::errc() || stop != end)
            fail(expression.line, "The number " + expression.text + " is too large");
        return value;
    }
    if (expression.kind == Kind::name) {
        const NamedVariable* const variable = find_variable(expression.text);
        return variable == nullptr ? std::nullopt : variable->constant;
    }
    std::vector<std::int64_t> parts;
    for (const CodeExpressionPtr& part : expression.parts) {
        const std::optional<int> value = constant_of(*part);
        if (!value) return std::nullopt;
        parts.push_back(*value);
    }
    const bool is_negation = expression.kind == Kind::unary && expression.text == "-";
    if (!is_negation && expression.kind != Kind::binary) return std::nullopt;
    const char sign = expression.text.size() == 1 ? expression.text[0] : ' ';
    std::int64_t whole = 0;
    if (is_negation) {
        whole = -parts[0];
    } else if (sign == '+') {
        whole = parts[0] + parts[1];
    } else if (sign == '-') {
        whole = parts[0] - parts[1];
    } else if (sign == '*') {
        whole = parts[0] * parts[1];
    } else if (sign == '/' && parts[1] != 0) {
        whole = parts[0] / parts[1];
    } else {
        return std::nullopt;
    }
    if (whole < std::numeric_limits<int>::min() || whole > std::numeric_limits<int>::max())
        return std::nullopt;
    return static_cast<int>(whole);
}

/// An expression as a value of this type.
BuiltValue CodeBuilder::value_of(const CodeExpression& expression, CodeTypeId type) {
    if (expression.kind == Kind::list)
        return build_construction(type, expression.parts, expression.line);
    return converted(build(expression), type, expression.line);
}

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

BuiltValue CodeBuilder::build_call(const CodeExpression& expression) {
    const CodeTypeId type = program_.types.find(expression.text);
    if (type >= 0) return build_construction(type, expression.parts, expression.line);
    const int own = program_.find_function(expression.text);
    if (own >= 0) return build_own_call(own, expression);
    std::vector<BuiltValue> arguments;
    for (const CodeExpressionPtr& part : expression.parts)
        arguments.push_back(build(*part));
    return build_host_call(expression.text, arguments, expression.line);
}

BuiltValue CodeBuilder::build_own_call(int function, const CodeExpression& expression) {
    const auto index = static_cast<std::size_t>(function);
    const CodeFunction called = program_.functions[index];
    if (called.parameters.size() != expression.parts.size())
        fail(expression.line, fmt::format("{} takes {}, not {}", called.name,
                                          called.parameters.size(), expression.parts.size()));
    std::vector<int> slots; // of the values, or of the places of references
    for (std::size_t i = 0; i < called.parameters.size(); ++i) {
        const CodeVariableInfo& parameter = called.parameters[i];
        const CodeExpression& part = *expression.parts[i];
        const bool is_const = takes_const_[index][i];
        if (!parameter.is_reference) {
            const BuiltValue value = value_of(part, parameter.type);
            if (program_.types[parameter.type].kind != TypeKind::list) {
                slots.push_back(in_slots(value));
                continue;
            }
            const BuiltValue copy = temporary(parameter.type);
            emit(CodeOp::set, 1, copy.at, 0);
            store(copy, value);
            slots.push_back(copy.at);
            continue;
        }
        BuiltValue value = is_const ? value_of(part, parameter.type) : build(part);
        if (!is_const && (!value.can_change || value.type != parameter.type))
            fail(part.line, fmt::format("{} changes its argument {}, so it must be a variable of "
                                        "type {}",
                                        called.name, i + 1, name_of(parameter.type)));
        slots.push_back(place_of(value));
    }
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const CodeVariableInfo& parameter = called.parameters[i];
        emit(CodeOp::copy, parameter.is_reference ? 2 : program_.types[parameter.type].words,
             called_frame + parameter.slot, slots[i]);
    }
    emit(CodeOp::call, 1, function, called_frame);
    const BuiltValue made = temporary(called.result);
    const int words = program_.types[called.result].words;
    if (words > 0) emit(CodeOp::copy, words, made.at, called_frame);
    return made;
}

BuiltValue CodeBuilder::build_host_call(const std::string& name,
                                        const std::vector<BuiltValue>& arguments, int line) {
    const CodeHostFunction* best = nullptr;
    int least = std::numeric_limits<int>::max();
    bool is_known = false;
    std::vector<std::string_view> names;
    for (const CodeHostFunction& one : usual_functions()) {
        names.push_back(one.name);
        if (one.name != name) continue;
        is_known = true;
        if (one.parameters.size() != arguments.size()) continue;
        int sum = 0;
        for (std::size_t i = 0; i < arguments.size() && sum >= 0; ++i) {
            const int distance =
                distance_between(program_.types, arguments[i].type, one.parameters[i]);
            sum = distance < 0 ? -1 : sum + distance;
        }
        if (sum >= 0 && sum < least) {
            least = sum;
            best = &one;
        }
    }
    if (!is_known) {
        for (const CodeFunction& one : program_.functions)
            names.push_back(one.name);
        fail(line, fmt::format("There is no function `{}`{}", name, or_meant(name, names)));
    }
    if (best == nullptr) {
        std::string types;
        for (const BuiltValue& argument : arguments)
            types += (types.empty() ? "" : ", ") + name_of(argument.type);
        fail(line, name == "*" ? fmt::format("These cannot be multiplied: {}", types)
                               : fmt::format("{} does not take ({})", name, types));
    }
    std::vector<int> slots;
    for (std::size_t i = 0; i < arguments.size(); ++i)
        slots.push_back(in_slots(converted(arguments[i], best->parameters[i], line)));
    int words = 0;
    for (const CodeTypeId parameter : best->parameters)
        words += program_.types[parameter].words;
    const int base = reserve(words);
    int at = base;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const int size = program_.types[best->parameters[i]].words;
        emit(CodeOp::copy, size, at, slots[i]);
        at += size;
    }
    auto known =
        std::find_if(program_.host.begin(), program_.host.end(), [&](const CodeHostFunction& one) {
            return one.name == best->name && one.parameters == best->parameters;
        });
    if (known == program_.host.end()) {
        program_.host.push_back(*best);
        known = program_.host.end() - 1;
    }
    const BuiltValue made = temporary(best->result);
    emit(CodeOp::call_host, 1, static_cast<int>(known - program_.host.begin()), made.at, base);
    return made;
}

/// vec3(a, b, c), int(x), {a, b}: a value of the type, made of its parts.
BuiltValue CodeBuilder::build_construction(CodeTypeId id,
                                           const std::vector<CodeExpressionPtr>& parts, int line) {
    const CodeType type = program_.types[id];
    if (program_.types.is_number(id)) {
        if (parts.size() != 1)
            fail(line,
                 fmt::format("{} is made of one value", at_beginning(with_article(type.name))));
        return value_of(*parts[0], id);
    }
    const BuiltValue made = temporary(id);
    if (type.kind == TypeKind::list) {
        const BuiltValue size = temporary(code_type::integer);
        emit(CodeOp::set, 1, size.at, 0);
        const int words = program_.types[type.element].words;
        emit(CodeOp::list_make, words, made.at, size.at);
        const int place = place_of(made);
        for (const CodeExpressionPtr& part : parts)
            emit(CodeOp::list_push, words, place, in_slots(value_of(*part, type.element)));
        return made;
    }
    if (type.kind == TypeKind::structure) {
        if (parts.size() > type.fields.size())
            fail(line, fmt::format("{} has {}", at_beginning(with_article(type.name)),
                                   counted(static_cast<std::int64_t>(type.fields.size()), "member",
                                           "members")));
        fill_zero(made.at, type.words);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            BuiltValue member = made;
            member.type = type.fields[i].type;
            member.at += type.fields[i].offset;
            store(member, value_of(*parts[i], member.type));
        }
        return made;
    }
    if (type.kind == TypeKind::array) {
        if (parts.size() > static_cast<std::size_t>(type.count))
            fail(line, fmt::format("{} has no room for {} values",
                                   at_beginning(with_article(type.name)), parts.size()));
        fill_zero(made.at, type.words);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            BuiltValue member = made;
            member.type = type.element;
            member.at += static_cast<int>(i) * program_.types[type.element].words;
            store(member, value_of(*parts[i], member.type));
        }
        return made;
    }
    // Vectors and matrices: all components of all parts, one after the other.
    if (!is_vector(type) && type.kind != TypeKind::matrix)
        fail(line,
             fmt::format("{} cannot be made like this", at_beginning(with_article(type.name))));
    const CodeTypeId number =
        type.kind == TypeKind::int_vector ? code_type::integer : code_type::real;
    std::vector<int> components; // slots
    for (const CodeExpressionPtr& part : parts) {
        const BuiltValue value = build(*part);
        const CodeType& from = program_.types[value.type];
        if (program_.types.is_number(value.type)) {
            components.push_back(in_slots(converted(value, number, line)));
            continue;
        }
        if (!is_vector(from))
            fail(line, fmt::format("{} is not made of {}", at_beginning(with_article(type.name)),
                                   with_article(from.name)));
        const CodeTypeId element = from.element;
        const int count = from.count, slot = in_slots(value);
        for (int i = 0; i < count; ++i)
            components.push_back(in_slots(
                converted({element, Where::slots, slot + i, 0, false, false}, number, line)));
    }
    const bool is_matrix = type.kind == TypeKind::matrix;
    if (components.size() == 1) {
        if (!is_matrix) {
            emit(CodeOp::spread, type.words, made.at, components[0]);
            return made;
        }
        fill_zero(made.at, type.words);
        for (int i = 0; i < type.count; ++i)
            emit(CodeOp::copy, 1, made.at + i * (type.count + 1), components[0]);
        return made;
    }
    const bool is_cut = parts.size() == 1 && !is_matrix &&
                        components.size() >= static_cast<std::size_t>(type.words);
    if (parts.empty()) {
        fill_zero(made.at, type.words);
        return made;
    }
    if (!is_cut && components.size() != static_cast<std::size_t>(type.words))
        fail(line, fmt::format("{} has {} numbers, not {}", at_beginning(with_article(type.name)),
                               type.words, components.size()));
    for (int i = 0; i < type.words; ++i)
        emit(CodeOp::copy, 1, made.at + i, components[static_cast<std::size_t>(i)]);
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

BuiltValue CodeBuilder::build_method(const CodeExpression& expression) {
    const BuiltValue list = build(*expression.parts[0]);
    const CodeType type = program_.types[list.type];
    const std::string& name = expression.text;
    const std::size_t arguments = expression.parts.size() - 1;
    if (type.kind != TypeKind::list)
        fail(expression.line,
             fmt::format("{} has no function `{}`", at_beginning(with_article(type.name)), name));
    const int words = program_.types[type.element].words;
    const auto takes = [&](std::string_view called, std::size_t count) {
        return name == called && arguments == count;
    };
    const auto integer = [&](int value) {
        const BuiltValue made = temporary(code_type::integer);
        emit(CodeOp::set, 1, made.at, value);
        return made.at;
    };
    if (takes("size", 0) || takes("empty", 0)) {
        const BuiltValue size = temporary(code_type::integer);
        emit(CodeOp::list_size, words, size.at, in_slots(list));
        if (name == "size") return size;
        const BuiltValue made = temporary(code_type::boolean);
        emit(CodeOp::equal_i, 1, made.at, size.at, integer(0));
        return made;
    }
    if (takes("front", 0) || takes("back", 0)) {
        const int from = in_slots(list);
        int index = integer(0);
        if (name == "back") {
            const int size = reserve(1);
            emit(CodeOp::list_size, words, size, from);
            const int one = integer(1);
            emit(CodeOp::sub_i, 1, index, size, one);
        }
        const int place = reserve(2);
        emit(CodeOp::list_element, words, place, from, index);
        return {type.element, Where::place, place, 0, list.has_name, list.can_change};
    }
    const bool changes = takes("resize", 1) || takes("push_back", 1) || takes("clear", 0);
    if (!changes)
        fail(expression.line, fmt::format("`{}` of a vector is not understood here", name));
    if (!list.can_change) fail(expression.line, "This vector is const");
    if (name == "push_back") {
        const int value = in_slots(value_of(*expression.parts[1], type.element));
        emit(CodeOp::list_push, words, place_of(list), value);
    } else {
        const int size = name == "clear"
                             ? integer(0)
                             : in_slots(value_of(*expression.parts[1], code_type::integer));
        emit(CodeOp::list_resize, words, place_of(list), size);
    }
    return {};
}

} // namespace rasterwalk
