#include "base/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#ifndef __EMSCRIPTEN__
#include <spawn.h>
#endif

#include "base/error.h"
#include "base/numbers.h"
#include "base/quoted.h"

namespace rasterwalk {

namespace {

using namespace std::chrono_literals;

/// A longer line is not an answer.
constexpr std::size_t longest_line = 4096;

/// How long a program may take to end after closing its output.
constexpr auto longest_end = 1s;

/// How a program has ended, according to waitpid().
std::string ending_text(int status) {
    if (WIFSIGNALED(status))
        return fmt::format("was stopped by a signal: {}", strsignal(WTERMSIG(status)));
    return fmt::format("ended with exit code {}", WEXITSTATUS(status));
}

#ifdef __EMSCRIPTEN__

/// A browser cannot start programs.
int start(const std::vector<std::string>&, pid_t&, int&) {
    return ENOSYS;
}

#else

/// Starts a program whose input and output are this socket.
/// @return 0, or why that cannot be done, as an errno
int spawn(const std::vector<std::string>& words, int socket, pid_t& process) {
    std::vector<char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str())); // only read
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, socket, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, socket, STDOUT_FILENO);
    // A group of its own: Ctrl+C is this program's to answer.
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    const int fault = posix_spawn(&process, words.front().c_str(), &files, &attributes,
                                  arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return fault;
}

/// The same, with a socket to it.
int start(const std::vector<std::string>& words, pid_t& process, int& socket) {
    std::array<int, 2> ends{};
    // A socket, because writing to a program that has ended is then an error instead of a signal.
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return errno;
    const int fault = spawn(words, ends[1], process);
    ::close(ends[1]);
    if (fault == 0) {
        socket = ends[0];
    } else {
        ::close(ends[0]);
    }
    return fault;
}

#endif

} // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& words, Patience patience)
    : name_(words.front()), patience_(std::move(patience)) {
    const int fault = start(words, process_, socket_);
    if (fault == 0) return;
    throw AccessError(fmt::format("cannot start {}: {}.", in_quotes(name_),
                                  fault == ENOSYS ? "this system cannot start other programs"
                                                  : std::strerror(fault)));
}

ChildProcess::~ChildProcess() {
    ::close(socket_);
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
}

void ChildProcess::write_line(const std::string& line) {
    write_bytes(line + '\n');
}

void ChildProcess::write_bytes(std::string_view bytes) {
    while (!bytes.empty()) {
        wait_for(POLLOUT);
        const ssize_t count =
            ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (count <= 0) throw_ended();
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

std::string ChildProcess::read_line() {
    std::size_t end = unread_.find('\n');
    while (end == std::string::npos) {
        if (unread_.size() > longest_line)
            throw AccessError(in_quotes(name_) + " sent a line that is too long.");
        read_more();
        end = unread_.find('\n');
    }
    std::string line = unread_.substr(0, end);
    unread_.erase(0, end + 1);
    return line;
}

std::string ChildProcess::read_bytes(std::size_t count) {
    while (unread_.size() < count)
        read_more();
    std::string bytes = unread_.substr(0, count);
    unread_.erase(0, count);
    return bytes;
}

/// Waits for more, and appends it to the unread text.
void ChildProcess::read_more() {
    std::array<char, 1 << 16> block{};
    while (true) {
        wait_for(POLLIN);
        const ssize_t count = ::recv(socket_, block.data(), block.size(), 0);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) throw_ended();
        unread_.append(block.data(), static_cast<std::size_t>(count));
        return;
    }
}

/// Waits until the socket has something to read, or room to write.
/// @param event POLLIN or POLLOUT
void ChildProcess::wait_for(short event) {
    const auto begin = std::chrono::steady_clock::now();
    while (true) {
        if (patience_.is_stopped && patience_.is_stopped()) throw WaitingStopped();
        const auto waited = std::chrono::duration_cast<std::chrono::milliseconds>(
            std::chrono::steady_clock::now() - begin);
        const auto left = patience_.longest - waited;
        if (left <= 0ms) {
            const double seconds = std::chrono::duration<double>(patience_.longest).count();
            throw AccessError(fmt::format("{} has not answered for {} s.", in_quotes(name_),
                                          significant(seconds, 3)));
        }
        pollfd wanted{socket_, event, 0};
        const auto slice = std::min(left, std::chrono::milliseconds(100ms));
        if (::poll(&wanted, 1, static_cast<int>(slice.count())) > 0) return;
    }
}

/// The program has closed its end of the socket.
void ChildProcess::throw_ended() {
    const auto begin = std::chrono::steady_clock::now();
    int status = 0;
    while (std::chrono::steady_clock::now() - begin < longest_end) {
        if (::waitpid(process_, &status, WNOHANG) == process_) {
            process_ = -1;
            throw AccessError(fmt::format("{} {}.", in_quotes(name_), ending_text(status)));
        }
        std::this_thread::sleep_for(1ms);
    }
    throw AccessError(in_quotes(name_) + " has closed its output but is still running.");
}

} // namespace rasterwalk
