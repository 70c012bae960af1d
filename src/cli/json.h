#pragma once

#include <ostream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <toml++/toml.h>

namespace rasterwalk {

inline toml::array texts_to_json(const std::vector<std::string>& texts) {
    toml::array array;
    for (const std::string& text : texts)
        array.push_back(text);
    return array;
}

inline toml::array vector_to_json(const glm::vec3& v) {
    return toml::array{static_cast<double>(v.x), static_cast<double>(v.y),
                       static_cast<double>(v.z)};
}

/// Prints a table as JSON and ends the line.
inline void print_json(const toml::table& table, std::ostream& out) {
    out << toml::json_formatter{table} << '\n';
}

/// The same with further keys whose value is null, for which TOML has no word.
inline void print_json(const toml::table& table, std::span<const std::string_view> null_keys,
                       std::ostream& out) {
    std::ostringstream printed;
    printed << toml::json_formatter{table};
    std::string text = printed.str();
    text.erase(text.rfind('}'));
    text.erase(text.find_last_not_of(" \n") + 1);
    out << text;
    bool is_first = table.empty();
    for (const std::string_view key : null_keys) {
        out << (is_first ? "\n    \"" : ",\n    \"") << key << "\" : null";
        is_first = false;
    }
    out << "\n}\n";
}

} // namespace rasterwalk
