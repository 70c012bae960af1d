#pragma once

// Runs part of a test as an ordinary user, even if the tests are run by root, to whom much is
// allowed that must be refused.

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <grp.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace rasterwalk::test {

/// The user that a test acts as.
enum class User {
    ordinary, ///< one without rights, if root runs the tests; otherwise the user who runs them
    same,     ///< the user who runs the tests
};

/// The numbers of a user and a group without rights.
inline constexpr unsigned ordinary_id = 65534;

inline bool is_root() {
    return ::geteuid() == 0;
}

/// Becomes an ordinary user for good. Ends the process if it cannot.
inline void become_ordinary_user() {
    if (!is_root()) return;
    if (::setgroups(0, nullptr) != 0 || ::setgid(ordinary_id) != 0 || ::setuid(ordinary_id) != 0)
        ::_exit(1);
#ifdef __linux__
    // A process that changes its user may no longer look at itself in /proc.
    ::prctl(PR_SET_DUMPABLE, 1);
#endif
}

/// What an action returns, a text, when this user takes it in a process of its own. Throws what it
/// throws, as a std::runtime_error. In there nothing can be asserted.
template <class Action>
std::string as_user(User user, Action action) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) std::abort();
    const pid_t child = ::fork();
    if (child < 0) std::abort();
    if (child == 0) {
        if (user == User::ordinary) become_ordinary_user();
        std::string said = "+";
        try {
            said += action();
        } catch (const std::exception& fault) {
            said = std::string("-") + fault.what();
        }
        for (std::size_t done = 0; done < said.size();) {
            const ssize_t count = ::write(ends[1], said.data() + done, said.size() - done);
            if (count < 0) ::_exit(1);
            done += static_cast<std::size_t>(count);
        }
        ::_exit(0);
    }
    ::close(ends[1]);
    std::string said;
    char block[4096];
    for (ssize_t count = 0; (count = ::read(ends[0], block, sizeof block)) > 0;)
        said.append(block, static_cast<std::size_t>(count));
    ::close(ends[0]);
    ::waitpid(child, nullptr, 0);
    if (said.empty()) throw std::runtime_error("the process ended without a word");
    if (said.front() == '-') throw std::runtime_error(said.substr(1));
    return said.substr(1);
}

template <class Action>
std::string as_ordinary_user(Action action) {
    return as_user(User::ordinary, action);
}

/// Makes a folder and all in it this user's own.
inline void give_to(User user, const std::string& folder) {
    if (user == User::same || !is_root()) return;
    const auto give = [](const std::filesystem::path& path) {
        if (::lchown(path.c_str(), ordinary_id, ordinary_id) != 0) std::abort();
    };
    give(folder);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        give(entry.path());
}

} // namespace rasterwalk::test
