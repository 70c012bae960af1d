#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "code/code_builder.h"
#include "code/code_host.h"

namespace rasterwalk {

namespace {

using Kind = CodeExpression::Kind;
using TypeKind = CodeType::Kind;
using StatementKind = CodeStatement::Kind;
using Where = BuiltValue::Where;

/// Global variables may take so many words: room for a few buffers of the largest picture.
constexpr std::int64_t most_global_words = 64'000'000;

/// What a condition of a line may not do: it would change the program that is walked.
void refuse_changes(const CodeExpression& expression, const CodeProgram& program,
                    const std::string& file) {
    const auto refuse = [&](const std::string& sentence) {
        throw InputError(file, expression.line, sentence);
    };
    const bool changes = expression.kind == Kind::assign || expression.kind == Kind::before ||
                         expression.kind == Kind::after;
    if (changes && expression.text == "=")
        refuse("A condition changes nothing: use == to compare.");
    if (changes) refuse("A condition changes nothing.");
    if (expression.kind == Kind::method && expression.text != "size" && expression.text != "empty")
        refuse("A condition changes nothing: of a vector, it may ask for size() and empty().");
    if (expression.kind == Kind::call && program.find_function(expression.text) >= 0)
        refuse("A condition calls no function of the program.");
    for (const CodeExpressionPtr& part : expression.parts)
        refuse_changes(*part, program, file);
}

/// Takes the first word off a text.
std::string next_word(std::string_view& rest) {
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    const std::string_view word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(word.size());
    return std::string(word);
}

/// Takes the first word off, if it is this one.
bool take_word(std::string_view& rest, std::string_view word) {
    std::string_view after = rest;
    if (next_word(after) != word) return false;
    rest = after;
    return true;
}

bool is_comparison(const CodeExpression& expression) {
    static constexpr std::string_view signs[]{"<", "<=", ">", ">=", "==", "!="};
    return expression.kind == Kind::binary &&
           std::find(std::begin(signs), std::end(signs), expression.text) != std::end(signs);
}

} // namespace

CodeBuilder::CodeBuilder(const CodeSyntax& syntax, const std::vector<CodeStop>& stops)
    : syntax_(syntax), stops_(stops) {
    program_.file = syntax.file;
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
        std::vector<bool> are_references, are_const;
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

/// The machine stops before a line whose condition holds. Of a line that begins in several places,
/// as that of a `for` does, the condition counts where its names are known.
void CodeBuilder::build_stops(int line) {
    for (std::size_t i = 0; i < stops_.size(); ++i) {
        if (stops_[i].line != line) continue;
        const int before = next_slot_;
        const std::size_t first = here();
        try {
            const CodeExpressionPtr written =
                parse_code_expression(stops_[i].condition, syntax_.file);
            refuse_changes(*written, program_, syntax_.file);
            emit(CodeOp::stop_if, 1,
                 in_slots(converted(build(*written), code_type::boolean, line)));
            stop_faults_[i].clear();
        } catch (const InputError& error) {
            program_.instructions.resize(first);
            if (!stop_faults_[i].empty()) stop_faults_[i] = error.what();
        }
        next_slot_ = before;
    }
}

/// A condition must count somewhere.
void CodeBuilder::check_stops() const {
    for (const std::string& fault : stop_faults_) {
        if (!fault.empty()) throw InputError(fault);
    }
}

/// What is written after `//@` in a line: a word and a value, which the mark has from the moment
/// on at which the line begins. With `each` before them, the line is the first of a loop whose
/// rounds do not depend on each other, so that rounds can be skipped.
void CodeBuilder::build_marks(int line) {
    for (const CodeMark& mark : syntax_.marks) {
        if (mark.line != line) continue;
        std::string_view rest = mark.text;
        const bool is_each = take_word(rest, "each");
        const std::string word = next_word(rest);
        if (word.empty() || rest.empty()) fail(line, "A mark is a word and a value");
        const int before = next_slot_;
        const CodeExpressionPtr written = parse_code_expression(rest, syntax_.file);
        const BuiltValue value = converted(build(*written), code_type::integer, line);
        auto known = std::find(program_.marks.begin(), program_.marks.end(), word);
        if (known == program_.marks.end()) {
            program_.marks.push_back(word);
            known = program_.marks.end() - 1;
        }
        const int index = static_cast<int>(known - program_.marks.begin());
        emit(CodeOp::mark, 1, index, in_slots(value));
        next_slot_ = before;
        if (!is_each) continue;
        if (loops_.empty()) fail(line, "Only iterations of a loop can be marked with `each`");
        loops_.back().go_on.push_back(emit(CodeOp::skip, 1, index));
    }
}

/// Keeps what a statement has computed, so that it can be shown at the line's end after the
/// variable has changed again.
void CodeBuilder::note_value(int line, const BuiltValue& value) {
    const CodeType& type = program_.types[value.type];
    const bool can_be_shown = type.kind != TypeKind::list && type.kind != TypeKind::array &&
                              type.kind != TypeKind::nothing;
    if (is_global_ || !can_be_shown) return;
    CodeNote note;
    note.type = value.type;
    const int words = program_.types[value.type].words;
    const int from = in_slots(value);
    note.set = reserve_for_note(1 + words);
    note.slot = note.set - 1;
    emit(CodeOp::note, words, note.set, from);
    auto noted = std::find_if(program_.lines.rbegin(), program_.lines.rend(),
                              [&](const CodeLine& one) { return one.line == line; });
    noted->note = static_cast<int>(current().notes.size());
    current().notes.push_back(std::move(note));
}

/// A condition, noted with what it compares; returns the slot that holds whether it held.
int CodeBuilder::build_condition(const CodeExpression& expression) {
    CodeNote note;
    note.kind = is_comparison(expression) ? CodeNote::Kind::compare : CodeNote::Kind::decision;
    note.set = reserve_for_note(2);
    note.slot = note.set - 1;
    int held = 0;
    if (note.kind == CodeNote::Kind::compare) {
        // The comparison leaves both values, in one type, where its instruction finds them.
        held = in_slots(build(expression));
        std::size_t at = here() - 1;
        if (program_.instructions[at].op == CodeOp::invert) --at;
        const CodeInstruction compared = program_.instructions[at];
        note.sign = expression.text;
        const bool is_swapped = note.sign == ">" || note.sign == ">=";
        const bool is_double = compared.op == CodeOp::less_d ||
                               compared.op == CodeOp::less_equal_d ||
                               compared.op == CodeOp::equal_d;
        const bool is_int = compared.op == CodeOp::less_i || compared.op == CodeOp::less_equal_i ||
                            compared.op == CodeOp::equal_i;
        note.compared = is_double ? code_type::double_real
                        : is_int  ? code_type::integer
                                  : code_type::real;
        const int words = is_double ? 2 : 1;
        note.left = reserve_for_note(words);
        note.right = reserve_for_note(words);
        emit(CodeOp::copy, words, note.left, is_swapped ? compared.c : compared.b);
        emit(CodeOp::copy, words, note.right, is_swapped ? compared.b : compared.c);
    } else {
        held = in_slots(converted(build(expression), code_type::boolean, expression.line));
    }
    emit(CodeOp::note, 1, note.set, held);
    program_.lines.back().note = static_cast<int>(current().notes.size());
    current().notes.push_back(std::move(note));
    return held;
}

/// Notes lie after everything else in a frame, whose size is not known yet: until then, their slots
/// count down from -1.
int CodeBuilder::reserve_for_note(int words) {
    const int slot = -1 - note_words_;
    note_words_ += words;
    return slot;
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
