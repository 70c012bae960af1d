#pragma once

namespace CLI {
class App;
}

namespace rasterwalk {

/// Adds the hidden option --print-for-package, with which packages are built: "manual" prints the
/// program's man page, "bash", "zsh" and "fish" its completion in that shell.
void add_package_option(CLI::App& app);

} // namespace rasterwalk
