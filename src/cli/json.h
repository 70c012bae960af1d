#pragma once

#include <ostream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace rasterwalk {

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
