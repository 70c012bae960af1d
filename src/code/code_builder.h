#pragma once

// Makes instructions of the syntax of a program: the state that its parts share, the files
// build_*.cpp.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "code/code_program.h"
#include "code/code_syntax.h"

namespace rasterwalk {

/// Where the value of an expression is.
struct BuiltValue {
    enum class Where : std::uint8_t {
        slots,  ///< in the frame, from slot `at`
        global, ///< from global word `at`
        place,  ///< in memory, `offset` words on from the place in slot `at`
    };
    CodeTypeId type = code_type::nothing;
    Where where = Where::slots;
    int at = 0, offset = 0;
    bool has_name = false;   ///< a variable or a part of one: it has a place
    bool can_change = false; ///< and is not const
};

/// A variable that can be named.
struct NamedVariable {
    BuiltValue value;
    std::optional<int> constant; ///< of a const int
};

/// The variables between two braces.
struct BuiltScope {
    std::map<std::string, NamedVariable, std::less<>> variables;
    std::vector<int> lists;     ///< slots of the lists that end with it
    std::size_t first_info = 0; ///< of the function's variables
};

/// The jumps out of a loop, whose targets are known when it has been built.
struct BuiltLoop {
    std::size_t scopes = 0; ///< how many there are around it
    std::vector<std::size_t> leave, go_on;
};

/// Slots from here on are, until the size of a frame is known, those of the frame of a function
/// that is called. Slots below 0 are those of notes, counted down.
inline constexpr int called_frame = 1 << 20;

/// The end of a sentence about a name that is not known: what may be meant.
std::string or_meant(const std::string& name, const std::vector<std::string_view>& names);

/// How far a conversion is from none; -1: there is none.
int distance_between(const CodeTypes& types, CodeTypeId from, CodeTypeId to);

class CodeBuilder {
  public:
    CodeBuilder(const CodeSyntax& syntax, const std::vector<CodeStop>& stops);

    CodeProgram build();

  private:
    // build_declarations.cpp
    void build_structures();
    void build_signatures();
    CodeTypeId type_with_sizes(CodeTypeId type, const CodeVariable& variable);
    void build_declaration(const CodeStatement& statement);
    BuiltValue variable_value(CodeTypeId id, const CodeVariable& variable);
    void build_reference(CodeTypeId type, bool is_const, const CodeVariable& variable);
    void build_variable(const CodeStatement& statement, const CodeVariable& variable);
    void build_globals();
    void build_global(const CodeStatement& statement, const CodeVariable& variable);

    // build_statements.cpp
    void build_function(const WrittenFunction& written);
    void build_statement(const CodeStatement& statement);
    void build_one(const CodeStatement& statement);
    void build_block(const CodeStatement& block);
    void build_choice(const CodeStatement& statement);
    void build_while(const CodeStatement& statement);
    void build_for(const CodeStatement& statement);
    void build_for_each(const CodeStatement& statement);
    void build_return(const CodeStatement& statement);
    void build_jump(const CodeStatement& statement);
    void finish_frame();
    void begin_line(int line);
    void begin_scope();
    void end_scope();
    void free_lists(std::size_t down_to);
    void declare(const std::string& name, const NamedVariable& variable, int line);
    void end_loop(const BuiltLoop& loop, std::size_t go_on_target);

    // build_marks.cpp
    void build_stops(int line);
    void check_stops() const;
    void build_marks(int line);
    void note_value(int line, const BuiltValue& value);
    int build_condition(const CodeExpression& expression);
    int reserve_for_note(int words);

    // build_expressions.cpp
    BuiltValue build(const CodeExpression& expression);
    BuiltValue build_name(const CodeExpression& expression);
    BuiltValue build_unary(const CodeExpression& expression);
    BuiltValue build_binary(const CodeExpression& expression);
    BuiltValue build_logic(const CodeExpression& expression);
    BuiltValue build_comparison(const CodeExpression& expression);
    BuiltValue arithmetic(const std::string& sign, const BuiltValue& left, const BuiltValue& right,
                          int line);
    BuiltValue build_assignment(const CodeExpression& expression);
    BuiltValue build_step(const CodeExpression& expression);
    BuiltValue build_conditional(const CodeExpression& expression);
    BuiltValue build_index(const CodeExpression& expression);
    BuiltValue build_member(const CodeExpression& expression);

    // build_calls.cpp
    BuiltValue build_call(const CodeExpression& expression);
    BuiltValue build_own_call(int function, const CodeExpression& expression);
    BuiltValue build_host_call(const std::string& name, const std::vector<BuiltValue>& arguments,
                               int line);
    BuiltValue build_construction(CodeTypeId id, const std::vector<CodeExpressionPtr>& parts,
                                  int line);
    BuiltValue build_method(const CodeExpression& expression);

    // build_values.cpp
    BuiltValue temporary(CodeTypeId type);
    int in_slots(const BuiltValue& value);
    int place_of(const BuiltValue& value);
    BuiltValue converted(const BuiltValue& value, CodeTypeId type, int line);
    bool can_convert(CodeTypeId from, CodeTypeId to) const;
    void store(const BuiltValue& target, const BuiltValue& value);
    void fill_zero(int slot, int words);
    BuiltValue value_of(const CodeExpression& expression, CodeTypeId type);
    std::optional<int> constant_of(const CodeExpression& expression) const;

    std::size_t emit(CodeOp op, int n = 1, int a = 0, int b = 0, int c = 0, int d = 0);
    void land(std::size_t jump);
    void land(const std::vector<std::size_t>& jumps);
    int reserve(int words);
    const NamedVariable* find_variable(const std::string& name) const;
    CodeTypeId type_of(const WrittenType& written);
    std::string name_of(CodeTypeId type) const { return program_.types[type].name; }
    std::size_t here() const { return program_.instructions.size(); }
    CodeFunction& current() { return program_.functions[static_cast<std::size_t>(function_)]; }
    [[noreturn]] void fail(int line, const std::string& sentence) const;

    const CodeSyntax& syntax_;
    const std::vector<CodeStop>& stops_;
    std::vector<std::string> stop_faults_; ///< of each; empty: it counts somewhere
    CodeProgram program_;
    std::vector<std::vector<bool>> takes_const_; ///< of each function, its parameters
    int function_ = 0;
    int next_slot_ = 0;              ///< of the frame
    std::vector<BuiltScope> scopes_; ///< the first: global
    std::vector<BuiltLoop> loops_;
    int note_words_ = 0;     ///< of the function
    bool is_global_ = false; ///< global variables are being declared
};

} // namespace rasterwalk
