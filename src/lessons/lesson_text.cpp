#include "lessons/lesson_text.h"

#include <algorithm>

#include "base/quoted.h"

namespace rasterwalk {

namespace {

/// Code, formulas and link targets are not looked for farther than this.
constexpr std::size_t longest_span = 2000;

class Scanner {
  public:
    Scanner(std::string_view text, int line, FaultList& faults)
        : text_(text), line_(line), faults_(faults) {}

    InlineParts scan() {
        while (at_ < text_.size()) {
            if (is_line_start_ && begin_line()) continue;
            step();
        }
        return std::move(parts_);
    }

  private:
    std::string_view rest() const { return text_.substr(at_); }

    void next_line() {
        bars_ = 0;
        at_ = std::min(text_.find('\n', at_), text_.size());
        if (at_ < text_.size()) ++at_;
        ++line_;
        is_line_start_ = true;
    }

    /// Code and empty lines are done with; returns true if the line is.
    bool begin_line() {
        is_line_start_ = false;
        const std::string_view line = rest().substr(0, rest().find('\n'));
        if (is_fence(line)) {
            in_code_ = !in_code_;
            open_.clear();
            next_line();
            return true;
        }
        if (in_code_) {
            next_line();
            return true;
        }
        if (trimmed(line).empty()) {
            open_.clear();
            emphasis_ = 0;
            next_line();
            return true;
        }
        check_depth(line);
        const std::string_view start = trimmed(line);
        const std::size_t close = start.find("]:");
        if (start.starts_with("[") && !start.starts_with("[^") && close != start.npos &&
            start.substr(0, close).find('(') == start.npos) {
            faults_.add(line_, "a link is written in its place: [words](target).");
        }
        return false;
    }

    /// How many bytes the mark of a list takes at the front of a line; 0 if there is none.
    static std::size_t list_mark(std::string_view line) {
        const std::size_t digits =
            std::min(line.find_first_not_of("0123456789"), std::min(line.size(), std::size_t{9}));
        const std::string_view after = line.substr(digits);
        const bool is_mark =
            after.size() >= 2 && after[1] == ' ' &&
            std::string_view(digits > 0 ? ".)" : "-*+").find(after[0]) != std::string_view::npos;
        return is_mark ? digits + 2 : 0;
    }

    /// Quotes and lists before the words of a line; a list within a list is indented by two blanks
    /// at least.
    void check_depth(std::string_view line) {
        std::size_t levels = 0;
        while (!line.empty()) {
            std::size_t length = 1;
            if (line[0] == ' ' || line[0] == '\t') {
                ++levels;
            } else if (line[0] == '>') {
                ++levels;
                if (line.starts_with("> ")) ++length;
            } else if ((length = list_mark(line)) > 0) {
                levels += 2;
            } else {
                break;
            }
            line.remove_prefix(length);
        }
        if (levels > static_cast<std::size_t>(deepest_lesson)) say_too_deep();
    }

    void say_too_deep() {
        if (told_depth_ == line_) return;
        told_depth_ = line_;
        faults_.refuse(line_, "the text is nested deeper than " + std::to_string(deepest_lesson) +
                                  " levels.");
    }

    void skip(std::size_t count) {
        const std::string_view passed = text_.substr(at_, count);
        line_ += static_cast<int>(std::count(passed.begin(), passed.end(), '\n'));
        at_ = std::min(at_ + count, text_.size());
    }

    void step() {
        const std::string_view here = rest();
        switch (here[0]) {
        case '\n':
            next_line();
            return;
        case '\\':
            skip(here.size() > 1 && here[1] != '\n' ? 2 : 1);
            return;
        case '`':
            skip_code();
            return;
        case '$':
            take_formula();
            return;
        case '<':
            check_angle();
            return;
        case '[':
            open_bracket();
            return;
        case '*':
        case '_':
            pass_emphasis();
            return;
        case '|':
            if (++bars_ == most_table_columns + 2) {
                faults_.refuse(line_, "a table has at most " + std::to_string(most_table_columns) +
                                          " columns.");
            }
            ++at_;
            return;
        case ']':
            close_bracket();
            return;
        default:
            ++at_;
        }
    }

    /// The same paragraph, as far as spans are looked for.
    std::string_view nearby() const {
        const std::string_view near = rest().substr(0, longest_span);
        return near.substr(0, near.find("\n\n"));
    }

    void skip_code() {
        const std::string_view near = nearby();
        const std::size_t ticks = std::min(near.find_first_not_of('`'), near.size());
        std::size_t end = ticks;
        while ((end = near.find('`', end)) != near.npos) {
            const std::size_t after = std::min(near.find_first_not_of('`', end), near.size());
            if (after - end == ticks) {
                skip(after);
                return;
            }
            end = after;
        }
        skip(ticks);
    }

    void take_formula() {
        const std::string_view near = nearby();
        const std::size_t dollars = near.starts_with("$$") ? 2 : 1;
        const std::string_view mark = near.substr(0, dollars);
        const std::size_t end = near.find(mark, dollars);
        const bool is_formula =
            end != near.npos && end > dollars && (dollars == 2 || near[1] != ' ');
        if (!is_formula) {
            skip(dollars);
            return;
        }
        parts_.formulas.push_back({std::string(near.substr(dollars, end - dollars)), line_});
        skip(end + dollars);
    }

    void check_angle() {
        const std::string_view near = nearby();
        const std::size_t end = near.find('>');
        const std::string_view inner = near.substr(1, end == near.npos ? 0 : end - 1);
        if (near.starts_with("<!--")) {
            faults_.add(line_, "a comment stands on lines of its own.");
        } else if (!inner.empty() && inner.find(' ') == inner.npos &&
                   inner.find(':') != inner.npos) {
            faults_.add(line_, "a link is written [words](target), not " +
                                   in_quotes(near.substr(0, end + 1)) + ".");
        }
        ++at_;
    }

    /// Counts roughly how deep emphasis stands in emphasis: a mark before a word opens, one behind
    /// a word closes.
    void pass_emphasis() {
        const char mark = text_[at_];
        const auto is_blank = [&](std::size_t i) {
            return i >= text_.size() ||
                   std::string_view(" \t\n").find(text_[i]) != std::string::npos;
        };
        const std::size_t end = std::min(text_.find_first_not_of(mark, at_), text_.size());
        const int count = static_cast<int>(end - at_);
        const bool may_open = !is_blank(end);
        const bool may_close = at_ > 0 && !is_blank(at_ - 1);
        const bool is_within_word = may_open && may_close;
        if (is_within_word && mark == '_') {
            // part of a name
        } else if (may_close && (!may_open || emphasis_ > 0)) {
            emphasis_ = std::max(0, emphasis_ - count);
        } else if (may_open) {
            emphasis_ += count;
        }
        at_ = end;
        if (emphasis_ > deepest_lesson) say_too_deep();
    }

    void open_bracket() {
        if (open_.size() > static_cast<std::size_t>(deepest_lesson)) {
            say_too_deep();
            open_.clear();
        }
        const bool is_picture = at_ > 0 && text_[at_ - 1] == '!';
        open_.push_back({at_ + 1, line_, is_picture});
        ++at_;
    }

    void close_bracket() {
        ++at_;
        if (open_.empty()) return;
        const Open open = open_.back();
        open_.pop_back();
        const std::string_view words = text_.substr(open.begin, at_ - 1 - open.begin);
        if (words.starts_with("^") && !rest().starts_with("(")) {
            parts_.footnotes.push_back({std::string(words.substr(1)), open.line});
            return;
        }
        if (!rest().starts_with("(")) return;
        const int line = line_;
        if (const std::optional<std::string> target = take_target()) {
            parts_.links.push_back({*target, std::string(words), line, open.is_picture});
        }
    }

    /// From the parenthesis to the one that closes it.
    std::optional<std::string> take_target() {
        const std::string_view near = nearby();
        if (near.starts_with("(<")) {
            const std::size_t end = near.find(">)");
            if (end == near.npos) return std::nullopt;
            skip(end + 2);
            return std::string(near.substr(2, end - 2));
        }
        int depth = 0;
        for (std::size_t i = 0; i < near.size(); ++i) {
            if (near[i] == '(') ++depth;
            if (near[i] == ')') --depth;
            if (depth == 0) {
                skip(i + 1);
                const std::string_view target = trimmed(near.substr(1, i - 1));
                if (target.find_first_of(" \t\n") != target.npos) {
                    faults_.add(line_, "the target of a link has no blanks: " + in_quotes(target) +
                                           "; write %20 for one.");
                    return std::nullopt;
                }
                return std::string(target);
            }
        }
        return std::nullopt;
    }

    struct Open {
        std::size_t begin; ///< of the words
        int line;
        bool is_picture;
    };

    std::string_view text_;
    std::size_t at_ = 0;
    int line_;
    bool is_line_start_ = true;
    bool in_code_ = false;
    int told_depth_ = 0;
    int emphasis_ = 0; ///< marks that are open
    int bars_ = 0;     ///< in the line so far: each ends a cell of a table
    std::vector<Open> open_;
    InlineParts parts_;
    FaultList& faults_;
};

} // namespace

InlineParts find_inline_parts(std::string_view text, int first_line, FaultList& faults) {
    return Scanner(text, first_line, faults).scan();
}

bool is_fence(std::string_view line) {
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    const std::string_view start = line.substr(indent);
    return start.starts_with("```") || start.starts_with("~~~");
}

} // namespace rasterwalk
