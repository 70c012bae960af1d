#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace rasterwalk {

/// What is thrown while an answer is waited for and `is_stopped` says so.
struct WaitingStopped {};

/// Another program that answers questions: what it reads is what is asked here, and what it writes
/// is read here. Its messages go where those of this program go. Ctrl+C in the terminal does not
/// reach it. When this goes out of scope, it is ended.
class ChildProcess {
  public:
    struct Patience {
        std::chrono::milliseconds longest{30'000}; ///< without a single byte of an answer
        std::function<bool()> is_stopped;          ///< asked ten times a second; null: never
    };

    /// Starts a program. Throws AccessError if it cannot be started.
    /// @param words its path, and its arguments
    ChildProcess(const std::vector<std::string>& words, Patience patience);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Asks something: the line and a line break.
    void write_line(const std::string& line);

    /// The next line of the answer, without its line break. Throws AccessError that names the
    /// program and says how it has ended, that it says nothing, or that the line has no end; throws
    /// WaitingStopped.
    std::string read_line();

    /// So many bytes of the answer. Throws the same.
    std::string read_bytes(std::size_t count);

  private:
    void read_more();
    [[noreturn]] void throw_ended();

    std::string name_;
    Patience patience_;
    int process_ = -1;
    int socket_ = -1;
    std::string unread_; ///< has arrived, and was not asked for yet
};

} // namespace rasterwalk
