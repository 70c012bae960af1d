#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk {

/// Thrown while waiting for an answer, if `is_stopped` says so.
struct WaitingStopped {};

/// Another program that answers questions: it reads the questions written here, and its output is
/// read here. Its messages go where those of this program go. Ctrl+C in the terminal does not reach
/// it. It is ended when this goes out of scope.
class ChildProcess {
  public:
    struct Patience {
        std::chrono::milliseconds longest{30'000}; ///< the longest wait without a byte of an answer
        std::function<bool()> is_stopped;          ///< asked ten times a second; null: never
    };

    /// Starts a program. Throws AccessError if it cannot be started.
    /// @param words its path, and its arguments
    ChildProcess(const std::vector<std::string>& words, Patience patience);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Asks a question: writes the line and a line break.
    void write_line(const std::string& line);

    /// Writes bytes that belong to a question. Throws as reading does, if the program takes none
    /// of them.
    void write_bytes(std::string_view bytes);

    /// The next line of the answer, without its line break. Throws an AccessError that names the
    /// program and says how it has ended, that it is silent, or that the line has no end; throws
    /// WaitingStopped.
    std::string read_line();

    /// The next `count` bytes of the answer. Throws the same.
    std::string read_bytes(std::size_t count);

  private:
    void read_more();
    void wait_for(short event);
    [[noreturn]] void throw_ended();

    std::string name_;
    Patience patience_;
    int process_ = -1;
    int socket_ = -1;
    std::string unread_; ///< has arrived, but has not been read yet
};

} // namespace rasterwalk
