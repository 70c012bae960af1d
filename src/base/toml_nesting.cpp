#include "base/toml_nesting.h"

#include <algorithm>

namespace rasterwalk {

namespace {

/// Walks over a TOML text, understanding only its strings and comments. Anything else malformed
/// ends the parsing anyway, and the text after it is not looked at.
class NestingScan {
  public:
    explicit NestingScan(std::string_view text) : rest_(text) {}

    std::optional<int> run() {
        while (!rest_.empty()) {
            const char c = rest_.front();
            if (c == '"' || c == '\'') {
                skip_string(c);
            } else if (c == '#') {
                skip(std::min(rest_.find('\n'), rest_.size()));
            } else {
                note(c);
                skip(1);
            }
            if (dots_ > most_key_dots || brackets_ > most_nested_brackets) return line_;
        }
        return std::nullopt;
    }

  private:
    /// A dot outside strings is in a key, or once in a number.
    void note(char c) {
        switch (c) {
        case '.':
            ++dots_;
            return;
        case '[':
        case '{':
            ++brackets_;
            break;
        case ']':
        case '}':
            brackets_ = std::max(brackets_ - 1, 0);
            break;
        case '\n':
        case '=':
        case ',':
            break;
        default:
            return;
        }
        dots_ = 0;
    }

    void skip(std::size_t count) {
        line_ += static_cast<int>(std::count(rest_.begin(), rest_.begin() + count, '\n'));
        rest_.remove_prefix(count);
    }

    void skip_string(char quote) {
        const std::size_t quotes = std::min(rest_.find_first_not_of(quote), rest_.size());
        if (quotes == 2) return skip(2); // empty
        const bool is_long = quotes >= 3;
        skip(is_long ? 3 : 1);
        while (!rest_.empty()) {
            const char c = rest_.front();
            if (c == quote && !is_long) return skip(1);
            if (c == quote) {
                // Up to two quotes of the text can precede the three that end it.
                const std::size_t run = std::min(rest_.find_first_not_of(quote), rest_.size());
                if (run >= 3) return skip(std::min<std::size_t>(run, 5));
                skip(run);
            } else if (c == '\n' && !is_long) {
                return; // malformed
            } else {
                skip(c == '\\' && quote == '"' ? std::min<std::size_t>(2, rest_.size()) : 1);
            }
        }
    }

    std::string_view rest_;
    int line_ = 1;
    int dots_ = 0;
    int brackets_ = 0;
};

} // namespace

std::optional<int> line_nested_too_deeply(std::string_view text) {
    return NestingScan(text).run();
}

} // namespace rasterwalk
