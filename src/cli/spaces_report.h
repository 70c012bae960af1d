#pragma once

#include <iosfwd>

#include "cli/json.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// The vertices of a triangle through every space, and vertex 0 through the conventions, as data:
/// an array for `spaces`, an object for `conventions`. The settings give the order of
/// multiplication.
Json spaces_json(const Frame& frame, int triangle);
Json conventions_json(const Frame& frame, int triangle);

/// The same in words.
void print_spaces(std::ostream& out, const Frame& frame, int triangle);
void print_conventions(std::ostream& out, const Frame& frame, int triangle);

} // namespace rasterwalk
