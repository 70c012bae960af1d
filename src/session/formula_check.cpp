#include <algorithm>
#include <array>

#include "session/lesson_check.h"
#include "session/quoted.h"

namespace rasterwalk {

namespace {

/// The commands that the program draws.
constexpr std::array<std::string_view, 53> commands{
    "cdot",   "times", "le",    "leq",   "ge",    "geq",   "ne",      "approx", "to",
    "pm",     "infty", "ldots", "dots",  "sum",   "max",   "min",     "cos",    "sin",
    "tan",    "alpha", "beta",  "gamma", "delta", "Delta", "epsilon", "theta",  "lambda",
    "mu",     "pi",    "rho",   "sigma", "phi",   "omega", "lfloor",  "rfloor", "lvert",
    "rvert",  "quad",  "frac",  "sqrt",  "hat",   "vec",   "bar",     "text",   "mathrm",
    "texttt", "left",  "right", ",",     ";",     "{",     "}",       "_"};

std::size_t command_length(std::string_view after) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto end = std::find_if_not(after.begin(), after.end(), is_letter);
    return std::max<std::size_t>(static_cast<std::size_t>(end - after.begin()),
                                 after.empty() ? 0 : 1);
}

} // namespace

std::vector<std::string> formula_faults(std::string_view tex) {
    std::vector<std::string> faults;
    int open = 0;
    bool closes_too_much = false;
    for (std::size_t i = 0; i < tex.size(); ++i) {
        if (tex[i] == '{') ++open;
        if (tex[i] == '}' && --open < 0) closes_too_much = true;
        if (tex[i] != '\\') continue;
        const std::size_t length = command_length(tex.substr(i + 1));
        const std::string_view name = tex.substr(i + 1, length);
        const bool is_known =
            name == "$" || std::find(commands.begin(), commands.end(), name) != commands.end();
        if (!is_known) {
            faults.push_back("the program cannot draw " + in_quotes("\\" + std::string(name)) +
                             " in a formula.");
        }
        i += length;
    }
    if (open != 0 || closes_too_much) {
        faults.push_back("the braces of the formula " + in_quotes(tex) + " do not match.");
    }
    return faults;
}

} // namespace rasterwalk
