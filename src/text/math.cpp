#include "text/math.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/quoted.h"
#include "base/text_parts.h"
#include "explain/vectors.h"

namespace rasterwalk {

namespace {

using NodeKind = MathNode::Kind;
using Style = MathNode::Style;

struct Command {
    std::string_view name, sign;
    Style style;
};

constexpr std::array commands{
    Command{"cdot", "·", Style::relation},   Command{"times", "×", Style::relation},
    Command{"le", "≤", Style::relation},     Command{"leq", "≤", Style::relation},
    Command{"ge", "≥", Style::relation},     Command{"geq", "≥", Style::relation},
    Command{"ne", "≠", Style::relation},     Command{"approx", "≈", Style::relation},
    Command{"to", "→", Style::relation},     Command{"pm", "±", Style::relation},
    Command{"infty", "∞", Style::upright},   Command{"ldots", "…", Style::upright},
    Command{"dots", "…", Style::upright},    Command{"sum", "∑", Style::upright},
    Command{"max", " max", Style::upright},  Command{"min", " min", Style::upright},
    Command{"cos", " cos", Style::upright},  Command{"sin", " sin", Style::upright},
    Command{"tan", " tan", Style::upright},  Command{"alpha", "α", Style::slanted},
    Command{"beta", "β", Style::slanted},    Command{"gamma", "γ", Style::slanted},
    Command{"delta", "δ", Style::slanted},   Command{"Delta", "Δ", Style::upright},
    Command{"epsilon", "ε", Style::slanted}, Command{"theta", "θ", Style::slanted},
    Command{"lambda", "λ", Style::slanted},  Command{"mu", "μ", Style::slanted},
    Command{"pi", "π", Style::slanted},      Command{"rho", "ρ", Style::slanted},
    Command{"sigma", "σ", Style::slanted},   Command{"phi", "φ", Style::slanted},
    Command{"omega", "ω", Style::slanted},   Command{"lfloor", "⌊", Style::upright},
    Command{"rfloor", "⌋", Style::upright},  Command{"lvert", "|", Style::upright},
    Command{"rvert", "|", Style::upright},   Command{",", " ", Style::upright},
    Command{";", " ", Style::upright},       Command{"quad", "  ", Style::upright},
    Command{"{", "{", Style::upright},       Command{"}", "}", Style::upright},
    Command{"_", "_", Style::upright},       Command{"$", "$", Style::upright},
};

MathNode symbol(std::string_view text, Style style = Style::upright) {
    return {NodeKind::symbol, std::string(text), style, {}};
}

class Reader {
  public:
    Reader(std::string_view tex, std::vector<std::string>* faults)
        : whole_(tex), rest_(tex), faults_(faults) {}

    /// Everything, even what follows a brace that closes nothing.
    MathNode read() {
        MathNode formula = row(0);
        while (!rest_.empty()) {
            MathNode more = row(0);
            for (MathNode& child : more.children)
                formula.children.push_back(std::move(child));
        }
        return formula;
    }

  private:
    /// Everything up to the closing brace, or to the end; `depth` is 0 outside all braces.
    MathNode row(int depth);
    MathNode group(int depth);
    MathNode atom(int depth);
    MathNode argument(const std::string& of, int depth);
    MathNode command(int depth);
    MathNode scripts(MathNode base, int depth);
    std::string_view raw_argument(const std::string& of);
    std::string_view take_command();
    void skip_blanks() {
        while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\n'))
            rest_.remove_prefix(1);
    }
    bool take(char c) {
        if (rest_.empty() || rest_[0] != c) return false;
        rest_.remove_prefix(1);
        return true;
    }

    bool is_at_end() {
        skip_blanks();
        return rest_.empty() || rest_[0] == '}';
    }

    /// Adds a sentence once, and none after too deep a nesting.
    void say(std::string sentence) {
        if (faults_ == nullptr || is_too_deep_) return;
        if (std::find(faults_->begin(), faults_->end(), sentence) == faults_->end()) {
            faults_->push_back(std::move(sentence));
        }
    }
    void report_no_match() {
        say("the braces of the formula " + in_quotes(whole_) + " do not match.");
    }
    void report_missing(const std::string& of) {
        say(in_quotes(of) + " has nothing to act on in the formula " + in_quotes(whole_) + ".");
    }
    void record_depth(int depth) {
        if (depth <= deepest_formula) return;
        say("the formula " + in_quotes(whole_) + " is nested deeper than " +
            std::to_string(deepest_formula) + " levels.");
        is_too_deep_ = true;
    }

    std::string_view whole_, rest_;
    std::vector<std::string>* faults_; ///< null: not collected
    bool is_too_deep_ = false;
};

MathNode Reader::row(int depth) {
    MathNode result;
    if (depth >= deepest_math) rest_ = {};
    for (skip_blanks(); !rest_.empty(); skip_blanks()) {
        if (take('}')) {
            if (depth == 0) report_no_match();
            return result;
        }
        result.children.push_back(scripts(atom(depth), depth));
    }
    if (depth > 0) report_no_match();
    return result;
}

/// The content of braces; the first has already been taken.
MathNode Reader::group(int depth) {
    record_depth(depth);
    return row(depth + 1);
}

MathNode Reader::scripts(MathNode base, int depth) {
    MathNode script{NodeKind::script, {}, Style::upright, {std::move(base), {}, {}}};
    bool is_script = false;
    std::array<bool, 3> has_one{};
    for (skip_blanks(); !rest_.empty(); skip_blanks()) {
        const char c = rest_[0];
        if (c != '^' && c != '_') break;
        rest_.remove_prefix(1);
        const std::size_t place = c == '^' ? 1 : 2;
        if (has_one[place]) {
            say("the formula " + in_quotes(whole_) +
                " has two subscripts or superscripts in one "
                "place.");
        }
        has_one[place] = is_script = true;
        script.children[place] = argument(std::string(1, c), depth);
    }
    return is_script ? script : std::move(script.children[0]);
}

/// What follows a command or a script: a group in braces, or one symbol.
MathNode Reader::argument(const std::string& of, int depth) {
    if (depth >= deepest_math) rest_ = {};
    if (is_at_end()) {
        report_missing(of);
        return {};
    }
    if (take('{')) return group(depth);
    return atom(depth + 1);
}

/// The text in braces, unchanged.
std::string_view Reader::raw_argument(const std::string& of) {
    if (is_at_end()) report_missing(of);
    if (!take('{')) return {};
    if (rest_.find('}') == rest_.npos) report_no_match();
    return take_part(rest_, '}');
}

MathNode Reader::atom(int depth) {
    const char c = rest_[0];
    if (take('{')) return group(depth);
    record_depth(depth);
    if (take('\\')) return command(depth);
    if ((c == '^' || c == '_') && rest_.size() == 1) report_missing(std::string(1, c));
    const auto byte = static_cast<unsigned char>(c);
    if (std::isdigit(byte) != 0) {
        std::size_t end = 0;
        while (end < rest_.size() &&
               (std::isdigit(static_cast<unsigned char>(rest_[end])) != 0 || rest_[end] == '.'))
            ++end;
        if (rest_[end - 1] == '.' && end > 1) --end; // the end of a sentence
        const MathNode number = symbol(rest_.substr(0, end));
        rest_.remove_prefix(end);
        return number;
    }
    std::size_t length = 1;
    while (byte >= 0x80 && length < rest_.size() &&
           (static_cast<unsigned char>(rest_[length]) & 0xC0u) == 0x80u)
        ++length;
    const std::string_view text = rest_.substr(0, length);
    rest_.remove_prefix(length);
    if (std::isalpha(byte) != 0) return symbol(text, Style::slanted);
    if (text == "-") return symbol("−", Style::relation);
    if (text == "*") return symbol("·", Style::relation);
    if (text == "=" || text == "<" || text == ">" || text == "+") {
        return symbol(text, Style::relation);
    }
    if (text == ",") return symbol(", ");
    return symbol(text);
}

/// The name of a command; its backslash has already been taken.
std::string_view Reader::take_command() {
    std::size_t length = 0;
    while (length < rest_.size() && std::isalpha(static_cast<unsigned char>(rest_[length])) != 0)
        ++length;
    if (length == 0 && !rest_.empty()) length = 1;
    const std::string_view name = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return name;
}

MathNode Reader::command(int depth) {
    const std::string_view name = take_command();
    const std::string written = "\\" + std::string(name);
    if (name == "frac") {
        MathNode top = argument(written, depth);
        MathNode bottom = argument(written, depth);
        return {NodeKind::fraction, {}, Style::upright, {std::move(top), std::move(bottom)}};
    }
    if (name == "sqrt") return {NodeKind::root, {}, Style::upright, {argument(written, depth)}};
    if (name == "hat" || name == "vec" || name == "bar") {
        const char* const mark = name == "hat" ? "ˆ" : name == "vec" ? "→" : "¯";
        return {NodeKind::accent, mark, Style::upright, {argument(written, depth)}};
    }
    if (name == "text" || name == "mathrm" || name == "texttt") {
        return symbol(raw_argument(written));
    }
    if (name == "left" || name == "right") {
        // The bracket itself follows; a dot means none.
        if (is_at_end()) report_missing(written);
        if (is_at_end() || take('.')) return {};
        return atom(depth);
    }
    const auto* const known = std::find_if(commands.begin(), commands.end(),
                                           [&](const Command& c) { return c.name == name; });
    if (known != commands.end()) return symbol(known->sign, known->style);
    say("the program cannot draw " + in_quotes(written) + " in a formula.");
    return symbol(written);
}

/// A sign at the beginning, or after another sign or a bracket, belongs to what follows, without
/// blanks.
void settle_signs(MathNode& node) {
    bool at_start = true;
    for (MathNode& child : node.children) {
        const bool is_relation = child.kind == NodeKind::symbol && child.style == Style::relation;
        if (is_relation && at_start) child.style = Style::upright;
        at_start = node.kind == NodeKind::row && child.kind == NodeKind::symbol &&
                   (is_relation || child.text == "(" || child.text == "[" || child.text == ", ");
        settle_signs(child);
        if (node.kind != NodeKind::row) at_start = true;
    }
}

} // namespace

MathNode parse_math(std::string_view tex, std::vector<std::string>* faults) {
    constexpr std::size_t longest = 2000;
    MathNode formula = Reader(tex.substr(0, longest), faults).read();
    settle_signs(formula);
    return formula;
}

char vector_letter(const MathNode& node) {
    const bool is_letter = node.kind == NodeKind::symbol && node.style == Style::slanted &&
                           node.text.size() == 1 && is_vector_letter(node.text.front());
    return is_letter ? node.text.front() : char{0};
}

} // namespace rasterwalk
