#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace rasterwalk {

/// A command's answer with --json. The keys of an object are printed in the order they are written:
/// by name.
using Json = nlohmann::ordered_json;

Json texts_to_json(const std::vector<std::string>& texts);

/// A list of its three numbers.
Json vector_to_json(const glm::vec3& v);

/// Prints it over several lines, four blanks deeper in each list and object, and ends the line.
/// Numbers have all their digits; those that JSON cannot express are texts: "Infinity",
/// "-Infinity", "NaN". Text is printed as UTF-8, with terminal controls escaped.
void print_json(const Json& value, std::ostream& out);

} // namespace rasterwalk
