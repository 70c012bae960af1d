#pragma once

// Carries out a program of the lab, line by line.

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "code/code_program.h"

namespace rasterwalk {

/// Why the machine stopped.
enum class CodeEnd : std::uint8_t {
    done,     ///< the function that was called has returned
    paused,   ///< before a line at which it was to stop
    failed,   ///< see CodeMachine::fault()
    too_long, ///< it has begun as many lines as it may
};

struct CodeFault {
    int line = 0; ///< of the source, from 1
    std::string sentence;
};

/// A function that is being carried out.
struct CodeCall {
    int function = 0;
    int line = 0; ///< of the source: the one that comes next, or that called the next function
    int base = 0; ///< word of the stack at which its frame begins
    int at = 0;   ///< instruction
};

/// A variable of a function, as it is now.
struct CodeShown {
    std::string name;
    std::string value;
};

/// What a line that has been carried out in this call has computed.
struct CodeLineValue {
    int line = 1;
    std::string text; ///< "9", "9 < 7 no"
};

class CodeMachine {
  public:
    /// Memory beyond the lists that the program makes: words.
    static constexpr int stack_words = 1 << 18;
    /// What all lists together may take, words.
    static constexpr std::int64_t most_list_words = 64'000'000;

    explicit CodeMachine(std::shared_ptr<const CodeProgram> program);

    /// Gives the global variables their first values. Nothing is being carried out after that.
    CodeEnd begin();

    /// The words of a global variable; empty: there is none of this name.
    std::span<std::uint32_t> global(std::string_view name);
    /// The elements of a global vector, with as many words as it is to have, or as it has.
    std::span<std::uint32_t> list(std::string_view name);
    void resize_list(std::string_view name, std::size_t words);

    /// Begins to carry out a function that takes nothing. What was being carried out is dropped.
    void call(int function);
    /// Goes on, until the function that was called returns, or something stops the machine.
    CodeEnd run();
    /// Goes on to the beginning of the next line.
    CodeEnd step_line();

    /// The machine pauses before the line with this number, counted from the first call.
    void pause_at(std::int64_t line) { pause_at_ = line; }
    /// The machine pauses before the first line for which this holds of the marks; it is asked
    /// whenever one gets a value.
    /// @param mark  the one, by its place in CodeProgram::marks
    /// @param marks the values of all; -1: none yet
    void pause_when(std::function<bool(std::size_t mark, std::span<const int> marks)> condition) {
        pause_when_ = std::move(condition);
    }
    /// The machine pauses before each beginning of this line of the source; 0: of none.
    void pause_before(int line) { pause_before_ = line; }
    /// The machine pauses before the next line in which no more functions than this are being
    /// carried out; 0: never.
    void pause_outside(std::size_t calls) { pause_outside_ = calls; }
    /// Rounds of loops that are marked with `each` are skipped as long as this mark is less.
    /// @param mark its place in CodeProgram::marks
    void skip_to(std::size_t mark, int value) { skip_to_[mark] = value; }
    /// How many lines may be begun, counted from the first call.
    void allow(std::int64_t lines) { most_lines_ = lines; }
    /// How many words all lists may take together: at most most_list_words.
    void allow_words(std::int64_t words) { most_list_words_ = std::min(words, most_list_words); }
    std::int64_t list_words() const { return list_words_; } ///< that they take now

    std::int64_t lines() const { return lines_; } ///< begun since the first call
    /// Lines of the source that were begun last, the last one first: at most most_recent_lines.
    std::vector<int> recent_lines(std::int64_t count) const;
    static constexpr std::int64_t most_recent_lines = 256;
    const CodeFault& fault() const { return fault_; }
    const CodeProgram& program() const { return *program_; }

    /// The functions that are being carried out, from outside to inside.
    const std::vector<CodeCall>& calls() const { return calls_; }
    /// The variables that are known where a call is.
    std::vector<CodeShown> variables(const CodeCall& call) const;
    /// What the lines of a call have computed so far.
    std::vector<CodeLineValue> line_values(const CodeCall& call) const;

  private:
    using Words = std::vector<std::uint32_t>;

    CodeEnd carry_out();
    std::uint32_t* memory(std::uint32_t block, std::int64_t word, std::int64_t count);
    std::uint32_t new_list(std::int64_t words);
    void resize(std::uint32_t& list, std::int64_t words);
    CodeEnd fail(std::string sentence);
    bool enter(int function, int base);
    void find_lists(CodeTypeId id, const std::uint32_t* words, std::vector<bool>& used) const;
    void free_dropped_lists();
    bool is_to_pause_at(int line) const;
    std::string text_of(CodeTypeId id, const std::uint32_t* words) const;

    std::shared_ptr<const CodeProgram> program_;
    std::vector<Words> blocks_;         ///< the stack, the global variables, and one for each list
    std::vector<std::uint32_t> unused_; ///< blocks of lists that are not needed any more
    std::int64_t list_words_ = 0;
    std::int64_t most_list_words_ = most_list_words;
    std::vector<CodeCall> calls_;
    std::int64_t lines_ = 0;
    std::array<int, most_recent_lines> recent_{}; ///< the line begun n-th is at n % its size
    std::int64_t pause_at_ = -1;
    std::int64_t most_lines_ = 1'000'000'000;
    std::int64_t paused_at_ = -1; ///< line at which it has paused, which it now goes on from
    bool is_to_pause_ = false;    ///< at the next line
    int pause_before_ = 0;
    std::size_t pause_outside_ = 0;
    std::vector<int> marks_;
    std::vector<int> skip_to_; ///< of each mark
    std::function<bool(std::size_t, std::span<const int>)> pause_when_;
    CodeFault fault_;
};

} // namespace rasterwalk
