#pragma once

// A program of the lab, understood and made into instructions that code_machine.h carries out.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "code/code_types.h"

namespace rasterwalk {

/// What an instruction does. `a` to `d` are its operands, `n` is how many words or components it
/// works on. A slot is a word of the frame: of the memory of the call that is being carried out.
enum class CodeOp : std::uint8_t {
    line,    ///< line b of the source begins
    note,    ///< slot a = 1, and the slots after it = slots b
    mark,    ///< mark `a` gets the value of slot b
    skip,    ///< to b, if mark `a` is to be skipped, see CodeMachine::skip_to()
    stop_if, ///< the machine stops at the next line if slot a is not 0
    set,     ///< slot a = the word b
    copy,    ///< slots a = slots b
    // Memory. A place is two words: a block, and a word in it.
    load,            ///< slots a = memory at the place in slot b, `c` words on
    store,           ///< memory at the place in slot a, `c` words on = slots b
    load_global,     ///< slots a = global words b
    store_global,    ///< global words a = slots b
    place_of_slot,   ///< slot a = the place of slot b
    place_of_global, ///< slot a = the place of global word b
    move_place,      ///< slot a = the place in slot b, `c` words on
    element,         ///< slot a = the place in slot b, index in slot c, of d elements of n words
    list_element,    ///< slot a = the place in the list in slot b, index in slot c, of n words
    // Numbers: i int, f float, d double.
    add_i,
    sub_i,
    mul_i,
    div_i,
    rem_i,
    neg_i,
    add_f,
    sub_f,
    mul_f,
    div_f,
    neg_f,
    add_d,
    sub_d,
    mul_d,
    div_d,
    neg_d,
    spread, ///< slots a = n times slot b
    less_i,
    less_equal_i,
    equal_i,
    less_f,
    less_equal_f,
    equal_f,
    less_d,
    less_equal_d,
    equal_d,
    invert, ///< slot a = not slot b
    int_to_real,
    real_to_int,
    int_to_double,
    double_to_int,
    real_to_double,
    double_to_real,
    // The way.
    jump, ///< to b
    jump_if,
    jump_if_not, ///< to b, if slot a is not 0, or if it is
    call,        ///< function a, whose frame begins at slot b
    call_host,   ///< host function a: its result to slots b, its arguments from slot c
    back,        ///< from a function
    // Lists: of n words an element.
    list_make,   ///< slot a = a new list of as many elements as slot b says
    list_free,   ///< the list in slot a is not needed any more, and slot a = 0
    list_copy,   ///< the list whose place is in slot a gets the elements of the list in slot b
    list_resize, ///< the list whose place is in slot a gets as many elements as slot b says
    list_push,   ///< the list whose place is in slot a gets one element more: slots b
    list_size,   ///< slot a = elements of the list in slot b
};

struct CodeInstruction {
    CodeOp op = CodeOp::back;
    int n = 1;
    int a = 0, b = 0, c = 0, d = 0;
};

/// What a line has computed, written at its end.
struct CodeNote {
    enum class Kind : std::uint8_t {
        value,    ///< the value in `slot`
        decision, ///< a condition: `slot` holds whether it held
        compare,  ///< the same, with the two values it compared
    };
    Kind kind = Kind::value;
    int set = -1; ///< slot that is 1 once the line has been carried out in this call
    int slot = -1;
    CodeTypeId type = code_type::nothing;
    std::string sign;          ///< of a comparison
    int left = -1, right = -1; ///< slots of what is compared
    CodeTypeId compared = code_type::nothing;
};

/// A statement that begins a line.
struct CodeLine {
    int line = 1; ///< of the source, from 1
    int function = 0;
    int note = -1; ///< of the function; -1: the line computes nothing that could be shown
};

/// A variable of a function, alive while instructions first to last are carried out.
struct CodeVariableInfo {
    std::string name;
    CodeTypeId type = code_type::nothing;
    int slot = 0;
    bool is_reference = false; ///< the slot holds the place
    int first = 0, last = 0;
};

/// The frame of a function has at most so many words.
inline constexpr int largest_frame = 20'000;

struct CodeFunction {
    std::string name;
    CodeTypeId result = code_type::nothing;
    bool is_defined = false;
    int first = 0;                            ///< instruction
    int words = 0;                            ///< of its frame: result, parameters, variables
    int line = 1;                             ///< of the source
    std::vector<CodeVariableInfo> parameters; ///< slots in the frame, after the result
    std::vector<CodeVariableInfo> variables;  ///< parameters too
    std::vector<CodeNote> notes;
};

struct CodeGlobal {
    std::string name;
    CodeTypeId type = code_type::nothing;
    int offset = 0; ///< words
};

/// A function that the program calls and that is not written in it: `max`, `glm::dot`.
struct CodeHostFunction {
    std::string name;
    CodeTypeId result = code_type::nothing;
    std::vector<CodeTypeId> parameters;
    /// @param result    words of the result
    /// @param arguments words of the arguments, one after the other
    std::function<void(std::uint32_t* result, const std::uint32_t* arguments)> call;
};

/// A program that can be carried out.
struct CodeProgram {
    CodeTypes types;
    std::vector<CodeInstruction> instructions;
    std::vector<CodeLine> lines;    ///< statements, see CodeOp::line
    std::vector<std::string> marks; ///< their words, see CodeOp::mark
    std::vector<CodeFunction> functions;
    std::vector<CodeGlobal> globals;
    int global_words = 0;
    std::vector<CodeHostFunction> host; ///< those that are called
    int start = 0;                      ///< function that gives the globals their values

    /// -1: there is none.
    int find_function(std::string_view name) const;
    const CodeGlobal* find_global(std::string_view name) const;
};

/// A condition of a line: the machine stops before it is carried out, if the condition holds.
struct CodeStop {
    int line = 1;          ///< of the source, from 1
    std::string condition; ///< an expression in the variables that are known there
};

/// Understands a program. Throws InputError with the file, the line and a sentence: an unknown
/// name, types that do not fit, a part of C++ that is not understood.
/// @param source the text; a file that several programs share can be put before it
/// @param file   its name, for messages
/// @param stops  their conditions change nothing, and call only functions of C++ and GLM
CodeProgram compile_code(std::string_view source, const std::string& file,
                         const std::vector<CodeStop>& stops = {});

} // namespace rasterwalk
