#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace rasterwalk {

/// An option or a positional of a program or a command, as its help shows it.
struct ShownOption {
    std::string group;
    std::vector<std::string> names; ///< "-o", "--output"; none of a positional
    std::string value;              ///< "FILE"; empty: a flag
    std::string about;
    bool is_required = false;

    friend bool operator==(const ShownOption&, const ShownOption&) = default;
};

/// All of them in the order of the help, except hidden ones.
std::vector<ShownOption> shown_options(const CLI::App& app);

} // namespace rasterwalk
