#include "mine/compile/source_text.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/text_parts.h"

namespace rasterwalk {

namespace {

/// Writes blanks over a range, but not over line breaks.
void blank_out(std::string& text, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < std::min(end, text.size()); ++i) {
        if (text[i] != '\n' && text[i] != '\r') text[i] = ' ';
    }
}

/// Behind a literal that begins here; one that is not closed ends with its line.
std::size_t end_of_literal(std::string_view text, std::size_t begin) {
    const char quote = text[begin];
    for (std::size_t i = begin + 1; i < text.size(); ++i) {
        if (text[i] == quote) return i + 1;
        if (text[i] == '\n') return i;
        if (text[i] == '\\') ++i;
    }
    return text.size();
}

/// Behind a raw literal whose quote is here: R"mark( ... )mark".
std::size_t end_of_raw_literal(std::string_view text, std::size_t quote) {
    const std::size_t open = text.find('(', quote);
    if (open == std::string_view::npos) return text.size();
    std::string closing = ")";
    closing += text.substr(quote + 1, open - quote - 1);
    closing += '"';
    const std::size_t close = text.find(closing, open);
    return close == std::string_view::npos ? text.size() : close + closing.size();
}

std::size_t end_of_comment(std::string_view text, std::size_t begin) {
    if (text[begin + 1] == '*') {
        const std::size_t close = text.find("*/", begin + 2);
        return close == std::string_view::npos ? text.size() : close + 2;
    }
    std::size_t end = text.find('\n', begin);
    // A backslash at its end continues it on the next line.
    while (end != std::string_view::npos && end > 0 &&
           (text[end - 1] == '\\' || (text[end - 1] == '\r' && end > 1 && text[end - 2] == '\\'))) {
        end = text.find('\n', end + 1);
    }
    return end == std::string_view::npos ? text.size() : end;
}

/// Blanks for comments, and for what is in quotes if that is asked for.
std::string reduced(std::string_view source, bool without_literals) {
    std::string text(source);
    for (std::size_t i = 0; i < source.size();) {
        const char letter = source[i];
        if (letter == '/' && i + 1 < source.size() &&
            (source[i + 1] == '/' || source[i + 1] == '*')) {
            const std::size_t end = end_of_comment(source, i);
            blank_out(text, i, end);
            i = end;
        } else if (letter == '"' || letter == '\'') {
            const bool is_raw = letter == '"' && i > 0 && source[i - 1] == 'R';
            // 1'000'000 holds no literal.
            const bool is_digit_mark = letter == '\'' && i > 0 && is_name_letter(source[i - 1]) &&
                                       std::isdigit(static_cast<unsigned char>(source[i - 1])) != 0;
            std::size_t end = i + 1;
            if (is_raw) end = end_of_raw_literal(source, i);
            if (!is_raw && !is_digit_mark) end = end_of_literal(source, i);
            if (without_literals) blank_out(text, i, end);
            i = end;
        } else {
            ++i;
        }
    }
    return text;
}

/// The directive of a line: "include", "if" ...; `rest` becomes what follows it. Empty: none.
std::string_view directive_of(std::string_view line, std::string_view& rest) {
    rest = trimmed(line);
    if (rest.empty() || rest.front() != '#') return {};
    rest = trimmed(rest.substr(1));
    std::size_t length = 0;
    while (length < rest.size() && is_name_letter(rest[length]))
        ++length;
    const std::string_view directive = rest.substr(0, length);
    rest = trimmed(rest.substr(length));
    return directive;
}

/// Calls do_line(begin, end) for each line; its end is that of its text.
template <typename DoLine>
void for_each_line(std::string_view text, const DoLine& do_line) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t found = text.find('\n', begin);
        const std::size_t end = found == std::string_view::npos ? text.size() : found;
        do_line(begin, end);
        begin = end + 1;
    }
}

void blank_out_unused(std::string& text) {
    int depth = 0; // of conditions inside the one that is false; 0: there is none
    const std::string lines = text;
    for_each_line(lines, [&](std::size_t begin, std::size_t end) {
        std::string_view rest;
        const std::string_view directive =
            directive_of(std::string_view(lines).substr(begin, end - begin), rest);
        if (depth == 0) {
            if (directive == "if" && (rest == "0" || rest == "false")) depth = 1;
            return;
        }
        if (directive.starts_with("if")) ++depth;
        if (directive == "endif") --depth;
        if (depth == 1 && directive.starts_with("el")) depth = 0;
        if (depth > 0) blank_out(text, begin, end);
    });
}

/// Names and signs of a bare text, one after the other.
std::vector<std::string_view> words_of(std::string_view code) {
    std::vector<std::string_view> words;
    for (std::size_t i = 0; i < code.size();) {
        std::size_t length = 1;
        if (is_name_letter(code[i])) {
            while (i + length < code.size() && is_name_letter(code[i + length]))
                ++length;
        } else if (code.substr(i, 2) == "::" || code.substr(i, 2) == "->") {
            length = 2;
        }
        if (std::isspace(static_cast<unsigned char>(code[i])) == 0) {
            words.push_back(code.substr(i, length));
        }
        i += length;
    }
    return words;
}

/// The place of the bracket that closes the one at `open`; none: the number of words.
std::size_t closing(const std::vector<std::string_view>& words, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < words.size(); ++i) {
        if (words[i] == "(" || words[i] == "{") ++depth;
        if (words[i] == ")" || words[i] == "}") --depth;
        if (depth == 0) return i;
    }
    return words.size();
}

bool is_keyword_before_bracket(std::string_view word) {
    constexpr std::string_view keywords[] = {
        "if",       "for",      "while",   "switch",        "return", "sizeof",   "catch",
        "decltype", "noexcept", "alignas", "__attribute__", "throw",  "operator", "explicit"};
    return std::find(std::begin(keywords), std::end(keywords), word) != std::end(keywords);
}

/// What follows the parameters of a function decides what it is: '{' a definition, ';' a
/// declaration, ' ' neither. `at` moves there.
char kind_of_function(const std::vector<std::string_view>& words, std::size_t& at) {
    for (; at < words.size(); ++at) {
        const std::string_view word = words[at];
        if (word == "{" || word == "try") return '{';
        if (word == ";") return ';';
        // Its constructor's members are set up.
        if (word == ":") {
            while (at < words.size() && words[at] != "{" && words[at] != ";")
                ++at;
            return at < words.size() && words[at] == "{" ? '{' : ' ';
        }
        if (word != "const" && word != "noexcept" && word != "->" && word != "override" &&
            word != "::" && word != "&" && !is_name_letter(word.front())) {
            return ' ';
        }
    }
    return ' ';
}

void sort_once(std::vector<std::string>& names) {
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
}

} // namespace

bool is_name_letter(char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}

std::string read_source(const std::string& path) {
    refuse_endless_file(path);
    std::string text = read_file(path, largest_source);
    const std::string_view start = std::string_view(text).substr(0, 4);
    if (start.starts_with("\xff\xfe") || start.starts_with("\xfe\xff")) {
        throw InputError(fmt::format("{}: the file is UTF-16. Save it as UTF-8.", path));
    }
    if (start.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    const std::size_t zero = text.find('\0');
    if (zero != std::string::npos) {
        const auto line = std::count(text.begin(), text.begin() + static_cast<long>(zero), '\n');
        throw InputError(path, static_cast<int>(line) + 1,
                         "the file is no text: it holds a byte of value 0.");
    }
    return text;
}

std::string without_comments(std::string_view source) {
    std::string text = reduced(source, false);
    blank_out_unused(text);
    return text;
}

std::string bare_code(std::string_view source) {
    std::string text = reduced(source, true);
    blank_out_unused(text);
    const std::string lines = text;
    bool is_continued = false;
    for_each_line(lines, [&](std::size_t begin, std::size_t end) {
        const std::string_view line = trimmed(std::string_view(lines).substr(begin, end - begin));
        const bool is_directive = is_continued || line.starts_with('#');
        is_continued = is_directive && line.ends_with('\\');
        if (is_directive) blank_out(text, begin, end);
    });
    return text;
}

std::vector<Include> includes_of(std::string_view source) {
    std::vector<Include> includes;
    const std::string text = without_comments(source);
    for_each_line(text, [&](std::size_t begin, std::size_t end) {
        std::string_view rest;
        const std::string_view line = std::string_view(text).substr(begin, end - begin);
        const std::string_view directive = directive_of(line, rest);
        if (directive != "include" && directive != "import") return;
        if (rest.size() < 2 || (rest.front() != '"' && rest.front() != '<')) return;
        const std::size_t close = rest.find(rest.front() == '"' ? '"' : '>', 1);
        if (close == std::string_view::npos || close == 1) return;
        Include include;
        include.begin = static_cast<std::size_t>(rest.data() - text.data());
        include.end = include.begin + close + 1;
        include.name = rest.substr(1, close - 1);
        include.is_quoted = rest.front() == '"';
        includes.push_back(include);
    });
    return includes;
}

FunctionNames function_names(std::string_view source) {
    FunctionNames names;
    const std::string code = bare_code(source);
    const std::vector<std::string_view> words = words_of(code);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string_view word = words[i];
        if (word == "{") {
            // Namespaces are looked into, classes and bodies are not.
            const bool is_namespace =
                i >= 1 && (words[i - 1] == "namespace" || words[i - 1] == "extern" ||
                           (i >= 2 && words[i - 2] == "namespace"));
            if (!is_namespace) i = closing(words, i);
            continue;
        }
        if (word != "(") continue;
        const std::size_t close = closing(words, i);
        std::size_t at = close + 1;
        if (i >= 2 && is_name_letter(words[i - 1].front()) &&
            !is_keyword_before_bracket(words[i - 1])) {
            std::string name(words[i - 1]);
            const bool is_member = words[i - 2] == "::" && i >= 3;
            if (is_member) name = std::string(words[i - 3]) + "::" + name;
            const char kind = kind_of_function(words, at);
            const std::string_view before = words[i - 2];
            const bool has_type = is_member || is_name_letter(before.front()) || before == "*" ||
                                  before == "&" || before == ">";
            if (kind == '{') names.defined.push_back(name);
            if (kind == ';' && has_type) names.declared.push_back(name);
        }
        // The body, or what follows, is looked at next.
        i = std::max(close, at == 0 ? at : at - 1);
    }
    sort_once(names.declared);
    sort_once(names.defined);
    return names;
}

} // namespace rasterwalk
