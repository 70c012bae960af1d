#include "text/prose.h"

#include <algorithm>
#include <array>

#include "base/letter_case.h"
#include "text/markdown_text.h"

namespace rasterwalk {

namespace {

/// In a mask: a character that is not read, between texts that have nothing to do with each other;
/// and one that takes the place of a word of code.
constexpr char gap = '\0', code_mark = '\1';

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// Makes a mask: a text of the same length in which only what is read is left, and each line break.
class Mask {
  public:
    explicit Mask(std::string_view text) : text_(text), mask_(text.size(), gap) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '\n') mask_[i] = '\n';
        }
    }

    bool is_at_end() const { return at_ >= text_.size(); }
    char here() const { return text_[at_]; }
    bool is_here(std::string_view part) const { return text_.substr(at_).starts_with(part); }
    std::size_t end_of_line() const { return std::min(text_.find('\n', at_), text_.size()); }
    std::string_view line() const { return text_.substr(at_, end_of_line() - at_); }

    void skip(std::size_t count = 1) { at_ = std::min(at_ + count, text_.size()); }
    void skip_line() { at_ = std::min(end_of_line() + 1, text_.size()); }
    /// What follows goes on with the text before.
    void join(std::size_t count) {
        for (; count > 0 && !is_at_end(); --count, ++at_)
            mask_[at_] = here() == '\n' ? '\n' : ' ';
    }
    void keep() {
        if (here() != '\n') mask_[at_] = here();
        ++at_;
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
            const std::size_t end = text_.find(c == '`' ? '`' : '}', at_ + 1);
            if (end < end_of_line()) {
                std::fill(mask_.begin() + static_cast<std::ptrdiff_t>(at_),
                          mask_.begin() + static_cast<std::ptrdiff_t>(end + 1), code_mark);
                at_ = end + 1;
                return;
            }
        }
        keep();
    }

    /// A string in quotes, which begins here, with backslashes before what is not meant. One
    /// without a blank is a name or a key: code.
    /// @param mark the quotes
    void read_string(std::string_view mark) {
        skip(mark.size());
        const std::size_t begin = at_;
        bool is_prose = false;
        while (!is_at_end() && !is_here(mark) && (here() != '\n' || mark.size() > 1)) {
            is_prose = is_prose || here() == ' ';
            here() == '\\' ? join(2) : read_text();
        }
        if (!is_prose) {
            std::fill(mask_.begin() + static_cast<std::ptrdiff_t>(begin),
                      mask_.begin() + static_cast<std::ptrdiff_t>(at_), code_mark);
        }
        if (is_here(mark)) skip(mark.size());
    }

    /// Blanks, which join two texts if one like the last begins after them.
    /// @param begin how it begins
    void read_blanks_to(std::string_view begin) {
        const std::size_t start = at_;
        while (!is_at_end() && is_blank(here()))
            ++at_;
        if (!is_here(begin)) return;
        for (std::size_t i = start; i < at_; ++i) {
            if (text_[i] != '\n') mask_[i] = ' ';
        }
    }

    std::string take() { return std::move(mask_); }

    /// The marks of a text that was read join what is before and after them.
    void join_marks(std::size_t from, std::size_t count) {
        std::fill_n(mask_.begin() + static_cast<std::ptrdiff_t>(from), count, ' ');
    }
    std::size_t place() const { return at_; }

  private:
    std::string_view text_;
    std::string mask_;
    std::size_t at_ = 0;
};

/// A comment up to the end of its line, and those on the lines after it.
void read_line_comments(Mask& mask, std::string_view mark) {
    mask.skip(mark.size());
    for (;;) {
        while (!mask.is_at_end() &&
               (mask.here() == '/' || mask.here() == '#' || mask.here() == '<'))
            mask.join(1);
        mask.keep_line();
        mask.read_blanks_to(mark);
        if (!mask.is_here(mark)) return;
        mask.join(mark.size());
    }
}

void read_strings(Mask& mask, std::string_view mark) {
    mask.read_string(mark);
    std::size_t end = mask.place();
    mask.read_blanks_to(mark);
    while (mask.is_here(mark)) {
        mask.join_marks(end - mark.size(), mark.size());
        mask.join_marks(mask.place(), mark.size());
        mask.read_string(mark);
        end = mask.place();
        mask.read_blanks_to(mark);
    }
}

std::string mask_of_program(std::string_view text) {
    Mask mask(text);
    while (!mask.is_at_end()) {
        if (mask.is_here("//")) {
            read_line_comments(mask, "//");
        } else if (mask.is_here("/*")) {
            mask.skip(2);
            while (!mask.is_at_end() && !mask.is_here("*/"))
                mask.read_text();
        } else if (mask.here() == '#') {
            mask.skip_line(); // #include "file.h"
        } else if (mask.is_here("'")) {
            // A character, or what divides a number's digits.
            mask.skip(mask.is_here("'\\") ? 4 : mask.line().substr(0, 3).ends_with('\'') ? 3 : 1);
        } else if (mask.is_here("R\"")) {
            const std::size_t open = mask.line().find('(');
            if (open == std::string_view::npos) {
                mask.skip();
                continue;
            }
            const std::string end = ")" + std::string(mask.line().substr(2, open - 2)) + "\"";
            mask.skip(open + 1);
            while (!mask.is_at_end() && !mask.is_here(end))
                mask.read_text();
            mask.skip(end.size());
        } else if (mask.here() == '"') {
            read_strings(mask, "\"");
        } else {
            mask.skip();
        }
    }
    return mask.take();
}

std::string mask_of_data(std::string_view text) {
    Mask mask(text);
    while (!mask.is_at_end()) {
        if (mask.here() == '#') {
            read_line_comments(mask, "#");
        } else if (mask.is_here("\"\"\"") || mask.is_here("'''")) {
            mask.read_string(mask.here() == '"' ? "\"\"\"" : "'''");
        } else if (mask.here() == '"' || mask.here() == '\'') {
            mask.read_string(mask.here() == '"' ? "\"" : "'");
        } else {
            mask.skip();
        }
    }
    return mask.take();
}

std::string mask_of_script(std::string_view text) {
    Mask mask(text);
    while (!mask.is_at_end()) {
        const std::string_view line = mask.line();
        const std::size_t begin = line.find_first_not_of(" \t");
        if (begin != std::string_view::npos && line[begin] == '#') {
            mask.skip(begin);
            read_line_comments(mask, "#");
        } else {
            mask.skip_line();
        }
    }
    return mask.take();
}

std::string mask_of_markdown(std::string_view text) {
    Mask mask(text);
    bool is_code = false, is_comment = false;
    while (!mask.is_at_end()) {
        if (is_comment) {
            if (mask.is_here("-->")) {
                is_comment = false;
                mask.skip(3);
            } else if (mask.here() == '"') {
                mask.read_string("\"");
            } else {
                mask.skip();
            }
            continue;
        }
        const std::size_t end = mask.end_of_line();
        if (is_fence(mask.line())) {
            is_code = !is_code;
            mask.skip_line();
            continue;
        }
        if (is_code || mask.line().find_first_not_of(" \t\r") == std::string_view::npos) {
            mask.skip_line();
            continue;
        }
        while (mask.place() < end && !is_comment) {
            if (mask.is_here("<!--")) {
                is_comment = true;
                mask.skip(4);
            } else if (mask.is_here("](")) {
                mask.join(1);
                const std::size_t target = mask.line().find(')');
                mask.join(target == std::string_view::npos ? 1 : target + 1);
            } else if (mask.here() == '[' || mask.here() == '*' || mask.here() == '_') {
                mask.join(1);
            } else if (mask.here() == '\\') {
                mask.skip(2);
            } else {
                mask.read_text();
            }
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

/// What begins with this byte pair is a mark of UTF-8 (dashes, quotes, dots), and no letter.
constexpr std::string_view mark_of_utf8 = "\xE2\x80", apostrophe = "\xE2\x80\x99";

} // namespace

std::optional<ProseKind> prose_kind(std::string_view path) {
    constexpr std::array<std::pair<std::string_view, ProseKind>, 8> ends{{
        {".md", ProseKind::markdown},
        {".h", ProseKind::program},
        {".cpp", ProseKind::program},
        {".toml", ProseKind::data},
        {".sh", ProseKind::script},
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
    const auto add = [&](std::string word) {
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
            i += rest.starts_with(mark_of_utf8) ? 3 : 1;
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
            add(std::move(word));
        }
    }
    return words;
}

} // namespace rasterwalk
