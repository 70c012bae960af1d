#include "base/toml_block.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "base/text_parts.h"

namespace rasterwalk {

int line_of(const toml::node& node) {
    return static_cast<int>(node.source().begin.line);
}

void TomlBlock::read(const TomlKeys& keys) {
    for (auto&& [key, node] : input_.nodes()) {
        const auto found = keys.find(std::string_view(key.str()));
        const toml::node& value = node;
        if (found == keys.end()) {
            refuse_key(key.str(), value, keys);
        } else {
            faults_.attempt(line_of(value), [&] { found->second(value); });
        }
    }
}

void TomlBlock::require(std::string_view key) {
    if (input_.find(key) == nullptr) {
        faults_.add(line_, input_.what() + " needs '" + std::string(key) + "'.");
    }
}

std::string TomlBlock::text(const toml::node& node) const {
    const auto* text = node.as_string();
    if (text == nullptr) input_.fail(node, "text in quotes is needed here.");
    if (trimmed(text->get()).empty()) input_.fail(node, "this text must not be empty.");
    return text->get();
}

int TomlBlock::whole(const toml::node& node, int smallest, int largest) const {
    const auto* number = node.as_integer();
    if (number == nullptr || number->get() < smallest || number->get() > largest) {
        input_.fail(node, fmt::format("a whole number between {} and {} is needed here.", smallest,
                                      largest));
    }
    return static_cast<int>(number->get());
}

glm::ivec2 TomlBlock::pixel(const toml::node& node) const {
    const std::optional<glm::ivec2> pixel = parse_pixel(text(node));
    if (!pixel) input_.fail(node, "a pixel is needed here: \"250,131\".");
    return *pixel;
}

std::string TomlBlock::word(const toml::node& node, const char* what,
                            std::span<const std::string_view> words) const {
    std::string written = text(node);
    if (std::find(words.begin(), words.end(), written) == words.end()) {
        input_.fail(node, no_such_name(what, written, words));
    }
    return written;
}

void TomlBlock::for_each_text(const toml::node& node, std::size_t most,
                              const std::function<void(const std::string&)>& use) const {
    const toml::array* list = node.as_array();
    if (list == nullptr) input_.fail(node, "a list of strings is needed here: [\"...\"].");
    if (list->size() > most) {
        input_.fail(node, fmt::format("the list has more than {} entries.", most));
    }
    for (const toml::node& entry : *list)
        faults_.attempt(line_of(entry), [&] { use(text(entry)); });
}

void TomlBlock::for_each_table(const toml::node& node, std::size_t most, const std::string& what,
                               const std::function<void(TomlBlock&, int line)>& use) const {
    const toml::array* list = node.as_array();
    if (list == nullptr) input_.fail(node, "a list of tables is needed here: [{ ... }].");
    if (list->size() > most) {
        input_.fail(node, fmt::format("the list has more than {} entries.", most));
    }
    for (const toml::node& entry : *list) {
        faults_.attempt(line_of(entry), [&] {
            TomlBlock block(table(entry), line_of(entry), what, faults_);
            use(block, line_of(entry));
        });
    }
}

const toml::table& TomlBlock::table(const toml::node& node) const {
    const toml::table* table = node.as_table();
    if (table == nullptr) input_.fail(node, "a table is needed here: { ... }.");
    return *table;
}

void TomlBlock::refuse_key(std::string_view key, const toml::node& node, const TomlKeys& keys) {
    std::vector<std::string_view> names;
    for (const auto& [name, use] : keys)
        names.push_back(name);
    faults_.add(line_of(node),
                fmt::format("{} has no {}; it has: {}.{}", input_.what(), in_quotes(key),
                            fmt::join(names, ", "), did_you_mean(key, names)));
}

} // namespace rasterwalk
