#include "mine/source_lines.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "base/letter_case.h"
#include "base/quoted.h"
#include "mine/compile/source_text.h"

namespace rasterwalk {

namespace {

constexpr std::size_t most_letters = 400;  ///< of a line: what is shown ends there
constexpr std::size_t most_of_head = 2000; ///< letters from a function's bracket to its body
constexpr std::string_view tab_blanks = "    ";

/// A line as it can be shown.
std::string shown_line(std::string_view line) {
    std::string shown;
    for (const char c : line.substr(0, most_letters)) {
        if (c == '\t') {
            shown += tab_blanks;
        } else if (c != '\r') {
            shown += c;
        }
    }
    return visible_line(shown);
}

/// The number of the line that this place is in, from 1.
int line_at(std::string_view text, std::size_t place) {
    return 1 + static_cast<int>(std::count(
                   text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

/// Does a definition's body follow the brackets that open here? A declaration or a call ends with
/// a semicolon or goes on with something else.
bool has_body(std::string_view code, std::size_t open) {
    int depth = 0;
    const std::size_t end = std::min(code.size(), open + most_of_head);
    for (std::size_t i = open; i < end; ++i) {
        const char c = code[i];
        if (c == '(') ++depth;
        if (c == ')' && --depth < 0) return false; // it was called within other brackets
        if (depth > 0 || c == ')') continue;
        if (c == '{') return true;
        // `const`, `noexcept` or `-> Pixel` may come before the body.
        const bool is_between = is_name_letter(c) || c == '-' || c == '>' || c == ':' ||
                                std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!is_between) return false;
    }
    return false;
}

/// The line on which a source defines the function; 0: it does not.
int line_of_definition(const std::string& source, std::string_view name) {
    const std::string code = bare_code(source);
    const std::string small = in_small_letters(code);
    const std::string wanted = in_small_letters(std::string(name));
    for (std::size_t at = small.find(wanted); at != small.npos; at = small.find(wanted, at + 1)) {
        std::size_t open = at + wanted.size();
        if (at > 0 && is_name_letter(code[at - 1])) continue;
        while (open < code.size() && std::isspace(static_cast<unsigned char>(code[open])) != 0)
            ++open;
        if (open < code.size() && code[open] == '(' && has_body(code, open))
            return line_at(code, at);
    }
    return 0;
}

} // namespace

SourceLines source_lines(const ProgramPlace& place, int before, int after) {
    SourceLines found;
    if (place.line <= 0 || place.file.empty()) return found;
    std::string text;
    try {
        text = read_source(place.file);
    } catch (const Error&) {
        return found; // it has been moved or is being written
    }
    found.first = std::max(1, place.line - before);
    std::size_t begin = 0;
    for (int number = 1; number <= place.line + after && begin < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (number >= found.first)
            found.lines.push_back(shown_line(std::string_view(text).substr(begin, end - begin)));
        begin = end + 1;
    }
    const auto count = static_cast<int>(found.lines.size());
    if (found.first + count <= place.line) found.lines.clear();
    return found;
}

ProgramPlace definition_of(const StudentFiles& files, std::string_view name) {
    std::vector<std::string> sources{files.main};
    sources.insert(sources.end(), files.sources.begin(), files.sources.end());
    for (const std::string& source : sources) {
        try {
            if (const int line = line_of_definition(read_source(source), name); line > 0)
                return {std::string(name), source, line};
        } catch (const Error&) {
            continue; // it has been moved or is being written
        }
    }
    return {};
}

std::string shown_path(const StudentFiles& files, const std::string& path) {
    const bool is_inside = path.starts_with(files.folder + '/');
    return is_inside ? path.substr(files.folder.size() + 1) : path;
}

} // namespace rasterwalk
