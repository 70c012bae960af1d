#include "text/prose.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/letter_case.h"
#include "text/markdown_text.h"

namespace rasterwalk {

namespace {

/// In a mask: a character that is not read, between unrelated texts; and one in place of a word of
/// code.
constexpr char gap = '\0', code_mark = '\1';

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// The longest piece of code in a text, or target of a link.
constexpr std::size_t longest_code = 200, longest_link = 1000, longest_delimiter = 16;

/// Makes a mask: a text of the same length in which only what is read is left, and each line break.
class Mask {
  public:
    explicit Mask(std::string_view text) : text_(text), mask_(text.size(), gap), end_(text.size()) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '\n') mask_[i] = '\n';
        }
    }

    bool is_at_end() const { return at_ >= end_; }
    char here() const { return text_[at_]; }
    char before() const { return at_ > 0 ? text_[at_ - 1] : '\n'; }
    std::string_view rest() const { return text_.substr(at_, end_ - at_); }
    bool is_here(std::string_view part) const { return rest().starts_with(part); }
    std::size_t end_of_line() {
        if (at_ > end_of_line_ || end_of_line_ == 0)
            end_of_line_ = std::min(text_.find('\n', at_), text_.size());
        return std::min(end_of_line_, end_);
    }
    std::string_view line() { return text_.substr(at_, end_of_line() - at_); }

    void skip(std::size_t count = 1) { at_ = std::min(at_ + count, end_); }
    void skip_line() { skip(end_of_line() + 1 - at_); }
    /// Joins what follows to the preceding text.
    void join(std::size_t count) {
        for (; count > 0 && !is_at_end(); --count, ++at_)
            mask_[at_] = here() == '\n' ? '\n' : ' ';
    }
    void keep_line() {
        const std::size_t end = end_of_line();
        while (at_ < end)
            read_text();
    }
    /// One character of a text, or a piece of code in it: `code` or {placeholder}.
    void read_text() {
        const char c = here();
        if (c == '`' || c == '{') {
            const std::string_view near = rest().substr(0, longest_code);
            const std::size_t end = near.find(c == '`' ? '`' : '}', 1);
            if (end < near.find("\n\n")) {
                fill(at_, at_ + end + 1, code_mark);
                at_ += end + 1;
                return;
            }
        }
        if (c != '\n') mask_[at_] = c;
        ++at_;
    }
    /// Reads with `step` up to the mark, and skips the mark.
    template <class Step>
    void read_to(std::string_view mark, const Step& step) {
        const std::size_t end = std::exchange(end_, std::min(text_.find(mark, at_), end_));
        while (!is_at_end())
            step(*this);
        end_ = end;
        skip(mark.size());
    }

    /// Strings in quotes with only blanks between them, which are one text. One without a blank is
    /// a name or a key: code.
    /// @param mark the quotes; a backslash escapes them, except in '...'
    void read_strings(std::string_view mark) {
        std::vector<std::pair<std::size_t, std::size_t>> parts;
        bool is_prose = false;
        do {
            if (!parts.empty()) fill(parts.back().second, at_ + mark.size(), ' ');
            skip(mark.size());
            const std::size_t begin = at_, end = std::exchange(end_, end_of_string(mark));
            is_prose = is_prose || rest().find(' ') != std::string_view::npos;
            while (!is_at_end())
                here() == '\\' && mark[0] == '"' ? join(2) : read_text();
            parts.emplace_back(begin, at_);
            end_ = end;
            if (!is_here(mark)) break; // not closed on its line
            skip(mark.size());
        } while (find_next(mark));
        for (const auto& [begin, end] : parts) {
            if (!is_prose) fill(begin, end, code_mark);
        }
    }

    /// A comment up to the end of its line, and those on the following lines.
    void read_line_comments(std::string_view mark) {
        do {
            join(mark.size());
            while (!is_at_end() && (here() == '/' || here() == '#' || here() == '<'))
                join(1);
            keep_line();
        } while (find_next(mark));
    }

    std::size_t place() const { return at_; }
    std::string take() { return std::move(mask_); }

  private:
    /// Line breaks stay.
    void fill(std::size_t begin, std::size_t end, char c) {
        for (std::size_t i = begin; i < std::min(end, text_.size()); ++i) {
            if (text_[i] != '\n') mask_[i] = c;
        }
    }
    std::size_t end_of_string(std::string_view mark) const {
        for (std::size_t i = at_; i < end_; ++i) {
            if (text_.substr(i).starts_with(mark) || (text_[i] == '\n' && mark.size() == 1))
                return i;
            if (text_[i] == '\\' && mark[0] == '"') ++i;
        }
        return end_;
    }
    /// Skips blanks if the mark comes after them.
    bool find_next(std::string_view mark) {
        std::size_t next = at_;
        while (next < end_ && is_blank(text_[next]))
            ++next;
        if (!text_.substr(next, end_ - next).starts_with(mark)) return false;
        join(next - at_);
        return true;
    }

    std::string_view text_;
    std::string mask_;
    std::size_t at_ = 0, end_, end_of_line_ = 0;
};

bool is_hex_digit(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

/// A character in quotes, or the separator between digits of a number.
void skip_quote(Mask& mask) {
    const std::string_view near = mask.line().substr(0, longest_delimiter);
    std::size_t end = near.size() > 2 && near[1] == '\\' ? 3 : 2;
    while (end < near.size() && near[end] != '\'')
        ++end;
    mask.skip(is_hex_digit(mask.before()) || end >= near.size() ? 1 : end + 1);
}

void read_raw_string(Mask& mask) {
    const std::string_view delimiter = mask.line().substr(2, longest_delimiter + 1);
    const std::size_t open = delimiter.find('(');
    if (delimiter.substr(0, open).find_first_of(" \\\")") != std::string_view::npos ||
        open == std::string_view::npos)
        return mask.skip();
    mask.skip(2 + open + 1);
    mask.read_to(")" + std::string(delimiter.substr(0, open)) + "\"",
                 [](Mask& text) { text.read_text(); });
}

std::string mask_of_program(std::string_view text) {
    Mask mask(text);
    while (!mask.is_at_end()) {
        if (mask.is_here("//")) {
            mask.read_line_comments("//");
        } else if (mask.is_here("/*")) {
            mask.skip(2);
            mask.read_to("*/", [](Mask& comment) { comment.read_text(); });
        } else if (mask.is_here("#include")) {
            mask.skip_line();
        } else if (mask.here() == '\'') {
            skip_quote(mask);
        } else if (mask.is_here("R\"")) {
            read_raw_string(mask);
        } else if (mask.here() == '"') {
            mask.read_strings("\"");
        } else {
            mask.skip();
        }
    }
    return mask.take();
}

void read_data(Mask& mask) {
    constexpr std::array<std::string_view, 4> marks{"\"\"\"", "\'\'\'", "\"", "'"};
    const auto mark = std::find_if(marks.begin(), marks.end(),
                                   [&](std::string_view one) { return mask.is_here(one); });
    if (mark != marks.end()) {
        mask.read_strings(*mark);
    } else if (mask.here() == '#') {
        mask.read_line_comments("#");
    } else {
        mask.skip();
    }
}

std::string mask_of_data(std::string_view text) {
    Mask mask(text);
    while (!mask.is_at_end())
        read_data(mask);
    return mask.take();
}

std::string mask_of_script(std::string_view text) {
    Mask mask(text);
    while (!mask.is_at_end()) {
        const std::size_t begin =
            std::min(mask.line().find_first_not_of(" \t"), mask.line().size());
        mask.skip(begin);
        if (mask.is_here("#")) {
            mask.read_line_comments("#");
        } else {
            mask.skip_line();
        }
    }
    return mask.take();
}

/// A line of a page, up to a comment.
void read_page_line(Mask& mask) {
    const std::size_t end = mask.end_of_line();
    while (mask.place() < end && !mask.is_here("<!--")) {
        if (mask.is_here("](")) {
            const std::size_t target = mask.line().substr(0, longest_link).find(')');
            mask.join(target == std::string_view::npos ? 2 : target + 1);
        } else if (mask.here() == '[' || mask.here() == '*' || mask.here() == '_') {
            mask.join(1);
        } else if (mask.here() == '\\') {
            mask.skip(2);
        } else {
            mask.read_text();
        }
    }
}

std::string mask_of_markdown(std::string_view text) {
    Mask mask(text);
    bool is_code = false;
    while (!mask.is_at_end()) {
        const bool is_line_begin = mask.before() == '\n';
        if (is_line_begin && is_fence(mask.line())) {
            is_code = !is_code;
            mask.skip_line();
        } else if (is_code) {
            mask.skip_line();
        } else if (mask.is_here("<!--")) {
            mask.skip(4);
            mask.read_to("-->", read_data);
        } else if (mask.here() == '\n') {
            mask.skip();
        } else {
            read_page_line(mask);
        }
    }
    return mask.take();
}

std::string mask_of(std::string_view text, ProseKind kind) {
    switch (kind) {
    case ProseKind::markdown:
        return mask_of_markdown(text);
    case ProseKind::program:
        return mask_of_program(text);
    case ProseKind::data:
        return mask_of_data(text);
    case ProseKind::script:
        return mask_of_script(text);
    }
    return {};
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '\'' || static_cast<unsigned char>(c) >= 0x80;
}

/// What begins with this byte pair is a mark in UTF-8 (dashes, quotes, dots), not a letter.
constexpr std::string_view mark_of_utf8 = "\xE2\x80", apostrophe = "\xE2\x80\x99";

} // namespace

std::optional<ProseKind> prose_kind(std::string_view path) {
    constexpr std::array<std::pair<std::string_view, ProseKind>, 11> ends{{
        {".md", ProseKind::markdown},
        {".h", ProseKind::program},
        {".cpp", ProseKind::program},
        {".js", ProseKind::program},
        {".mjs", ProseKind::program},
        {".toml", ProseKind::data},
        {".sh", ProseKind::script},
        {".py", ProseKind::script},
        {".cmake", ProseKind::script},
        {"CMakeLists.txt", ProseKind::script},
        {"widgets.txt", ProseKind::script},
    }};
    for (const auto& [end, kind] : ends) {
        if (path.ends_with(end)) return kind;
    }
    return std::nullopt;
}

std::vector<ProseWord> prose_of(std::string_view text, ProseKind kind) {
    const std::string mask = mask_of(text, kind);
    std::vector<ProseWord> words;
    int line = 1, breaks = 0;
    bool follows = false;
    const auto add = [&](const std::string& word) {
        words.push_back({in_small_letters(word), line, follows});
        follows = true;
    };
    for (std::size_t i = 0; i < mask.size();) {
        const std::string_view rest = std::string_view(mask).substr(i);
        if (mask[i] == '\n') {
            ++line;
            // An empty line ends a text.
            if (++breaks > 1) follows = false;
            ++i;
        } else if (is_blank(mask[i])) {
            ++i;
        } else if (mask[i] == code_mark) {
            breaks = 0;
            i = std::min(mask.find_first_not_of(code_mark, i), mask.size());
            add("{}");
        } else if (!is_letter(mask[i]) ||
                   (rest.starts_with(mark_of_utf8) && !rest.starts_with(apostrophe))) {
            breaks = 0;
            follows = false;
            i += rest.starts_with(mark_of_utf8) && rest.size() > 2 && rest[2] != '\n' ? 3 : 1;
        } else {
            breaks = 0;
            std::string word;
            while (i < mask.size() && is_letter(mask[i])) {
                const std::string_view here = std::string_view(mask).substr(i);
                if (here.starts_with(apostrophe)) {
                    word += '\'';
                    i += apostrophe.size();
                } else if (here.starts_with(mark_of_utf8)) {
                    break;
                } else {
                    word += mask[i++];
                }
            }
            add(word);
        }
    }
    return words;
}

} // namespace rasterwalk
