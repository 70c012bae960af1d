#pragma once

// Reading a table of TOML key by key, so that one fault does not hide the next.

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>
#include <toml++/toml.h>

#include "base/faults.h"
#include "base/toml_input.h"

namespace rasterwalk {

/// The line of a node in its file, from 1.
int line_of(const toml::node& node);

/// What each key of a table does. A missing key, or one that fails, does not stop the others.
using TomlKeys = std::map<std::string_view, std::function<void(const toml::node&)>>;

/// A table with the faults found in it. The readers of single values throw InputError.
class TomlBlock {
  public:
    /// @param line where the table begins
    /// @param what how messages name the table
    TomlBlock(const toml::table& table, int line, std::string what, FaultList& faults)
        : input_(table, faults.path(), std::move(what)), line_(line), faults_(faults) {}

    void read(const TomlKeys& keys);

    /// A key that must be there.
    void require(std::string_view key);

    /// Text that is not blank.
    std::string text(const toml::node& node) const;
    int whole(const toml::node& node, int smallest, int largest) const;
    glm::ivec2 pixel(const toml::node& node) const;

    /// One of these words. @param what they are, in the message
    std::string word(const toml::node& node, const char* what,
                     std::span<const std::string_view> words) const;

    /// Every text of a list, each with its own faults.
    void for_each_text(const toml::node& node, std::size_t most,
                       const std::function<void(const std::string&)>& use) const;

    /// Every table of a list, each with its own faults. @param what how messages name each
    void for_each_table(const toml::node& node, std::size_t most, const std::string& what,
                        const std::function<void(TomlBlock&, int line)>& use) const;

    const toml::table& table(const toml::node& node) const;

    const TomlInput& input() const { return input_; }
    FaultList& faults() const { return faults_; }

  private:
    void refuse_key(std::string_view key, const toml::node& node, const TomlKeys& keys);

    TomlInput input_;
    int line_;
    FaultList& faults_;
};

} // namespace rasterwalk
