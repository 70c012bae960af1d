#include "code/tokens.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/error.h"

namespace rasterwalk {

namespace {

/// Of two that begin alike, the longer one comes first.
constexpr std::array<std::string_view, 48> code_signs{
    "<<=", ">>=", "...", "::", "++", "--", "+=", "-=", "*=", "/=", "%=", "&=",
    "|=",  "^=",  "==",  "!=", "<=", ">=", "&&", "||", "<<", ">>", "->", "+",
    "-",   "*",   "/",   "%",  "=",  "<",  ">",  "!",  "&",  "|",  "^",  "~",
    "?",   ":",   ";",   ",",  ".",  "(",  ")",  "[",  "]",  "{",  "}",  "#"};

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool begins_name(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool is_in_name(char c) {
    return begins_name(c) || is_digit(c);
}

/// Walks through a source.
class Cutter {
  public:
    Cutter(std::string_view source, const std::string& file) : source_(source), file_(file) {}

    CodeTokens cut() {
        while (skip_blanks(), at_ < source_.size())
            cut_one();
        found_.tokens.push_back({CodeToken::Kind::end, source_.substr(source_.size()), line_});
        return std::move(found_);
    }

  private:
    std::string_view rest() const { return source_.substr(at_); }

    void advance(std::size_t count) {
        line_ += static_cast<int>(
            std::count(source_.begin() + static_cast<std::ptrdiff_t>(at_),
                       source_.begin() + static_cast<std::ptrdiff_t>(at_ + count), '\n'));
        at_ += count;
    }

    /// The rest of the line, without its end.
    std::string_view rest_of_line() const { return rest().substr(0, rest().find('\n')); }

    bool is_first_of_line() const {
        const std::size_t begin = source_.substr(0, at_).find_last_of('\n') + 1;
        return source_.substr(begin, at_ - begin).find_first_not_of(" \t") == source_.npos;
    }

    void skip_comment() {
        const std::size_t end = rest().find("*/", 2);
        if (end == source_.npos)
            throw InputError(file_, line_, "This comment does not end: */ is missing.");
        advance(end + 2);
    }

    void skip_blanks() {
        while (at_ < source_.size()) {
            if (std::isspace(static_cast<unsigned char>(source_[at_])) != 0) {
                advance(1);
            } else if (rest().starts_with("//")) {
                const std::string_view comment = rest_of_line();
                if (comment.starts_with("//@")) found_.marks.push_back({line_, comment.substr(3)});
                advance(comment.size());
            } else if (rest().starts_with("/*")) {
                skip_comment();
            } else if (source_[at_] == '#' && is_first_of_line()) {
                advance(rest_of_line().size());
            } else {
                return;
            }
        }
    }

    void add(CodeToken::Kind kind, std::size_t length) {
        found_.tokens.push_back({kind, rest().substr(0, length), line_});
        advance(length);
    }

    void cut_number() {
        std::size_t end = at_;
        bool is_real = false;
        const auto digits = [&] {
            while (end < source_.size() && is_digit(source_[end]))
                ++end;
        };
        digits();
        if (end < source_.size() && source_[end] == '.') {
            is_real = true;
            ++end;
            digits();
        }
        if (end < source_.size() && (source_[end] == 'e' || source_[end] == 'E')) {
            is_real = true;
            ++end;
            if (end < source_.size() && (source_[end] == '+' || source_[end] == '-')) ++end;
            digits();
        }
        CodeToken::Kind kind = is_real ? CodeToken::Kind::real : CodeToken::Kind::integer;
        if (is_real && end < source_.size() && (source_[end] == 'f' || source_[end] == 'F')) {
            kind = CodeToken::Kind::single_real;
            ++end;
        }
        if (end < source_.size() && is_in_name(source_[end])) {
            throw InputError(file_, line_,
                             "The number " + std::string(source_.substr(at_, end - at_)) +
                                 " is followed by a letter.");
        }
        add(kind, end - at_);
    }

    void cut_text() {
        std::size_t end = at_ + 1;
        while (end < source_.size() && source_[end] != '"' && source_[end] != '\n')
            end += source_[end] == '\\' ? 2 : 1;
        if (end >= source_.size() || source_[end] == '\n')
            throw InputError(file_, line_, "This text does not end: \" is missing.");
        add(CodeToken::Kind::text, end + 1 - at_);
    }

    void cut_one() {
        const char c = source_[at_];
        const bool is_number =
            is_digit(c) || (c == '.' && at_ + 1 < source_.size() && is_digit(source_[at_ + 1]));
        if (begins_name(c)) {
            const auto end = std::find_if_not(source_.begin() + static_cast<std::ptrdiff_t>(at_),
                                              source_.end(), is_in_name);
            return add(CodeToken::Kind::name,
                       static_cast<std::size_t>(end - source_.begin()) - at_);
        }
        if (is_number) return cut_number();
        if (c == '"') return cut_text();
        for (const std::string_view sign : code_signs)
            if (rest().starts_with(sign)) return add(CodeToken::Kind::sign, sign.size());
        throw InputError(file_, line_, "C++ has no such sign outside of texts.");
    }

    std::string_view source_;
    const std::string& file_;
    std::size_t at_ = 0;
    int line_ = 1;
    CodeTokens found_;
};

} // namespace

CodeTokens tokens_of(std::string_view source, const std::string& file) {
    return Cutter(source, file).cut();
}

} // namespace rasterwalk
