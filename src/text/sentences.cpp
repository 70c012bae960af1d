#include "text/sentences.h"

#include <algorithm>
#include <cctype>

namespace rasterwalk {

namespace {

std::string_view next_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

bool is_blank(std::string_view line) {
    return line.find_first_not_of(" \t\r") == line.npos;
}

bool begins_code(std::string_view line) {
    return line.starts_with("```") || line.starts_with("~~~");
}

/// Does this line begin a block that is read as something else than running text?
bool begins_other_block(std::string_view line) {
    for (const std::string_view mark :
         {"#", "|", ">", "- ", "* ", "+ ", "![", "<!--", "$$", "    ", "\t", "---", "***", "[^"}) {
        if (line.starts_with(mark)) return true;
    }
    const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
    return digits > 0 && line.substr(digits).starts_with(". ");
}

std::string first_paragraph(std::string_view text) {
    std::string paragraph;
    while (!text.empty()) {
        const std::string_view line = next_line(text);
        if (begins_code(line)) {
            if (!paragraph.empty()) return paragraph;
            while (!text.empty() && !begins_code(next_line(text))) {
            }
        } else if (is_blank(line)) {
            if (!paragraph.empty()) return paragraph;
        } else if (paragraph.empty() && begins_other_block(line)) {
            // What goes on without a mark of its own belongs to it.
            while (!text.empty() && !is_blank(next_line(text))) {
            }
        } else {
            if (!paragraph.empty()) paragraph += '\n';
            paragraph.append(line);
        }
    }
    return paragraph;
}

std::string without_notes(std::string text) {
    for (std::size_t at = text.find("[^"); at != text.npos; at = text.find("[^", at)) {
        const std::size_t end = text.find(']', at);
        if (end == text.npos) break;
        text.erase(at, end + 1 - at);
    }
    return text;
}

/// What is open at a place of a paragraph: nothing may be cut there.
class Nesting {
  public:
    void read(char c) {
        if (is_escaped_) {
            is_escaped_ = false;
        } else if (c == '\\') {
            is_escaped_ = true;
        } else if (c == '`') {
            in_code_ = !in_code_;
        } else if (!in_code_) {
            if (c == '$') in_formula_ = !in_formula_;
            if (c == '[') ++brackets_;
            if (c == ']') brackets_ = std::max(brackets_ - 1, 0);
            if (c == '*' && before_ != '*') is_emphasis_ = !is_emphasis_;
        }
        before_ = c;
    }
    bool is_open() const { return in_code_ || in_formula_ || brackets_ > 0 || is_emphasis_; }

  private:
    bool in_code_ = false, in_formula_ = false, is_escaped_ = false, is_emphasis_ = false;
    int brackets_ = 0;
    char before_ = '\0';
};

} // namespace

std::vector<std::string> leading_sentences(std::string_view markdown) {
    const std::string text = without_notes(first_paragraph(markdown));
    std::vector<std::string> sentences;
    std::size_t start = 0;
    Nesting nesting;
    bool is_ended = false; // the sentence, but for closing quotes and marks of emphasis
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        nesting.read(c);
        if (c == '.' || c == '?' || c == '!') {
            is_ended = true;
        } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            if (is_ended && !nesting.is_open()) {
                sentences.push_back(text.substr(start, i - start));
                start = i + 1;
            }
            is_ended = false;
        } else if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
            is_ended = false;
        }
    }
    if (start < text.size() && !is_blank(std::string_view(text).substr(start))) {
        sentences.push_back(text.substr(start));
    }
    return sentences;
}

} // namespace rasterwalk
