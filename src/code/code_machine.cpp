#include "code/code_machine.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace rasterwalk {

namespace {

/// Giving the global variables their values takes at most so many lines.
constexpr std::int64_t most_lines_of_start = 1'000'000;

/// So many words of new memory count as a line.
constexpr std::int64_t words_of_line = 64;

constexpr std::uint32_t stack_block = 0, global_block = 1;

std::int32_t as_int(std::uint32_t word) {
    return static_cast<std::int32_t>(word);
}

float as_real(std::uint32_t word) {
    return std::bit_cast<float>(word);
}

double as_double(const std::uint32_t* words) {
    double value = 0.0;
    std::memcpy(&value, words, sizeof value);
    return value;
}

void put_double(std::uint32_t* words, double value) {
    std::memcpy(words, &value, sizeof value);
}

/// int() of a number that has none gives what most processors give.
std::int32_t to_int(double value) {
    constexpr double end = 2147483648.0;
    return value > -end - 1.0 && value < end ? static_cast<std::int32_t>(value)
                                             : std::numeric_limits<std::int32_t>::min();
}

/// op of n components. Whole numbers wrap around, as they do on most processors.
template <class Op>
void each_int(std::uint32_t* f, const CodeInstruction& in, Op op) {
    for (int i = 0; i < in.n; ++i)
        f[in.a + i] = op(f[in.b + i], f[in.c + i]);
}

template <class Op>
void each_real(std::uint32_t* f, const CodeInstruction& in, Op op) {
    for (int i = 0; i < in.n; ++i)
        f[in.a + i] = std::bit_cast<std::uint32_t>(op(as_real(f[in.b + i]), as_real(f[in.c + i])));
}

template <class Op>
void of_doubles(std::uint32_t* f, const CodeInstruction& in, Op op) {
    put_double(f + in.a, op(as_double(f + in.b), as_double(f + in.c)));
}

} // namespace

CodeMachine::CodeMachine(std::shared_ptr<const CodeProgram> program)
    : program_(std::move(program)), blocks_(2), marks_(program_->marks.size(), -1),
      skip_to_(program_->marks.size(), std::numeric_limits<int>::min()) {
    // The arguments of a call are there before it is known whether its frame has room.
    blocks_[stack_block].resize(stack_words + largest_frame);
    blocks_[global_block].resize(static_cast<std::size_t>(program_->global_words));
}

CodeEnd CodeMachine::begin() {
    call(program_->start);
    const std::int64_t allowed = std::exchange(most_lines_, most_lines_of_start);
    const CodeEnd end = run();
    most_lines_ = allowed;
    lines_ = 0;
    return end;
}

std::span<std::uint32_t> CodeMachine::global(std::string_view name) {
    const CodeGlobal* const found = program_->find_global(name);
    if (found == nullptr) return {};
    return std::span(blocks_[global_block])
        .subspan(static_cast<std::size_t>(found->offset),
                 static_cast<std::size_t>(program_->types[found->type].words));
}

std::span<std::uint32_t> CodeMachine::list(std::string_view name) {
    const CodeGlobal* const found = program_->find_global(name);
    if (found == nullptr || program_->types[found->type].kind != CodeType::Kind::list) return {};
    const std::span<std::uint32_t> handle = global(name);
    if (handle[0] >= blocks_.size() || handle[0] == 0) return {};
    return blocks_[handle[0]];
}

void CodeMachine::resize_list(std::string_view name, std::size_t words) {
    const CodeGlobal* const found = program_->find_global(name);
    if (found == nullptr || program_->types[found->type].kind != CodeType::Kind::list) return;
    const std::span<std::uint32_t> handle = global(name);
    if (handle.size() == 1) resize(handle[0], static_cast<std::int64_t>(words));
}

bool CodeMachine::enter(int function, int base) {
    const CodeFunction& called = program_->functions[static_cast<std::size_t>(function)];
    constexpr std::size_t most_calls = 500;
    if (base + called.words > stack_words || calls_.size() >= most_calls) return false;
    // Only the lines of this call have computed something; the arguments are there already.
    std::uint32_t* const frame = blocks_[stack_block].data() + base;
    int given = program_->types[called.result].words;
    std::fill_n(frame, given, 0u);
    for (const CodeVariableInfo& parameter : called.parameters)
        given += parameter.is_reference ? 2 : program_->types[parameter.type].words;
    std::fill(frame + given, frame + called.words, 0u);
    calls_.push_back({function, called.line, base, called.first});
    return true;
}

/// Notes the lists that a value holds.
void CodeMachine::find_lists(CodeTypeId id, const std::uint32_t* words,
                             std::vector<bool>& used) const {
    const CodeType& type = program_->types[id];
    if (!program_->types.has_list(id)) return;
    if (type.kind == CodeType::Kind::list) {
        if (*words == 0) return;
        used[*words] = true;
        if (!program_->types.has_list(type.element)) return;
        const Words& block = blocks_[*words];
        const auto step = static_cast<std::size_t>(program_->types[type.element].words);
        for (std::size_t at = 0; at + step <= block.size(); at += step)
            find_lists(type.element, block.data() + at, used);
    } else if (type.kind == CodeType::Kind::array) {
        const auto step = static_cast<std::size_t>(program_->types[type.element].words);
        for (std::size_t i = 0; i < static_cast<std::size_t>(type.count); ++i)
            find_lists(type.element, words + i * step, used);
    } else {
        for (const CodeField& field : type.fields)
            find_lists(field.type, words + field.offset, used);
    }
}

/// Lists of calls that were not carried out to their end are held by nothing any more.
void CodeMachine::free_dropped_lists() {
    std::vector<bool> used(blocks_.size());
    for (const CodeGlobal& global : program_->globals)
        find_lists(global.type, blocks_[global_block].data() + global.offset, used);
    unused_.clear();
    for (std::size_t block = global_block + 1; block < blocks_.size(); ++block) {
        if (used[block]) continue;
        auto list = static_cast<std::uint32_t>(block);
        resize(list, 0);
        unused_.push_back(list);
    }
}

void CodeMachine::call(int function) {
    if (!calls_.empty()) free_dropped_lists();
    calls_.clear();
    fault_ = {};
    is_to_pause_ = false;
    paused_at_ = -1;
    enter(function, 0);
}

CodeEnd CodeMachine::step_line() {
    const std::int64_t wanted = pause_at_;
    // The line at which it has paused is still to begin.
    pause_at_ = lines_ + (paused_at_ == lines_ + 1 ? 2 : 1);
    const CodeEnd end = run();
    pause_at_ = wanted;
    return end;
}

CodeEnd CodeMachine::run() {
    if (calls_.empty()) return CodeEnd::done;
    return carry_out();
}

CodeEnd CodeMachine::fail(std::string sentence) {
    fault_ = {calls_.empty() ? 0 : calls_.back().line, std::move(sentence)};
    return CodeEnd::failed;
}

std::uint32_t* CodeMachine::memory(std::uint32_t block, std::int64_t word, std::int64_t count) {
    if (block >= blocks_.size()) return nullptr;
    Words& words = blocks_[block];
    if (word < 0 || word + count > static_cast<std::int64_t>(words.size())) return nullptr;
    return words.data() + word;
}

std::uint32_t CodeMachine::new_list(std::int64_t words) {
    std::uint32_t block = 0;
    if (unused_.empty()) {
        block = static_cast<std::uint32_t>(blocks_.size());
        blocks_.emplace_back();
    } else {
        block = unused_.back();
        unused_.pop_back();
    }
    resize(block, words);
    return block;
}

void CodeMachine::resize(std::uint32_t& list, std::int64_t words) {
    if (list == 0) {
        list = new_list(words);
        return;
    }
    Words& block = blocks_[list];
    // Memory takes time as well.
    const std::int64_t more = words - static_cast<std::int64_t>(block.size());
    if (more > 0) most_lines_ -= more / words_of_line;
    list_words_ += words - static_cast<std::int64_t>(block.size());
    block.resize(static_cast<std::size_t>(words), 0u);
}

bool CodeMachine::is_to_pause_at(int line) const {
    return is_to_pause_ || lines_ + 1 == pause_at_ || line == pause_before_ ||
           calls_.size() <= pause_outside_;
}

CodeEnd CodeMachine::carry_out() {
    const CodeInstruction* const code = program_->instructions.data();
    const CodeInstruction* next = code + calls_.back().at;
    std::uint32_t* const stack = blocks_[stack_block].data();
    std::uint32_t* f = stack + calls_.back().base; // the frame
    const auto set_flag = [&](const CodeInstruction& in, bool value) { f[in.a] = value ? 1u : 0u; };
    const auto has_room = [&](std::int64_t more) {
        return more >= 0 && list_words_ + more <= most_list_words_;
    };
    constexpr const char* no_room = "The vectors need more memory than there is.";
    while (true) {
        const CodeInstruction& in = *next;
        ++next;
        switch (in.op) {
        case CodeOp::line:
            calls_.back().line = in.b;
            if (is_to_pause_at(in.b) || lines_ >= most_lines_) {
                calls_.back().at = static_cast<int>(&in - code);
                if (lines_ >= most_lines_) return CodeEnd::too_long;
                if (paused_at_ != lines_ + 1) {
                    is_to_pause_ = false;
                    paused_at_ = lines_ + 1;
                    return CodeEnd::paused;
                }
            }
            recent_[static_cast<std::size_t>(lines_ % most_recent_lines)] = in.b;
            ++lines_;
            break;
        case CodeOp::mark:
            marks_[static_cast<std::size_t>(in.a)] = as_int(f[in.b]);
            if (pause_when_ && pause_when_(static_cast<std::size_t>(in.a), marks_))
                is_to_pause_ = true;
            break;
        case CodeOp::skip:
            if (marks_[static_cast<std::size_t>(in.a)] < skip_to_[static_cast<std::size_t>(in.a)])
                next = code + in.b;
            break;
        case CodeOp::stop_if:
            if (f[in.a] != 0 && paused_at_ != lines_ + 1) is_to_pause_ = true;
            break;
        case CodeOp::set:
            f[in.a] = static_cast<std::uint32_t>(in.b);
            break;
        case CodeOp::note:
            f[in.a] = 1;
            std::copy_n(f + in.b, in.n, f + in.a + 1);
            break;
        case CodeOp::copy:
            if (in.n == 1) {
                f[in.a] = f[in.b];
            } else {
                std::memmove(f + in.a, f + in.b, static_cast<std::size_t>(in.n) * sizeof *f);
            }
            break;
        case CodeOp::load: {
            const std::uint32_t* const from =
                memory(f[in.b], std::int64_t{f[in.b + 1]} + in.c, in.n);
            if (from == nullptr) return fail("This reference refers to nothing any more.");
            std::copy_n(from, in.n, f + in.a);
            break;
        }
        case CodeOp::store: {
            std::uint32_t* const to = memory(f[in.a], std::int64_t{f[in.a + 1]} + in.c, in.n);
            if (to == nullptr) return fail("This reference refers to nothing any more.");
            std::copy_n(f + in.b, in.n, to);
            break;
        }
        case CodeOp::load_global:
            std::copy_n(blocks_[global_block].data() + in.b, in.n, f + in.a);
            break;
        case CodeOp::store_global:
            std::copy_n(f + in.b, in.n, blocks_[global_block].data() + in.a);
            break;
        case CodeOp::place_of_slot:
            f[in.a + 1] = static_cast<std::uint32_t>(f - stack + in.b);
            f[in.a] = stack_block;
            break;
        case CodeOp::place_of_global:
            f[in.a] = global_block;
            f[in.a + 1] = static_cast<std::uint32_t>(in.b);
            break;
        case CodeOp::move_place: {
            const std::uint32_t block = f[in.b];
            f[in.a + 1] = f[in.b + 1] + static_cast<std::uint32_t>(in.c);
            f[in.a] = block;
            break;
        }
        case CodeOp::element: {
            const std::int32_t index = as_int(f[in.c]);
            if (index < 0 || index >= in.d)
                return fail(fmt::format("There is no element [{}]: they are [0] to [{}].", index,
                                        in.d - 1));
            const std::uint32_t block = f[in.b];
            f[in.a + 1] = f[in.b + 1] + static_cast<std::uint32_t>(index * in.n);
            f[in.a] = block;
            break;
        }
        case CodeOp::list_element: {
            const std::int32_t index = as_int(f[in.c]);
            const std::uint32_t block = f[in.b];
            const std::int64_t size = static_cast<std::int64_t>(blocks_[block].size()) / in.n;
            if (block == stack_block || index < 0 || index >= size)
                return fail(
                    block == stack_block || size == 0
                        ? fmt::format("There is no element [{}]: the vector is empty.", index)
                        : fmt::format("There is no element [{}]: they are [0] to [{}].", index,
                                      size - 1));
            f[in.a] = block;
            f[in.a + 1] = static_cast<std::uint32_t>(index * in.n);
            break;
        }
        case CodeOp::add_i:
            each_int(f, in, [](std::uint32_t x, std::uint32_t y) { return x + y; });
            break;
        case CodeOp::sub_i:
            each_int(f, in, [](std::uint32_t x, std::uint32_t y) { return x - y; });
            break;
        case CodeOp::mul_i:
            each_int(f, in, [](std::uint32_t x, std::uint32_t y) { return x * y; });
            break;
        case CodeOp::div_i:
        case CodeOp::rem_i:
            for (int i = 0; i < in.n; ++i) {
                const std::int64_t x = as_int(f[in.b + i]), y = as_int(f[in.c + i]);
                if (y == 0) return fail("A whole number is divided by 0.");
                f[in.a + i] = static_cast<std::uint32_t>(in.op == CodeOp::div_i ? x / y : x % y);
            }
            break;
        case CodeOp::neg_i:
            for (int i = 0; i < in.n; ++i)
                f[in.a + i] = 0u - f[in.b + i];
            break;
        case CodeOp::add_f:
            each_real(f, in, [](float x, float y) { return x + y; });
            break;
        case CodeOp::sub_f:
            each_real(f, in, [](float x, float y) { return x - y; });
            break;
        case CodeOp::mul_f:
            each_real(f, in, [](float x, float y) { return x * y; });
            break;
        case CodeOp::div_f:
            each_real(f, in, [](float x, float y) { return x / y; });
            break;
        case CodeOp::neg_f:
            for (int i = 0; i < in.n; ++i)
                f[in.a + i] = std::bit_cast<std::uint32_t>(-as_real(f[in.b + i]));
            break;
        case CodeOp::add_d:
            of_doubles(f, in, [](double x, double y) { return x + y; });
            break;
        case CodeOp::sub_d:
            of_doubles(f, in, [](double x, double y) { return x - y; });
            break;
        case CodeOp::mul_d:
            of_doubles(f, in, [](double x, double y) { return x * y; });
            break;
        case CodeOp::div_d:
            of_doubles(f, in, [](double x, double y) { return x / y; });
            break;
        case CodeOp::neg_d:
            put_double(f + in.a, -as_double(f + in.b));
            break;
        case CodeOp::spread: {
            const std::uint32_t value = f[in.b];
            std::fill_n(f + in.a, in.n, value);
            break;
        }
        case CodeOp::less_i:
            set_flag(in, as_int(f[in.b]) < as_int(f[in.c]));
            break;
        case CodeOp::less_equal_i:
            set_flag(in, as_int(f[in.b]) <= as_int(f[in.c]));
            break;
        case CodeOp::equal_i:
            set_flag(in, f[in.b] == f[in.c]);
            break;
        case CodeOp::less_f:
            set_flag(in, as_real(f[in.b]) < as_real(f[in.c]));
            break;
        case CodeOp::less_equal_f:
            set_flag(in, as_real(f[in.b]) <= as_real(f[in.c]));
            break;
        case CodeOp::equal_f:
            set_flag(in, as_real(f[in.b]) == as_real(f[in.c]));
            break;
        case CodeOp::less_d:
            set_flag(in, as_double(f + in.b) < as_double(f + in.c));
            break;
        case CodeOp::less_equal_d:
            set_flag(in, as_double(f + in.b) <= as_double(f + in.c));
            break;
        case CodeOp::equal_d:
            set_flag(in, as_double(f + in.b) == as_double(f + in.c));
            break;
        case CodeOp::invert:
            set_flag(in, f[in.b] == 0);
            break;
        case CodeOp::int_to_real:
            f[in.a] = std::bit_cast<std::uint32_t>(static_cast<float>(as_int(f[in.b])));
            break;
        case CodeOp::real_to_int:
            f[in.a] = static_cast<std::uint32_t>(to_int(static_cast<double>(as_real(f[in.b]))));
            break;
        case CodeOp::int_to_double:
            put_double(f + in.a, static_cast<double>(as_int(f[in.b])));
            break;
        case CodeOp::double_to_int:
            f[in.a] = static_cast<std::uint32_t>(to_int(as_double(f + in.b)));
            break;
        case CodeOp::real_to_double:
            put_double(f + in.a, static_cast<double>(as_real(f[in.b])));
            break;
        case CodeOp::double_to_real:
            f[in.a] = std::bit_cast<std::uint32_t>(static_cast<float>(as_double(f + in.b)));
            break;
        case CodeOp::jump:
            next = code + in.b;
            break;
        case CodeOp::jump_if:
            if (f[in.a] != 0) next = code + in.b;
            break;
        case CodeOp::jump_if_not:
            if (f[in.a] == 0) next = code + in.b;
            break;
        case CodeOp::call: {
            const CodeFunction& called = program_->functions[static_cast<std::size_t>(in.a)];
            if (!called.is_defined)
                return fail(fmt::format("{} is declared, but nowhere written.", called.name));
            calls_.back().at = static_cast<int>(&in - code);
            if (!enter(in.a, calls_.back().base + in.b))
                return fail("The functions call each other too deeply.");
            f = stack + calls_.back().base;
            next = code + calls_.back().at;
            break;
        }
        case CodeOp::call_host:
            program_->host[static_cast<std::size_t>(in.a)].call(f + in.b, f + in.c);
            break;
        case CodeOp::back:
            calls_.pop_back();
            if (calls_.empty()) return CodeEnd::done;
            next = code + calls_.back().at + 1;
            f = stack + calls_.back().base;
            break;
        case CodeOp::list_make: {
            const std::int32_t size = as_int(f[in.b]);
            if (size < 0) return fail(fmt::format("A vector cannot have {} elements.", size));
            if (!has_room(std::int64_t{size} * in.n)) return fail(no_room);
            f[in.a] = new_list(std::int64_t{size} * in.n);
            break;
        }
        case CodeOp::list_free:
            if (f[in.a] != 0) {
                resize(f[in.a], 0);
                unused_.push_back(f[in.a]);
                f[in.a] = 0;
            }
            break;
        case CodeOp::list_copy:
        case CodeOp::list_resize:
        case CodeOp::list_push: {
            std::uint32_t* handle = memory(f[in.a], f[in.a + 1], 1);
            if (handle == nullptr) return fail("This reference refers to nothing any more.");
            const auto old = static_cast<std::int64_t>(*handle == 0 ? 0 : blocks_[*handle].size());
            std::int64_t size = old;
            if (in.op == CodeOp::list_copy) {
                size = f[in.b] == 0 ? 0 : static_cast<std::int64_t>(blocks_[f[in.b]].size());
            } else if (in.op == CodeOp::list_resize) {
                const std::int32_t count = as_int(f[in.b]);
                if (count < 0) return fail(fmt::format("A vector cannot have {} elements.", count));
                size = std::int64_t{count} * in.n;
            } else {
                size += in.n;
            }
            if (size > old && !has_room(size - old)) return fail(no_room);
            if (*handle == 0) {
                const std::uint32_t made = new_list(size);
                handle = memory(f[in.a], f[in.a + 1], 1);
                *handle = made;
            } else {
                resize(*handle, size);
            }
            Words& words = blocks_[*handle];
            if (in.op == CodeOp::list_copy && f[in.b] != 0 && f[in.b] != *handle)
                std::copy(blocks_[f[in.b]].begin(), blocks_[f[in.b]].end(), words.begin());
            if (in.op == CodeOp::list_push) std::copy_n(f + in.b, in.n, words.end() - in.n);
            break;
        }
        case CodeOp::list_size:
            f[in.a] = f[in.b] == 0 ? 0u
                                   : static_cast<std::uint32_t>(blocks_[f[in.b]].size()) /
                                         static_cast<std::uint32_t>(in.n);
            break;
        }
    }
}

std::vector<int> CodeMachine::recent_lines(std::int64_t count) const {
    std::vector<int> lines;
    for (std::int64_t i = 1; i <= std::min({count, lines_, most_recent_lines}); ++i)
        lines.push_back(recent_[static_cast<std::size_t>((lines_ - i) % most_recent_lines)]);
    return lines;
}

std::string CodeMachine::text_of(CodeTypeId id, const std::uint32_t* words) const {
    const CodeType& type = program_->types[id];
    int size = 0;
    if (type.kind == CodeType::Kind::list && *words != 0 && *words < blocks_.size())
        size = static_cast<int>(blocks_[*words].size()) / program_->types[type.element].words;
    return code_value_text(program_->types, id, words, size);
}

std::vector<CodeShown> CodeMachine::variables(const CodeCall& call) const {
    const CodeFunction& function = program_->functions[static_cast<std::size_t>(call.function)];
    const std::uint32_t* const frame = blocks_[stack_block].data() + call.base;
    std::vector<CodeShown> shown;
    for (const CodeVariableInfo& variable : function.variables) {
        if (call.at < variable.first || call.at > variable.last) continue;
        const std::uint32_t* words = frame + variable.slot;
        if (variable.is_reference) {
            const std::size_t block = words[0], word = words[1];
            const auto count = static_cast<std::size_t>(program_->types[variable.type].words);
            if (block >= blocks_.size() || word + count > blocks_[block].size()) continue;
            words = blocks_[block].data() + word;
        }
        shown.push_back({variable.name, text_of(variable.type, words)});
    }
    return shown;
}

std::vector<CodeLineValue> CodeMachine::line_values(const CodeCall& call) const {
    const CodeFunction& function = program_->functions[static_cast<std::size_t>(call.function)];
    const std::uint32_t* const frame = blocks_[stack_block].data() + call.base;
    std::vector<CodeLineValue> values;
    for (const CodeLine& line : program_->lines) {
        if (line.function != call.function || line.note < 0) continue;
        const CodeNote& note = function.notes[static_cast<std::size_t>(line.note)];
        if (frame[note.set] == 0) continue;
        std::string text = text_of(
            note.kind == CodeNote::Kind::value ? note.type : code_type::boolean, frame + note.slot);
        if (note.kind != CodeNote::Kind::value) text = frame[note.slot] != 0 ? "yes" : "no";
        if (note.kind == CodeNote::Kind::compare)
            text = fmt::format("{} {} {} {}", text_of(note.compared, frame + note.left), note.sign,
                               text_of(note.compared, frame + note.right), text);
        values.push_back({line.line, std::move(text)});
    }
    return values;
}

} // namespace rasterwalk
