#pragma once

#include <map>
#include <string>
#include <vector>

#include <sys/types.h>

namespace rasterwalk::test {

/// A program that runs alongside the test and is ended with it.
class Program {
  public:
    /// @param words the program and its arguments
    /// @param environment what to set besides what the test has; an empty value removes a name
    /// @param folder it runs in, and where its "stdout" and "stderr" are
    Program(const std::vector<std::string>& words,
            const std::map<std::string, std::string>& environment, const std::string& folder);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    bool is_running();
    /// Waits until it ends. Returns the exit code, 128 and more for a signal, -1 if it still runs.
    int wait(double seconds);
    /// Time that the processor spent on it, seconds.
    double cpu_seconds() const;

  private:
    pid_t pid_ = -1;
    int exit_code_ = -1;
};

/// Asks again and again until the answer is yes. Returns false if it never was.
template <typename Question>
bool becomes_true(double seconds, Question&& question);

void sleep_seconds(double seconds);

template <typename Question>
bool becomes_true(double seconds, Question&& question) {
    constexpr double pause = 0.02;
    for (double waited = 0.0; waited < seconds; waited += pause) {
        if (question()) return true;
        sleep_seconds(pause);
    }
    return question();
}

} // namespace rasterwalk::test
