#pragma once

#include <ostream>

#include <toml++/toml.h>

namespace rasterwalk {

/// Prints a table as JSON and ends the line.
inline void print_json(const toml::table& table, std::ostream& out) {
    out << toml::json_formatter{table} << '\n';
}

} // namespace rasterwalk
