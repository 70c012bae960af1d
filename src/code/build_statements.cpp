#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "code/code_builder.h"

namespace rasterwalk {

namespace {

using Kind = CodeExpression::Kind;
using TypeKind = CodeType::Kind;
using StatementKind = CodeStatement::Kind;
using Where = BuiltValue::Where;

} // namespace

CodeBuilder::CodeBuilder(const CodeSyntax& syntax, const std::vector<CodeStop>& stops)
    : syntax_(syntax), stops_(stops) {
    for (const CodeStop& stop : stops)
        stop_faults_.push_back(
            fmt::format("{}:{}: No statement begins in this line.", syntax.file, stop.line));
}

CodeProgram CodeBuilder::build() {
    scopes_.emplace_back();
    build_structures();
    build_signatures();
    build_globals();
    for (const WrittenFunction& written : syntax_.functions)
        if (written.body != nullptr) build_function(written);
    check_stops();
    return std::move(program_);
}

void CodeBuilder::begin_scope() {
    scopes_.emplace_back();
    scopes_.back().first_info = current().variables.size();
}

void CodeBuilder::free_lists(std::size_t down_to) {
    for (std::size_t i = scopes_.size(); i > down_to; --i)
        for (const int slot : scopes_[i - 1].lists)
            emit(CodeOp::list_free, 1, slot);
}

void CodeBuilder::end_scope() {
    free_lists(scopes_.size() - 1);
    for (std::size_t i = scopes_.back().first_info; i < current().variables.size(); ++i)
        if (current().variables[i].last < 0) current().variables[i].last = static_cast<int>(here());
    scopes_.pop_back();
}

void CodeBuilder::declare(const std::string& name, const NamedVariable& variable, int line) {
    BuiltScope& scope = scopes_.back();
    if (scope.variables.contains(name))
        fail(line, fmt::format("There is a variable `{}` here already", name));
    if (!is_global_) {
        const BuiltValue& value = variable.value;
        current().variables.push_back({name, value.type, value.at, value.where == Where::place,
                                       static_cast<int>(here()), -1});
    }
    scope.variables.emplace(name, variable);
}

void CodeBuilder::begin_line(int line) {
    build_marks(line);
    program_.lines.push_back({line, function_, -1});
    build_stops(line);
    emit(CodeOp::line, 1, 0, line);
}

/// Now that the size of a frame is known: gives the notes of the function their slots, and the
/// frames of the functions that it calls their beginning.
void CodeBuilder::finish_frame() {
    CodeFunction& made = current();
    const int notes = made.words;
    made.words += note_words_;
    note_words_ = 0;
    const auto place = [&](int& slot) {
        if (slot < 0) slot = notes - 1 - slot;
        if (slot >= called_frame) slot += made.words - called_frame;
    };
    for (CodeNote& note : made.notes)
        for (int* const slot : {&note.set, &note.slot, &note.left, &note.right})
            place(*slot);
    for (std::size_t i = static_cast<std::size_t>(made.first); i < here(); ++i) {
        CodeInstruction& in = program_.instructions[i];
        if (in.op == CodeOp::copy || in.op == CodeOp::note) place(in.a);
        if (in.op == CodeOp::copy || in.op == CodeOp::call) place(in.b);
    }
}

/// What a statement needs beyond its variables is given back.
void CodeBuilder::build_statement(const CodeStatement& statement) {
    const int before = next_slot_;
    build_one(statement);
    if (statement.kind != StatementKind::declare) next_slot_ = before;
}

void CodeBuilder::build_one(const CodeStatement& statement) {
    switch (statement.kind) {
    case StatementKind::nothing:
        return;
    case StatementKind::block:
        return build_block(statement);
    case StatementKind::declare:
        begin_line(statement.line);
        return build_declaration(statement);
    case StatementKind::express: {
        begin_line(statement.line);
        const BuiltValue value = build(*statement.value);
        const bool changes = statement.value->kind == Kind::assign ||
                             statement.value->kind == Kind::before ||
                             statement.value->kind == Kind::after;
        if (changes)
            note_value(statement.line, statement.value->kind == Kind::after
                                           ? build(*statement.value->parts[0])
                                           : value);
        return;
    }
    case StatementKind::choose:
        return build_choice(statement);
    case StatementKind::repeat:
        return build_while(statement);
    case StatementKind::count:
        return build_for(statement);
    case StatementKind::for_each:
        return build_for_each(statement);
    case StatementKind::give_back:
        begin_line(statement.line);
        return build_return(statement);
    case StatementKind::leave:
    case StatementKind::go_on:
        begin_line(statement.line);
        return build_jump(statement);
    }
}

void CodeBuilder::build_block(const CodeStatement& block) {
    begin_scope();
    for (const CodeStatementPtr& inner : block.inner)
        build_statement(*inner);
    end_scope();
}

void CodeBuilder::build_function(const WrittenFunction& written) {
    function_ = program_.find_function(written.name);
    CodeFunction& made = current();
    made.first = static_cast<int>(here());
    next_slot_ = made.words;
    begin_scope();
    for (std::size_t i = 0; i < made.parameters.size(); ++i) {
        const CodeVariableInfo parameter = made.parameters[i];
        if (parameter.name.empty()) continue;
        const bool is_const = takes_const_[static_cast<std::size_t>(function_)][i];
        const Where where = parameter.is_reference ? Where::place : Where::slots;
        declare(parameter.name, {{parameter.type, where, parameter.slot, 0, true, !is_const}, {}},
                written.line);
        if (!parameter.is_reference && program_.types[parameter.type].kind == TypeKind::list)
            scopes_.back().lists.push_back(parameter.slot);
    }
    begin_scope();
    for (const CodeStatementPtr& inner : written.body->inner)
        build_statement(*inner);
    // The end of the function is a line too: there, its results can be read.
    begin_line(written.body->end_line);
    end_scope();
    end_scope();
    emit(CodeOp::back);
    finish_frame();
}

void CodeBuilder::build_choice(const CodeStatement& statement) {
    begin_line(statement.line);
    const std::size_t to_else = emit(CodeOp::jump_if_not, 1, build_condition(*statement.value));
    build_statement(*statement.inner[0]);
    if (statement.inner.size() < 2) return land(to_else);
    const std::size_t to_end = emit(CodeOp::jump);
    land(to_else);
    build_statement(*statement.inner[1]);
    land(to_end);
}

void CodeBuilder::end_loop(const BuiltLoop& loop, std::size_t go_on_target) {
    land(loop.leave);
    for (const std::size_t jump : loop.go_on)
        program_.instructions[jump].b = static_cast<int>(go_on_target);
}

void CodeBuilder::build_while(const CodeStatement& statement) {
    const std::size_t begin = here();
    begin_line(statement.line);
    const std::size_t to_end = emit(CodeOp::jump_if_not, 1, build_condition(*statement.value));
    loops_.push_back({scopes_.size(), {}, {}});
    build_statement(*statement.inner[0]);
    emit(CodeOp::jump, 1, 0, static_cast<int>(begin));
    land(to_end);
    end_loop(loops_.back(), begin);
    loops_.pop_back();
}

void CodeBuilder::build_for(const CodeStatement& statement) {
    begin_scope();
    const CodeStatement& before = *statement.inner[0];
    build_statement(before);
    const std::size_t begin = here();
    // The first time, the line has begun with what stands before the condition.
    std::size_t to_end = 0;
    if (statement.value != nullptr) {
        if (before.kind == StatementKind::nothing) begin_line(statement.line);
        to_end = emit(CodeOp::jump_if_not, 1, build_condition(*statement.value));
    }
    loops_.push_back({scopes_.size(), {}, {}});
    build_statement(*statement.inner[1]);
    const std::size_t next = here();
    begin_line(statement.line);
    if (statement.next != nullptr) build(*statement.next);
    emit(CodeOp::jump, 1, 0, static_cast<int>(begin));
    if (statement.value != nullptr) land(to_end);
    end_loop(loops_.back(), next);
    loops_.pop_back();
    end_scope();
}

void CodeBuilder::build_for_each(const CodeStatement& statement) {
    begin_scope();
    begin_line(statement.line);
    const BuiltValue list = build(*statement.value);
    const CodeType type = program_.types[list.type];
    if (type.kind != TypeKind::list)
        fail(statement.line, fmt::format("There is no loop over {}", with_article(type.name)));
    const int words = program_.types[type.element].words;
    const int from = in_slots(list);
    const int index = reserve(1), one = reserve(1), size = reserve(1), is_less = reserve(1);
    emit(CodeOp::set, 1, index, 0);
    emit(CodeOp::set, 1, one, 1);
    const std::size_t begin = here();
    emit(CodeOp::list_size, words, size, from);
    emit(CodeOp::less_i, 1, is_less, index, size);
    const std::size_t to_end = emit(CodeOp::jump_if_not, 1, is_less);
    begin_scope();
    const int place = reserve(2);
    emit(CodeOp::list_element, words, place, from, index);
    const CodeTypeId element = type_of(statement.type);
    if (element != type.element)
        fail(statement.line, fmt::format("The elements are of type {}", name_of(type.element)));
    BuiltValue value{element, Where::place, place,
                     0,       true,         !statement.type.is_const && list.can_change};
    if (!statement.type.is_reference) {
        const BuiltValue copy = temporary(element);
        store(copy, value);
        value = {element, Where::slots, copy.at, 0, true, !statement.type.is_const};
    }
    declare(statement.variables[0].name, {value, {}}, statement.line);
    loops_.push_back({scopes_.size() - 1, {}, {}});
    build_statement(*statement.inner[0]);
    end_scope();
    const std::size_t next = here();
    begin_line(statement.line);
    emit(CodeOp::add_i, 1, index, index, one);
    emit(CodeOp::jump, 1, 0, static_cast<int>(begin));
    land(to_end);
    end_loop(loops_.back(), next);
    loops_.pop_back();
    end_scope();
}

void CodeBuilder::build_return(const CodeStatement& statement) {
    const CodeTypeId type = current().result;
    if ((statement.value == nullptr) != (type == code_type::nothing))
        fail(statement.line,
             type == code_type::nothing
                 ? fmt::format("{} returns nothing", current().name)
                 : fmt::format("{} returns {}", current().name, with_article(name_of(type))));
    if (statement.value != nullptr) {
        const BuiltValue value = value_of(*statement.value, type);
        const BuiltValue result{type, Where::slots, 0, 0, false, true};
        if (program_.types[type].kind == TypeKind::list) emit(CodeOp::set, 1, 0, 0);
        store(result, value);
        note_value(statement.line, result);
    }
    free_lists(1);
    emit(CodeOp::back);
}

void CodeBuilder::build_jump(const CodeStatement& statement) {
    const bool leaves = statement.kind == StatementKind::leave;
    if (loops_.empty())
        fail(statement.line, fmt::format("`{}` is for loops", leaves ? "break" : "continue"));
    BuiltLoop& loop = loops_.back();
    free_lists(loop.scopes);
    (leaves ? loop.leave : loop.go_on).push_back(emit(CodeOp::jump));
}

int CodeProgram::find_function(std::string_view name) const {
    const auto found = std::find_if(functions.begin(), functions.end(),
                                    [&](const CodeFunction& one) { return one.name == name; });
    return found == functions.end() ? -1 : static_cast<int>(found - functions.begin());
}

const CodeGlobal* CodeProgram::find_global(std::string_view name) const {
    const auto found = std::find_if(globals.begin(), globals.end(),
                                    [&](const CodeGlobal& one) { return one.name == name; });
    return found == globals.end() ? nullptr : &*found;
}

CodeProgram compile_code(std::string_view source, const std::string& file,
                         const std::vector<CodeStop>& stops) {
    const CodeSyntax syntax = parse_code(source, file);
    return CodeBuilder(syntax, stops).build();
}

} // namespace rasterwalk
