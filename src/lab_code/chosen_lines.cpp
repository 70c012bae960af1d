#include "lab_code/chosen_lines.h"

#include <optional>

#include "base/error.h"
#include "base/text_parts.h"
#include "code/code_syntax.h"

namespace rasterwalk {

namespace {

/// What a condition says, and whether a mistake holds that it names.
struct Answer {
    bool holds = false, is_mistaken = false;
};

/// None if it is not a condition: nothing but words, !, && and ||.
std::optional<Answer> answer_of(const CodeExpression& condition, const CodeWords& words) {
    if (condition.kind == CodeExpression::Kind::name) {
        const bool holds = words.holds(condition.text);
        return Answer{holds, holds && words.is_mistake(condition.text)};
    }
    std::vector<Answer> parts; // all are read, whatever the first one is
    for (const CodeExpressionPtr& part : condition.parts) {
        const std::optional<Answer> answer = answer_of(*part, words);
        if (!answer) return std::nullopt;
        parts.push_back(*answer);
    }
    if (condition.kind == CodeExpression::Kind::unary && condition.text == "!")
        return Answer{!parts[0].holds, parts[0].is_mistaken};
    if (condition.kind != CodeExpression::Kind::binary) return std::nullopt;
    const bool is_mistaken = parts[0].is_mistaken || parts[1].is_mistaken;
    if (condition.text == "&&") return Answer{parts[0].holds && parts[1].holds, is_mistaken};
    if (condition.text == "||") return Answer{parts[0].holds || parts[1].holds, is_mistaken};
    return std::nullopt;
}

/// An #if that is open.
struct OpenChoice {
    int line = 0;
    bool was_reached = false; ///< the lines around it are chosen
    bool has_chosen = false;  ///< one of its parts so far
    bool is_chosen = false;   ///< the part that is being read
    bool is_usual = false;    ///< that part is the one after #else
    bool is_mistaken = false; ///< the part that was chosen is a mistake's
    std::size_t first = 0;    ///< of the lines of the part that was chosen before #else
    std::size_t end = 0;
    std::vector<std::string> usual; ///< lines after #else that are not chosen
};

/// Reads a file and chooses.
class Chooser {
  public:
    Chooser(const std::string& name, int file, const CodeWords& words,
            std::vector<ChosenLine>& lines)
        : name_(&name), file_(file), words_(&words), lines_(&lines) {}

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

    bool is_reached() const { return open_.empty() || open_.back().is_chosen; }

    Answer value_of(std::string_view text) const {
        std::optional<Answer> answer;
        try {
            answer = answer_of(*parse_code_expression(text, *name_), *words_);
        } catch (const InputError&) {
            // Said below.
        }
        if (!answer) fail(line_, "A condition has words, !, &&, || and parentheses.");
        return *answer;
    }

    void read_line(std::string_view line) {
        if (!line.starts_with('#')) {
            keep(line);
        } else if (line.starts_with("#if ")) {
            begin(line.substr(4));
        } else if (line.starts_with("#elif ")) {
            next_part(value_of(line.substr(6)), false);
        } else if (line == "#else") {
            next_part({true, false}, true);
        } else if (line == "#endif") {
            end();
        } else {
            fail(line_, "Only #if, #elif, #else and #endif are understood.");
        }
    }

    void keep(std::string_view line) {
        if (is_reached()) {
            lines_->push_back({std::string(line), file_, line_, {}});
        } else if (open_.back().was_reached && open_.back().is_usual) {
            open_.back().usual.emplace_back(line);
        }
    }

    void begin(std::string_view condition) {
        OpenChoice choice;
        choice.line = line_;
        choice.was_reached = is_reached();
        const Answer answer = value_of(condition);
        choice.is_chosen = choice.was_reached && answer.holds;
        choice.is_mistaken = answer.is_mistaken;
        choice.has_chosen = choice.is_chosen;
        choice.first = choice.end = lines_->size();
        open_.push_back(choice);
    }

    void next_part(const Answer& answer, bool is_usual) {
        if (open_.empty()) fail(line_, "There is no #if before this.");
        OpenChoice& choice = open_.back();
        if (choice.is_usual) fail(line_, "#else is the last part of an #if.");
        if (choice.is_chosen) choice.end = lines_->size();
        choice.is_chosen = choice.was_reached && answer.holds && !choice.has_chosen;
        if (choice.is_chosen) {
            choice.first = choice.end = lines_->size();
            choice.is_mistaken = answer.is_mistaken;
        }
        choice.has_chosen = choice.has_chosen || choice.is_chosen;
        choice.is_usual = is_usual;
    }

    /// The lines of a mistake know those after #else: one for one.
    void end() {
        if (open_.empty()) fail(line_, "There is no #if before this.");
        const OpenChoice& choice = open_.back();
        const bool is_like = choice.is_mistaken && choice.end - choice.first == choice.usual.size();
        for (std::size_t i = 0; is_like && i < choice.usual.size(); ++i) {
            ChosenLine& chosen = (*lines_)[choice.first + i];
            if (chosen.text != choice.usual[i]) chosen.usual = choice.usual[i];
        }
        open_.pop_back();
    }

    const std::string* name_;
    int file_;
    const CodeWords* words_;
    std::vector<ChosenLine>* lines_;
    std::vector<OpenChoice> open_;
    int line_ = 0;
};

} // namespace

void choose_lines(std::string_view text, const std::string& name, int file, const CodeWords& words,
                  std::vector<ChosenLine>& lines) {
    Chooser(name, file, words, lines).read(text);
}

} // namespace rasterwalk
