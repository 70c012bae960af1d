#include "lab_code/chosen_lines.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "base/text_parts.h"
#include "code/code_syntax.h"

namespace rasterwalk {

namespace {

/// None if it is not a condition: nothing but words, !, && and ||.
std::optional<bool> answer_of(const CodeExpression& condition, const CodeWord& holds) {
    if (condition.kind == CodeExpression::Kind::name) return holds(condition.text);
    std::vector<bool> parts; // all are read, whatever the first one is
    for (const CodeExpressionPtr& part : condition.parts) {
        const std::optional<bool> answer = answer_of(*part, holds);
        if (!answer) return std::nullopt;
        parts.push_back(*answer);
    }
    if (condition.kind == CodeExpression::Kind::unary && condition.text == "!") return !parts[0];
    if (condition.kind != CodeExpression::Kind::binary) return std::nullopt;
    if (condition.text == "&&") return parts[0] && parts[1];
    if (condition.text == "||") return parts[0] || parts[1];
    return std::nullopt;
}

/// An #if that is open.
struct OpenChoice {
    int line = 0;
    bool was_reached = false; ///< the lines around it are chosen
    bool has_chosen = false;  ///< one of its parts so far
    bool is_chosen = false;   ///< the part that is being read
    bool is_last = false;     ///< that part is the one after #else
};

/// Reads a file and chooses.
class Chooser {
  public:
    Chooser(const std::string& name, int file, const CodeWord& holds,
            std::vector<ChosenLine>& lines)
        : name_(&name), file_(file), holds_(&holds), lines_(&lines) {}

    void read(std::string_view text) {
        for (const std::string_view line : split_lines(text)) {
            ++line_;
            read_line(line);
        }
        if (!open_.empty()) fail(open_.back().line, "This #if has no #endif.");
    }

  private:
    [[noreturn]] void fail(int line, const std::string& sentence) const {
        throw InputError(*name_, line, sentence);
    }

    bool is_reached() const {
        return open_.empty() || (open_.back().was_reached && open_.back().is_chosen);
    }

    bool value_of(std::string_view text) const {
        std::optional<bool> answer;
        try {
            answer = answer_of(*parse_code_expression(text, *name_), *holds_);
        } catch (const InputError&) {
            // Said below.
        }
        if (!answer) fail(line_, "A condition has words, !, &&, || and parentheses.");
        return *answer;
    }

    void read_line(std::string_view line) {
        if (!line.starts_with('#')) {
            if (is_reached()) lines_->push_back({std::string(line), file_, line_});
        } else if (line.starts_with("#if ")) {
            const bool was_reached = is_reached(), is_chosen = value_of(line.substr(4));
            open_.push_back({line_, was_reached, is_chosen, is_chosen});
        } else if (line.starts_with("#elif ")) {
            next_part(value_of(line.substr(6)));
        } else if (line == "#else") {
            next_part(true);
            open_.back().is_last = true;
        } else if (line == "#endif") {
            if (open_.empty()) fail(line_, "There is no #if before this.");
            open_.pop_back();
        } else {
            fail(line_, "Only #if, #elif, #else and #endif are understood.");
        }
    }

    void next_part(bool holds) {
        if (open_.empty()) fail(line_, "There is no #if before this.");
        OpenChoice& choice = open_.back();
        if (choice.is_last) fail(line_, "#else is the last part of an #if.");
        choice.is_chosen = holds && !choice.has_chosen;
        choice.has_chosen = choice.has_chosen || choice.is_chosen;
    }

    const std::string* name_;
    int file_;
    const CodeWord* holds_;
    std::vector<ChosenLine>* lines_;
    std::vector<OpenChoice> open_;
    int line_ = 0;
};

bool has_text(const std::vector<std::string>& lines, const ChosenLine& line) {
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& one) {
        return shown_words(one) == shown_words(line.text);
    });
}

/// Longer helpers of a mistake are not what is wrong.
constexpr std::size_t most_lines_added = 2;
/// What would take more room is another program.
constexpr std::size_t most_lines_right = 8;

/// Lines of a mistake and the right ones in their place: one for one if there are as many, and the
/// last one has all of them if not.
/// @param before the line in front of them; null: there is none
void lay_side_by_side(const std::vector<ChosenLine*>& wrong, const std::vector<std::string>& right,
                      ChosenLine* before) {
    const bool is_like = wrong.size() == right.size();
    if (right.empty() && wrong.size() > most_lines_added) return;
    if (!is_like && std::max(wrong.size(), right.size()) > most_lines_right) return;
    ChosenLine* last = wrong.empty() ? before : wrong.back();
    for (std::size_t i = 0; i < wrong.size(); ++i) {
        if (has_text(is_like ? std::vector{right[i]} : right, *wrong[i])) continue;
        wrong[i]->is_mistake = true;
        if (is_like) wrong[i]->usual = {right[i]};
        last = wrong[i];
    }
    if (is_like || last == nullptr) return;
    for (const std::string& line : right) {
        const bool is_there = std::any_of(wrong.begin(), wrong.end(), [&](const ChosenLine* one) {
            return shown_words(one->text) == shown_words(line);
        });
        if (!is_there) last->usual.push_back(line);
    }
}

} // namespace

std::string_view shown_words(std::string_view line) {
    line = line.substr(0, line.find("//@"));
    return line.substr(0, line.find_last_not_of(' ') + 1);
}

void choose_lines(std::string_view text, const std::string& name, int file, const CodeWord& holds,
                  std::vector<ChosenLine>& lines) {
    Chooser(name, file, holds, lines).read(text);
}

void mark_mistakes(std::vector<ChosenLine>& lines, const std::vector<ChosenLine>& right) {
    std::vector<ChosenLine*> wrong_part; // between two lines that both have
    std::vector<std::string> right_part;
    ChosenLine* before = nullptr;
    std::size_t i = 0, j = 0;
    while (i < lines.size() || j < right.size()) {
        if (j == right.size() || (i < lines.size() && lines[i].line < right[j].line)) {
            wrong_part.push_back(&lines[i++]);
        } else if (i == lines.size() || right[j].line < lines[i].line) {
            right_part.push_back(right[j++].text);
        } else {
            lay_side_by_side(wrong_part, right_part, before);
            wrong_part.clear();
            right_part.clear();
            before = &lines[i++];
            ++j;
        }
    }
    lay_side_by_side(wrong_part, right_part, before);
}

} // namespace rasterwalk
