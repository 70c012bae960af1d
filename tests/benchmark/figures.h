#pragma once

// The lines that a benchmark prints, `made-step 401.2 ms`, and those that another version printed.

#include <map>
#include <string>

namespace rasterwalk {

/// Milliseconds by name.
using KnownFigures = std::map<std::string, double>;

/// The figures in a file of such lines; none where the path is empty. Throws AccessError.
KnownFigures read_figures(const std::string& path);

/// Prints a line; it ends with the ratio to the figure of the same name, if there is one.
void print_figure(const std::string& name, double milliseconds, const KnownFigures& others);

} // namespace rasterwalk
