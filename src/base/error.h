#pragma once

#include <stdexcept>
#include <string>

namespace rasterwalk {

/// What a program of this project reports as its exit code.
enum class ExitCode : int {
    done = 0,
    difference = 1,    ///< a check found a difference
    usage = 2,         ///< wrong usage of the command line
    bad_input = 3,     ///< a file or value that cannot be understood
    no_access = 4,     ///< a file that cannot be read or written, a program that cannot be asked
    no_display = 5,    ///< a window was asked for and there is no display
    interrupted = 130, ///< stopped by Ctrl+C, as shells say it; what was done is printed
};

/// A fault with a sentence for the person and an exit code for the shell.
class Error : public std::runtime_error {
  public:
    Error(ExitCode exit_code, const std::string& sentence)
        : std::runtime_error(sentence), code(exit_code) {}
    ExitCode code;
};

/// Wrong usage: an unknown name, a value that a setting does not take.
struct UsageError : Error {
    explicit UsageError(const std::string& sentence) : Error(ExitCode::usage, sentence) {}
};

/// Bad input in a file; the sentence begins with "file:line: " where there is a line.
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
