// Where values are, and how they become values of other types.

#include <algorithm>
#include <charconv>
#include <limits>

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "code/code_builder.h"

namespace rasterwalk {

namespace {

using Kind = CodeExpression::Kind;
using TypeKind = CodeType::Kind;
using Where = BuiltValue::Where;

} // namespace

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

} // namespace rasterwalk
