#pragma once

// Reading TOML strictly: every fault is an InputError with file:line and one sentence.

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <toml++/toml.h>

namespace rasterwalk {

/// Parses text; `path` is only used in messages. Throws InputError.
/// @param told receives now and then how many bytes have been read; if it throws, the parsing ends
toml::table parse_toml(std::string_view text, const std::string& path,
                       const std::function<void(std::size_t)>& on_read = {});

/// A table being read, with the name of its file.
class TomlInput {
  public:
    /// @param what how messages name the table: "the camera"
    TomlInput(const toml::table& table, const std::string& path, std::string what)
        : table_(&table), path_(&path), what_(std::move(what)) {}

    /// Refuses every key but these.
    void allow_only(std::initializer_list<std::string_view> keys) const;

    /// Throws InputError at the line of this node.
    [[noreturn]] void fail(const toml::node& at, const std::string& sentence) const;
    [[noreturn]] void fail(const std::string& sentence) const { fail(*table_, sentence); }

    const toml::node* find(std::string_view key) const { return table_->get(key); }

    /// A key that must be there, of this type. `text` must not be empty.
    std::string text(std::string_view key) const;
    const toml::array& list(std::string_view key) const;
    std::string text_or_empty(std::string_view key) const;

    /// Read into `value` if the key is there: finite and within the range.
    void read(std::string_view key, float& value, float smallest, float largest) const;
    void read(std::string_view key, int& value, int smallest, int largest) const;
    void read(std::string_view key, glm::vec3& value, float smallest, float largest) const;
    /// One number stands for all three.
    void read_colour(std::string_view key, glm::vec3& value, float smallest, float largest) const;

    /// A table within this one.
    TomlInput table(const toml::node& node, std::string what) const;

    /// Numbers of a node.
    float number(const toml::node& node, float smallest, float largest,
                 const std::string& what) const;
    glm::vec3 vector(const toml::node& node, float smallest, float largest,
                     const std::string& what) const;

    const toml::table& nodes() const { return *table_; }
    const std::string& what() const { return what_; }

  private:
    const toml::node& require(std::string_view key) const;

    /// How messages name the value of a key: "'focal_length' of the camera".
    std::string name_of(std::string_view key) const;

    const toml::table* table_;
    const std::string* path_;
    std::string what_;
};

/// Reads a text that is a list of tables, `[[key]]`, and nothing else. Throws InputError.
/// @param what how messages name the file: "the file of presets"
/// @param read makes an entry from a table; it also gets the earlier entries
template <class Entry, class Read>
std::vector<Entry> parse_tables(std::string_view text, const std::string& path,
                                std::string_view key, std::string what, const Read& read) {
    const toml::table root = parse_toml(text, path);
    const TomlInput input(root, path, std::move(what));
    input.allow_only({key});
    std::vector<Entry> entries;
    for (const toml::node& node : input.list(key)) {
        const TomlInput table = input.table(
            node, std::string(key).append(" ").append(std::to_string(entries.size() + 1)));
        entries.push_back(read(table, entries));
    }
    return entries;
}

} // namespace rasterwalk
