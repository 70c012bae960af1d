// Types, functions and variables that a program declares.

#include <utility>

#include <fmt/format.h>

#include "code/code_builder.h"

namespace rasterwalk {

namespace {

using TypeKind = CodeType::Kind;
using Where = BuiltValue::Where;

/// Global variables may take so many words: room for a few buffers of the largest picture.
constexpr std::int64_t most_global_words = 64'000'000;

} // namespace

CodeTypeId CodeBuilder::type_of(const WrittenType& written) {
    const std::string& name = written.element.empty() ? written.name : written.element;
    const CodeTypeId type = program_.types.find(name);
    if (type < 0) fail(written.line, fmt::format("There is no type `{}`", name));
    if (written.element.empty()) {
        if (name != written.name || name == "vector")
            fail(written.line, "A vector needs the type of its elements");
        return type;
    }
    if (written.name != "vector")
        fail(written.line, fmt::format("`{}<...>` is not understood here", written.name));
    if (program_.types.has_list(type) || type == code_type::nothing)
        fail(written.line, fmt::format("A vector of {} is not understood here", name));
    return program_.types.list_of(type);
}

void CodeBuilder::build_structures() {
    for (const WrittenStruct& written : syntax_.structs) {
        std::vector<CodeField> fields;
        for (const WrittenField& field : written.fields) {
            const CodeTypeId type = type_of(field.type);
            if (program_.types.has_list(type) || field.type.is_reference ||
                type == code_type::nothing)
                fail(field.type.line, "Only numbers, vectors of GLM and structs of them are "
                                      "understood as members");
            fields.push_back({field.name, type, 0});
        }
        if (program_.types.find(written.name) >= 0)
            fail(written.line, fmt::format("There is a type `{}` already", written.name));
        if (fields.empty())
            fail(written.line, fmt::format("A struct needs members: {} has none", written.name));
        std::int64_t words = 0;
        for (const CodeField& field : fields)
            words += program_.types[field.type].words;
        if (words > largest_frame)
            fail(written.line, fmt::format("The members of {} need too much room", written.name));
        program_.types.add_structure(written.name, std::move(fields));
    }
}

void CodeBuilder::build_signatures() {
    for (const WrittenFunction& written : syntax_.functions) {
        CodeFunction made;
        made.name = written.name;
        made.line = written.line;
        made.result = type_of(written.result);
        made.is_defined = written.body != nullptr;
        if (written.result.is_reference)
            fail(written.line, "Functions that return a reference are not understood here");
        int slot = program_.types[made.result].words;
        std::vector<bool> are_const;
        for (const WrittenField& field : written.parameters) {
            CodeVariableInfo parameter;
            parameter.name = field.name;
            parameter.type = type_of(field.type);
            parameter.is_reference = field.type.is_reference;
            parameter.slot = slot;
            if (parameter.type == code_type::nothing) fail(written.line, "A parameter is not void");
            slot += parameter.is_reference ? 2 : program_.types[parameter.type].words;
            if (slot > largest_frame)
                fail(written.line,
                     fmt::format("The parameters of {} need too much room", written.name));
            are_const.push_back(field.type.is_const);
            made.parameters.push_back(std::move(parameter));
        }
        made.words = slot;
        const int known = program_.find_function(written.name);
        if (known < 0) {
            program_.functions.push_back(std::move(made));
            takes_const_.push_back(std::move(are_const));
            continue;
        }
        CodeFunction& other = program_.functions[static_cast<std::size_t>(known)];
        if (other.is_defined && made.is_defined)
            fail(written.line, fmt::format("There is a function {} already", written.name));
        if (made.is_defined) {
            other = std::move(made);
            takes_const_[static_cast<std::size_t>(known)] = std::move(are_const);
        }
    }
    // The values of globals are made by a function too.
    program_.start = static_cast<int>(program_.functions.size());
    CodeFunction start;
    start.name = "the global variables";
    start.is_defined = true;
    program_.functions.push_back(std::move(start));
    takes_const_.emplace_back();
}

CodeTypeId CodeBuilder::type_with_sizes(CodeTypeId type, const CodeVariable& variable) {
    for (std::size_t i = variable.sizes.size(); i > 0; --i) {
        const std::optional<int> size = constant_of(*variable.sizes[i - 1]);
        if (!size || *size < 1)
            fail(variable.line,
                 fmt::format("The size of `{}` must be known and above 0", variable.name));
        const std::int64_t words = std::int64_t{program_.types[type].words} * *size;
        if (words > most_global_words)
            fail(variable.line, fmt::format("`{}` needs too much room", variable.name));
        type = program_.types.array_of(type, *size);
    }
    return type;
}

void CodeBuilder::build_declaration(const CodeStatement& statement) {
    for (const CodeVariable& variable : statement.variables)
        build_variable(statement, variable);
}

/// What a variable begins with.
BuiltValue CodeBuilder::variable_value(CodeTypeId id, const CodeVariable& variable) {
    const CodeType type = program_.types[id];
    if (variable.value != nullptr) return value_of(*variable.value, id);
    if (type.kind != TypeKind::list && !variable.arguments.empty())
        return build_construction(id, variable.arguments, variable.line);
    const BuiltValue made = temporary(id);
    if (type.kind != TypeKind::list) {
        fill_zero(made.at, type.words);
        return made;
    }
    // vector<Pixel> line(count) and line(count, value)
    if (variable.arguments.size() > 2)
        fail(variable.line, "A vector is made with a size and a value");
    const int words = program_.types[type.element].words;
    const BuiltValue size = temporary(code_type::integer);
    emit(CodeOp::set, 1, size.at, 0);
    if (variable.arguments.size() == 1)
        store(size, value_of(*variable.arguments[0], code_type::integer));
    emit(CodeOp::list_make, words, made.at, size.at);
    if (variable.arguments.size() < 2) return made;
    const int count = in_slots(value_of(*variable.arguments[0], code_type::integer));
    const int value = in_slots(value_of(*variable.arguments[1], type.element));
    const int place = place_of(made);
    const int index = reserve(1), one = reserve(1), is_less = reserve(1);
    emit(CodeOp::set, 1, index, 0);
    emit(CodeOp::set, 1, one, 1);
    const std::size_t begin = here();
    emit(CodeOp::less_i, 1, is_less, index, count);
    const std::size_t to_end = emit(CodeOp::jump_if_not, 1, is_less);
    emit(CodeOp::list_push, words, place, value);
    emit(CodeOp::add_i, 1, index, index, one);
    emit(CodeOp::jump, 1, 0, static_cast<int>(begin));
    land(to_end);
    return made;
}

void CodeBuilder::build_reference(CodeTypeId type, bool is_const, const CodeVariable& variable) {
    if (variable.value == nullptr) fail(variable.line, "A reference refers to something");
    const BuiltValue value = build(*variable.value);
    if (value.type != type || (!is_const && !value.can_change))
        fail(variable.line,
             fmt::format("`{}` must refer to a variable of type {}", variable.name, name_of(type)));
    const int place = place_of(value);
    declare(variable.name, {{type, Where::place, place, 0, true, !is_const}, {}}, variable.line);
}

void CodeBuilder::build_variable(const CodeStatement& statement, const CodeVariable& variable) {
    const CodeTypeId written = type_of(statement.type);
    if (written == code_type::nothing) fail(variable.line, "A variable is not void");
    const CodeTypeId type = type_with_sizes(written, variable);
    const bool is_const = statement.type.is_const;
    if (statement.type.is_reference) return build_reference(type, is_const, variable);
    // The value is made before the name is known, and after the room is reserved: what the value
    // needs is given back.
    const int slot = reserve(program_.types[type].words);
    BuiltValue value{type, Where::slots, slot, 0, true, !is_const};
    const int top = next_slot_;
    const bool is_list = program_.types[type].kind == TypeKind::list;
    const BuiltValue begin = variable_value(type, variable);
    if (is_list && !begin.has_name) {
        emit(CodeOp::copy, 1, slot, begin.at); // it becomes the variable's own
    } else {
        if (is_list) emit(CodeOp::set, 1, slot, 0);
        store(value, begin);
    }
    next_slot_ = top;
    NamedVariable named{value, {}};
    if (is_const && type == code_type::integer && variable.value != nullptr)
        named.constant = constant_of(*variable.value);
    declare(variable.name, named, variable.line);
    if (is_list) scopes_.back().lists.push_back(slot);
    const bool has_value = variable.value != nullptr || !variable.arguments.empty();
    if (has_value) note_value(statement.line, value);
}

void CodeBuilder::build_globals() {
    function_ = program_.start;
    is_global_ = true;
    current().first = static_cast<int>(here());
    for (const CodeStatementPtr& statement : syntax_.globals)
        for (const CodeVariable& variable : statement->variables)
            build_global(*statement, variable);
    emit(CodeOp::back);
    finish_frame();
    is_global_ = false;
}

void CodeBuilder::build_global(const CodeStatement& statement, const CodeVariable& variable) {
    const CodeTypeId written = type_of(statement.type);
    if (written == code_type::nothing || statement.type.is_reference)
        fail(variable.line, "A global variable is a value");
    const CodeTypeId type = type_with_sizes(written, variable);
    const int words = program_.types[type].words;
    if (std::int64_t{program_.global_words} + words > most_global_words)
        fail(variable.line, "The global variables need too much room");
    program_.globals.push_back({variable.name, type, program_.global_words});
    program_.global_words += words;
    NamedVariable named{
        {type, Where::global, program_.globals.back().offset, 0, true, !statement.type.is_const},
        {}};
    next_slot_ = 0;
    const bool has_value = variable.value != nullptr || !variable.arguments.empty();
    if (has_value) {
        program_.lines.push_back({variable.line, function_, -1});
        emit(CodeOp::line, 1, 0, variable.line);
        store(named.value, variable_value(type, variable));
    }
    if (statement.type.is_const && type == code_type::integer && variable.value != nullptr)
        named.constant = constant_of(*variable.value);
    declare(variable.name, named, variable.line);
}

} // namespace rasterwalk
