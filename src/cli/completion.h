#pragma once

#include <string>

namespace CLI {
class App;
}

namespace rasterwalk {

/// Scripts that complete a program's commands, options and files in a shell.
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);

} // namespace rasterwalk
