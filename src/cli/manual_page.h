#pragma once

#include <string>

namespace CLI {
class App;
}

namespace rasterwalk {

/// A program's man page, in the words of its --help. What a command has in common with the program
/// is explained once.
std::string manual_page(const CLI::App& app);

} // namespace rasterwalk
