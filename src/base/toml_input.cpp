#include "base/toml_input.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <istream>
#include <optional>
#include <streambuf>
#include <string_view>

#include <fmt/format.h>

#include "base/error.h"
#include "base/numbers.h"
#include "base/quoted.h"

namespace rasterwalk {

namespace {

/// The most dots in one TOML key, and the most nested brackets. toml++ makes, reads and frees
/// tables recursively; with these bounds the depth stays at about a thousand.
constexpr int most_key_dots = 32;

constexpr int most_nested_brackets = 32;

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

/// The first line, from 1, in which a TOML text goes beyond these bounds; none if it stays within
/// them. Strings and comments do not count.
std::optional<int> line_nested_too_deeply(std::string_view text) {
    return NestingScan(text).run();
}

/// A text as a stream, in blocks, so that the parser's progress can be reported between them.
/// toml++ would mistake an exception for its own, so it is kept, and the text ends there.
class WatchedText : public std::streambuf {
  public:
    WatchedText(std::string_view text, const std::function<void(std::size_t)>& on_read)
        : text_(text), on_read_(on_read) {}

    /// Rethrows an exception thrown on the way.
    void rethrow() const {
        if (thrown_) std::rethrow_exception(thrown_);
    }

  private:
    static constexpr std::size_t block = std::size_t{1} << 14;

    int_type underflow() override {
        if (end_ == text_.size() || thrown_) return traits_type::eof();
        try {
            if (on_read_) on_read_(end_);
        } catch (...) {
            thrown_ = std::current_exception();
            return traits_type::eof();
        }
        const std::size_t begin = end_;
        end_ = std::min(begin + block, text_.size());
        // It is only read, but streams have no constant characters.
        char* const bytes = const_cast<char*>(text_.data());
        setg(bytes + begin, bytes + begin, bytes + end_);
        return traits_type::to_int_type(*gptr());
    }

    /// toml++ looks for a byte order mark, and goes back.
    pos_type seekoff(off_type by, std::ios_base::seekdir from, std::ios_base::openmode) override {
        const off_type size = static_cast<off_type>(text_.size());
        const off_type here = static_cast<off_type>(end_) - (egptr() - gptr());
        const off_type place = by + (from == std::ios_base::beg   ? 0
                                     : from == std::ios_base::end ? size
                                                                  : here);
        if (place < 0 || place > size) return off_type{-1};
        end_ = static_cast<std::size_t>(place);
        setg(nullptr, nullptr, nullptr);
        return place;
    }
    pos_type seekpos(pos_type place, std::ios_base::openmode mode) override {
        return seekoff(off_type(place), std::ios_base::beg, mode);
    }

    std::string_view text_;
    const std::function<void(std::size_t)>& on_read_;
    std::size_t end_ = 0; ///< of the block being read
    std::exception_ptr thrown_;
};

} // namespace

toml::table parse_toml(std::string_view text, const std::string& path,
                       const std::function<void(std::size_t)>& on_read) {
    if (const std::optional<int> line = line_nested_too_deeply(text)) {
        throw InputError(path, *line,
                         fmt::format("this is nested too deeply: a key has more than {} dots, or "
                                     "more than {} brackets are nested.",
                                     most_key_dots, most_nested_brackets));
    }
    WatchedText buffer(text, on_read);
    std::istream stream(&buffer);
    try {
        toml::table table = toml::parse(stream, path);
        buffer.rethrow();
        return table;
    } catch (const toml::parse_error& error) {
        buffer.rethrow();
        std::string sentence(error.description());
        // A key or string of the file can be quoted in it; a message is one line.
        std::replace_if(
            sentence.begin(), sentence.end(),
            [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
        if (!sentence.ends_with('.')) sentence += '.';
        const int line = static_cast<int>(error.source().begin.line);
        throw InputError(path, std::max(line, 1), sentence);
    }
}

void TomlInput::fail(const toml::node& at, const std::string& sentence) const {
    // A sentence can quote the file: a zero byte in it would be the end of what().
    throw InputError(*path_, std::max(static_cast<int>(at.source().begin.line), 1),
                     visible_line(sentence));
}

void TomlInput::allow_only(std::initializer_list<std::string_view> keys) const {
    for (auto&& [key, value] : *table_) {
        const std::string_view name = key.str();
        if (std::find(keys.begin(), keys.end(), name) != keys.end()) continue;
        fail(value, fmt::format("{} has no '{}'; it has: {}.", what_, name, fmt::join(keys, ", ")));
    }
}

const toml::node& TomlInput::require(std::string_view key) const {
    const toml::node* node = find(key);
    if (node == nullptr) fail(fmt::format("{} needs '{}'.", what_, key));
    return *node;
}

std::string TomlInput::name_of(std::string_view key) const {
    return fmt::format("'{}' of {}", key, what_);
}

std::string TomlInput::text(std::string_view key) const {
    const toml::node& node = require(key);
    std::string value = text_or_empty(key);
    if (value.empty()) fail(node, name_of(key) + " must not be empty.");
    return value;
}

std::string TomlInput::text_or_empty(std::string_view key) const {
    const toml::node* node = find(key);
    if (node == nullptr) return {};
    const auto* value = node->as_string();
    if (value == nullptr) fail(*node, name_of(key) + " must be text in quotes.");
    return value->get();
}

const toml::array& TomlInput::list(std::string_view key) const {
    const toml::node& node = require(key);
    const toml::array* array = node.as_array();
    if (array == nullptr) fail(node, name_of(key) + " must be a list.");
    return *array;
}

float TomlInput::number(const toml::node& node, float smallest, float largest,
                        const std::string& what) const {
    double value = 0.0;
    if (const auto* real = node.as_floating_point()) {
        value = real->get();
    } else if (const auto* integer = node.as_integer()) {
        value = static_cast<double>(integer->get());
    } else {
        fail(node, what + " must be a number.");
    }
    if (!std::isfinite(value)) fail(node, what + " must be a finite number.");
    const float rounded = static_cast<float>(value);
    if (!(rounded >= smallest && rounded <= largest)) {
        fail(node, fmt::format("{} must be between {} and {}.", what,
                               significant(static_cast<double>(smallest), 6),
                               significant(static_cast<double>(largest), 6)));
    }
    return rounded;
}

glm::vec3 TomlInput::vector(const toml::node& node, float smallest, float largest,
                            const std::string& what) const {
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != 3) fail(node, what + " must be three numbers.");
    glm::vec3 value;
    for (int i = 0; i < 3; ++i) {
        value[i] = number(*array->get(static_cast<std::size_t>(i)), smallest, largest, what);
    }
    return value;
}

void TomlInput::read(std::string_view key, float& value, float smallest, float largest) const {
    if (const toml::node* node = find(key)) {
        value = number(*node, smallest, largest, name_of(key));
    }
}

void TomlInput::read(std::string_view key, int& value, int smallest, int largest) const {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const auto* integer = node->as_integer();
    if (integer == nullptr || integer->get() < smallest || integer->get() > largest) {
        fail(*node, fmt::format("{} must be a whole number between {} and {}.", name_of(key),
                                smallest, largest));
    }
    value = static_cast<int>(integer->get());
}

void TomlInput::read(std::string_view key, glm::vec3& value, float smallest, float largest) const {
    if (const toml::node* node = find(key)) {
        value = vector(*node, smallest, largest, name_of(key));
    }
}

void TomlInput::read_colour(std::string_view key, glm::vec3& value, float smallest,
                            float largest) const {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const std::string name = name_of(key);
    value = node->is_array() ? vector(*node, smallest, largest, name)
                             : glm::vec3(number(*node, smallest, largest, name));
}

TomlInput TomlInput::table(const toml::node& node, std::string what) const {
    const toml::table* table = node.as_table();
    if (table == nullptr) fail(node, what + " must be a table.");
    return {*table, *path_, std::move(what)};
}

} // namespace rasterwalk
