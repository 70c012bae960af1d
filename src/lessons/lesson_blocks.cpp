#include "lessons/lesson_blocks.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/limits.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "base/toml_block.h"
#include "facts/facts.h"
#include "lessons/lesson_link.h"
#include "lessons/lesson_run.h"
#include "view/view_table.h"

namespace rasterwalk {

namespace {

Expression condition(const TomlBlock& block, const toml::node& node) {
    return parse_condition(block.text(node));
}

/// An expression is text; a plain number needs no quotes.
Expression expression(const TomlBlock& block, const toml::node& node) {
    if (const std::optional<double> number = node.value<double>()) {
        // All digits of a double, because a count may be larger than a float can hold.
        return parse_expression(shortest(*number));
    }
    return parse_expression(block.text(node));
}

/// Throws UsageError for an {EXPRESSION} in code or in a formula, which would be shown unchanged.
void refuse_numbers_in_code(std::string_view text) {
    while (true) {
        const std::size_t begin = text.find_first_of("`$");
        const std::size_t end = begin == text.npos ? begin : text.find(text[begin], begin + 1);
        if (end == text.npos) return;
        const std::string_view code = text.substr(begin + 1, end - begin - 1);
        text.remove_prefix(end + 1);
        const std::size_t open = code.find('{');
        const std::size_t close = open == code.npos ? open : code.find('}', open);
        if (close == code.npos) continue;
        const std::string_view inner = code.substr(open + 1, close - open - 1);
        const std::string_view name = inner.substr(0, inner.find(':'));
        if (name == "answer" || find_name(name)) {
            throw UsageError(fmt::format("{} is not replaced inside code or a formula.",
                                         in_quotes(code.substr(open, close - open + 1))));
        }
    }
}

/// Markdown with {EXPRESSION}, but without {answer}, which would be given away or does not exist.
/// Throws UsageError for an expression that is not understood.
std::string checked_text(const TomlBlock& block, const toml::node& node) {
    std::string text = block.text(node);
    refuse_numbers_in_code(text);
    fill_in(text, "", std::nullopt, [](std::string_view) { return Value(); });
    if (text.find("{answer") != text.npos)
        throw UsageError("there is no {answer} here; only 'because' of a prediction has it.");
    return text;
}

/// Text that is not blank, and not longer than this, bytes.
std::string short_text(const TomlBlock& block, const toml::node& node, std::size_t longest) {
    std::string text = block.text(node);
    if (text.size() > longest)
        block.input().fail(node, fmt::format("this may have at most {} bytes.", longest));
    return text;
}

using PredictionKind = LessonPrediction::Kind;

/// The keys that each kind needs, and those that belong to another kind.
void check_kind(TomlBlock& block, PredictionKind kind) {
    struct Rule {
        std::string_view key;
        PredictionKind kind;
        bool is_needed;
    };
    constexpr Rule rules[] = {
        {"answer", PredictionKind::number, true}, {"tolerance", PredictionKind::number, false},
        {"unit", PredictionKind::number, false},  {"choices", PredictionKind::choice, true},
        {"right", PredictionKind::choice, true},  {"where", PredictionKind::pixel, true},
        {"recipe", PredictionKind::pixel, true},  {"wrong", PredictionKind::pixel, true},
    };
    constexpr std::string_view names[] = {"number", "pixel", "choice"};
    for (const Rule& rule : rules) {
        const toml::node* const node = block.input().find(rule.key);
        if (rule.kind == kind && rule.is_needed && node == nullptr) block.require(rule.key);
        if (rule.kind != kind && node != nullptr) {
            block.faults().add(line_of(*node),
                               fmt::format("'{}' belongs to a prediction of kind {}.", rule.key,
                                           names[static_cast<std::size_t>(rule.kind)]));
        }
    }
}

std::vector<NotYet> read_not_yet(const TomlBlock& task, const toml::node& node) {
    std::vector<NotYet> read;
    const auto read_one = [&](TomlBlock& block, int line) {
        std::optional<Expression> when;
        NotYet one;
        one.line = line;
        TomlKeys keys;
        keys["when"] = [&](const toml::node& n) { when = condition(block, n); };
        keys["says"] = [&](const toml::node& n) { one.says = checked_text(block, n); };
        block.read(keys);
        for (const char* key : {"when", "says"})
            block.require(key);
        if (!when || one.says.empty()) return;
        one.when = std::move(*when);
        read.push_back(std::move(one));
    };
    task.for_each_table(node, most_not_yet, "an entry of 'not_yet'", read_one);
    return read;
}

/// @param p with its kind and choices
std::vector<Misconception> read_misconceptions(const TomlBlock& prediction, const toml::node& node,
                                               const LessonPrediction& p) {
    std::vector<Misconception> read;
    const auto read_one = [&](TomlBlock& block, int line) {
        Misconception one;
        one.line = line;
        TomlKeys keys;
        keys["says"] = [&](const toml::node& n) { one.says = checked_text(block, n); };
        keys["answer"] = [&](const toml::node& n) {
            if (p.kind == PredictionKind::number) one.answer = expression(block, n);
            if (p.kind == PredictionKind::pixel) one.answer = condition(block, n);
            if (p.kind != PredictionKind::choice) return;
            const auto found = std::find(p.choices.begin(), p.choices.end(), block.text(n));
            if (found == p.choices.end())
                block.input().fail(n, "'answer' must be one of the choices, word for word.");
            one.choice = static_cast<int>(found - p.choices.begin());
        };
        if (p.kind == PredictionKind::number) {
            keys["tolerance"] = [&](const toml::node& n) { one.tolerance = expression(block, n); };
        }
        block.read(keys);
        for (const char* key : {"answer", "says"})
            block.require(key);
        const bool is_known = one.answer || one.choice >= 0;
        if (is_known && !one.says.empty()) read.push_back(std::move(one));
    };
    prediction.for_each_table(node, most_misconceptions, "an entry of 'misconceptions'", read_one);
    return read;
}

} // namespace

std::string read_question_id(const TomlBlock& block, const toml::node& node) {
    constexpr std::size_t longest = 60;
    std::string text = block.text(node);
    const bool is_good =
        text.size() <= longest &&
        text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_") == text.npos;
    if (!is_good) {
        block.input().fail(node, "an id consists of lowercase letters, digits, - and _, at most " +
                                     std::to_string(longest) + ".");
    }
    return text;
}

ViewState read_lesson_block(const toml::table& table, int line, Lesson& lesson, FaultList& faults) {
    TomlBlock block(table, line, "the block 'lesson'", faults);
    ViewState state;
    state.line = line;
    TomlKeys keys = view_keys(block, state);
    keys["title"] = [&](const toml::node& n) { lesson.title = block.text(n); };
    keys["section"] = [&](const toml::node& n) { lesson.section = block.text(n); };
    keys["about"] = [&](const toml::node& n) { lesson.about = block.text(n); };
    keys["program"] = [&](const toml::node& n) { lesson.program = block.text(n); };
    keys["sources"] = [&](const toml::node& n) {
        block.for_each_text(n, most_sources,
                            [&](const std::string& text) { lesson.sources.push_back(text); });
    };
    keys["minutes"] = [&](const toml::node& n) { lesson.minutes = block.whole(n, 1, 120); };
    keys["picture"] = [&](const toml::node& n) {
        state.lines["picture"] = line_of(n);
        lesson.picture = block.whole(n, 0, most_lesson_steps);
    };
    block.read(keys);
    for (const char* key : {"title", "section", "minutes", "about", "program"})
        block.require(key);
    return state;
}

LessonTask read_task(const toml::table& table, int line, FaultList& faults) {
    TomlBlock block(table, line, "the block 'task'", faults);
    LessonTask task;
    task.line = task.done_line = task.recipe_line = task.because_line = line;
    TomlKeys keys;
    keys["id"] = [&](const toml::node& n) { task.id = read_question_id(block, n); };
    keys["done"] = [&](const toml::node& n) {
        task.done_line = line_of(n);
        task.done = condition(block, n);
    };
    keys["recipe"] = [&](const toml::node& n) {
        task.recipe_line = line_of(n);
        std::size_t links = 0;
        if (const toml::array* list = n.as_array()) links = list->size();
        block.for_each_text(n, most_recipe_links, [&](const std::string& target) {
            parse_lesson_link(target);
            task.recipe.push_back(target);
        });
        if (links == 0) block.input().fail(n, "a recipe must have at least one link.");
        // Half a recipe solves nothing, but that need not be reported too.
        if (task.recipe.size() < links) task.recipe.clear();
    };
    keys["hint"] = [&](const toml::node& n) { task.hint = block.text(n); };
    keys["because"] = [&](const toml::node& n) {
        task.because_line = line_of(n);
        task.because = checked_text(block, n);
    };
    keys["not_yet"] = [&](const toml::node& n) { task.not_yet = read_not_yet(block, n); };
    block.read(keys);
    for (const char* key : {"id", "done", "recipe"})
        block.require(key);
    return task;
}

LessonPrediction read_prediction(const toml::table& table, int line, const ViewState& step,
                                 FaultList& faults) {
    TomlBlock block(table, line, "the block 'prediction'", faults);
    LessonPrediction p;
    p.line = p.answer_line = p.because_line = line;
    p.at = step;
    TomlKeys keys;
    keys["id"] = [&](const toml::node& n) { p.id = read_question_id(block, n); };
    keys["kind"] = [&](const toml::node& n) {
        constexpr std::string_view names[] = {"number", "pixel", "choice"};
        const std::string name = block.word(n, "kind of prediction", names);
        p.kind = name == "number"  ? PredictionKind::number
                 : name == "pixel" ? PredictionKind::pixel
                                   : PredictionKind::choice;
    };
    keys["look_back"] = [&](const toml::node& n) {
        const std::optional<bool> is_on = n.value_exact<bool>();
        if (!is_on) block.input().fail(n, "'look_back' must be true or false.");
        p.looks_back = *is_on;
    };
    keys["answer"] = [&](const toml::node& n) {
        p.answer_line = line_of(n);
        p.answer = expression(block, n);
    };
    keys["tolerance"] = [&](const toml::node& n) { p.tolerance = expression(block, n); };
    keys["unit"] = [&](const toml::node& n) { p.unit = short_text(block, n, longest_unit); };
    keys["choices"] = [&](const toml::node& n) {
        block.for_each_text(n, most_choices, [&](const std::string& text) {
            if (text.size() > longest_choice)
                throw UsageError(
                    fmt::format("a choice may have at most {} bytes.", longest_choice));
            if (std::find(p.choices.begin(), p.choices.end(), text) != p.choices.end())
                throw UsageError("there are two choices " + in_quotes(text) + ".");
            p.choices.push_back(text);
        });
        if (p.choices.size() < 2) block.input().fail(n, "there must be at least two choices.");
    };
    keys["right"] = [&](const toml::node& n) {
        p.answer_line = line_of(n);
        block.for_each_text(n, most_choices, [&](const std::string& text) {
            p.right.push_back(parse_condition(text));
        });
    };
    keys["where"] = [&](const toml::node& n) {
        p.answer_line = line_of(n);
        p.where = condition(block, n);
    };
    keys["recipe"] = [&](const toml::node& n) { p.right_pixel = block.pixel(n); };
    keys["wrong"] = [&](const toml::node& n) { p.wrong_pixel = block.pixel(n); };
    keys["at"] = [&](const toml::node& n) {
        p.at = combined(step, read_view_state(block.table(n), line_of(n), faults));
    };
    keys["then"] = [&](const toml::node& n) {
        p.then = combined(step, read_view_state(block.table(n), line_of(n), faults));
    };
    keys["because"] = [&](const toml::node& n) {
        p.because_line = line_of(n);
        p.because = block.text(n);
        refuse_numbers_in_code(p.because);
    };
    const toml::node* misconceptions = nullptr;
    keys["misconceptions"] = [&](const toml::node& n) { misconceptions = &n; };
    block.read(keys);
    for (const char* key : {"id", "kind"})
        block.require(key);
    // Reading them needs kind and choices, which may be below them.
    if (misconceptions != nullptr) {
        faults.attempt(line_of(*misconceptions),
                       [&] { p.misconceptions = read_misconceptions(block, *misconceptions, p); });
    }
    check_kind(block, p.kind);
    const auto size_of = [&](std::string_view key) -> std::size_t {
        const toml::node* const node = block.input().find(key);
        const toml::array* const list = node != nullptr ? node->as_array() : nullptr;
        return list != nullptr ? list->size() : 0;
    };
    if (p.kind == PredictionKind::choice && size_of("choices") != size_of("right")) {
        faults.add(p.answer_line, "'right' needs one condition for each choice.");
    }
    return p;
}

} // namespace rasterwalk
