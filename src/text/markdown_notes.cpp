#include "text/markdown_notes.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "base/text_parts.h"
#include "text/markdown_text.h"

namespace rasterwalk {

namespace {

constexpr std::string_view opening = "[^";

/// 12 in raised digits.
std::string raised_number(std::size_t number) {
    static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char c : std::to_string(number))
        text += digits[c - '0'];
    return text;
}

/// The notes of a text, by id; their lines are taken out of `lines`.
std::map<std::string, std::string> take_definitions(std::vector<std::string_view>& lines) {
    std::map<std::string, std::string> definitions;
    std::vector<std::string_view> kept;
    bool in_code = false;
    std::string* open = nullptr; // the note that an indented line continues
    for (const std::string_view line : lines) {
        if (is_fence(line)) in_code = !in_code;
        const std::string_view id = in_code ? std::string_view() : footnote_label(line);
        const std::size_t colon = id.size() + opening.size() + 1;
        if (!id.empty() && line.size() > colon && line[colon] == ':') {
            const std::size_t start = std::min(line.find_first_not_of(' ', colon + 1), line.size());
            open = &(definitions[std::string(id)] = line.substr(start));
        } else if (open != nullptr && line.starts_with("  ") && !in_code) {
            const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
            *open += ' ';
            *open += line.substr(start);
        } else {
            open = nullptr;
            kept.push_back(line);
        }
    }
    lines = std::move(kept);
    return definitions;
}

/// Replaces the references in one line by links.
class Linker {
  public:
    explicit Linker(const std::map<std::string, std::string>& definitions)
        : definitions_(definitions) {}

    void add(std::string_view line, std::string& out) {
        bool in_code = false;
        for (std::size_t i = 0; i < line.size();) {
            if (line[i] == '`') in_code = !in_code;
            const std::string_view id =
                in_code ? std::string_view() : footnote_label(line.substr(i));
            const std::size_t number = id.empty() ? 0 : number_of(std::string(id));
            if (number == 0) {
                out += line[i++];
                continue;
            }
            out += '[';
            out += raised_number(number);
            out += "](note:";
            out += std::to_string(number);
            out += ')';
            i += opening.size() + id.size() + 1;
        }
    }

    std::vector<std::string> notes;

  private:
    /// From 1; 0 if there is no such note.
    std::size_t number_of(const std::string& id) {
        const auto known = numbers_.find(id);
        if (known != numbers_.end()) return known->second;
        const auto definition = definitions_.find(id);
        if (definition == definitions_.end() || notes.size() >= most_footnotes) return 0;
        notes.push_back(definition->second);
        return numbers_[id] = notes.size();
    }

    const std::map<std::string, std::string>& definitions_;
    std::map<std::string, std::size_t> numbers_;
};

} // namespace

std::string_view footnote_label(std::string_view text) {
    if (!text.starts_with(opening)) return {};
    const std::size_t end = text.find_first_of("] \n");
    if (end == text.npos || text[end] != ']') return {};
    return text.substr(opening.size(), end - opening.size());
}

std::vector<std::string> take_footnotes(std::string& markdown) {
    if (markdown.find(opening) == markdown.npos) return {};
    std::vector<std::string_view> lines = split_lines(markdown);
    const std::map<std::string, std::string> definitions = take_definitions(lines);
    if (definitions.empty()) return {};
    Linker linker(definitions);
    std::string text;
    bool in_code = false;
    for (const std::string_view line : lines) {
        if (is_fence(line)) in_code = !in_code;
        if (in_code) {
            text += line;
        } else {
            linker.add(line, text);
        }
        text += '\n';
    }
    if (!linker.notes.empty()) text += "\n---\n\n";
    for (std::size_t i = 0; i < linker.notes.size(); ++i) {
        text += std::to_string(i + 1);
        text += ". ";
        text += linker.notes[i];
        text += '\n';
    }
    markdown = std::move(text);
    return std::move(linker.notes);
}

} // namespace rasterwalk
