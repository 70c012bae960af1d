// Calls: of functions, of types that make a value, and of what vectors can be asked.

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "base/numbers.h"
#include "code/code_builder.h"
#include "code/code_host.h"

namespace rasterwalk {

namespace {

using TypeKind = CodeType::Kind;
using Where = BuiltValue::Where;

} // namespace

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
