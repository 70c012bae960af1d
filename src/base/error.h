#pragma once

#include <stdexcept>
#include <string>

namespace rasterwalk {

/// The exit codes of this project's programs.
enum class ExitCode : int {
    done = 0,
    difference = 1,    ///< a check found a difference
    usage = 2,         ///< wrong use of the command line
    bad_input = 3,     ///< a file or value that cannot be understood
    no_access = 4,     ///< a file that cannot be read or written, a program that does not answer
    no_display = 5,    ///< a window was asked for and there is no display
    interrupted = 130, ///< stopped by Ctrl+C, the shells' code; finished work is printed
};

/// A fault with a sentence for the person and an exit code for the shell.
class Error : public std::runtime_error {
  public:
    Error(ExitCode exit_code, const std::string& sentence)
        : std::runtime_error(sentence), code(exit_code) {}
    ExitCode code;
};

/// Wrong use: an unknown name, a value that a setting does not take.
struct UsageError : Error {
    explicit UsageError(const std::string& sentence) : Error(ExitCode::usage, sentence) {}
};

/// Bad input in a file; the sentence begins with "file:line: " if there is a line.
struct InputError : Error {
    explicit InputError(const std::string& sentence) : Error(ExitCode::bad_input, sentence) {}
    InputError(const std::string& path, int line, const std::string& sentence)
        : Error(ExitCode::bad_input, path + ":" + std::to_string(line) + ": " + sentence) {}
};

/// A file that cannot be opened, read or written; another program that does not answer.
struct AccessError : Error {
    explicit AccessError(const std::string& sentence) : Error(ExitCode::no_access, sentence) {}
};

} // namespace rasterwalk
