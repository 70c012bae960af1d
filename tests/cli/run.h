#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "cli/cli.h"

namespace rasterwalk::test {

/// What a command line printed, and how it ended.
struct CliRun {
    int exit_code = -1;
    std::string out;
    std::string err;
    CliRequest request;
};

/// Runs `rasterwalk` with these arguments, and with a clock and a terminal if there is one.
inline CliRun run(const std::vector<std::string>& arguments, const Clock& clock = {},
                  std::ostream* terminal = nullptr) {
    std::vector<const char*> argv{"rasterwalk"};
    for (const std::string& argument : arguments)
        argv.push_back(argument.c_str());
    std::ostringstream out, err;
    CliRun result;
    result.request.patience = std::chrono::hours(1);
    result.exit_code = run_cli(static_cast<int>(argv.size()), argv.data(), out, err, result.request,
                               clock, terminal);
    result.out = out.str();
    result.err = err.str();
    return result;
}

/// JSON without blanks and line ends.
inline std::string without_blanks(std::string text) {
    text.erase(
        std::remove_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\n'; }),
        text.end());
    return text;
}

} // namespace rasterwalk::test
