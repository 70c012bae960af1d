#include "text/sentences.h"

#include <algorithm>
#include <cctype>

#include "base/text_parts.h"

namespace rasterwalk {

namespace {

bool begins_code(std::string_view line) {
    return line.starts_with("```") || line.starts_with("~~~");
}

bool is_list_item(std::string_view line) {
    const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
    return line.starts_with("- ") || line.starts_with("* ") || line.starts_with("+ ") ||
           (digits > 0 && line.substr(digits).starts_with(". "));
}

/// Does this line begin a block that is not running text?
bool begins_other_block(std::string_view line) {
    for (const std::string_view mark :
         {"#", "|", ">", "![", "<!--", "$$", "    ", "\t", "---", "***", "[^"}) {
        if (line.starts_with(mark)) return true;
    }
    return is_list_item(line);
}

/// A part of a text between blank lines, or between the fences of code.
struct Block {
    std::string text;
    bool is_paragraph = false;
    bool is_list = false;
};

/// Adds a line to a block.
void append_line(std::string& text, std::string_view line) {
    if (!text.empty()) text += '\n';
    text.append(line);
}

std::vector<Block> blocks_of(std::string_view text) {
    std::vector<Block> blocks;
    Block block;
    const auto end_block = [&] {
        if (!block.text.empty()) blocks.push_back(block);
        block = {};
    };
    while (!text.empty()) {
        const std::string_view line = take_part(text, '\n');
        if (begins_code(line)) {
            end_block();
            append_line(block.text, line);
            for (bool is_open = true; is_open && !text.empty();) {
                const std::string_view code = take_part(text, '\n');
                append_line(block.text, code);
                is_open = !begins_code(code);
            }
            end_block();
        } else if (trimmed(line).empty()) {
            end_block();
        } else {
            // A line without its own mark belongs to the block it is in.
            if (block.text.empty()) {
                block.is_paragraph = !begins_other_block(line);
                block.is_list = is_list_item(line);
            }
            append_line(block.text, line);
        }
    }
    end_block();
    return blocks;
}

std::string without_notes(std::string text) {
    for (std::size_t at = text.find("[^"); at != text.npos; at = text.find("[^", at)) {
        const std::size_t end = text.find(']', at);
        if (end == text.npos) break;
        text.erase(at, end + 1 - at);
    }
    return text;
}

/// What is open at a place in a paragraph, which must not be cut there.
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
    bool is_literal() const { return in_code_ || in_formula_; }
    bool is_open() const { return in_code_ || in_formula_ || brackets_ > 0 || is_emphasis_; }

  private:
    bool in_code_ = false, in_formula_ = false, is_escaped_ = false, is_emphasis_ = false;
    int brackets_ = 0;
    char before_ = '\0';
};

bool is_end_mark(char c) {
    return c == '.' || c == '?' || c == '!';
}

/// Does the text go on in lower case? Then what ended was "e.g." or the like.
bool goes_on_small(std::string_view text, std::size_t at) {
    const std::size_t next = text.find_first_not_of(" \t\r\n", at);
    return next != text.npos && std::islower(static_cast<unsigned char>(text[next])) != 0;
}

/// Is it a whole sentence, and not continued by what follows?
bool is_whole_sentence(std::string_view text) {
    const std::size_t last = text.find_last_not_of(" \t\r\n*_)\"'");
    return last != text.npos && is_end_mark(text[last]);
}

std::vector<std::string> sentences_of(const std::string& text) {
    std::vector<std::string> sentences;
    std::size_t start = 0;
    Nesting nesting;
    bool is_ended = false; // the sentence, except for closing quotes and marks of emphasis
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        nesting.read(c);
        if (is_end_mark(c)) {
            // A full stop in code is a key or a member.
            if (!nesting.is_literal()) is_ended = true;
        } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            if (is_ended && !nesting.is_open() && !goes_on_small(text, i)) {
                sentences.push_back(text.substr(start, i - start));
                start = i + 1;
            }
            is_ended = false;
        } else if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == ',' || c == ';') {
            is_ended = false;
        }
    }
    if (start < text.size() && !trimmed(std::string_view(text).substr(start)).empty()) {
        sentences.push_back(text.substr(start));
    }
    return sentences;
}

/// The items of a list, each with the lines that belong to it.
std::vector<std::string> items_of(std::string_view list) {
    std::vector<std::string> items;
    while (!list.empty()) {
        const std::string_view line = take_part(list, '\n');
        if (items.empty() || is_list_item(line)) items.emplace_back();
        append_line(items.back(), line);
    }
    return items;
}

} // namespace

std::vector<std::string> leading_sentences(std::string_view markdown) {
    for (const Block& block : blocks_of(markdown)) {
        if (block.is_paragraph) return sentences_of(without_notes(block.text));
    }
    return {};
}

std::vector<ReadingPiece> reading_pieces(std::string_view markdown) {
    std::vector<ReadingPiece> pieces;
    bool is_running = false; // the previous piece comes from a paragraph
    for (const Block& block : blocks_of(markdown)) {
        if (block.text.starts_with("[^") || block.text.starts_with("<!--")) continue;
        if (!block.is_paragraph && !block.is_list && is_running &&
            !is_whole_sentence(pieces.back().text)) {
            pieces.back().text.append("\n\n").append(block.text);
            is_running = false;
            continue;
        }
        const std::vector<std::string> parts = block.is_paragraph
                                                   ? sentences_of(without_notes(block.text))
                                               : block.is_list ? items_of(block.text)
                                                               : std::vector{block.text};
        // Running text goes on from one paragraph to the next.
        bool is_first = !block.is_paragraph || pieces.empty() || !is_running;
        is_running = block.is_paragraph;
        for (const std::string& part : parts) {
            pieces.push_back({part, is_first, block.is_list ? "\n" : " "});
            is_first = false;
        }
    }
    return pieces;
}

CutTable cut_table(std::string_view markdown) {
    CutTable cut;
    bool is_code = false;
    int lines = 0; // of the table
    while (!markdown.empty()) {
        const std::string_view line = take_part(markdown, '\n');
        if (begins_code(line)) is_code = !is_code;
        const bool is_of_table = !is_code && line.starts_with('|') && cut.after.empty();
        if (!is_of_table) {
            std::string& text = lines == 0 ? cut.before : cut.after;
            if (!text.empty() || !trimmed(line).empty()) append_line(text, line);
        } else if (lines++ < 2) {
            append_line(cut.head, line);
        } else {
            cut.rows.emplace_back(line);
        }
    }
    return cut;
}

} // namespace rasterwalk
