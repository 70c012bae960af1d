#include "cli/package_option.h"

#include <map>
#include <string>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "cli/completion.h"
#include "cli/manual_page.h"

namespace rasterwalk {

void add_package_option(CLI::App& app) {
    const auto print = [&app](const std::string& what) {
        static const std::map<std::string, std::string (*)(const CLI::App&)> makers{
            {"manual", manual_page},
            {"bash", bash_completion},
            {"zsh", zsh_completion},
            {"fish", fish_completion}};
        const auto maker = makers.find(what);
        if (maker == makers.end())
            throw UsageError("--print-for-package prints manual, bash, zsh or fish.");
        // As --version does.
        throw CLI::CallForVersion(maker->second(app), 0);
    };
    app.add_option_function<std::string>("--print-for-package", print)->group("");
}

} // namespace rasterwalk
