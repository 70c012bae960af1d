#include <algorithm>
#include <array>
#include <optional>

#include "base/quoted.h"
#include "lessons/lesson_check.h"

namespace rasterwalk {

namespace {

/// The commands that the program draws, beside those that take something: \frac{a}{b}.
constexpr std::array<std::string_view, 44> signs{
    "cdot",  "times", "le",    "leq",   "ge",    "geq",   "ne",      "approx", "to",
    "pm",    "infty", "ldots", "dots",  "sum",   "max",   "min",     "cos",    "sin",
    "tan",   "alpha", "beta",  "gamma", "delta", "Delta", "epsilon", "theta",  "lambda",
    "mu",    "pi",    "rho",   "sigma", "phi",   "omega", "lfloor",  "rfloor", "lvert",
    "rvert", "quad",  ",",     ";",     "{",     "}",     "_",       "$"};

/// How many arguments a command takes; none if there is no such command.
std::optional<int> argument_count(std::string_view command) {
    if (command == "frac") return 2;
    constexpr std::array<std::string_view, 9> takers{"sqrt",   "hat",    "vec",  "bar",  "text",
                                                     "mathrm", "texttt", "left", "right"};
    if (std::find(takers.begin(), takers.end(), command) != takers.end()) return 1;
    if (std::find(signs.begin(), signs.end(), command) != signs.end()) return 0;
    return std::nullopt;
}

/// Reads a formula as the program draws it, and writes down what it cannot.
class FormulaReader {
  public:
    explicit FormulaReader(std::string_view tex) : whole_(tex), rest_(tex) {}

    std::vector<std::string> read() {
        while (!rest_.empty()) {
            row(0);
            if (rest_.starts_with('}')) {
                mismatch();
                rest_.remove_prefix(1);
            }
        }
        return std::move(faults_);
    }

  private:
    void say(const std::string& sentence) {
        if (std::find(faults_.begin(), faults_.end(), sentence) == faults_.end()) {
            faults_.push_back(sentence);
        }
    }
    void mismatch() { say("the braces of the formula " + in_quotes(whole_) + " do not match."); }

    void say_too_deep() {
        say("the formula " + in_quotes(whole_) + " is nested deeper than " +
            std::to_string(deepest_formula) + " levels.");
        is_too_deep_ = true;
        rest_ = {};
    }

    void skip_blanks() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \n"), rest_.size()));
    }

    /// Up to the brace that closes it, or to the end.
    void row(int depth) {
        bool has_script[2] = {false, false};
        for (skip_blanks(); !rest_.empty() && rest_[0] != '}'; skip_blanks()) {
            const char c = rest_[0];
            if (c != '^' && c != '_') {
                has_script[0] = has_script[1] = false;
                atom(depth);
                continue;
            }
            rest_.remove_prefix(1);
            bool& has_one = has_script[c == '^' ? 0 : 1];
            if (has_one) say("the formula " + in_quotes(whole_) + " has two scripts in one place.");
            has_one = true;
            argument(c == '^' ? "^" : "_", depth);
        }
    }

    void group(int depth) {
        if (depth > deepest_formula) return say_too_deep();
        rest_.remove_prefix(1);
        row(depth + 1);
        if (rest_.empty()) {
            if (!is_too_deep_) mismatch();
            return;
        }
        rest_.remove_prefix(1);
    }

    void atom(int depth) {
        if (depth > deepest_formula) {
            say_too_deep();
        } else if (rest_[0] == '{') {
            group(depth);
        } else if (rest_[0] == '\\') {
            command(depth);
        } else {
            rest_.remove_prefix(1);
        }
    }

    void argument(const std::string& of, int depth) {
        skip_blanks();
        if (rest_.empty() || rest_[0] == '}') {
            say(in_quotes(of) + " has nothing to stand on in the formula " + in_quotes(whole_) +
                ".");
        } else if (rest_[0] == '{') {
            group(depth);
        } else {
            atom(depth + 1);
        }
    }

    void command(int depth) {
        rest_.remove_prefix(1);
        const auto is_letter = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        };
        const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_letter);
        std::size_t length = static_cast<std::size_t>(end - rest_.begin());
        if (length == 0 && !rest_.empty()) length = 1;
        const std::string name(rest_.substr(0, length));
        rest_.remove_prefix(length);
        const std::optional<int> count = argument_count(name);
        if (!count) {
            say("the program cannot draw " + in_quotes("\\" + name) + " in a formula.");
            return;
        }
        for (int i = 0; i < *count; ++i)
            argument("\\" + name, depth);
    }

    std::string_view whole_, rest_;
    bool is_too_deep_ = false;
    std::vector<std::string> faults_;
};

} // namespace

std::vector<std::string> formula_faults(std::string_view tex) {
    return FormulaReader(tex).read();
}

} // namespace rasterwalk
