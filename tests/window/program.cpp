#include "tests/window/program.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rasterwalk::test {

namespace {

void redirect(const std::string& path, int descriptor) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file < 0 || dup2(file, descriptor) < 0) _exit(126);
    close(file);
}

} // namespace

void sleep_seconds(double seconds) {
    const auto whole = static_cast<std::time_t>(seconds);
    timespec left{whole, static_cast<long>(1e9 * (seconds - static_cast<double>(whole)))};
    while (nanosleep(&left, &left) != 0 && errno == EINTR) {
    }
}

Program::Program(const std::vector<std::string>& words,
                 const std::map<std::string, std::string>& environment, const std::string& folder) {
    std::vector<std::string> copies = words;
    std::vector<char*> arguments;
    for (std::string& word : copies)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("no process could be started");
    if (pid_ > 0) return;
    for (const auto& [name, value] : environment) {
        if (value.empty()) {
            unsetenv(name.c_str());
        } else {
            setenv(name.c_str(), value.c_str(), 1);
        }
    }
    if (chdir(folder.c_str()) != 0) _exit(126);
    redirect("stdout", STDOUT_FILENO);
    redirect("stderr", STDERR_FILENO);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

Program::~Program() {
    if (!is_running()) return;
    kill(pid_, SIGTERM);
    if (wait(5.0) >= 0) return;
    kill(pid_, SIGKILL);
    wait(5.0);
}

bool Program::is_running() {
    if (exit_code_ >= 0) return false;
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == 0) return true;
    exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return false;
}

int Program::wait(double seconds) {
    becomes_true(seconds, [&] { return !is_running(); });
    return exit_code_;
}

double Program::cpu_seconds() const {
    std::ifstream file("/proc/" + std::to_string(pid_) + "/stat");
    std::string word;
    long user = 0, system = 0;
    // The name in parentheses has no blanks for this program; times are the 14th and 15th word.
    for (int i = 1; i < 14 && file >> word; ++i) {
    }
    file >> user >> system;
    return static_cast<double>(user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

} // namespace rasterwalk::test
