// What is kept for those who walk the program: marks, conditions of lines, and what a line has
// computed.

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "code/code_builder.h"

namespace rasterwalk {

namespace {

using Kind = CodeExpression::Kind;
using TypeKind = CodeType::Kind;

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

} // namespace rasterwalk
